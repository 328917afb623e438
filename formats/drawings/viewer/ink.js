// What is written over the picture: numbers of vertices, angle arcs, rings about violations.
import {distance, pixelsPerUnit} from "./cameras.js";
import {isGrown, pointAt, positionOf} from "./data.js";
import {angleAt, neighboursAt} from "./exact.js";
import {toScene} from "./layers.js";
import {pixelsOf, placeOf, projectionRows, toPixels} from "./pick.js";
import {placesOfViolation} from "./select.js";
import {byId, stage, view} from "./state.js";
import {tubeRadius} from "./tubes.js";

export const ink = byId("ink");
export const kMostNames = 400;  // vertices of a drawing that shows their numbers
const kMostRings = 40;  // violations of a drawing that shows all of them

const markStyle = () => view.dark ? "#ff6fc1" : "#b0006d";

function writeAt(context, at, text) {
  context.lineWidth = 4;
  context.strokeStyle = view.dark ? "#14171cd0" : "#fbfaf7d0";
  context.strokeText(text, at.x, at.y);
  context.fillText(text, at.x, at.y);
}

/// The way between two lattice points in the scene: its length, and its direction.
function wayInScene(from, to) {
  const way = view.space.matrix.map(row => row.reduce((sum, entry, j) => sum + entry * (to[j] - from[j]), 0));
  const length = Math.hypot(...way);
  return {length, direction: way.map(c => c / length)};
}

/// Draws an arc between the ways from `here` to two points, on the picture; its label in the middle, if it has one.
function drawArc(context, drawing, here, [to, other], label) {
  const first = wayInScene(here, to), second = wayInScene(here, other), radius = tubeRadius(drawing);
  const room = Math.min(0.42 * Math.min(first.length, second.length), 14 * radius);
  const size = Math.max(4.5 * radius, room);
  const cosine = first.direction.reduce((sum, c, i) => sum + c * second.direction[i], 0);
  const angle = Math.acos(Math.max(-1, Math.min(1, cosine))), sine = Math.sin(angle);
  if (!(sine > 1e-9)) return;
  const origin = toScene(here, [0, 0, 0]), {camera} = view;
  const toPicture = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  const onArc = share => {
    const a = Math.sin((1 - share) * angle) / sine, b = Math.sin(share * angle) / sine;
    const place = origin.map((c, i) => c + size * (a * first.direction[i] + b * second.direction[i]));
    return toPixels(new THREE.Vector3(...place).applyMatrix4(toPicture).toArray());
  };
  context.beginPath();
  for (let k = 0; k <= 24; ++k) {
    const at = onArc(k / 24);
    context.lineTo(at.x, at.y);
  }
  context.lineWidth = 2;
  context.strokeStyle = markStyle();
  context.stroke();
  if (label) writeAt(context, onArc(0.5), label);
}

function drawAngles(context, rows, drawing) {
  const what = view.selected;
  if (!what || what.kind === "edge") return;
  const here = placeOf(drawing, what);
  const ends = what.kind === "vertex" ? neighboursAt(drawing, what.vertex)
    : [what.bend - 1, what.bend + 1].map(i => pointAt(drawing, what.edge, i));
  const pairs = ends.flatMap((end, i) => ends.slice(0, i).map(earlier => [end, earlier]));
  const labels = pairs.map(pair => angleAt(drawing, here, ...pair).degrees.toFixed(2) + "\u00b0");
  const areEqual = labels.length > 1 && labels.every(label => label === labels[0]);  // one label for all
  pairs.forEach((pair, k) => drawArc(context, drawing, here, pair, areEqual ? "" : labels[k]));
  const at = pixelsOf(rows, here);
  if (!areEqual || !(at.depth > 0)) return;
  const label = `${labels.length} \u00d7 ${labels[0]}`, half = context.measureText(label).width / 2 + 4;
  const x = Math.max(half, Math.min(stage.clientWidth - half, at.x));  // never cut at the sides
  writeAt(context, {x, y: at.y + 14 + 3 * tubeRadius(drawing) * pixelsPerUnit(at.depth)}, label);
}

function writeNames(context, rows, drawing) {
  const lift = Math.max(12, 2.5 * tubeRadius(drawing) * pixelsPerUnit(distance()) + 9);
  for (let v = 0; v < drawing.n; ++v) {
    const {x, y, depth} = pixelsOf(rows, positionOf(drawing, v));
    if (depth > 0 && isGrown(drawing, v)) writeAt(context, {x, y: y - lift}, String(v));
  }
}

function drawRings(context, rows, drawing) {
  const {violations} = drawing.about.verdict;
  context.strokeStyle = markStyle();
  violations.forEach((violation, k) => {
    const isShown = k === view.violation;
    if (!isShown && violations.length > kMostRings) return;
    context.lineWidth = isShown ? 3.5 : 1.5;
    for (const point of placesOfViolation(drawing, violation)) {
      const {x, y, depth} = pixelsOf(rows, point);
      if (!(depth > 0)) continue;
      context.beginPath();
      context.arc(x, y, isShown ? 17 : 11, 0, 7);
      context.stroke();
    }
  });
}

function inkContext() {
  ink.width = stage.clientWidth * devicePixelRatio;
  ink.height = stage.clientHeight * devicePixelRatio;
  const context = ink.getContext("2d");
  context.scale(devicePixelRatio, devicePixelRatio);
  return Object.assign(context, {
    font: "600 12.5px system-ui, sans-serif", textAlign: "center", textBaseline: "middle", lineJoin: "round",
    fillStyle: view.dark ? "#ffffff" : "#101418",
  });
}

export function drawInk() {
  const {drawing} = view;
  const isWritten = drawing && drawing.n && (view.names || view.selected || drawing.about.verdict.violations.length);
  ink.style.display = isWritten ? "" : "none";
  if (!isWritten) return;
  const context = inkContext(), rows = projectionRows();
  if (view.names && drawing.n <= kMostNames) writeNames(context, rows, drawing);
  drawAngles(context, rows, drawing);
  drawRings(context, rows, drawing);
}
