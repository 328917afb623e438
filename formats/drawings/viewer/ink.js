// What is written over the picture: numbers of vertices, angle arcs, rings about violations.

const ink = byId("ink");

function writeAt(context, at, text) {
  context.lineWidth = 4;
  context.strokeStyle = view.dark ? "#14171cd0" : "#fbfaf7d0";
  context.strokeText(text, at.x, at.y);
  context.fillText(text, at.x, at.y);
}

/// An arc between the directions from `here` to a and to b, on the picture; its label in the middle, if it has one.
function drawArc(context, d, here, a, b, label) {
  const length = p => Math.hypot(...p), metric = view.space.matrix;
  const inScene = to => metric.map(row => row.reduce((sum, c, j) => sum + c * (to[j] - here[j]), 0));
  const u = inScene(a), v = inScene(b), size = Math.max(4.5 * tubeRadius(d), Math.min(0.42 * Math.min(length(u), length(v)), 14 * tubeRadius(d)));
  const one = u.map(c => c / length(u)), two = v.map(c => c / length(v));
  const whole = Math.acos(Math.max(-1, Math.min(1, one.reduce((sum, c, i) => sum + c * two[i], 0)))), sine = Math.sin(whole);
  if (!(sine > 1e-9)) return;
  const origin = toScene(view.space, here, [0, 0, 0], 0), matrix = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  const onArc = t => new THREE.Vector3(...one.map((c, i) => origin[i] + size * (Math.sin((1 - t) * whole) * c + Math.sin(t * whole) * two[i]) / sine)).applyMatrix4(matrix);
  context.beginPath();
  for (let k = 0; k <= 24; ++k) {
    const at = toPixels(onArc(k / 24).toArray());
    if (k === 0) context.moveTo(at.x, at.y); else context.lineTo(at.x, at.y);
  }
  context.lineWidth = 2;
  context.strokeStyle = view.dark ? "#ff6fc1" : "#b0006d";
  context.stroke();
  if (label) writeAt(context, toPixels(onArc(0.5).toArray()), label);
}

function drawAngles(context, rows, d) {
  const what = view.selected;
  if (!what || what.kind === "edge") return;
  const here = [...placeOf(d, what)];
  const others = what.kind === "vertex" ? raysAt(d, what.vertex).map(ray => ray.to)
    : [what.bend - 1, what.bend + 1].map(i => [...pointOf(d, what.edge, i, [0, 0, 0])]);
  const pairs = others.flatMap((a, i) => others.slice(0, i).map(b => [a, b]));
  const labels = pairs.map(([a, b]) => angleBetween(d, primitiveOf(here, a).vector, primitiveOf(here, b).vector).degrees.toFixed(2) + "\u00b0");
  const equal = labels.length > 1 && labels.every(label => label === labels[0]);  // one label for all
  pairs.forEach(([a, b], k) => drawArc(context, d, here, a, b, equal ? "" : labels[k]));
  const at = toPixels(project(rows, here, [0, 0, 0]));
  const label = `${labels.length} \u00d7 ${labels[0]}`, half = context.measureText(label).width / 2 + 4;  // never cut at the sides
  if (equal && at.depth > 0) writeAt(context, {x: Math.max(half, Math.min(stage.clientWidth - half, at.x)), y: at.y + 14 + 3 * tubeRadius(d) * pixelsPerUnit(at.depth)}, label);
}

function drawInk() {
  const d = view.drawing, scale = devicePixelRatio;
  const written = d && d.n && (view.names || view.selected || d.about.verdict.violations.length);
  ink.style.display = written ? "" : "none";
  if (!written) return;
  ink.width = stage.clientWidth * scale;
  ink.height = stage.clientHeight * scale;
  const context = ink.getContext("2d");
  context.scale(scale, scale);
  context.font = "600 12.5px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineJoin = "round";
  context.fillStyle = view.dark ? "#ffffff" : "#101418";
  const rows = projectionRows();
  if (view.names && d.n <= 400) {
    const lift = Math.max(12, 2.5 * tubeRadius(d) * pixelsPerUnit(distance()) + 9);
    for (let v = 0; v < d.n; ++v) {
      const at = toPixels(project(rows, positionOf(d, v), [0, 0, 0]));
      if (at.depth > 0 && isGrown(d, v)) writeAt(context, {x: at.x, y: at.y - lift}, String(v));
    }
  }
  drawAngles(context, rows, d);
  context.strokeStyle = view.dark ? "#ff6fc1" : "#b0006d";
  d.about.verdict.violations.forEach((violation, k) => {
    if (k !== view.violation && d.about.verdict.violations.length > 40) return;
    context.lineWidth = k === view.violation ? 3.5 : 1.5;
    for (const p of placesOfViolation(d, violation)) {
      const at = toPixels(project(rows, p, [0, 0, 0]));
      if (!(at.depth > 0)) continue;
      context.beginPath();
      context.arc(at.x, at.y, k === view.violation ? 17 : 11, 0, 7);
      context.stroke();
    }
  });
}
