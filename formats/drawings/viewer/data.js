// From the page's texts to arrays. Coordinates count from the low corner of the drawing's box, so that they are exact.

const about = k => JSON.parse(byId("about-" + k).textContent);

function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const kPiece = 1 << 22, padding = text.endsWith("==") ? 2 : text.endsWith("=") ? 1 : 0;
  const bytes = new Uint8Array(text.length / 4 * 3 - padding);
  for (let at = 0, to = 0; at < text.length; at += kPiece) {
    const binary = atob(text.slice(at, at + kPiece));
    for (let i = 0; i < binary.length; ++i) bytes[to++] = binary.charCodeAt(i);
  }
  return bytes;
}

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/// A drawing: `about` (see drawing_html.cpp), x, y, z of the vertices, u, v and role of the edges, and the bends: those
/// of edge e from u to v are firstBend[e] to firstBend[e + 1] in bendX, bendY, bendZ.
function decoded(facts, bytes) {
  let at = 0;
  const natural = () => {
    let byte = bytes[at++];
    if (byte < 128) return byte;
    let value = byte & 127, factor = 128;
    do { byte = bytes[at++]; value += (byte & 127) * factor; factor *= 128; } while (byte > 127);
    return value;
  };
  const signed = () => { const value = natural(); return value % 2 ? -(value + 1) / 2 : value / 2; };
  const Numbers = Math.max(...facts.extents) < 2 ** 31 ? Int32Array : Float64Array;
  const {n, m, bends} = facts;
  const d = {about: facts, n, m, x: new Numbers(n), y: new Numbers(n), z: new Numbers(n), u: new Uint32Array(m), v: new Uint32Array(m),
    role: new Uint8Array(m), firstBend: new Uint32Array(m + 1), bendX: new Numbers(bends), bendY: new Numbers(bends), bendZ: new Numbers(bends)};
  let x = 0, y = 0, z = 0;
  for (let i = 0; i < n; ++i) {
    d.x[i] = x += signed(); d.y[i] = y += signed(); d.z[i] = z += signed();
  }
  let u = 0, bend = 0;
  for (let e = 0; e < m; ++e) {
    d.u[e] = u += signed(); d.v[e] = u + signed();
    const count = natural();
    d.role[e] = natural();
    x = d.x[u]; y = d.y[u]; z = d.z[u];
    for (let i = 0; i < count; ++i, ++bend) {
      d.bendX[bend] = x += signed(); d.bendY[bend] = y += signed(); d.bendZ[bend] = z += signed();
    }
    d.firstBend[e + 1] = bend;
  }
  d.segments = bends + m;
  return d;
}

/// The texts of one drawing as arrays, or {about} alone if the graph was not drawn.
async function loadDrawing(k) {
  const facts = about(k);
  if (facts.error !== undefined) return {about: facts};
  return decoded(facts, await inflated(bytesOfBase64(byId("geometry-" + k).textContent)));
}

const pointsOf = (d, e) => d.firstBend[e + 1] - d.firstBend[e] + 2;

/// Point i of edge e on its way from u to v, in out[0..2].
function pointOf(d, e, i, out) {
  const bends = d.firstBend[e + 1] - d.firstBend[e];
  if (i === 0 || i > bends) {
    const w = i === 0 ? d.u[e] : d.v[e];
    out[0] = d.x[w]; out[1] = d.y[w]; out[2] = d.z[w];
  } else {
    const b = d.firstBend[e] + i - 1;
    out[0] = d.bendX[b]; out[1] = d.bendY[b]; out[2] = d.bendZ[b];
  }
  return out;
}

/// For each vertex its place in the order of growth, from 1; made when first asked for.
function growthRanks(d) {
  if (d.ranks) return d.ranks;
  const [a, b, c] = d.about.order.weights;
  const order = Uint32Array.from({length: d.n}, (_, v) => v);
  if (a || b || c) {
    const key = Float64Array.from(order, v => a * d.x[v] + b * d.y[v] + c * d.z[v]);
    order.sort((v, w) => key[v] - key[w] || v - w);
  }
  d.ranks = new Uint32Array(d.n);
  order.forEach((v, place) => { d.ranks[v] = place + 1; });
  return d.ranks;
}
const isGrown = (d, v) => view.grown >= d.n || growthRanks(d)[v] <= view.grown;
const isEdgeGrown = (d, e) => isGrown(d, d.u[e]) && isGrown(d, d.v[e]);

/// The edges at each vertex: those of v are edges[first[v]] to edges[first[v + 1]]; made when first asked for.
function incidence(d) {
  if (d.incident) return d.incident;
  const first = new Uint32Array(d.n + 2), edges = new Uint32Array(2 * d.m);
  for (let e = 0; e < d.m; ++e) { ++first[d.u[e] + 2]; ++first[d.v[e] + 2]; }
  for (let v = 2; v < d.n + 2; ++v) first[v] += first[v - 1];
  for (let e = 0; e < d.m; ++e) { edges[first[d.u[e] + 1]++] = e; edges[first[d.v[e] + 1]++] = e; }
  return d.incident = {first, edges};
}
const edgesAt = (d, v) => { const {first, edges} = incidence(d); return edges.subarray(first[v], first[v + 1]); };
