// The parts of three.js that the viewer uses.
export {
  AmbientLight, BackSide, BufferAttribute, BufferGeometry, Color, CylinderGeometry, DirectionalLight, DynamicDrawUsage, Fog,
  HemisphereLight, IcosahedronGeometry, InstancedBufferAttribute, InstancedMesh, LineBasicMaterial, LineSegments, Matrix4,
  MeshBasicMaterial, MeshStandardMaterial, OrthographicCamera, PerspectiveCamera, Points, REVISION, Scene, ShaderMaterial,
  Vector3, WebGLRenderer,
} from "three";
export {OrbitControls} from "three/addons/controls/OrbitControls.js";
