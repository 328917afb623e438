// From the page's texts to arrays. Coordinates count from the low corner of the drawing's box, so that they are exact.
import {byId, view} from "./state.js";

export const factsOfPage = page => JSON.parse(byId("about-" + page).textContent);

export function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const kPiece = 1 << 22;
  const padding = text.endsWith("==") ? 2 : text.endsWith("=") ? 1 : 0;
  const bytes = new Uint8Array(text.length / 4 * 3 - padding);
  for (let begin = 0, to = 0; begin < text.length; begin += kPiece) {
    const binary = atob(text.slice(begin, begin + kPiece));
    for (let i = 0; i < binary.length; ++i) bytes[to++] = binary.charCodeAt(i);
  }
  return bytes;
}

export async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/// Reads the numbers of geometry_numbers.cpp one after the other.
class NumberReader {
  constructor(bytes) {
    this.bytes = bytes;
    this.next = 0;
  }
  natural() {
    let byte = this.bytes[this.next++];
    if (byte < 128) return byte;
    let value = byte & 127, factor = 128;
    do {
      byte = this.bytes[this.next++];
      value += (byte & 127) * factor;
      factor *= 128;
    } while (byte > 127);
    return value;
  }
  signed() {
    const value = this.natural();
    return value % 2 ? -(value + 1) / 2 : value / 2;
  }
}

/// A drawing without its geometry. Vertices are at x, y, z; edges have ends u, v and a role; the bends of an edge from
/// u to v are firstBend[edge] to firstBend[edge + 1] in bendX, bendY, bendZ. The rest is made when first asked for.
function emptyDrawing(facts) {
  const {n, m, bends} = facts;
  const Numbers = Math.max(...facts.extents) < 2 ** 31 ? Int32Array : Float64Array;
  return {
    about: facts, n, m, segments: bends + m,
    x: new Numbers(n), y: new Numbers(n), z: new Numbers(n),
    u: new Uint32Array(m), v: new Uint32Array(m), role: new Uint8Array(m),
    firstBend: new Uint32Array(m + 1), bendX: new Numbers(bends), bendY: new Numbers(bends), bendZ: new Numbers(bends),
    ranks: null,  // see growthRanks
    incidence: null,  // see edgesAt
    directions: null,  // see directionClasses in layers.js
  };
}

export function decoded(facts, bytes) {
  const drawing = emptyDrawing(facts), numbers = new NumberReader(bytes);
  let x = 0, y = 0, z = 0;
  for (let v = 0; v < drawing.n; ++v) {
    drawing.x[v] = x += numbers.signed();
    drawing.y[v] = y += numbers.signed();
    drawing.z[v] = z += numbers.signed();
  }
  let u = 0, bend = 0;
  for (let edge = 0; edge < drawing.m; ++edge) {
    drawing.u[edge] = u += numbers.signed();
    drawing.v[edge] = u + numbers.signed();
    const count = numbers.natural();
    drawing.role[edge] = numbers.natural();
    x = drawing.x[u];
    y = drawing.y[u];
    z = drawing.z[u];
    for (let i = 0; i < count; ++i, ++bend) {
      drawing.bendX[bend] = x += numbers.signed();
      drawing.bendY[bend] = y += numbers.signed();
      drawing.bendZ[bend] = z += numbers.signed();
    }
    drawing.firstBend[edge + 1] = bend;
  }
  return drawing;
}

/// The texts of one drawing as arrays; without vertices, edges and segments if the graph was not drawn.
export async function loadDrawing(page) {
  const facts = factsOfPage(page);
  if (facts.error !== undefined) return {about: facts, n: 0, m: 0, segments: 0};
  return decoded(facts, await inflated(bytesOfBase64(byId("geometry-" + page).textContent)));
}

export const pointsOf = (drawing, edge) => drawing.firstBend[edge + 1] - drawing.firstBend[edge] + 2;
export const positionOf = (drawing, v) => [drawing.x[v], drawing.y[v], drawing.z[v]];

/// Point i of an edge on its way from u to v, in out[0..2].
export function pointOf(drawing, edge, i, out) {
  const bends = drawing.firstBend[edge + 1] - drawing.firstBend[edge];
  if (i === 0 || i > bends) {
    const end = i === 0 ? drawing.u[edge] : drawing.v[edge];
    out[0] = drawing.x[end];
    out[1] = drawing.y[end];
    out[2] = drawing.z[end];
  } else {
    const bend = drawing.firstBend[edge] + i - 1;
    out[0] = drawing.bendX[bend];
    out[1] = drawing.bendY[bend];
    out[2] = drawing.bendZ[bend];
  }
  return out;
}
export const pointAt = (drawing, edge, i) => pointOf(drawing, edge, i, [0, 0, 0]);

/// For each vertex its place in the order of growth, from 1.
export function growthRanks(drawing) {
  if (drawing.ranks) return drawing.ranks;
  const [a, b, c] = drawing.about.order.weights;
  const order = Uint32Array.from({length: drawing.n}, (_, v) => v);
  if (a || b || c) {
    const key = Float64Array.from(order, v => a * drawing.x[v] + b * drawing.y[v] + c * drawing.z[v]);
    order.sort((v, w) => key[v] - key[w] || v - w);
  }
  drawing.ranks = new Uint32Array(drawing.n);
  order.forEach((v, place) => { drawing.ranks[v] = place + 1; });
  return drawing.ranks;
}
export const isGrown = (drawing, v) => view.grown >= drawing.n || growthRanks(drawing)[v] <= view.grown;
export const isEdgeGrown = (drawing, edge) => isGrown(drawing, drawing.u[edge]) && isGrown(drawing, drawing.v[edge]);

/// The edges at each vertex: those of v are edges[first[v]] to edges[first[v + 1]].
function incidenceOf(drawing) {
  if (drawing.incidence) return drawing.incidence;
  const first = new Uint32Array(drawing.n + 2), edges = new Uint32Array(2 * drawing.m);
  for (let edge = 0; edge < drawing.m; ++edge) {
    ++first[drawing.u[edge] + 2];
    ++first[drawing.v[edge] + 2];
  }
  for (let v = 2; v < drawing.n + 2; ++v) first[v] += first[v - 1];
  for (let edge = 0; edge < drawing.m; ++edge) {
    edges[first[drawing.u[edge] + 1]++] = edge;
    edges[first[drawing.v[edge] + 1]++] = edge;
  }
  drawing.incidence = {first, edges};
  return drawing.incidence;
}
export function edgesAt(drawing, v) {
  const {first, edges} = incidenceOf(drawing);
  return edges.subarray(first[v], first[v + 1]);
}

/// Visits 0 ... count - 1, until `visit` says false, in an order every beginning of which is spread evenly.
export function spreadOver(count, visit) {
  const divisor = (a, b) => b ? divisor(b, a % b) : a;
  let step = Math.max(1, Math.floor(count * 0.618));
  while (divisor(step, count) > 1) ++step;
  for (let visited = 0, at = 0; visited < count; ++visited, at = (at + step) % count) {
    if (visit(at) === false) return;
  }
}
