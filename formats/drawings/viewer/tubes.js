// Edges as tubes with round joints, vertices as balls: for small drawings all, for large ones those that are near.

const kMostTubes = 9000;

const solid = extra => new THREE.MeshStandardMaterial({roughness: 0.42, metalness: 0, ...extra});
const tubeParts = {
  cylinder: new THREE.CylinderGeometry(1, 1, 1, 14, 1, true),
  sphere: new THREE.IcosahedronGeometry(1, 3),
};
const meshes = {
  halo: new THREE.InstancedMesh(tubeParts.cylinder, new THREE.MeshBasicMaterial({side: THREE.BackSide, fog: false}), kMostTubes),
  tubes: new THREE.InstancedMesh(tubeParts.cylinder, solid(), kMostTubes),
  joints: new THREE.InstancedMesh(tubeParts.sphere, solid(), kMostTubes),
  balls: new THREE.InstancedMesh(tubeParts.sphere, solid({roughness: 0.3}), kMostTubes),
  chosenTubes: new THREE.InstancedMesh(tubeParts.cylinder, solid({emissiveIntensity: 0.55}), 512),
  chosenBalls: new THREE.InstancedMesh(tubeParts.sphere, solid({emissiveIntensity: 0.55}), 512),
};
for (const mesh of Object.values(meshes)) {
  mesh.frustumCulled = false;
  mesh.count = 0;
  mesh.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
  mesh.setColorAt(0, new THREE.Color(1, 1, 1));
  scene.add(mesh);
}
meshes.halo.renderOrder = -1;

/// Radius of a tube in the scene: a share of the lattice's unit, or of the room that a segment has.
function tubeRadius(d) {
  const side = Math.cbrt(view.space.size.reduce((product, s) => product * Math.max(s, 0.05), 1));
  const room = 0.13 / Math.sqrt(Math.max(1, d.segments));
  return side * Math.min(0.014, Math.max(0.16 * view.space.unit / side, room)) * 2 ** (view.thickness / 5);
}

function putTube(mesh, at, a, b, radius) {
  const y = [b[0] - a[0], b[1] - a[1], b[2] - a[2]], length = Math.hypot(...y) || 1e-9;
  const along = Math.abs(y[2]) < 0.9 * length ? [0, 0, 1] : [1, 0, 0];
  const x = [y[1] * along[2] - y[2] * along[1], y[2] * along[0] - y[0] * along[2], y[0] * along[1] - y[1] * along[0]];
  const k = radius / Math.hypot(...x);
  for (let i = 0; i < 3; ++i) x[i] *= k;
  const z = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]].map(c => c / length);
  mesh.instanceMatrix.array.set([...x, 0, ...y, 0, ...z, 0, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2, 1], 16 * at);
}
/// What keeps the tubes behind a tube at a distance; short of its ends, so that it spares what it is joined to.
function putHalo(at, a, b, radius) {
  const length = Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), cut = Math.min(0.5, 6 * radius / (length || 1));
  const between = t => a.map((c, i) => c + t * (b[i] - c));
  putTube(meshes.halo, at, between(cut), between(1 - cut), radius * 1.6);
}
function putBall(mesh, at, p, radius) {
  mesh.instanceMatrix.array.set([radius, 0, 0, 0, 0, radius, 0, 0, 0, 0, radius, 0, p[0], p[1], p[2], 1], 16 * at);
}
const paintAt = (mesh, at, colour) => mesh.instanceColor.array.set([colour.r, colour.g, colour.b], 3 * at);
function send(mesh, count) {
  mesh.count = count;
  mesh.instanceMatrix.needsUpdate = true;
  mesh.instanceColor.needsUpdate = true;
}

/// The least depth of the drawing's box in the scene, or as little as a camera within it sees.
function nearestDepth(d, matrix) {
  const corners = Array.from({length: 8}, (_, k) => project(matrix, d.about.extents.map((extent, i) => k >> i & 1 ? extent : 0), [0, 0, 0]));
  return Math.max(camera.near, corners.reduce((least, corner) => Math.min(least, corner[2]), Infinity));
}

/// Segments [e, i, distance] to be shown as tubes: all, or those that are at least a pixel wide, the nearest ones if
/// they are too many.
function segmentsForTubes(d) {
  const found = [], point = [0, 0, 0], place = [0, 0, 0];
  if (d.segments <= kMostTubes) {
    for (let e = 0; e < d.m; ++e) if (isEdgeGrown(d, e)) for (let i = 0; i + 1 < pointsOf(d, e); ++i) found.push([e, i, 0]);
    return found;
  }
  const matrix = projectionRows(), radius = tubeRadius(d);
  if (radius * pixelsPerUnit(nearestDepth(d, matrix)) < 0.8) return found;
  const inside = new Float64Array(3);
  for (let e = 0; e < d.m; ++e) for (let i = 0; i + 1 < pointsOf(d, e); ++i) {
    pointOf(d, e, i, point);
    pointOf(d, e, i + 1, place);
    for (let c = 0; c < 3; ++c) point[c] = (point[c] + place[c]) / 2;
    project(matrix, point, inside);
    if (!(inside[2] > 0) || Math.abs(inside[0]) > 1.2 || Math.abs(inside[1]) > 1.2) continue;
    if (radius * pixelsPerUnit(inside[2]) >= 0.8 && isEdgeGrown(d, e)) found.push([e, i, inside[2]]);
  }
  if (found.length > kMostTubes) found.sort((a, b) => a[2] - b[2]).length = kMostTubes;
  return found;
}

function buildTubes(d) {
  const radius = tubeRadius(d), a = [0, 0, 0], b = [0, 0, 0], point = [0, 0, 0];
  const all = d.segments <= kMostTubes, shown = segmentsForTubes(d), vertices = new Set();
  let tubes = 0, joints = 0, balls = 0, halos = 0;
  for (const [e, i] of shown) {
    toScene(view.space, pointOf(d, e, i, point), a, 0);
    toScene(view.space, pointOf(d, e, i + 1, point), b, 0);
    const colour = solidPalette[toneOf(d, e, i)];
    putTube(meshes.tubes, tubes, a, b, radius);
    if (all) putHalo(halos++, a, b, radius);
    paintAt(meshes.tubes, tubes++, colour);
    if (i > 0) {
      putBall(meshes.joints, joints, a, radius * 1.02);
      paintAt(meshes.joints, joints++, colour);
    } else if (!all) vertices.add(d.u[e]);
    if (!all && i + 2 === pointsOf(d, e)) vertices.add(d.v[e]);
  }
  const ball = v => {
    if (balls === kMostTubes || !isGrown(d, v)) return;
    putBall(meshes.balls, balls, toScene(view.space, positionOf(d, v), a, 0), radius * 2.3);
    paintAt(meshes.balls, balls++, view.ballColour);
  };
  if (all) for (let v = 0; v < Math.min(d.n, kMostTubes); ++v) ball(v);
  else vertices.forEach(ball);
  send(meshes.halo, halos);
  send(meshes.tubes, tubes);
  send(meshes.joints, joints);
  send(meshes.balls, balls);
}

/// What is selected, and the edges and places of the violation shown, in the mark's colour.
function buildChosen(d, edges, vertices) {
  const radius = tubeRadius(d) * 1.35, point = [0, 0, 0], a = [0, 0, 0], b = [0, 0, 0];
  let tubes = 0, balls = 0;
  for (const e of edges) for (let i = 0; i + 1 < pointsOf(d, e) && tubes < 512 && balls < 500; ++i) {
    toScene(view.space, pointOf(d, e, i, point), a, 0);
    toScene(view.space, pointOf(d, e, i + 1, point), b, 0);
    putTube(meshes.chosenTubes, tubes++, a, b, radius);
    if (i > 0) putBall(meshes.chosenBalls, balls++, a, radius * 1.02);
  }
  for (const v of vertices) {
    if (balls < 512) putBall(meshes.chosenBalls, balls++, toScene(view.space, positionOf(d, v), a, 0), tubeRadius(d) * 3);
  }
  for (let i = 0; i < 512; ++i) { paintAt(meshes.chosenTubes, i, view.mark); paintAt(meshes.chosenBalls, i, view.mark); }
  send(meshes.chosenTubes, tubes);
  send(meshes.chosenBalls, balls);
}
