// The page: starts, shows a drawing, draws a frame, listens.

let renderer = null;
let budget = 0;      // segments drawn in a frame while moving; follows the times that frames take
let progress = 0;    // how many lines of the resting picture are drawn
let lastFrame = 0;
const kAtOnce = 60000;
const kOver = 7;     // more lines than this over each pixel show nothing more

function adaptBudget(time) {
  const took = time - lastFrame;
  lastFrame = time;
  if (!view.moving) return;
  if (view.frames === null) { view.frames = []; return; }  // the first picture of a turn
  view.frames.push(took);
  if (took > 29) budget = Math.max(2000, budget * (took > 100 ? 0.5 : 0.8));
  else if (took < 22) budget = Math.min(kMostLines, budget * 1.12);
}

/// Pixels of the picture to one of the page: more at rest, which smooths edges, fewer where turning would be slow.
function adaptResolution(d) {
  const whole = Math.min(2, devicePixelRatio), slow = view.frames && view.frames.length > 3 && view.frames.slice(-3).every(took => took > 36);
  if (slow) view.coarse = Math.max(0.5, (view.coarse || whole) * 0.8);
  const ratio = view.moving ? view.coarse || whole : d.segments > kMostTubes ? whole : 2;
  if (renderer.getPixelRatio() !== ratio) renderer.setPixelRatio(ratio);
}

/// How many lines cover the picture kOver times; when it is zoomed in, most are beside it.
function enoughLines() {
  const closer = Math.max(1, view.fitHeight / heightSeen());
  return Math.max(5000, kOver * stage.clientWidth * stage.clientHeight * 0.35 / (1 + view.meanLength * pixelsPerUnit(distance())) * closer ** 2);
}

/// How the drawing is shown from here: "tubes", "lines" or "density".
function levelOfDetail(d) {
  const scale = pixelsPerUnit(distance());
  if (d.segments <= kMostTubes) return tubeRadius(d) * scale >= 0.55 && (!view.moving || d.segments * 20 <= budget * 9) ? "tubes" : "lines";
  return view.meanLength * scale < 2.5 ? "density" : "lines";
}

function drawFrame(time) {
  const d = view.drawing;
  if (!renderer || !d || !d.n) { drawInk(); return; }
  adaptBudget(time);
  adaptResolution(d);
  shapeDepth();
  aimLamps();
  if (!budget) budget = enoughLines() / 3;
  const level = levelOfDetail(d), enough = level === "lines" ? enoughLines() : Infinity;
  const all = Math.round(Math.min(layers.held, enough)), most = view.moving ? Math.min(all, Math.round(budget)) : kAtOnce;
  const crowded = layers.held > enough;
  lineMaterial.uniforms.opacity.value = crowded ? 0.3 : 1;
  lineMaterial.depthTest = lineMaterial.depthWrite = !crowded;
  if (view.moving || view.fresh !== false) progress = 0;
  const from = progress, count = Math.min(all - from, most), first = from === 0;
  progress = from + count;
  const tubes = level === "tubes" || (!view.moving && d.segments > kMostTubes);
  layers.lines.visible = level === "lines";
  layers.density.visible = level === "density";
  layers.lines.geometry.setDrawRange(2 * from, 2 * count);
  layers.dots.visible = first && level !== "tubes";
  layers.dots.geometry.setDrawRange(0, Math.min(d.n, view.moving ? Math.ceil(count / 3) : crowded ? Math.ceil(all / 3) : d.n));
  const ballPixels = 5 * tubeRadius(d) * pixelsPerUnit(distance());
  dotMaterial.uniforms.dotSize.value = Math.min(14, Math.max(level === "density" ? 1 : 1.6, ballPixels)) * renderer.getPixelRatio();
  for (const mesh of [meshes.tubes, meshes.joints, meshes.balls, meshes.halo]) mesh.visible = tubes && first && mesh.count > 0;
  for (const mesh of [meshes.chosenTubes, meshes.chosenBalls]) mesh.visible = first && mesh.count > 0;
  renderer.autoClear = first;
  renderer.render(scene, camera);
  view.level = level;
  if (first) drawInk();
  view.fresh = false;
  if (!view.moving && progress < all && level !== "tubes") requestMore(); else if (!view.moving) settle(d, level, all);
}
/// The rest of a large picture, on top of what is there.
function requestMore() {
  if (!asked) asked = requestAnimationFrame(time => { asked = 0; drawFrame(time); });
}

/// The resting picture is whole: say what it shows.
function settle(d, level, shown) {
  const part = shown < d.segments ? ` an even sample of ${withCommas(shown)} of ${withCommas(d.segments)} segments;` : "";
  const words = {tubes: "", lines: `Edges are lines at this size;${part} zoom in for tubes.`, density: `Edges are a cloud of points at this size;${part} zoom in for lines and tubes.`};
  byId("detail").textContent = level === "lines" && meshes.tubes.count ? "Near edges are tubes, far ones lines." : words[level];
  view.settled = view.settled || performance.now();
}

function meanLength(d) {
  const a = [0, 0, 0], b = [0, 0, 0], p = [0, 0, 0];
  let sum = 0, count = 0;
  spreadOver(d.m, e => {
    for (let i = 0; i + 1 < pointsOf(d, e); ++i, ++count) {
      toScene(view.space, pointOf(d, e, i, p), a, 0);
      toScene(view.space, pointOf(d, e, i + 1, p), b, 0);
      sum += Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    }
    return count < 20000;
  });
  return count ? sum / count : 0;
}

/// Makes everything that the drawing's place in the scene decides.
function placeDrawing(d) {
  view.space = spaceOf(d, view.stretch);
  view.meanLength = meanLength(d);
  byId("stretched").hidden = !view.stretch;
  buildLayers(d);
  buildBoxes(d);
  repaint();
  growLayers(d);
}
function repaint() {
  const d = view.drawing;
  applyTheme();
  if (!d || !d.n) return redraw();
  paintLayers(d);
  if (renderer && controls) buildTubes(d);
  fillLegend(d);
  showChosen();
}

async function showDrawing(k) {
  tellProblem("");
  view.page = k;
  view.settled = false;
  byId("which").value = k;
  const d = await loadDrawing(k);
  if (view.page !== k) return;
  budget = 0;
  Object.assign(view, {drawing: d, fitHeight: 0, selected: null, violation: -1, edgesOf: undefined, grown: d.n || 0, following: null});
  byId("selection").hidden = true;
  byId("panel").inert = !d.n;
  fillHeader(d);
  if (d.about.error !== undefined) {
    renderer.clear();
    drawInk();
    tellProblem(`This graph of ${d.about.n} vertices was not drawn: ${d.about.error}`);
    return;
  }
  if (!d.n) { renderer.clear(); drawInk(); tellProblem("A drawing without vertices: there is nothing to see."); return; }
  view.colours = d.about.roles.title ? "role" : "direction";
  byId("colours").value = view.colours;
  view.stretch = byId("stretch").checked = spaceOf(d, false).flatness > 6;
  fillPanel(d);
  placeDrawing(d);
  grow(d.n);
  await lookFrom(kViews[0]);
  view.fitHeight = heightSeen();
  redraw();
}

function start(context) {
  if (typeof DecompressionStream === "undefined") throw new Error("This browser is too old for the viewer: it lacks DecompressionStream (Chrome 80, Firefox 113, Safari 16.4 have it).");
  renderer = new THREE.WebGLRenderer({canvas: stage, context, preserveDrawingBuffer: true});
  renderer.setSize(innerWidth, innerHeight, false);
  stage.addEventListener("webglcontextlost", () => tellProblem("The browser has lost the 3D picture (WebGL context lost): load the page again."));
  camera.position.copy(kViews[0]);
  applyTheme();
  controls = new THREE.OrbitControls(camera, stage);
  Object.assign(controls, {zoomToCursor: true, screenSpacePanning: true});
  controls.addEventListener("change", moved);
  controls.addEventListener("start", () => { flight = null; view.following = null; });
  shapeCameras();
}

/// The one WebGL context of the page, which takes long to make in software, or null.
function webGL() {
  try { return stage.getContext("webgl2", {alpha: false, antialias: false, depth: true, stencil: false, preserveDrawingBuffer: true}); } catch { return null; }
}

async function run() {
  view.space = {radius: 1, centre: [0, 0, 0], matrix: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], size: [1, 1, 1], unit: 1};
  if (innerWidth <= 700) foldPanel(true);
  applyTheme();
  if (!pageCount) return tellProblem("There is no drawing in this page.");
  const context = webGL();
  if (!context) return tellProblem("This page draws with WebGL 2, which this browser does not offer or has turned off. Another browser, or its setting for hardware acceleration, may help.");
  try {
    start(context);
    fillPages();
    listen();
    await showDrawing(Math.min(pageCount - 1, Number(document.body.dataset.page) || 0));
    view.ready = performance.now();
  } catch (error) {
    tellProblem(`The drawing cannot be shown: ${error.message}`);
  }
}

function fillPages() {
  byId("pages").hidden = pageCount < 2;
  for (let k = 0; k < pageCount; ++k) {
    const option = document.createElement("option"), facts = about(k);
    option.value = k;
    option.textContent = `${k + 1} of ${pageCount}: ${facts.title}${facts.verdict && facts.verdict.kind === "violated" ? " (violated)" : facts.error !== undefined ? " (not drawn)" : ""}`;
    byId("which").append(option);
  }
}

function foldPanel(hide = !byId("panel").hidden) {
  byId("panel").hidden = hide;
  byId("unfold").setAttribute("aria-expanded", String(!hide));
  if (controls) { shapeCameras(); redraw(); }
}
const showPage = k => showDrawing((k + pageCount) % pageCount);
function toggleTheme() { view.dark = !view.dark; repaint(); }
function togglePerspective() {
  const next = camera === cameras.perspective ? "orthographic" : "perspective";
  useCamera(next);
  byId("perspective").textContent = next;
  byId("perspective").setAttribute("aria-pressed", String(next === "perspective"));
}
function toggleNames() { view.names = byId("names").checked = !view.names && !byId("names").disabled; redraw(); }

const kKeys = {
  ArrowLeft: event => event.shiftKey ? pan(0.05, 0) : turn(-0.09, 0), ArrowRight: event => event.shiftKey ? pan(-0.05, 0) : turn(0.09, 0),
  ArrowUp: event => event.shiftKey ? pan(0, -0.05) : turn(0, 0.09), ArrowDown: event => event.shiftKey ? pan(0, 0.05) : turn(0, -0.09),
  "+": () => zoom(1.2), "=": () => zoom(1.2), "-": () => zoom(1 / 1.2),
  0: () => lookFrom(kViews[0]), 1: () => lookFrom(kViews[1]), 2: () => lookFrom(kViews[2]), 3: () => lookFrom(kViews[3]), Home: () => lookFrom(kViews[0]),
  ".": () => stepVertex(1), ",": () => stepVertex(-1), e: stepEdge, f: followEdge, v: () => showViolation(view.violation + 1),
  "[": () => grow(view.grown - Math.max(1, view.drawing.n / 50)), "]": () => grow(view.grown + Math.max(1, view.drawing.n / 50)), " ": play,
  p: togglePerspective, b: () => showBox("box", !byId("box").checked), t: () => showBox("bound", !byId("bound").checked), l: toggleNames,
  d: toggleTheme, s: savePicture, h: () => foldPanel(), "?": () => { byId("keys").open = !byId("keys").open; },
  PageUp: () => showPage(view.page - 1), PageDown: () => showPage(view.page + 1),
  Escape: () => { view.violation = -1; view.following = null; select(null); hover(); },
};

function listenToPointer() {
  let down = null, waiting = 0;
  stage.addEventListener("pointerdown", event => { down = [event.clientX, event.clientY]; hover(); });
  addEventListener("pointerup", event => {
    const still = down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4;
    down = null;
    if (still && event.target === stage) { select(pick(event.clientX, event.clientY)); stage.focus(); }
  });
  stage.addEventListener("pointermove", event => {
    if (down || event.pointerType === "touch") return;
    clearTimeout(waiting);
    const large = view.drawing && view.drawing.segments > 40000;
    waiting = setTimeout(() => hover(event.clientX, event.clientY), large ? 90 : 12);
  });
  stage.addEventListener("pointerleave", () => { clearTimeout(waiting); hover(); });
}

function listen() {
  listenToPointer();
  addEventListener("keydown", event => {
    const own = event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement || (event.target instanceof HTMLButtonElement && event.key === " ");
    if (event.ctrlKey || event.metaKey || event.altKey || (own && event.key !== "Escape")) return;
    const action = kKeys[event.key];
    if (!action || !view.drawing || (!view.drawing.n && !event.key.startsWith("Page"))) return;
    event.preventDefault();
    action(event);
  });
  addEventListener("resize", () => { renderer.setSize(innerWidth, innerHeight, false); shapeCameras(); redraw(); });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", event => { view.dark = event.matches; repaint(); });
  for (const button of document.querySelectorAll("[data-view]")) button.onclick = () => lookFrom(kViews[button.dataset.view]);
  const clicks = {perspective: togglePerspective, theme: toggleTheme, save: savePicture, play, follow: followEdge, clear: kKeys.Escape,
    unfold: () => foldPanel(), previous: () => showPage(view.page - 1), next: () => showPage(view.page + 1)};
  for (const id in clicks) byId(id).onclick = () => clicks[id]();
  byId("which").onchange = event => showPage(Number(event.target.value));
  byId("thickness").oninput = event => { view.thickness = Number(event.target.value); repaint(); };
  byId("stretch").onchange = event => { view.stretch = event.target.checked; placeDrawing(view.drawing); lookFrom(kViews[0]); };
  for (const name of ["box", "bound"]) byId(name).onchange = event => showBox(name, event.target.checked);
  byId("names").onchange = event => { view.names = event.target.checked; redraw(); };
  byId("colours").onchange = event => { view.colours = event.target.value; repaint(); };
  byId("grow").oninput = event => grow(Number(event.target.value));
}

/// What tests and scripts of readers may ask.
window.ar3d = {
  view,
  /// The place of a vertex, or of point i of an edge, on the page in pixels.
  screenOf: (vertex, edge, i) => {
    const d = view.drawing, p = edge === undefined ? positionOf(d, vertex) : [...pointOf(d, edge, i, [0, 0, 0])];
    return toPixels(project(projectionRows(), p, [0, 0, 0]));
  },
  frames: () => [...view.frames || []],
  camera: () => camera.position.toArray(),
  /// What the last frame held.
  cost: () => {
    const {calls, lines, points, triangles} = renderer.info.render;
    return {calls, lines, points, triangles, pixels: stage.width * stage.height};
  },
};
run();
