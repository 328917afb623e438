// Where points are in the scene, and the layers that show a drawing of any size: one-pixel lines for all segments or a
// sample of them, dots for the vertices. Tubes are in tubes.js. z is up; the drawing's box is about the origin and its
// longest side has length 1.
import {growthRanks, pointOf, pointsOf, spreadOver} from "./data.js";
import {withMinus} from "./exact.js";
import {view} from "./state.js";

export const kMostLines = 1500000;  // segments held as lines; of larger drawings a sample, spread evenly over the edges
export const kPalette = [
  [0, 114, 178], [230, 159, 0], [0, 158, 115], [204, 121, 167],
  [86, 180, 233], [213, 94, 0], [240, 228, 66], [120, 120, 120],
];
export const kOtherDirections = kPalette.length - 1;

/// The rows of the transpose of F, where gram / denominator = F F^T (Cholesky).
function metricRows({gram, gram_denominator: denominator}) {
  const factor = [[0, 0, 0], [0, 0, 0], [0, 0, 0]];
  for (let i = 0; i < 3; ++i) {
    for (let j = 0; j <= i; ++j) {
      let sum = gram[i][j] / denominator;
      for (let k = 0; k < j; ++k) sum -= factor[i][k] * factor[j][k];
      factor[i][j] = i === j ? Math.sqrt(sum) : sum / factor[j][j];
    }
  }
  return [0, 1, 2].map(i => [0, 1, 2].map(j => factor[j][i]));
}
/// How long a lattice box is along each axis of the scene.
export const sidesOf = (rows, extents) =>
  rows.map(row => row.reduce((sum, entry, j) => sum + Math.abs(entry) * extents[j], 0));

/// The map from lattice coordinates to the scene: rows of `matrix`, applied to the difference from `centre`.
export function spaceOf(drawing, stretch) {
  const {extents} = drawing.about;
  const rows = metricRows(drawing.about), sides = sidesOf(rows, extents);
  const longest = Math.max(...sides) || 1;
  const scale = sides.map(side => 1 / (stretch && side > 0 ? side : longest));
  const size = sides.map((side, i) => side * scale[i]);
  return {
    matrix: rows.map((row, i) => row.map(entry => entry * scale[i])),
    centre: extents.map(extent => extent / 2),
    size,
    unit: stretch ? Math.min(...scale) : 1 / longest,
    radius: Math.hypot(...size) / 2 || 0.5,
    flatness: longest / Math.min(longest, ...sides.filter(side => side > 0)),
  };
}

/// The point's place in the scene, in out[at..at + 2].
export function toScene(point, out, at = 0) {
  const {matrix, centre} = view.space;
  const x = point[0] - centre[0], y = point[1] - centre[1], z = point[2] - centre[2];
  for (let i = 0; i < 3; ++i) out[at + i] = matrix[i][0] * x + matrix[i][1] * y + matrix[i][2] * z;
  return out;
}
export const vectorInScene = point => new THREE.Vector3(...toScene(point, [0, 0, 0]));

const kVertexShader = `
  attribute float birth; attribute float tone;
  uniform float grown, dotSize; uniform vec3 palette[8];
  varying vec3 colour; varying float depth;
  void main() {
    vec4 place = modelViewMatrix * vec4(position, 1.0);
    depth = -place.z;
    colour = palette[int(tone)];
    gl_Position = birth > grown ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * place;
    gl_PointSize = dotSize;
  }`;
const kFragmentShader = `
  uniform vec3 paper; uniform float near, far, opacity, round;
  varying vec3 colour; varying float depth;
  void main() {
    float shade = 1.0;
    if (round > 0.5) {
      vec2 at = 2.0 * gl_PointCoord - 1.0;
      float from = dot(at, at);
      if (from > 1.0) discard;
      shade = 0.75 + 0.5 * sqrt(1.0 - from) * (0.6 - 0.4 * at.y);
    }
    float faded = clamp((depth - near) / (far - near), 0.0, 0.82);
    gl_FragColor = vec4(mix(min(colour * shade, 1.0), paper, faded), opacity);
  }`;

/// The uniforms that all layers share; each has its own beside them.
export const sharedUniforms = {
  grown: {value: 0}, paper: {value: [1, 1, 1]}, near: {value: 0}, far: {value: 1},
  palette: {value: new Array(24).fill(0)},
};
function layerMaterial(own) {
  const uniforms = {...sharedUniforms};
  for (const name in own) uniforms[name] = {value: own[name]};
  return new THREE.ShaderMaterial({uniforms, vertexShader: kVertexShader, fragmentShader: kFragmentShader});
}

export const scene = new THREE.Scene();
scene.fog = new THREE.Fog(0, 0, 1);
export const lineMaterial = layerMaterial({opacity: 1, round: 0, dotSize: 1});
lineMaterial.transparent = true;  // where lines lie many times over each other
const densityMaterial = layerMaterial({opacity: 0.4, round: 0, dotSize: 1.5});
densityMaterial.transparent = true;
densityMaterial.depthWrite = false;
export const dotMaterial = layerMaterial({opacity: 1, round: 1, dotSize: 4, palette: new Array(24).fill(0)});

/// The layers of the drawing shown.
export const layers = {
  lines: null,
  density: null,
  dots: null,
  held: 0,  // how many lines
  dotOrder: null,  // the vertices in the order of the dots
  hasBirths: false,  // the layers know when each point is grown
};

function geometryOf(positions, tones) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
  geometry.setAttribute("birth", new THREE.BufferAttribute(new Float32Array(positions.length / 3), 1));
  geometry.setAttribute("tone", new THREE.BufferAttribute(tones, 1));
  geometry.boundingSphere = {center: new THREE.Vector3(), radius: 1};  // known: nothing is computed over all points
  return geometry;
}

/// Calls visit(edge, i, number) for the segments that the lines hold, in their order. @return how many there are.
function forEachLine(drawing, visit) {
  let held = 0;
  spreadOver(drawing.m, edge => {
    const count = pointsOf(drawing, edge) - 1;
    if (held + count > kMostLines) return false;
    for (let i = 0; i < count; ++i) visit(edge, i, held++);
    return true;
  });
  return held;
}

function lineGeometry(drawing) {
  const room = Math.min(drawing.segments, kMostLines), positions = new Float32Array(6 * room), point = [0, 0, 0];
  layers.held = forEachLine(drawing, (edge, i, number) => {
    toScene(pointOf(drawing, edge, i, point), positions, 6 * number);
    toScene(pointOf(drawing, edge, i + 1, point), positions, 6 * number + 3);
  });
  return geometryOf(positions, new Uint8Array(2 * room));
}
function dotGeometry(drawing) {
  const positions = new Float32Array(3 * drawing.n);
  let dots = 0;
  layers.dotOrder = new Uint32Array(drawing.n);
  spreadOver(drawing.n, v => {
    layers.dotOrder[dots] = v;
    toScene([drawing.x[v], drawing.y[v], drawing.z[v]], positions, 3 * dots++);
  });
  return geometryOf(positions, new Uint8Array(drawing.n));
}

const layerObjects = () => [layers.lines, layers.density, layers.dots];
export function buildLayers(drawing) {
  for (const layer of layerObjects()) {
    if (!layer) continue;
    scene.remove(layer);
    layer.geometry.dispose();
  }
  const lines = lineGeometry(drawing);
  layers.lines = new THREE.LineSegments(lines, lineMaterial);
  layers.density = new THREE.Points(lines, densityMaterial);
  layers.dots = new THREE.Points(dotGeometry(drawing), dotMaterial);
  for (const layer of layerObjects()) {
    layer.frustumCulled = false;
    scene.add(layer);
  }
  layers.hasBirths = false;
}

/// The direction of a segment in lowest terms, up to sign.
function directionName(from, to) {
  const divisor = (a, b) => b ? divisor(b, a % b) : a;
  const parts = from.map((c, i) => to[i] - c);
  const sign = parts.find(part => part !== 0) < 0 ? -1 : 1;
  const by = (parts.map(Math.abs).reduce(divisor) || 1) * sign;
  return withMinus(`\u00b1(${parts.map(part => part / by).join(", ")})`);
}

/// The class of each segment's direction: at most 7 have names, all others are kOtherDirections.
export function directionClasses(drawing) {
  if (drawing.directions) return drawing.directions;
  const numbers = new Map(), classes = new Uint8Array(drawing.segments), from = [0, 0, 0], to = [0, 0, 0];
  let segment = 0;
  for (let edge = 0; edge < drawing.m; ++edge) {
    for (let i = 0; i + 1 < pointsOf(drawing, edge); ++i, ++segment) {
      const name = directionName(pointOf(drawing, edge, i, from), pointOf(drawing, edge, i + 1, to));
      if (!numbers.has(name) && numbers.size < kOtherDirections) numbers.set(name, numbers.size);
      classes[segment] = numbers.get(name) ?? kOtherDirections;
    }
  }
  drawing.directions = {names: [...numbers.keys()], classes};
  return drawing.directions;
}
/// The number of the colour of segment i of an edge.
export function toneOf(drawing, edge, i) {
  if (view.colours !== "direction") return Math.min(kPalette.length - 1, drawing.role[edge]);
  return directionClasses(drawing).classes[drawing.firstBend[edge] + edge + i];
}

/// Writes the colours of palettes, made of numbers from 0 to 1, into the layers.
export function setLayerColours(palette, ball, paper) {
  sharedUniforms.palette.value = palette.flat();
  dotMaterial.uniforms.palette.value = kPalette.flatMap(() => ball);
  sharedUniforms.paper.value = paper;
}

export function paintLayers(drawing) {
  const {tone} = layers.lines.geometry.attributes;
  forEachLine(drawing, (edge, i, number) => {
    tone.array[2 * number] = tone.array[2 * number + 1] = toneOf(drawing, edge, i);
  });
  tone.needsUpdate = true;
}

export function growLayers(drawing) {
  sharedUniforms.grown.value = view.grown >= drawing.n ? 1e9 : view.grown;
  if (layers.hasBirths || view.grown >= drawing.n) return;
  const ranks = growthRanks(drawing);
  const lines = layers.lines.geometry.attributes.birth, dots = layers.dots.geometry.attributes.birth;
  forEachLine(drawing, (edge, _, number) => {
    const birth = Math.max(ranks[drawing.u[edge]], ranks[drawing.v[edge]]);
    lines.array[2 * number] = lines.array[2 * number + 1] = birth;
  });
  layers.dotOrder.forEach((v, i) => { dots.array[i] = ranks[v]; });
  lines.needsUpdate = dots.needsUpdate = layers.hasBirths = true;
}
