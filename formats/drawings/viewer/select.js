// What is selected, followed and grown; violations.
import {flyNear, heightSeen} from "./cameras.js";
import {edgesAt, pointAt, pointsOf, positionOf} from "./data.js";
import {describe, withCommas} from "./exact.js";
import {growLayers, vectorInScene} from "./layers.js";
import {placeOf} from "./pick.js";
import {byId, redraw, view} from "./state.js";
import {buildChosen, buildTubes, kMostTubes, tubeRadius} from "./tubes.js";

const hasEdge = what => what !== null && what.edge !== undefined;

export function select(what) {
  view.selected = what;
  byId("selection").hidden = !what;
  if (what) byId("selected").textContent = describe(view.drawing, what);
  byId("follow").hidden = !hasEdge(what);
  showChosen();
}

export function showChosen() {
  const {drawing, selected} = view;
  if (!drawing || !drawing.n) return;
  const edges = new Set(), vertices = new Set();
  if (hasEdge(selected)) edges.add(selected.edge);
  if (selected && selected.kind === "vertex") vertices.add(selected.vertex);
  const violation = drawing.about.verdict.violations[view.violation];
  if (violation) {
    violation.edges.filter(edge => edge < drawing.m).forEach(edge => edges.add(edge));
    violation.vertices.filter(v => v < drawing.n).forEach(v => vertices.add(v));
  }
  buildChosen(drawing, edges, vertices);
  redraw();
}

/// A violation's places, from the low corner: its points, else its vertices, else the middles of its edges.
export function placesOfViolation(drawing, {points, vertices, edges}) {
  const {low} = drawing.about;
  if (points.length) return points.map(point => point.map((c, i) => Number(BigInt(c) - BigInt(low[i]))));
  const known = vertices.filter(v => v < drawing.n);
  if (known.length) return known.map(v => positionOf(drawing, v));
  return edges.filter(edge => edge < drawing.m).map(edge => placeOf(drawing, {kind: "edge", edge, segment: 0}));
}

export function showViolation(number) {
  const {drawing} = view, list = drawing && drawing.n ? drawing.about.verdict.violations : [];
  if (!list.length) return;
  view.violation = (number + list.length) % list.length;
  byId("violation-list").querySelectorAll("button").forEach((button, i) => {
    button.setAttribute("aria-current", i === view.violation);
  });
  showChosen();
  const [place] = placesOfViolation(drawing, list[view.violation]);
  if (place) flyNear(vectorInScene(place), Math.max(26 * tubeRadius(drawing), 0.12));
}

/// Takes the camera along the selected edge from its first end to its last.
export async function followEdge() {
  const {drawing, selected} = view;
  if (!hasEdge(selected)) return;
  const {edge} = selected, height = Math.min(heightSeen(), Math.max(30 * tubeRadius(drawing), 0.3));
  view.followed = edge;
  for (let i = 0; i < pointsOf(drawing, edge); ++i) {
    await flyNear(vectorInScene(pointAt(drawing, edge, i)), height, i === 0 ? 450 : 900);
    if (view.followed !== edge || view.drawing !== drawing) break;
  }
  view.followed = null;
}

/// Selects the vertex that is `by` places further, or the first one.
export function stepVertex(by) {
  const {drawing, selected} = view;
  const next = selected && selected.kind === "vertex" ? selected.vertex + by : 0;
  select({kind: "vertex", vertex: (next + drawing.n) % drawing.n});
}

/// Selects the next edge of the vertex that was selected last.
export function stepEdge() {
  const {drawing, selected} = view;
  if (selected && selected.kind === "vertex") view.steppedVertex = selected.vertex;
  const edges = [...edgesAt(drawing, view.steppedVertex)];
  if (!edges.length) return;
  const at = hasEdge(selected) ? edges.indexOf(selected.edge) : -1;
  select({kind: "edge", edge: edges[(at + 1) % edges.length], segment: 0});
}

/// Shows so many vertices, in the order of growth.
export function grow(count) {
  const {drawing} = view;
  if (!drawing || !drawing.n) return;
  view.grown = Math.min(drawing.n, Math.max(1, Math.round(count)));
  byId("grow").value = view.grown;
  byId("grown").textContent =
    `${withCommas(view.grown)} of ${withCommas(drawing.n)} vertices, in order of ${drawing.about.order.title}`;
  growLayers(drawing);
  if (drawing.segments <= kMostTubes || !view.moving) buildTubes(drawing);
  redraw();
}

/// Grows the drawing in six seconds, or stops that.
let askedGrowth = 0;
export function play() {
  const {drawing} = view;
  if (!drawing || !drawing.n) return;
  if (askedGrowth) {
    cancelAnimationFrame(askedGrowth);
    askedGrowth = 0;
    return;
  }
  const first = view.grown >= drawing.n ? 1 : view.grown, milliseconds = 6000 * (1 - first / drawing.n) + 1;
  let begin = 0;
  const step = now => {
    begin = begin || now;
    const share = Math.min(1, (now - begin) / milliseconds);
    grow(first + share * (drawing.n - first));
    askedGrowth = share < 1 ? requestAnimationFrame(step) : 0;
  };
  askedGrowth = requestAnimationFrame(step);
}
