// What is selected, followed and grown; violations.

function select(what) {
  view.selected = what;
  const d = view.drawing;
  byId("selection").hidden = !what;
  if (what) byId("selected").textContent = describe(d, what);
  byId("follow").hidden = !what || what.edge === undefined;
  showChosen();
}

function showChosen() {
  const d = view.drawing, what = view.selected, edges = new Set(), vertices = new Set();
  if (!d || !d.n) return;
  if (what && what.edge !== undefined) edges.add(what.edge);
  if (what && what.kind === "vertex") vertices.add(what.vertex);
  const violation = d.about.verdict.violations[view.violation];
  if (violation) {
    violation.edges.filter(e => e < d.m).forEach(e => edges.add(e));
    violation.vertices.filter(v => v < d.n).forEach(v => vertices.add(v));
  }
  buildChosen(d, edges, vertices);
  redraw();
}

/// A violation's places, from the low corner: its points, else its vertices, else the middles of its edges.
function placesOfViolation(d, violation) {
  if (violation.points.length) return violation.points.map(p => p.map((c, i) => Number(BigInt(c) - BigInt(d.about.low[i]))));
  const vertices = violation.vertices.filter(v => v < d.n);
  if (vertices.length) return vertices.map(v => positionOf(d, v));
  return violation.edges.filter(e => e < d.m).map(e => placeOf(d, {kind: "edge", edge: e, segment: 0}));
}

function showViolation(k) {
  const d = view.drawing, list = d && d.n ? d.about.verdict.violations : [];
  if (!list.length) return;
  view.violation = (k + list.length) % list.length;
  [...byId("violation-list").querySelectorAll("button")].forEach((button, i) => button.setAttribute("aria-current", i === view.violation));
  showChosen();
  const places = placesOfViolation(d, list[view.violation]);
  if (places.length) return flyNear(vectorInScene(places[0]), Math.max(26 * tubeRadius(d), 0.12));
}

/// Takes the camera along the selected edge from its first end to its last.
async function followEdge() {
  const d = view.drawing, what = view.selected;
  if (!what || what.edge === undefined) return;
  const height = Math.min(heightSeen(), Math.max(30 * tubeRadius(d), 0.3));
  view.following = what.edge;
  for (let i = 0; i < pointsOf(d, what.edge) && view.following === what.edge && view.drawing === d; ++i) {
    const place = vectorInScene(pointOf(d, what.edge, i, [0, 0, 0]));
    const away = camera.position.clone().sub(controls.target).setLength(height / 2 / Math.tan(kHalfAngle));
    await flyTo(place, place.clone().add(away), height / 2, i === 0 ? 450 : 900);
  }
  view.following = null;
}

/// Selects the vertex that is `by` places further, or the first one.
function stepVertex(by) {
  const d = view.drawing, what = view.selected;
  if (!d || !d.n) return;
  const now = what && what.kind === "vertex" ? what.vertex + by : 0;
  select({kind: "vertex", vertex: (now + d.n) % d.n});
}

/// Selects the next edge of the selected vertex, or of the first end of the selected edge.
function stepEdge() {
  const d = view.drawing, what = view.selected;
  if (!d || !d.m) return;
  const at = what && what.kind === "vertex" ? what.vertex : view.edgesOf !== undefined ? view.edgesOf : 0;
  view.edgesOf = at;
  const edges = [...edgesAt(d, at)];
  if (!edges.length) return;
  const now = what && what.edge !== undefined ? edges.indexOf(what.edge) : -1;
  select({kind: "edge", edge: edges[(now + 1) % edges.length], segment: 0});
}

function grow(count) {
  const d = view.drawing;
  if (!d || !d.n) return;
  view.grown = Math.min(d.n, Math.max(1, Math.round(count)));
  byId("grow").value = view.grown;
  byId("grown").textContent = `${withCommas(view.grown)} of ${withCommas(d.n)} vertices, in order of ${d.about.order.title}`;
  growLayers(d);
  if (d.segments <= kMostTubes || !view.moving) buildTubes(d);
  redraw();
}

let playing = 0;
function play() {
  const d = view.drawing;
  if (!d || !d.n) return;
  if (playing) { cancelAnimationFrame(playing); playing = 0; return; }
  let begin = 0;
  const from = view.grown >= d.n ? 1 : view.grown, milliseconds = 6000 * (1 - from / d.n) + 1;
  const step = now => {
    begin = begin || now;
    const t = Math.min(1, (now - begin) / milliseconds);
    grow(from + t * (d.n - from));
    playing = t < 1 ? requestAnimationFrame(step) : 0;
  };
  playing = requestAnimationFrame(step);
}
