// The two cameras, what moves them, and what they cost.

const stage = byId("stage");
const cameras = {perspective: new THREE.PerspectiveCamera(30, 1, 0.001, 100), orthographic: new THREE.OrthographicCamera(-1, 1, 1, -1, -100, 100)};
let camera = cameras.perspective, controls = null;
for (const one of Object.values(cameras)) one.up.set(0, 0, 1);

const lamps = [new THREE.HemisphereLight(0xffffff, 0xa09a90, 1.9), new THREE.DirectionalLight(0xffffff, 2.4), new THREE.DirectionalLight(0xbfd4ff, 0.7)];
for (const lamp of lamps) scene.add(lamp);
scene.add(lamps[1].target, lamps[2].target);

/// The light comes from above and left of the reader, with a weaker one from below.
function aimLamps() {
  const right = new THREE.Vector3().setFromMatrixColumn(camera.matrix, 0), up = new THREE.Vector3().setFromMatrixColumn(camera.matrix, 1);
  const back = new THREE.Vector3().setFromMatrixColumn(camera.matrix, 2);
  lamps[1].position.copy(back).addScaledVector(up, 1.1).addScaledVector(right, -0.8);
  lamps[2].position.copy(back).multiplyScalar(0.4).addScaledVector(up, -1).addScaledVector(right, 1);
}

const distance = () => camera.position.distanceTo(controls.target);
const kHalfAngle = 15 * Math.PI / 180;
/// Height of what is seen at the target, in the scene.
const heightSeen = () => camera === cameras.perspective ? 2 * distance() * Math.tan(kHalfAngle) : (camera.top - camera.bottom) / camera.zoom;
/// Pixels that one unit of the scene takes at a depth. The height is that of the last resize: asking the page for it
/// costs microseconds each time.
const pixelsPerUnit = depth => view.height / (camera === cameras.perspective ? 2 * depth * Math.tan(kHalfAngle) : heightSeen());

function shapeCameras() {
  view.height = stage.clientHeight;
  const width = innerWidth, height = innerHeight, wide = width > 700, open = !byId("panel").hidden;
  const aside = open && wide ? 140 : 0, below = open && !wide ? Math.min(0.23 * height, byId("panel").offsetHeight / 2) : 0;
  cameras.perspective.aspect = width / height;
  const half = cameras.orthographic.top;
  Object.assign(cameras.orthographic, {left: -half * width / height, right: half * width / height});
  for (const one of Object.values(cameras)) {
    one.setViewOffset(width, height, aside, below, width, height);
    one.updateProjectionMatrix();
  }
}

/// Limits of depth, and the fog that shows it.
function shapeDepth() {
  const far = distance(), radius = Math.max(view.space.radius, byId("bound").checked ? view.boundRadius || 0 : 0);
  if (camera === cameras.perspective) Object.assign(camera, {near: Math.max(far / 200, far - 6 * radius), far: far + 6 * radius});
  else Object.assign(camera, {near: far - 8 * radius, far: far + 8 * radius});
  camera.updateProjectionMatrix();
  const seen = Math.min(view.space.radius, 2 * heightSeen());
  shared.near.value = far - 0.2 * seen;
  shared.far.value = far + 2.6 * seen;
  Object.assign(scene.fog, {near: shared.near.value, far: shared.far.value});
}

function useCamera(name) {
  const next = cameras[name];
  if (next === camera) return;
  const height = heightSeen();
  next.position.copy(camera.position);
  if (name === "orthographic") {
    Object.assign(next, {top: height / 2, bottom: -height / 2, zoom: 1});
  } else {
    next.position.sub(controls.target).setLength(height / 2 / Math.tan(kHalfAngle)).add(controls.target);
  }
  camera = controls.object = next;
  shapeCameras();
  controls.update();
  moved();
}

/// Points of the scene that a view must hold: a box, or a sample of the drawing's own points.
function pointsToHold(size) {
  if (size) return Array.from({length: 8}, (_, k) => new THREE.Vector3(...size.map((s, i) => (k >> i & 1 ? 0.5 : -0.5) * s)));
  const d = view.drawing, points = [];
  spreadOver(d.n, v => { points.push(vectorInScene(positionOf(d, v))); return points.length < 2000; });
  if (d.m) spreadOver(d.m, e => {
    for (let i = 1; i + 1 < pointsOf(d, e); ++i) points.push(vectorInScene(pointOf(d, e, i, [0, 0, 0])));
    return points.length < 9000;
  });
  return points;
}

/// A view from a direction in which the drawing, or a box about the origin, just fits beside the controls.
function lookFrom(direction, size) {
  const open = !byId("panel").hidden, wide = innerWidth > 700 && open ? 280 : 0, low = innerWidth <= 700 && open ? 0.44 * innerHeight : 0;
  const tanY = 0.92 * Math.tan(kHalfAngle) * (innerHeight - low - 110) / innerHeight, tanX = 0.92 * Math.tan(kHalfAngle) * (innerWidth - wide - 20) / innerHeight;
  const back = direction.clone().normalize(), right = new THREE.Vector3(0, 0, 1).cross(back).normalize(), up = back.clone().cross(right);
  const points = pointsToHold(size), bounds = axis => {
    const along = points.map(p => p.dot(axis));
    return [along.reduce((a, b) => Math.min(a, b)), along.reduce((a, b) => Math.max(a, b))];
  };
  const [x, y, z] = [right, up, back].map(bounds), middle = ([low, high]) => (low + high) / 2;
  const target = right.clone().multiplyScalar(middle(x)).addScaledVector(up, middle(y)).addScaledVector(back, middle(z));
  let away = 0.02, half = 0.01;
  for (const p of points) {
    p.sub(target);
    const reach = Math.max(Math.abs(p.dot(right)) / tanX, Math.abs(p.dot(up)) / tanY);
    away = Math.max(away, p.dot(back) + reach);
    half = Math.max(half, reach * Math.tan(kHalfAngle));
  }
  return flyTo(target, target.clone().addScaledVector(back, away), half);
}
const kViews = [[0.78, -1, 0.62], [1, 0, 0.0001], [0, -1, 0.0001], [0.0001, -0.0002, 1]].map(v => new THREE.Vector3(...v));

let flight = null;
const noMotion = matchMedia("(prefers-reduced-motion: reduce)");
/// Moves target and camera there; `half` is half the height that the orthographic camera then shows.
function flyTo(target, position, half, milliseconds = 450) {
  flight = {from: [controls.target.clone(), camera.position.clone(), camera.top / camera.zoom], to: [target, position, half],
    begin: performance.now(), milliseconds: noMotion.matches || !view.ready ? 1 : milliseconds};
  return new Promise(done => { flight.done = done; stepFlight(performance.now()); });
}
function stepFlight(now) {
  if (!flight) return;
  const f = flight, t = Math.min(1, Math.max(0, (now - f.begin) / f.milliseconds)), s = t * t * (3 - 2 * t);
  controls.target.lerpVectors(f.from[0], f.to[0], s);
  camera.position.lerpVectors(f.from[1], f.to[1], s);
  if (camera === cameras.orthographic) camera.zoom = camera.top / (f.from[2] + s * (f.to[2] - f.from[2]));
  controls.update();
  moved();
  if (t >= 1) { flight = null; f.done(); } else requestAnimationFrame(stepFlight);
}

/// Looks at a place from where the camera is, near enough to see it.
function flyNear(place, height) {
  const away = camera.position.clone().sub(controls.target).setLength(height / 2 / Math.tan(kHalfAngle));
  return flyTo(place.clone(), place.clone().add(away), height / 2);
}

function turn(right, up) {
  const offset = camera.position.clone().sub(controls.target), away = offset.length();
  const around = Math.atan2(offset.y, offset.x) + right;
  const height = Math.min(1.5, Math.max(-1.5, Math.asin(offset.z / away) + up));
  camera.position.set(Math.cos(around) * Math.cos(height), Math.sin(around) * Math.cos(height), Math.sin(height)).multiplyScalar(away).add(controls.target);
  controls.update();
  moved();
}
function zoom(factor) {
  if (camera === cameras.orthographic) { camera.zoom *= factor; camera.updateProjectionMatrix(); }
  else camera.position.sub(controls.target).divideScalar(factor).add(controls.target);
  controls.update();
  moved();
}
function pan(right, up) {
  const by = new THREE.Vector3().setFromMatrixColumn(camera.matrix, 0).multiplyScalar(right * heightSeen());
  by.addScaledVector(new THREE.Vector3().setFromMatrixColumn(camera.matrix, 1), up * heightSeen());
  camera.position.add(by);
  controls.target.add(by);
  controls.update();
  moved();
}

/// The camera has moved: quick pictures until it rests.
let resting = 0;
function moved() {
  if (!view.moving) view.frames = null;
  view.moving = true;
  clearTimeout(resting);
  resting = setTimeout(rested, 180);
  redraw();
}
function rested() {
  view.moving = false;
  const d = view.drawing;
  if (d && d.n && d.segments > kMostTubes) buildTubes(d);
  redraw();
}
