// Exact coordinates and angles, as texts.

const minus = text => text.replace(/-/g, "\u2212");
const gcd = (a, b) => { while (b) [a, b] = [b, a % b]; return a < 0n ? -a : a; };

/// "(x, y, z)" in the drawing's own coordinates, exact to the last digit.
const coordinates = (d, p) => minus("(" + p.map((c, i) => String(BigInt(c) + BigInt(d.about.low[i]))).join(", ") + ")");

/// Differences as BigInt, divided by their common divisor, and that divisor.
function primitiveOf(from, to) {
  const parts = from.map((c, i) => BigInt(to[i]) - BigInt(c));
  const common = parts.reduce(gcd, 0n) || 1n;
  return {vector: parts.map(c => c / common), times: common};
}

function inner(d, a, b) {
  const gram = d.about.gram;
  let sum = 0n;
  for (let i = 0; i < 3; ++i) for (let j = 0; j < 3; ++j) sum += a[i] * BigInt(gram[i][j]) * b[j];
  return sum;
}

function root(value) {
  if (value < 2n) return value;
  let r = BigInt(Math.floor(Math.sqrt(Number(value))));
  while (r * r > value) --r;
  while ((r + 1n) * (r + 1n) <= value) ++r;
  return r;
}

/// The angle between two vectors in the drawing's metric: {degrees, text}, where text gives the cosine exactly.
function angleBetween(d, a, b) {
  const product = inner(d, a, b), squares = inner(d, a, a) * inner(d, b, b);
  if (squares === 0n) return {degrees: NaN, text: "no angle: a segment of length 0"};
  let top = product * product, bottom = squares;
  const common = gcd(top, bottom) || 1n;
  top /= common; bottom /= common;
  const sign = product < 0n ? "-" : "", p = root(top), q = root(bottom);
  const cosine = Math.sign(Number(product)) * Math.sqrt(Number(top) / Number(bottom));
  const degrees = Math.acos(Math.min(1, Math.max(-1, cosine))) * 180 / Math.PI;
  const fraction = p * p === top && q * q === bottom ? (q === 1n ? `${p}` : `${p}/${q}`) : `\u221a(${top}/${bottom})`;
  return {degrees, text: minus(`${degrees.toFixed(2)}\u00b0 (cos = ${sign}${fraction})`)};
}

const lengthOf = (d, a) => Math.sqrt(Number(inner(d, a, a)) / d.about.gram_denominator);

/// The points of edge e as arrays of three numbers.
function polyline(d, e) {
  return Array.from({length: pointsOf(d, e)}, (_, i) => [...pointOf(d, e, i, [0, 0, 0])]);
}
const positionOf = (d, v) => [d.x[v], d.y[v], d.z[v]];

/// The first segments at a vertex: [{edge, to}], `to` the next point on the edge.
function raysAt(d, v) {
  return [...edgesAt(d, v)].map(e => {
    const points = polyline(d, e);
    return {edge: e, to: d.u[e] === v ? points[1] : points[points.length - 2]};
  });
}

/// What hovering and selecting say; see pick.js for the kinds.
function describe(d, what) {
  const lines = [];
  if (what.kind === "vertex") {
    const here = positionOf(d, what.vertex), rays = raysAt(d, what.vertex);
    lines.push(`vertex ${what.vertex} at ${coordinates(d, here)}`, `degree ${rays.length}`);
    const counts = new Map();
    for (let i = 0; i < rays.length; ++i) for (let j = 0; j < i; ++j) {
      const {text} = angleBetween(d, primitiveOf(here, rays[i].to).vector, primitiveOf(here, rays[j].to).vector);
      counts.set(text, (counts.get(text) || 0) + 1);
    }
    for (const [text, count] of counts) lines.push(count > 1 ? `${count} angles of ${text}` : `angle ${text}`);
  } else {
    const e = what.edge, points = polyline(d, e), bends = points.length - 2;
    const name = `edge ${d.u[e]}\u2013${d.v[e]}`;
    if (what.kind === "bend") {
      const b = what.bend, p = points[b];
      lines.push(`bend ${b} of ${bends} of ${name}`, `at ${coordinates(d, p)}`);
      lines.push("angle " + angleBetween(d, primitiveOf(p, points[b - 1]).vector, primitiveOf(p, points[b + 1]).vector).text);
    } else {
      lines.push(`${name} (number ${e}): ${bends === 1 ? "1 bend" : bends + " bends"}`);
      if (d.about.roles.title) lines.push(d.about.roles.list[d.role[e]].name);
      const {vector, times} = primitiveOf(points[what.segment], points[what.segment + 1]);
      lines.push(minus(`segment ${what.segment + 1} of ${bends + 1}: ${times} \u00d7 (${vector.join(", ")})`));
      const length = lengthOf(d, vector) * Number(times);
      lines.push(`length ${length.toPrecision(6)}, from u to v`);
    }
  }
  return lines.join("\n");
}
