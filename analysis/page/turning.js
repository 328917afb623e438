// The drawing on the first screen, which turns: lines on a canvas, the nearer ones stronger. Only while it is seen, and not where motion is unwanted.
import {byId, element, firstOf, percent, rowsOf, shortName} from "./values.js";
import {graphOf, graphText, inflated, isDrawn, open, viewerText} from "./graphs.js";

const kShades = 5, kTurn_s = 16, kFrame_ms = 33;

/** Reads naturals and signed numbers as geometry_numbers.cpp writes them. */
const numbersIn = bytes => {
  let next = 0;
  const natural = () => {
    let value = 0, factor = 1, byte;
    do {
      byte = bytes[next++];
      value += (byte & 127) * factor;
      factor *= 128;
    } while (byte > 127);
    return value;
  };
  return {natural, signed: () => {
    const value = natural();
    return value % 2 ? -(value + 1) / 2 : value / 2;
  }};
};

/** F of gram / denominator = F F^T (Cholesky): lattice coordinates times F are those of space. */
const metricOf = (gram, denominator) => {
  const f = [[0, 0, 0], [0, 0, 0], [0, 0, 0]];
  for (let i = 0; i < 3; ++i) for (let j = 0; j <= i; ++j) {
    let sum = gram[i][j] / denominator;
    for (let k = 0; k < j; ++k) sum -= f[i][k] * f[j][k];
    f[i][j] = i === j ? Math.sqrt(sum) : sum / f[j][j];
  }
  return f;
};

/** The polylines of the row's drawing in space, about the middle of its box, in a ball of radius 1; and its vertices. */
const spaceOf = async row => {
  const text = await viewerText(), page = graphOf(row).drawing, part = id => text.split(`id="${id}-${page}">`)[1].split("\u003c/script>")[0];
  const {n, m, extents, gram, gram_denominator: denominator} = JSON.parse(part("about")), metric = metricOf(gram, denominator);
  const numbers = numbersIn(new Uint8Array(await inflated(part("geometry")).arrayBuffer()));
  const step = at => [at[0] + numbers.signed(), at[1] + numbers.signed(), at[2] + numbers.signed()], vertices = [], lines = [];
  for (let v = 0, at = [0, 0, 0]; v < n; ++v) vertices.push(at = step(at));
  for (let edge = 0, u = 0; edge < m; ++edge) {
    u += numbers.signed();
    const v = u + numbers.signed(), bends = numbers.natural(), line = [vertices[u]];
    numbers.natural();  // the role
    for (let i = 0; i < bends; ++i) line.push(step(line.at(-1)));
    lines.push([...line, vertices[v]]);
  }
  const inSpace = point => [0, 1, 2].map(j => [0, 1, 2].reduce((sum, i) => sum + (point[i] - extents[i] / 2) * metric[i][j], 0));
  const all = lines.map(line => line.map(inSpace)), ends = vertices.map(inSpace), radius = Math.max(1e-9, ...[...ends, ...all.flat()].map(point => Math.hypot(...point)));
  const scaled = point => point.map(c => c / radius);
  return {lines: all.map(line => line.map(scaled)), vertices: ends.map(scaled)};
};

const paint = (canvas, {lines, vertices}, angle) => {
  const side = Math.min(canvas.clientWidth, canvas.clientHeight), sharp = devicePixelRatio || 1, context = canvas.getContext("2d"), style = getComputedStyle(canvas);
  canvas.width = canvas.clientWidth * sharp;
  canvas.height = canvas.clientHeight * sharp;
  context.setTransform(sharp, 0, 0, sharp, canvas.width / 2, canvas.height / 2);
  const [c, s] = [Math.cos(angle), Math.sin(angle)], tilt = 0.4, [ct, st] = [Math.cos(tilt), Math.sin(tilt)];
  const seen = ([x, y, z]) => {
    const [a, b] = [x * c - y * s, x * s + y * c], depth = b * ct - z * st, far = 0.49 * side * 3 / (3 + depth);
    return [far * a, -far * (z * ct + b * st), depth];
  };
  const shades = Array.from({length: kShades}, () => []);
  for (const line of lines) {
    const points = line.map(seen);
    for (let i = 1; i < points.length; ++i) {
      const near = (1 - (points[i - 1][2] + points[i][2]) / 2) / 2;
      shades[Math.max(0, Math.min(kShades - 1, Math.floor(near * kShades)))].push([points[i - 1], points[i]]);
    }
  }
  shades.forEach((segments, shade) => {
    context.globalAlpha = 0.35 + 0.65 * shade / (kShades - 1);
    context.strokeStyle = style.color;
    context.lineWidth = 0.6 + 0.9 * shade / (kShades - 1);
    context.beginPath();
    for (const [[x0, y0], [x1, y1]] of segments) {
      context.moveTo(x0, y0);
      context.lineTo(x1, y1);
    }
    context.stroke();
  });
  context.globalAlpha = 1;
  context.fillStyle = style.outlineColor;
  const size = vertices.length > 200 ? 1.4 : 2.4;
  for (const [x, y] of vertices.map(seen)) context.fillRect(x - size / 2, y - size / 2, size, size);
};

/** Of every setting the stored drawing that comes closest to its bound, the closest first. */
const choices = () => {
  const best = new Map();
  for (const row of rowsOf("shares")) if (isDrawn(row.row) && !(best.get(row.setting)?.share >= row.share)) best.set(row.setting, row);
  return [...best.values()].sort((a, b) => b.share - a.share);
};

export const turningPart = () => {
  const those = choices(), place = byId("turning");
  if (!those.length || !firstOf("study").study) return;
  place.hidden = false;
  const canvas = element("canvas", {role: "img", "aria-label": "A drawing in 3D, turning"}), select = element("select", {"aria-label": "Which drawing"},
    those.map((row, i) => element("option", {value: i}, `${shortName(row.setting)} on ${rowsOf("bounds")[row.curve].name}, ${graphText(row.row, graphOf(row.row).n)}: ${percent(row.share)} of the bound`)));
  const button = element("button", {type: "button"}, "Look closer"), still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  place.append(canvas, element("p", {class: "choice"}, select, " ", button));
  let shape = null, angle = 0.6, isSeen = false, last = 0, isWaiting = false;
  const frame = now => {
    isWaiting = false;
    if (!shape || !isSeen) return;
    if (now - last >= kFrame_ms || still) {
      angle += still ? 0 : Math.min(now - last, 100) / 1000 * 2 * Math.PI / kTurn_s;
      last = now;
      paint(canvas, shape, angle);
      canvas.dataset.angle = angle.toFixed(3);
    }
    if (!still) again();
  };
  const again = () => {
    if (!isWaiting) requestAnimationFrame(frame);
    isWaiting = true;
  };
  const show = async () => {
    shape = await spaceOf(those[Number(select.value)].row);
    again();
  };
  select.addEventListener("change", show);
  button.addEventListener("click", () => open(those[Number(select.value)].row));
  canvas.addEventListener("pointermove", event => {
    if (!event.buttons) return;
    angle += event.movementX / 100;
    again();
  });
  new IntersectionObserver(entries => {
    isSeen = entries.at(-1).isIntersecting;
    if (isSeen) again();
  }).observe(canvas);
  show();
};
