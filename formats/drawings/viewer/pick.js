// What is under the pointer: vertices before bends before segments, the nearest to the reader of those within reach.
import {isPerspective, pixelsPerUnit} from "./cameras.js";
import {isEdgeGrown, isGrown, pointAt, pointOf, pointsOf, positionOf} from "./data.js";
import {describe} from "./exact.js";
import {byId, stage, view} from "./state.js";
import {tubeRadius} from "./tubes.js";

/// From lattice coordinates (from the low corner) to the picture: rows for x, y and depth, each to be applied to a
/// point and 1.
export function projectionRows() {
  const {camera, space: {matrix, centre}} = view;
  camera.updateMatrixWorld();
  const toPicture = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
  const toCamera = camera.matrixWorldInverse.elements;
  const compose = (elements, row, sign) => {
    const [a, b, c, d] = [0, 4, 8, 12].map(column => sign * elements[column + row]);
    const out = [0, 1, 2].map(j => a * matrix[0][j] + b * matrix[1][j] + c * matrix[2][j]);
    return [...out, d - out[0] * centre[0] - out[1] * centre[1] - out[2] * centre[2]];
  };
  return {
    x: compose(toPicture, 0, 1), y: compose(toPicture, 1, 1), depth: compose(toCamera, 2, -1), isFlat: !isPerspective(),
  };
}

const applied = (row, point) => row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + row[3];

/// A lattice point in the picture: x and y from -1 to 1, and the depth in the scene (at most 0: behind the reader).
export function project(rows, point, out) {
  const depth = applied(rows.depth, point), by = rows.isFlat ? 1 : depth;
  out[0] = applied(rows.x, point) / by;
  out[1] = applied(rows.y, point) / by;
  out[2] = rows.isFlat ? Math.max(depth, 1e-9) : depth;
  return out;
}
export function toPixels([x, y, depth]) {
  return {x: (x + 1) / 2 * stage.clientWidth, y: (1 - y) / 2 * stage.clientHeight, depth};
}
export const pixelsOf = (rows, point) => toPixels(project(rows, point, [0, 0, 0]));

/// The search for what is nearest to a place of the page.
class Search {
  constructor(drawing, pageX, pageY) {
    this.drawing = drawing;
    this.width = stage.clientWidth;
    this.height = stage.clientHeight;
    this.x = 2 * pageX / this.width - 1;
    this.y = 1 - 2 * pageY / this.height;
    this.radius = tubeRadius(drawing);
    this.rows = projectionRows();
    this.best = null;
    this.bestDepth = Infinity;
  }
  /// Pixels within which something counts whose radius is `factor` times that of a tube.
  reach(depth, factor) {
    return Math.max(7, factor * this.radius * pixelsPerUnit(depth));
  }
  pixelsTo([x, y]) {
    return Math.hypot((x - this.x) * this.width, (y - this.y) * this.height) / 2;
  }
  offer(depth, what) {
    if (depth >= this.bestDepth) return;
    this.bestDepth = depth;
    this.best = what;
  }
  offerVertices() {
    const point = [0, 0, 0], seen = new Float64Array(3), {drawing} = this;
    for (let v = 0; v < drawing.n; ++v) {
      point[0] = drawing.x[v];
      point[1] = drawing.y[v];
      point[2] = drawing.z[v];
      project(this.rows, point, seen);
      const depth = seen[2];
      if (depth > 0 && this.pixelsTo(seen) < this.reach(depth, 2.5) && isGrown(drawing, v)) {
        this.offer(depth, {kind: "vertex", vertex: v});
      }
    }
  }
  offerEdges() {
    const point = [0, 0, 0], from = new Float64Array(3), to = new Float64Array(3), {drawing} = this;
    for (let edge = 0; edge < drawing.m; ++edge) {
      project(this.rows, pointOf(drawing, edge, 0, point), from);
      for (let segment = 0; segment + 1 < pointsOf(drawing, edge); ++segment) {
        project(this.rows, pointOf(drawing, edge, segment + 1, point), to);
        if (from[2] > 0 && to[2] > 0) this.offerSegment(edge, segment, from, to);
        from.set(to);
      }
    }
  }
  offerSegment(edge, segment, from, to) {
    const alongX = (to[0] - from[0]) * this.width, alongY = (to[1] - from[1]) * this.height;
    const awayX = (this.x - from[0]) * this.width, awayY = (this.y - from[1]) * this.height;
    const square = alongX * alongX + alongY * alongY || 1;
    const share = Math.min(1, Math.max(0, (awayX * alongX + awayY * alongY) / square));
    const pixels = Math.hypot(awayX - share * alongX, awayY - share * alongY) / 2;
    const depth = from[2] + share * (to[2] - from[2]);
    if (pixels >= this.reach(depth, 1.3) || !isEdgeGrown(this.drawing, edge)) return;
    const hasBend = segment + 2 < pointsOf(this.drawing, edge);
    if (hasBend && this.pixelsTo(to) < this.reach(to[2], 1.6)) {
      this.offer(depth - 3 * this.radius, {kind: "bend", edge, bend: segment + 1});
    } else {
      this.offer(depth, {kind: "edge", edge, segment});
    }
  }
}

/// What is there: {kind: "vertex", vertex}, {kind: "bend", edge, bend}, {kind: "edge", edge, segment} or null.
export function pick(pageX, pageY) {
  const {drawing} = view;
  if (!drawing || !drawing.n) return null;
  const search = new Search(drawing, pageX, pageY);
  search.offerVertices();
  if (!search.best) search.offerEdges();
  return search.best;
}

/// The lattice point (from the low corner) that stands for what is picked.
export function placeOf(drawing, what) {
  if (what.kind === "vertex") return positionOf(drawing, what.vertex);
  if (what.kind === "bend") return pointAt(drawing, what.edge, what.bend);
  const from = pointAt(drawing, what.edge, what.segment), to = pointAt(drawing, what.edge, what.segment + 1);
  return from.map((c, i) => (c + to[i]) / 2);
}

/// Says what is there, or hides what was said if no place is given.
export function hover(pageX, pageY) {
  const tip = byId("tip"), what = pageX === undefined ? null : pick(pageX, pageY);
  tip.hidden = !what;
  if (!what) return;
  tip.textContent = describe(view.drawing, what);
  const {width, height} = tip.getBoundingClientRect();
  const isLow = pageY + 18 + height > innerHeight;
  tip.style.left = Math.max(4, Math.min(pageX + 14, innerWidth - width - 8)) + "px";
  tip.style.top = (isLow ? Math.max(4, pageY - height - 12) : pageY + 18) + "px";
}
