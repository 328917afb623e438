// Exact coordinates and angles, as texts.
import {edgesAt, pointAt, pointsOf, positionOf} from "./data.js";

export const withMinus = text => text.replace(/-/g, "\u2212");
export const withCommas = number => String(number).replace(/\B(?=(\d{3})+$)/g, ",");

function commonDivisor(a, b) {
  while (b) [a, b] = [b, a % b];
  return a < 0n ? -a : a;
}

/// "(x, y, z)" in the drawing's own coordinates, exact to the last digit.
function coordinateText(drawing, point) {
  const own = point.map((c, i) => String(BigInt(c) + BigInt(drawing.about.low[i])));
  return withMinus(`(${own.join(", ")})`);
}

/// Differences as BigInt, divided by their common divisor, and that divisor.
function primitiveOf(from, to) {
  const parts = from.map((c, i) => BigInt(to[i]) - BigInt(c));
  const times = parts.reduce(commonDivisor, 0n) || 1n;
  return {vector: parts.map(c => c / times), times};
}

function innerProduct(drawing, a, b) {
  let sum = 0n;
  drawing.about.gram.forEach((row, i) => row.forEach((entry, j) => { sum += a[i] * BigInt(entry) * b[j]; }));
  return sum;
}

function floorOfRoot(value) {
  if (value < 2n) return value;
  let root = BigInt(Math.floor(Math.sqrt(Number(value))));
  while (root * root > value) --root;
  while ((root + 1n) * (root + 1n) <= value) ++root;
  return root;
}

/// The text of sqrt(top / bottom), a fraction in lowest terms.
function rootText(top, bottom) {
  const topRoot = floorOfRoot(top), bottomRoot = floorOfRoot(bottom);
  if (topRoot * topRoot !== top || bottomRoot * bottomRoot !== bottom) return `\u221a(${top}/${bottom})`;
  return bottomRoot === 1n ? `${topRoot}` : `${topRoot}/${bottomRoot}`;
}

/// The angle at `here` between the ways to two points, in the drawing's metric: {degrees, text}; the text gives the
/// cosine exactly.
export function angleAt(drawing, here, to, other) {
  const a = primitiveOf(here, to).vector, b = primitiveOf(here, other).vector;
  const product = innerProduct(drawing, a, b);
  const squares = innerProduct(drawing, a, a) * innerProduct(drawing, b, b);
  if (squares === 0n) return {degrees: NaN, text: "no angle: a segment of length 0"};
  const common = commonDivisor(product * product, squares) || 1n;
  const top = product * product / common, bottom = squares / common;
  const cosine = Math.sign(Number(product)) * Math.sqrt(Number(top) / Number(bottom));
  const degrees = Math.acos(Math.min(1, Math.max(-1, cosine))) * 180 / Math.PI;
  const sign = product < 0n ? "-" : "";
  return {degrees, text: withMinus(`${degrees.toFixed(2)}\u00b0 (cos = ${sign}${rootText(top, bottom)})`)};
}

/// The next points on the edges at a vertex.
export function neighboursAt(drawing, v) {
  return [...edgesAt(drawing, v)].map(
    edge => pointAt(drawing, edge, drawing.u[edge] === v ? 1 : pointsOf(drawing, edge) - 2));
}

/// Its number, and its name if the graph's file had names.
function nameOf(drawing, v) {
  const {names} = drawing.about;
  return names ? `${v} \u201c${names[v].slice(0, 60)}\u201d` : `${v}`;
}

function describeVertex(drawing, v) {
  const here = positionOf(drawing, v), ends = neighboursAt(drawing, v), counts = new Map();
  ends.forEach((end, i) => ends.slice(0, i).forEach(earlier => {
    const {text} = angleAt(drawing, here, end, earlier);
    counts.set(text, (counts.get(text) || 0) + 1);
  }));
  const angles = [...counts].map(([text, count]) => count > 1 ? `${count} angles of ${text}` : `angle ${text}`);
  return [`vertex ${nameOf(drawing, v)} at ${coordinateText(drawing, here)}`, `degree ${ends.length}`, ...angles];
}

const edgeName = (drawing, edge) => `edge ${nameOf(drawing, drawing.u[edge])}\u2013${nameOf(drawing, drawing.v[edge])}`;

function describeBend(drawing, {edge, bend}) {
  const [before, here, behind] = [bend - 1, bend, bend + 1].map(i => pointAt(drawing, edge, i));
  return [`bend ${bend} of ${pointsOf(drawing, edge) - 2} of ${edgeName(drawing, edge)}`,
    `at ${coordinateText(drawing, here)}`, `angle ${angleAt(drawing, here, before, behind).text}`];
}

function describeEdge(drawing, {edge, segment}) {
  const bends = pointsOf(drawing, edge) - 2, {roles} = drawing.about;
  const lines = [`${edgeName(drawing, edge)} (number ${edge}): ${bends === 1 ? "1 bend" : bends + " bends"}`];
  if (roles.title) lines.push(roles.list[drawing.role[edge]].name);
  const {vector, times} = primitiveOf(pointAt(drawing, edge, segment), pointAt(drawing, edge, segment + 1));
  const square = Number(innerProduct(drawing, vector, vector)) / drawing.about.gram_denominator;
  lines.push(withMinus(`segment ${segment + 1} of ${bends + 1}: ${times} \u00d7 (${vector.join(", ")})`));
  lines.push(`length ${(Math.sqrt(square) * Number(times)).toPrecision(6)}, from u to v`);
  return lines;
}

/// What hovering and selecting say; see pick.js for the kinds.
export function describe(drawing, what) {
  const lines = what.kind === "vertex" ? describeVertex(drawing, what.vertex)
    : what.kind === "bend" ? describeBend(drawing, what) : describeEdge(drawing, what);
  return lines.join("\n");
}
