// Where points are in the scene, and the layers that show a drawing of any size: one-pixel lines for all segments or a
// sample of them, dots for the vertices. Tubes are in tubes.js. z is up; the drawing's box is about the origin and its
// longest side has length 1.

const kMostLines = 1500000;  // segments held as lines; of larger drawings a sample, spread evenly over the edges
const kPalette = [[0, 114, 178], [230, 159, 0], [0, 158, 115], [204, 121, 167], [86, 180, 233], [213, 94, 0], [240, 228, 66], [120, 120, 120]];

/// The map from lattice coordinates to the scene: rows of `matrix`, applied to the difference from `centre`.
function spaceOf(d, stretch) {
  const {gram, gram_denominator, extents} = d.about;
  const factor = [[0, 0, 0], [0, 0, 0], [0, 0, 0]];  // Cholesky: gram / denominator = factor factor^T
  for (let i = 0; i < 3; ++i) for (let j = 0; j <= i; ++j) {
    let sum = gram[i][j] / gram_denominator;
    for (let k = 0; k < j; ++k) sum -= factor[i][k] * factor[j][k];
    factor[i][j] = i === j ? Math.sqrt(sum) : sum / factor[j][j];
  }
  const rows = [0, 1, 2].map(i => [0, 1, 2].map(j => factor[j][i]));  // its transpose
  const sides = rows.map(row => row.reduce((sum, c, j) => sum + Math.abs(c) * extents[j], 0));
  const longest = Math.max(...sides) || 1;
  const scale = sides.map(side => 1 / (stretch && side > 0 ? side : longest));
  const matrix = rows.map((row, i) => row.map(c => c * scale[i]));
  const centre = extents.map(extent => extent / 2);
  const size = sides.map((side, i) => side * scale[i]);
  return {matrix, centre, size, unit: stretch ? Math.min(...scale) : 1 / longest, radius: Math.hypot(...size) / 2 || 0.5,
    flatness: longest / Math.min(longest, ...sides.filter(side => side > 0))};
}

function toScene(space, p, out, at) {
  const x = p[0] - space.centre[0], y = p[1] - space.centre[1], z = p[2] - space.centre[2], m = space.matrix;
  out[at] = m[0][0] * x + m[0][1] * y + m[0][2] * z;
  out[at + 1] = m[1][0] * x + m[1][1] * y + m[1][2] * z;
  out[at + 2] = m[2][0] * x + m[2][1] * y + m[2][2] * z;
  return out;
}
const vectorInScene = p => new THREE.Vector3(...toScene(view.space, p, [0, 0, 0], 0));

/// Visits 0 ... count - 1 in an order every beginning of which is spread evenly.
function spreadOver(count, visit) {
  let step = Math.max(1, Math.floor(count * 0.618));
  const common = (a, b) => b ? common(b, a % b) : a;
  while (common(step, count) > 1) ++step;
  for (let i = 0, at = 0; i < count; ++i, at = (at + step) % count) if (visit(at) === false) return;
}

const kVertexShader = `
  attribute float birth; attribute float tone;
  uniform float grown, dotSize; uniform vec3 palette[8];
  varying vec3 colour; varying float depth;
  void main() {
    vec4 place = modelViewMatrix * vec4(position, 1.0);
    depth = -place.z;
    colour = palette[int(tone)];
    gl_Position = birth > grown ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * place;
    gl_PointSize = dotSize;
  }`;
const kFragmentShader = `
  uniform vec3 paper; uniform float near, far, opacity, round;
  varying vec3 colour; varying float depth;
  void main() {
    float shade = 1.0;
    if (round > 0.5) {
      vec2 at = 2.0 * gl_PointCoord - 1.0;
      float from = dot(at, at);
      if (from > 1.0) discard;
      shade = 0.75 + 0.5 * sqrt(1.0 - from) * (0.6 - 0.4 * at.y);
    }
    float faded = clamp((depth - near) / (far - near), 0.0, 0.82);
    gl_FragColor = vec4(mix(min(colour * shade, 1.0), paper, faded), opacity);
  }`;

/// One material's uniforms stand beside those that all layers share.
const shared = {grown: {value: 0}, paper: {value: [1, 1, 1]}, near: {value: 0}, far: {value: 1},
  palette: {value: new Array(24).fill(0)}};
function layerMaterial(own) {
  const uniforms = {...shared};
  for (const name in own) uniforms[name] = {value: own[name]};
  return new THREE.ShaderMaterial({uniforms, vertexShader: kVertexShader, fragmentShader: kFragmentShader});
}

const scene = new THREE.Scene();
const layers = {lines: null, density: null, dots: null, held: 0};
const lineMaterial = layerMaterial({opacity: 1, round: 0, dotSize: 1});
lineMaterial.transparent = true;  // where lines lie many times over each other
const densityMaterial = layerMaterial({opacity: 0.4, round: 0, dotSize: 1.5});
densityMaterial.transparent = true;
densityMaterial.depthWrite = false;
const dotMaterial = layerMaterial({opacity: 1, round: 1, dotSize: 4});
dotMaterial.uniforms.palette = {value: new Array(24).fill(0)};

function geometryOf(positions, tones) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
  geometry.setAttribute("birth", new THREE.BufferAttribute(new Float32Array(positions.length / 3), 1));
  geometry.setAttribute("tone", new THREE.BufferAttribute(tones, 1));
  geometry.boundingSphere = {center: new THREE.Vector3(), radius: 1};  // known: nothing is computed over all points
  return geometry;
}

/// Calls visit(e, i) for the segments that the lines hold, in their order.
function forEachLine(d, visit) {
  let held = 0;
  spreadOver(d.m, e => {
    const count = pointsOf(d, e) - 1;
    if (held + count > kMostLines) return false;
    for (let i = 0; i < count; ++i) visit(e, i, held++);
  });
  return held;
}

function buildLayers(d) {
  for (const layer of [layers.lines, layers.density, layers.dots]) {
    if (layer) { scene.remove(layer); layer.geometry.dispose(); }
  }
  const room = Math.min(d.segments, kMostLines), positions = new Float32Array(6 * room), point = [0, 0, 0];
  layers.held = forEachLine(d, (e, i, at) => {
    toScene(view.space, pointOf(d, e, i, point), positions, 6 * at);
    toScene(view.space, pointOf(d, e, i + 1, point), positions, 6 * at + 3);
  });
  const lines = geometryOf(positions, new Uint8Array(2 * room));
  layers.lines = new THREE.LineSegments(lines, lineMaterial);
  layers.density = new THREE.Points(lines, densityMaterial);
  const dots = new Float32Array(3 * d.n);
  let dot = 0;
  layers.dotOrder = new Uint32Array(d.n);
  spreadOver(d.n, v => {
    layers.dotOrder[dot] = v;
    toScene(view.space, [d.x[v], d.y[v], d.z[v]], dots, 3 * dot++);
  });
  layers.dots = new THREE.Points(geometryOf(dots, new Uint8Array(d.n)), dotMaterial);
  for (const layer of [layers.lines, layers.density, layers.dots]) {
    layer.frustumCulled = false;
    scene.add(layer);
  }
  layers.births = false;
}

/// The classes of directions up to sign, at most 7 by name; all others are class 7.
function directionClasses(d) {
  if (d.directions) return d.directions;
  const names = new Map(), classes = new Uint8Array(d.segments), from = [0, 0, 0], to = [0, 0, 0];
  const common = (a, b) => { a = Math.abs(a); b = Math.abs(b); while (b) [a, b] = [b, a % b]; return a; };
  for (let e = 0; e < d.m; ++e) for (let i = 0, s = d.firstBend[e] + e; i + 1 < pointsOf(d, e); ++i, ++s) {
    pointOf(d, e, i, from); pointOf(d, e, i + 1, to);
    let [a, b, c] = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
    const by = (common(common(a, b), c) || 1) * ((a || b || c) < 0 ? -1 : 1);
    const name = minus(`\u00b1(${a / by}, ${b / by}, ${c / by})`);
    if (!names.has(name) && names.size < 7) names.set(name, names.size);
    classes[s] = names.has(name) ? names.get(name) : 7;
  }
  return d.directions = {names: [...names.keys()], classes};
}
const toneOf = (d, e, i) => view.colours === "direction" ? directionClasses(d).classes[d.firstBend[e] + e + i] : Math.min(7, d.role[e]);

/// Fills what depends on colours and on growth into the layers.
function paintLayers(d) {
  const {tone} = layers.lines.geometry.attributes;
  forEachLine(d, (e, i, at) => { tone.array[2 * at] = tone.array[2 * at + 1] = toneOf(d, e, i); });
  tone.needsUpdate = true;
}
function growLayers(d) {
  shared.grown.value = view.grown >= d.n ? 1e9 : view.grown;
  if (layers.births || view.grown >= d.n) return;
  const ranks = growthRanks(d), lines = layers.lines.geometry.attributes.birth, dots = layers.dots.geometry.attributes.birth;
  forEachLine(d, (e, i, at) => { lines.array[2 * at] = lines.array[2 * at + 1] = Math.max(ranks[d.u[e]], ranks[d.v[e]]); });
  for (let i = 0; i < d.n; ++i) dots.array[i] = ranks[layers.dotOrder[i]];
  lines.needsUpdate = dots.needsUpdate = layers.births = true;
}
