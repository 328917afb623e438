// Edges as tubes with round joints, vertices as balls: for small drawings all, for large ones those that are near.
import {isEdgeGrown, isGrown, pointOf, pointsOf, positionOf} from "./data.js";
import {pixelsPerUnit} from "./cameras.js";
import {project, projectionRows} from "./pick.js";
import {scene, toneOf, toScene} from "./layers.js";
import {view} from "./state.js";

export const kMostTubes = 9000;
const kMostChosen = 512;  // tubes, and balls, of what is selected

const kCylinder = new THREE.CylinderGeometry(1, 1, 1, 14, 1, true);
const kSphere = new THREE.IcosahedronGeometry(1, 3);

function instances(shape, material, most) {
  const mesh = new THREE.InstancedMesh(shape, material, most);
  mesh.frustumCulled = false;
  mesh.count = 0;
  mesh.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
  mesh.setColorAt(0, new THREE.Color(1, 1, 1));
  scene.add(mesh);
  return mesh;
}
const solid = extra => new THREE.MeshStandardMaterial({roughness: 0.42, metalness: 0, ...extra});
const behind = () => new THREE.MeshBasicMaterial({side: THREE.BackSide, fog: false});

export const meshes = {
  halo: instances(kCylinder, behind(), kMostTubes),
  tubes: instances(kCylinder, solid(), kMostTubes),
  joints: instances(kSphere, solid(), kMostTubes),
  balls: instances(kSphere, solid({roughness: 0.3}), kMostTubes),
  chosenTubes: instances(kCylinder, solid({emissiveIntensity: 0.55}), kMostChosen),
  chosenBalls: instances(kSphere, solid({emissiveIntensity: 0.55}), kMostChosen),
};
meshes.halo.renderOrder = -1;

/// Radius of a tube in the scene: a share of the lattice's unit, or of the room that a segment has.
export function tubeRadius(drawing) {
  const side = Math.cbrt(view.space.size.reduce((product, length) => product * Math.max(length, 0.05), 1));
  const room = 0.13 / Math.sqrt(Math.max(1, drawing.segments));
  return side * Math.min(0.014, Math.max(0.16 * view.space.unit / side, room)) * 2 ** (view.thickness / 5);
}

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/// Makes instance `at` the tube from a to b: columns x and z of its matrix are as long as the radius, y is b - a.
function putTube(mesh, at, a, b, radius) {
  const y = [b[0] - a[0], b[1] - a[1], b[2] - a[2]], length = Math.hypot(...y) || 1e-9;
  const aside = cross(y, Math.abs(y[2]) < 0.9 * length ? [0, 0, 1] : [1, 0, 0]);
  const scale = radius / Math.hypot(...aside);
  const x = aside.map(c => c * scale), z = cross(x, y).map(c => c / length);
  const middle = a.map((c, i) => (c + b[i]) / 2);
  mesh.instanceMatrix.array.set([...x, 0, ...y, 0, ...z, 0, ...middle, 1], 16 * at);
}
/// What keeps the tubes behind a tube at a distance; short of its ends, so that it spares what it is joined to.
function putHalo(at, a, b, radius) {
  const length = Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), cut = Math.min(0.5, 6 * radius / (length || 1));
  const between = share => a.map((c, i) => c + share * (b[i] - c));
  putTube(meshes.halo, at, between(cut), between(1 - cut), radius * 1.6);
}
function putBall(mesh, at, place, radius) {
  mesh.instanceMatrix.array.set([radius, 0, 0, 0, 0, radius, 0, 0, 0, 0, radius, 0, ...place, 1], 16 * at);
}
const paintAt = (mesh, at, colour) => mesh.instanceColor.array.set([colour.r, colour.g, colour.b], 3 * at);
function send(mesh, count) {
  mesh.count = count;
  mesh.instanceMatrix.needsUpdate = true;
  mesh.instanceColor.needsUpdate = true;
}

/// The least depth of the drawing's box in the scene, or as little as a camera within it sees.
function nearestDepth(drawing, rows) {
  let least = Infinity;
  for (let k = 0; k < 8; ++k) {
    const corner = drawing.about.extents.map((extent, i) => k >> i & 1 ? extent : 0);
    least = Math.min(least, project(rows, corner, [0, 0, 0])[2]);
  }
  return Math.max(view.camera.near, least);
}

/// Calls visit(edge, i) for all segments.
function forEachSegment(drawing, visit) {
  for (let edge = 0; edge < drawing.m; ++edge) {
    for (let i = 0; i + 1 < pointsOf(drawing, edge); ++i) visit(edge, i);
  }
}

/// Segments [edge, i, distance] to be shown as tubes: all, or those that are at least a pixel wide, the nearest ones if
/// they are too many.
function segmentsForTubes(drawing) {
  const found = [], kLeastPixels = 0.8;
  if (drawing.segments <= kMostTubes) {
    forEachSegment(drawing, (edge, i) => { if (isEdgeGrown(drawing, edge)) found.push([edge, i, 0]); });
    return found;
  }
  const rows = projectionRows(), radius = tubeRadius(drawing);
  const isWide = depth => radius * pixelsPerUnit(depth) >= kLeastPixels;
  if (!isWide(nearestDepth(drawing, rows))) return found;
  const middle = [0, 0, 0], end = [0, 0, 0], seen = new Float64Array(3);
  forEachSegment(drawing, (edge, i) => {
    pointOf(drawing, edge, i, middle);
    pointOf(drawing, edge, i + 1, end);
    for (let c = 0; c < 3; ++c) middle[c] = (middle[c] + end[c]) / 2;
    project(rows, middle, seen);
    const [x, y, depth] = seen;
    if (!(depth > 0) || Math.abs(x) > 1.2 || Math.abs(y) > 1.2) return;
    if (isWide(depth) && isEdgeGrown(drawing, edge)) found.push([edge, i, depth]);
  });
  if (found.length > kMostTubes) found.sort((a, b) => a[2] - b[2]).length = kMostTubes;
  return found;
}

function putBalls(drawing, vertices, radius) {
  const place = [0, 0, 0];
  let balls = 0;
  for (const v of vertices) {
    if (balls === kMostTubes) break;
    if (!isGrown(drawing, v)) continue;
    putBall(meshes.balls, balls, toScene(positionOf(drawing, v), place), radius);
    paintAt(meshes.balls, balls++, view.ballColour);
  }
  send(meshes.balls, balls);
}

export function buildTubes(drawing) {
  const radius = tubeRadius(drawing), isWhole = drawing.segments <= kMostTubes;
  const from = [0, 0, 0], to = [0, 0, 0], point = [0, 0, 0], ends = new Set();
  let tubes = 0, joints = 0;
  for (const [edge, i] of segmentsForTubes(drawing)) {
    toScene(pointOf(drawing, edge, i, point), from);
    toScene(pointOf(drawing, edge, i + 1, point), to);
    const colour = view.solidPalette[toneOf(drawing, edge, i)];
    putTube(meshes.tubes, tubes, from, to, radius);
    if (isWhole) putHalo(tubes, from, to, radius);
    paintAt(meshes.tubes, tubes++, colour);
    if (i > 0) {
      putBall(meshes.joints, joints, from, radius * 1.02);
      paintAt(meshes.joints, joints++, colour);
    } else {
      ends.add(drawing.u[edge]);
    }
    if (i + 2 === pointsOf(drawing, edge)) ends.add(drawing.v[edge]);
  }
  send(meshes.halo, isWhole ? tubes : 0);
  send(meshes.tubes, tubes);
  send(meshes.joints, joints);
  putBalls(drawing, isWhole ? Array(Math.min(drawing.n, kMostTubes)).keys() : ends, radius * 2.3);
}

/// What is selected, and the edges and vertices of the violation shown, in the mark's colour.
export function buildChosen(drawing, edges, vertices) {
  const radius = tubeRadius(drawing) * 1.35, from = [0, 0, 0], to = [0, 0, 0], point = [0, 0, 0];
  let tubes = 0, balls = 0;
  for (const edge of edges) {
    for (let i = 0; i + 1 < pointsOf(drawing, edge) && tubes < kMostChosen && balls < kMostChosen - 12; ++i) {
      toScene(pointOf(drawing, edge, i, point), from);
      toScene(pointOf(drawing, edge, i + 1, point), to);
      putTube(meshes.chosenTubes, tubes++, from, to, radius);
      if (i > 0) putBall(meshes.chosenBalls, balls++, from, radius * 1.02);
    }
  }
  for (const v of vertices) {
    if (balls === kMostChosen) break;
    putBall(meshes.chosenBalls, balls++, toScene(positionOf(drawing, v), from), tubeRadius(drawing) * 3);
  }
  for (const mesh of [meshes.chosenTubes, meshes.chosenBalls]) {
    for (let i = 0; i < kMostChosen; ++i) paintAt(mesh, i, view.markColour);
  }
  send(meshes.chosenTubes, tubes);
  send(meshes.chosenBalls, balls);
}
