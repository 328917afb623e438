// The two cameras, what moves them, and what they cost.
import {pointAt, pointsOf, positionOf, spreadOver} from "./data.js";
import {scene, sharedUniforms, vectorInScene} from "./layers.js";
import {byId, redraw, stage, view} from "./state.js";
import {buildTubes, kMostTubes} from "./tubes.js";

const kHalfAngle = 15 * Math.PI / 180;  // of what the perspective camera sees
const kHalfTangent = Math.tan(kHalfAngle);
const kNarrow = 700;  // pixels; on a page that is not wider the controls are below, not beside the picture

const cameras = {
  perspective: new THREE.PerspectiveCamera(2 * 15, 1, 0.001, 100),
  orthographic: new THREE.OrthographicCamera(-1, 1, 1, -1, -100, 100),
};
for (const camera of Object.values(cameras)) camera.up.set(0, 0, 1);
view.camera = cameras.perspective;

/// Directions of the views: from a corner and along the axes.
export const kViews = [[0.78, -1, 0.62], [1, 0, 0.0001], [0, -1, 0.0001], [0.0001, -0.0002, 1]]
  .map(direction => new THREE.Vector3(...direction));

const keyLamp = new THREE.DirectionalLight(0xffffff, 2.4), fillLamp = new THREE.DirectionalLight(0xbfd4ff, 0.7);
scene.add(new THREE.HemisphereLight(0xffffff, 0xa09a90, 1.9), keyLamp, fillLamp, keyLamp.target, fillLamp.target);

const cameraAxis = i => new THREE.Vector3().setFromMatrixColumn(view.camera.matrix, i);

/// The light comes from above and left of the reader, with a weaker one from below.
export function aimLamps() {
  const right = cameraAxis(0), up = cameraAxis(1), back = cameraAxis(2);
  keyLamp.position.copy(back).addScaledVector(up, 1.1).addScaledVector(right, -0.8);
  fillLamp.position.copy(back).multiplyScalar(0.4).addScaledVector(up, -1).addScaledVector(right, 1);
}

export const isPerspective = () => view.camera === cameras.perspective;
export const distance = () => view.camera.position.distanceTo(view.controls.target);
export const fromTarget = () => view.camera.position.clone().sub(view.controls.target);

/// Height of what is seen at the target, in the scene.
export function heightSeen() {
  if (isPerspective()) return 2 * distance() * kHalfTangent;
  return (view.camera.top - view.camera.bottom) / view.camera.zoom;
}

/// Pixels that one unit of the scene takes at a depth. The height is that of the last resize: asking the page for it
/// costs microseconds each time.
export function pixelsPerUnit(depth) {
  return view.height / (isPerspective() ? 2 * depth * kHalfTangent : heightSeen());
}

/// Pixels that the open controls take: at the right, at the left (apps/play), or below.
function roomOfControls() {
  const isWide = innerWidth > kNarrow, [panel, source] = ["panel", "source"].map(id => byId(id)).map(controls => ({
    width: controls && !controls.hidden ? controls.offsetWidth + 16 : 0,
    height: controls && !controls.hidden ? controls.offsetHeight : 0,
  }));
  if (!isWide) return {right: 0, left: 0, below: Math.max(panel.height, source.height)};
  return {right: panel.width, left: source.width, below: 0};
}

export function shapeCameras() {
  view.height = stage.clientHeight;
  const width = innerWidth, height = innerHeight, {right, left, below} = roomOfControls();
  const lift = Math.min(0.23 * height, below / 2);
  cameras.perspective.aspect = width / height;
  const half = cameras.orthographic.top * width / height;
  Object.assign(cameras.orthographic, {left: -half, right: half});
  for (const camera of Object.values(cameras)) {
    camera.setViewOffset(width, height, (right - left) / 2, lift, width, height);
    camera.updateProjectionMatrix();
  }
}

/// Limits of depth, and the fog that shows it.
export function shapeDepth() {
  const {camera, space} = view, away = distance();
  const radius = Math.max(space.radius, byId("bound").checked ? view.boundRadius : 0);
  camera.near = isPerspective() ? Math.max(away / 200, away - 6 * radius) : away - 8 * radius;
  camera.far = away + (isPerspective() ? 6 : 8) * radius;
  camera.updateProjectionMatrix();
  const seen = Math.min(space.radius, 2 * heightSeen());
  const near = away - 0.2 * seen, far = away + 2.6 * seen;
  sharedUniforms.near.value = near;
  sharedUniforms.far.value = far;
  Object.assign(scene.fog, {near, far});
}

export function useCamera(name) {
  const next = cameras[name];
  if (next === view.camera) return;
  const height = heightSeen();
  next.position.copy(view.camera.position);
  if (name === "orthographic") {
    Object.assign(next, {top: height / 2, bottom: -height / 2, zoom: 1});
  } else {
    next.position.sub(view.controls.target).setLength(height / 2 / kHalfTangent).add(view.controls.target);
  }
  view.camera = view.controls.object = next;
  shapeCameras();
  view.controls.update();
  moved();
}

/// Points of the scene that a view must hold: a box, or a sample of the drawing's own points.
function pointsToHold(size) {
  if (size) {
    const corner = k => size.map((side, i) => (k >> i & 1 ? 0.5 : -0.5) * side);
    return Array.from({length: 8}, (_, k) => new THREE.Vector3(...corner(k)));
  }
  const {drawing} = view, points = [];
  spreadOver(drawing.n, v => {
    points.push(vectorInScene(positionOf(drawing, v)));
    return points.length < 2000;
  });
  spreadOver(drawing.m, edge => {
    for (let i = 1; i + 1 < pointsOf(drawing, edge); ++i) points.push(vectorInScene(pointAt(drawing, edge, i)));
    return points.length < 9000;
  });
  return points;
}

/// Shares of a distance that the camera sees to the side and upwards, beside the controls and with a rim.
function tangentsSeen() {
  const {right, left, below} = roomOfControls(), lost = below ? 0.44 * innerHeight : 0;
  const perPixel = 0.92 * kHalfTangent / innerHeight;
  return {x: perPixel * (innerWidth - right - left - 20), y: perPixel * (innerHeight - lost - 110)};
}

/// A view from a direction in which the drawing, or a box about the origin, just fits beside the controls.
export function lookFrom(direction, size) {
  const back = direction.clone().normalize();
  const right = new THREE.Vector3(0, 0, 1).cross(back).normalize(), up = back.clone().cross(right);
  const points = pointsToHold(size), tangents = tangentsSeen();
  const target = new THREE.Vector3();
  for (const axis of [right, up, back]) {
    const along = points.map(point => point.dot(axis));
    const low = along.reduce((a, b) => Math.min(a, b)), high = along.reduce((a, b) => Math.max(a, b));
    target.addScaledVector(axis, (low + high) / 2);
  }
  let away = 0.02, half = 0.01;
  for (const point of points) {
    point.sub(target);
    const reach = Math.max(Math.abs(point.dot(right)) / tangents.x, Math.abs(point.dot(up)) / tangents.y);
    away = Math.max(away, point.dot(back) + reach);
    half = Math.max(half, reach * kHalfTangent);
  }
  return flyTo(target, target.clone().addScaledVector(back, away), half);
}

const noMotion = matchMedia("(prefers-reduced-motion: reduce)");

/// Moves target and camera there; `half` is half the height that the orthographic camera then shows.
function flyTo(target, position, half, milliseconds = 450) {
  const {camera, controls} = view;
  return new Promise(done => {
    view.flight = {
      from: {target: controls.target.clone(), position: camera.position.clone(), half: camera.top / camera.zoom},
      to: {target, position, half},
      begin: performance.now(),
      milliseconds: noMotion.matches || !view.ready ? 1 : milliseconds,
      done,
    };
    stepFlight(performance.now());
  });
}
function stepFlight(now) {
  if (!view.flight) return;
  const {flight, camera, controls} = view, {from, to} = flight;
  const time = Math.min(1, Math.max(0, (now - flight.begin) / flight.milliseconds));
  const share = time * time * (3 - 2 * time);
  controls.target.lerpVectors(from.target, to.target, share);
  camera.position.lerpVectors(from.position, to.position, share);
  if (!isPerspective()) camera.zoom = camera.top / (from.half + share * (to.half - from.half));
  controls.update();
  moved();
  if (time < 1) {
    requestAnimationFrame(stepFlight);
  } else {
    view.flight = null;
    flight.done();
  }
}

/// Looks at a place from where the camera is, near enough to see `height` of the scene.
export function flyNear(place, height, milliseconds) {
  const away = fromTarget().setLength(height / 2 / kHalfTangent);
  return flyTo(place.clone(), place.clone().add(away), height / 2, milliseconds);
}

export function turn(right, up) {
  const offset = fromTarget(), away = offset.length();
  const around = Math.atan2(offset.y, offset.x) + right;
  const height = Math.min(1.5, Math.max(-1.5, Math.asin(offset.z / away) + up)), flat = Math.cos(height);
  view.camera.position.set(Math.cos(around) * flat, Math.sin(around) * flat, Math.sin(height));
  view.camera.position.multiplyScalar(away).add(view.controls.target);
  view.controls.update();
  moved();
}
export function zoom(factor) {
  if (isPerspective()) {
    view.camera.position.sub(view.controls.target).divideScalar(factor).add(view.controls.target);
  } else {
    view.camera.zoom *= factor;
    view.camera.updateProjectionMatrix();
  }
  view.controls.update();
  moved();
}
/// @param right,up  shares of the height seen.
export function pan(right, up) {
  const by = cameraAxis(0).multiplyScalar(right * heightSeen()).addScaledVector(cameraAxis(1), up * heightSeen());
  view.camera.position.add(by);
  view.controls.target.add(by);
  view.controls.update();
  moved();
}

/// The camera has moved: quick pictures until it rests.
let restTimer = 0;
export function moved() {
  if (!view.moving) view.frames = null;
  view.moving = true;
  clearTimeout(restTimer);
  restTimer = setTimeout(rest, 180);
  redraw();
}
function rest() {
  view.moving = false;
  const {drawing} = view;
  if (drawing && drawing.segments > kMostTubes) buildTubes(drawing);
  redraw();
}
