// The page: starts, shows a drawing, listens.
import {
  fromTarget, heightSeen, isPerspective, kViews, lookFrom, moved, pan, shapeCameras, turn, useCamera, zoom,
} from "./cameras.js";
import {loadDrawing, pointAt, pointsOf, positionOf, spreadOver} from "./data.js";
import {forgetBudget} from "./frame.js";
import {drawInk} from "./ink.js";
import {buildLayers, growLayers, paintLayers, spaceOf, vectorInScene} from "./layers.js";
import {
  applyTheme, buildBoxes, fillHeader, fillLegend, fillPages, fillPanel, savePicture, showBox,
} from "./panel.js";
import {hover, pick, pixelsOf, projectionRows} from "./pick.js";
import {followEdge, grow, play, select, showChosen, showViolation, stepEdge, stepVertex} from "./select.js";
import {byId, pageCount, redraw, stage, tellProblem, view} from "./state.js";
import {buildTubes} from "./tubes.js";

const kTooOld = "This browser is too old for the viewer: it lacks DecompressionStream " +
  "(Chrome 80, Firefox 113, Safari 16.4 have it).";
const kNoWebGl = "This page draws with WebGL 2, which this browser does not offer or has turned off. " +
  "Another browser, or its setting for hardware acceleration, may help.";
const kContextLost = "The browser has lost the 3D picture (WebGL context lost): load the page again.";

function meanLength(drawing) {
  let sum = 0, count = 0;
  spreadOver(drawing.m, edge => {
    for (let i = 0; i + 1 < pointsOf(drawing, edge); ++i, ++count) {
      const from = vectorInScene(pointAt(drawing, edge, i)), to = vectorInScene(pointAt(drawing, edge, i + 1));
      sum += from.distanceTo(to);
    }
    return count < 20000;
  });
  return count ? sum / count : 0;
}

/// Makes everything that the drawing's place in the scene decides.
function placeDrawing(drawing) {
  view.space = spaceOf(drawing, view.stretch);
  view.meanLength = meanLength(drawing);
  byId("stretched").hidden = !view.stretch;
  buildLayers(drawing);
  buildBoxes(drawing);
  repaint();
  growLayers(drawing);
}
function repaint() {
  const {drawing} = view;
  applyTheme();
  if (!drawing || !drawing.n) {
    redraw();
    return;
  }
  paintLayers(drawing);
  if (view.renderer && view.controls) buildTubes(drawing);
  fillLegend(drawing);
  showChosen();
}

/// Shows why there is no picture of this drawing.
function showNothing({about: {n, error}}) {
  view.renderer.clear();
  drawInk();
  tellProblem(error === undefined ? "A drawing without vertices: there is nothing to see."
    : `This graph of ${n} vertices was not drawn: ${error}`);
}

async function showDrawing(page) {
  tellProblem("");
  view.page = page;
  byId("which").value = page;
  const drawing = await loadDrawing(page);
  if (view.page === page) await showLoaded(drawing);
}
export async function showLoaded(drawing) {
  forgetBudget();
  Object.assign(view, {drawing, settled: 0, fitHeight: 0, selected: null, violation: -1, followed: null,
    steppedVertex: 0, grown: drawing.n});
  byId("selection").hidden = true;
  byId("panel").inert = !drawing.n;
  fillHeader(drawing);
  if (!drawing.n) {
    showNothing(drawing);
    return;
  }
  view.colours = drawing.about.roles.title ? "role" : "direction";
  byId("colours").value = view.colours;
  view.stretch = byId("stretch").checked = spaceOf(drawing, false).flatness > 6;
  fillPanel(drawing);
  placeDrawing(drawing);
  grow(drawing.n);
  await lookFrom(kViews[0]);
  view.fitHeight = heightSeen();
  redraw();
}
const showPage = page => showDrawing((page + pageCount) % pageCount);

/// The one WebGL context of the page, which takes long to make in software, or null.
function webGlContext() {
  const options = {alpha: false, antialias: false, depth: true, stencil: false, preserveDrawingBuffer: true};
  try {
    return stage.getContext("webgl2", options);
  } catch {
    return null;
  }
}

function start(context) {
  if (typeof DecompressionStream === "undefined") throw new Error(kTooOld);
  view.renderer = new THREE.WebGLRenderer({canvas: stage, context, preserveDrawingBuffer: true});
  view.renderer.setSize(innerWidth, innerHeight, false);
  stage.addEventListener("webglcontextlost", () => tellProblem(kContextLost));
  view.camera.position.copy(kViews[0]);
  applyTheme();
  view.controls = new THREE.OrbitControls(view.camera, stage);
  Object.assign(view.controls, {zoomToCursor: true, screenSpacePanning: true});
  view.controls.addEventListener("change", moved);
  view.controls.addEventListener("start", () => Object.assign(view, {flight: null, followed: null}));
  shapeCameras();
}

/// Starts the viewer and waits for `showFirst`, which shows the first drawing; or says why there is no picture.
export async function startViewer(showFirst) {
  if (innerWidth <= 700) foldPanel(true);
  applyTheme();
  const context = webGlContext();
  if (!context) {
    tellProblem(kNoWebGl);
    return;
  }
  try {
    start(context);
    view.renderer.clear();
    listen();
    await showFirst();
    view.ready = performance.now();
  } catch (error) {
    tellProblem(`The drawing cannot be shown: ${error.message}`);
  }
}
/// Shows the drawings that the page holds.
export function showPages() {
  if (!pageCount) {
    tellProblem("There is no drawing in this page.");
    return;
  }
  startViewer(() => {
    fillPages();
    return showDrawing(Math.min(pageCount - 1, Number(document.body.dataset.page) || 0));
  });
}

function foldPanel(isHidden = !byId("panel").hidden) {
  byId("panel").hidden = isHidden;
  byId("unfold").setAttribute("aria-expanded", String(!isHidden));
  if (!view.controls) return;
  shapeCameras();
  redraw();
}
function toggleTheme() {
  view.dark = !view.dark;
  repaint();
}
function togglePerspective() {
  const name = isPerspective() ? "orthographic" : "perspective";
  useCamera(name);
  byId("perspective").textContent = name;
  byId("perspective").setAttribute("aria-pressed", String(isPerspective()));
}
function showNames(isShown) {
  view.names = byId("names").checked = isShown && !byId("names").disabled;
  redraw();
}
function selectNothing() {
  view.violation = -1;
  view.followed = null;
  select(null);
  hover();
}
function toggleKeys() {
  byId("keys").open = !byId("keys").open;
}
const growStep = () => Math.max(1, view.drawing.n / 50);
const toggleBox = name => showBox(name, !byId(name).checked);

const kActions = {
  ArrowLeft: event => event.shiftKey ? pan(0.05, 0) : turn(-0.09, 0),
  ArrowRight: event => event.shiftKey ? pan(-0.05, 0) : turn(0.09, 0),
  ArrowUp: event => event.shiftKey ? pan(0, -0.05) : turn(0, 0.09),
  ArrowDown: event => event.shiftKey ? pan(0, 0.05) : turn(0, -0.09),
  "+": () => zoom(1.2),
  "=": () => zoom(1.2),
  "-": () => zoom(1 / 1.2),
  0: () => lookFrom(kViews[0]),
  1: () => lookFrom(kViews[1]),
  2: () => lookFrom(kViews[2]),
  3: () => lookFrom(kViews[3]),
  Home: () => lookFrom(kViews[0]),
  ".": () => stepVertex(1),
  ",": () => stepVertex(-1),
  e: stepEdge,
  f: followEdge,
  v: () => showViolation(view.violation + 1),
  "[": () => grow(view.grown - growStep()),
  "]": () => grow(view.grown + growStep()),
  " ": play,
  p: togglePerspective,
  b: () => toggleBox("box"),
  t: () => toggleBox("bound"),
  l: () => showNames(!view.names),
  d: toggleTheme,
  s: savePicture,
  h: () => foldPanel(),
  "?": toggleKeys,
  PageUp: () => showPage(view.page - 1),
  PageDown: () => showPage(view.page + 1),
  Escape: selectNothing,
};

function listenToPointer() {
  let down = null, hoverTimer = 0;
  stage.addEventListener("pointerdown", event => {
    down = [event.clientX, event.clientY];
    hover();
  });
  addEventListener("pointerup", event => {
    const isClick = down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4;
    down = null;
    if (!isClick || event.target !== stage) return;
    select(pick(event.clientX, event.clientY));
    stage.focus();
  });
  stage.addEventListener("pointermove", event => {
    if (down || event.pointerType === "touch") return;
    clearTimeout(hoverTimer);
    const isLarge = view.drawing && view.drawing.segments > 40000;
    hoverTimer = setTimeout(() => hover(event.clientX, event.clientY), isLarge ? 90 : 12);
  });
  stage.addEventListener("pointerleave", () => {
    clearTimeout(hoverTimer);
    hover();
  });
}

/// Does the control that has the focus take the key itself?
function isControlsKey({target, key}) {
  if (key === "Escape") return false;
  return target instanceof HTMLInputElement || target instanceof HTMLSelectElement ||
    target instanceof HTMLTextAreaElement ||
    (target instanceof HTMLButtonElement && key === " ");
}
function takeKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || isControlsKey(event)) return;
  const action = kActions[event.key];
  if (!action || !view.drawing || (!view.drawing.n && !event.key.startsWith("Page"))) return;
  if (event.key === "Escape" && !view.selected) return;  // the page around may close it
  event.preventDefault();
  action(event);
}

function listenToControls() {
  for (const button of document.querySelectorAll("[data-view]")) {
    button.onclick = () => lookFrom(kViews[button.dataset.view]);
  }
  const clicks = {
    perspective: togglePerspective, theme: toggleTheme, save: savePicture, play, follow: followEdge,
    clear: selectNothing, unfold: () => foldPanel(), previous: kActions.PageUp, next: kActions.PageDown,
  };
  for (const id in clicks) byId(id).onclick = () => clicks[id]();
  const changes = {
    which: control => showPage(Number(control.value)),
    stretch: control => {
      view.stretch = control.checked;
      placeDrawing(view.drawing);
      lookFrom(kViews[0]);
    },
    box: control => showBox("box", control.checked),
    bound: control => showBox("bound", control.checked),
    names: control => showNames(control.checked),
    colours: control => {
      view.colours = control.value;
      repaint();
    },
  };
  for (const id in changes) byId(id).onchange = event => changes[id](event.target);
  byId("grow").oninput = event => grow(Number(event.target.value));
  byId("thickness").oninput = event => {
    view.thickness = Number(event.target.value);
    repaint();
  };
}

function listen() {
  listenToPointer();
  listenToControls();
  addEventListener("keydown", takeKey);
  addEventListener("resize", () => {
    view.renderer.setSize(innerWidth, innerHeight, false);
    shapeCameras();
    redraw();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", event => {
    view.dark = event.matches;
    repaint();
  });
}

/// What tests and scripts of readers may ask.
window.ar3d = {
  view,
  turn,
  /// Looks from where the camera is, so that the drawing just fits.
  fit: () => lookFrom(fromTarget()),
  /// The place of a vertex, or of point i of an edge, on the page in pixels.
  screenOf: (vertex, edge, i) => {
    const {drawing} = view;
    return pixelsOf(projectionRows(), edge === undefined ? positionOf(drawing, vertex) : pointAt(drawing, edge, i));
  },
  frames: () => [...view.frames || []],
  camera: () => view.camera.position.toArray(),
  /// What the last frame held.
  cost: () => {
    const {calls, lines, points, triangles} = view.renderer.info.render;
    return {calls, lines, points, triangles, pixels: stage.width * stage.height};
  },
};
