// What is under the pointer: vertices before bends before segments, the nearest to the reader of those within reach.

/// Rows x, y, w of the matrix from lattice coordinates (from the low corner) to the picture.
function projectionRows() {
  camera.updateMatrixWorld();
  const e = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
  const back = camera.matrixWorldInverse.elements, {matrix, centre} = view.space;
  const compose = row => {
    const out = [0, 1, 2].map(j => row[0] * matrix[0][j] + row[1] * matrix[1][j] + row[2] * matrix[2][j]);
    out.push(row[3] - out[0] * centre[0] - out[1] * centre[1] - out[2] * centre[2]);
    return out;
  };
  return {x: compose([e[0], e[4], e[8], e[12]]), y: compose([e[1], e[5], e[9], e[13]]),
    depth: compose([-back[2], -back[6], -back[10], -back[14]]), flat: camera === cameras.orthographic};
}

/// Lattice point p in the picture: x and y from -1 to 1, and the depth in the scene (at most 0: behind the reader).
function project(rows, p, out) {
  const of = row => row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
  const depth = of(rows.depth), by = rows.flat ? 1 : depth;
  out[0] = of(rows.x) / by;
  out[1] = of(rows.y) / by;
  out[2] = rows.flat ? Math.max(depth, 1e-9) : depth;
  return out;
}
function toPixels(ndc) {
  return {x: (ndc[0] + 1) / 2 * stage.clientWidth, y: (1 - ndc[1]) / 2 * stage.clientHeight, depth: ndc[2]};
}

function pick(x, y) {
  const d = view.drawing;
  if (!d || !d.n) return null;
  const rows = projectionRows(), width = stage.clientWidth, height = stage.clientHeight, a = new Float64Array(3), b = new Float64Array(3);
  const at = [2 * x / width - 1, 1 - 2 * y / height], point = [0, 0, 0], radius = tubeRadius(d);
  const reach = (depth, factor) => Math.max(7, factor * radius * pixelsPerUnit(depth));
  let best = null, bestCost = Infinity;
  const offer = (cost, make) => { if (cost < bestCost) { bestCost = cost; best = make(); } };
  const away = p => Math.hypot((p[0] - at[0]) * width, (p[1] - at[1]) * height) / 2;
  for (let v = 0; v < d.n; ++v) {
    point[0] = d.x[v]; point[1] = d.y[v]; point[2] = d.z[v];
    project(rows, point, a);
    if (a[2] > 0 && away(a) < reach(a[2], 2.5) && isGrown(d, v)) offer(a[2], () => ({kind: "vertex", vertex: v}));
  }
  if (best) return best;
  for (let e = 0; e < d.m; ++e) {
    const count = pointsOf(d, e);
    project(rows, pointOf(d, e, 0, point), a);
    for (let i = 0; i + 1 < count; ++i) {
      project(rows, pointOf(d, e, i + 1, point), b);
      if (a[2] > 0 && b[2] > 0) {
        const dx = (b[0] - a[0]) * width, dy = (b[1] - a[1]) * height, px = (at[0] - a[0]) * width, py = (at[1] - a[1]) * height;
        const t = Math.min(1, Math.max(0, (px * dx + py * dy) / (dx * dx + dy * dy || 1)));
        const off = Math.hypot(px - t * dx, py - t * dy) / 2, depth = a[2] + t * (b[2] - a[2]);
        if (off < reach(depth, 1.3) && isEdgeGrown(d, e)) {
          const isBend = i + 2 < count && away(b) < reach(b[2], 1.6);
          offer(isBend ? depth - 3 * radius : depth, () => isBend ? {kind: "bend", edge: e, bend: i + 1} : {kind: "edge", edge: e, segment: i});
        }
      }
      a.set(b);
    }
  }
  return best;
}

/// The lattice point (from the low corner) that stands for what is picked.
function placeOf(d, what) {
  if (what.kind === "vertex") return positionOf(d, what.vertex);
  if (what.kind === "bend") return pointOf(d, what.edge, what.bend, [0, 0, 0]);
  const a = pointOf(d, what.edge, what.segment, [0, 0, 0]), b = pointOf(d, what.edge, what.segment + 1, [0, 0, 0]);
  return a.map((c, i) => (c + b[i]) / 2);
}

let pointed = null;
function hover(x, y) {
  const tip = byId("tip"), what = x === undefined ? null : pick(x, y);
  pointed = what;
  tip.hidden = !what;
  if (!what) return;
  tip.textContent = describe(view.drawing, what);
  const box = tip.getBoundingClientRect();
  tip.style.left = Math.max(4, Math.min(x + 14, innerWidth - box.width - 8)) + "px";
  tip.style.top = (y + 18 + box.height > innerHeight ? Math.max(4, y - box.height - 12) : y + 18) + "px";
}
