// Draws a frame: all of a small drawing; of a large one as many lines as there is time for while the camera moves, and
// the rest on top of them while it rests.
import {aimLamps, distance, heightSeen, pixelsPerUnit, shapeDepth} from "./cameras.js";
import {withCommas} from "./exact.js";
import {drawInk} from "./ink.js";
import {dotMaterial, kMostLines, layers, lineMaterial, scene} from "./layers.js";
import {askForFrame, byId, stage, view} from "./state.js";
import {kMostTubes, meshes, tubeRadius} from "./tubes.js";

const kAtOnce = 60000;  // lines of a frame at rest
const kMostOver = 7;  // more lines than this over each pixel show nothing more

const work = {
  budget: 0,  // lines drawn in a frame while moving; follows the times that frames take, 0: not known yet
  done: 0,  // lines of the resting picture that are drawn
  lastFrame: 0,
};

export function forgetBudget() {
  work.budget = 0;
}

function adaptBudget(time) {
  const took = time - work.lastFrame;
  work.lastFrame = time;
  if (!view.moving) return;
  if (view.frames === null) {  // the first picture of a turn
    view.frames = [];
    return;
  }
  view.frames.push(took);
  if (took > 29) work.budget = Math.max(2000, work.budget * (took > 100 ? 0.5 : 0.8));
  else if (took < 22) work.budget = Math.min(kMostLines, work.budget * 1.12);
}

/// Pixels of the picture to one of the page: more at rest, which smooths edges, fewer where turning would be slow.
function adaptResolution(drawing) {
  const whole = Math.min(2, devicePixelRatio);
  const isSlow = view.frames && view.frames.length > 3 && view.frames.slice(-3).every(took => took > 36);
  if (isSlow) view.movingRatio = Math.max(0.5, (view.movingRatio || whole) * 0.8);
  const ratio = view.moving ? view.movingRatio || whole : drawing.segments > kMostTubes ? whole : 2;
  if (view.renderer.getPixelRatio() !== ratio) view.renderer.setPixelRatio(ratio);
}

/// How many lines cover the picture kMostOver times; when it is zoomed in, most are beside it.
function enoughLines() {
  const closer = Math.max(1, view.fitHeight / heightSeen()), pixels = stage.clientWidth * stage.clientHeight;
  const pixelsPerLine = 1 + view.meanLength * pixelsPerUnit(distance());
  return Math.max(5000, kMostOver * pixels * 0.35 / pixelsPerLine * closer ** 2);
}

/// How the drawing is shown from here: "tubes", "lines" or "density".
function levelOfDetail(drawing) {
  const scale = pixelsPerUnit(distance());
  if (drawing.segments > kMostTubes) return view.meanLength * scale < 2.5 ? "density" : "lines";
  const inTime = !view.moving || drawing.segments * 20 <= work.budget * 9;
  return tubeRadius(drawing) * scale >= 0.55 && inTime ? "tubes" : "lines";
}

/// The lines from the first to the last of those of this frame, and the vertices.
function showLayers(drawing, {level, isFirst, isCrowded, all, first, count}) {
  lineMaterial.uniforms.opacity.value = isCrowded ? 0.3 : 1;
  lineMaterial.depthTest = lineMaterial.depthWrite = !isCrowded;
  layers.lines.visible = level === "lines";
  layers.density.visible = level === "density";
  layers.lines.geometry.setDrawRange(2 * first, 2 * count);
  layers.dots.visible = isFirst && level !== "tubes";
  const dots = view.moving ? Math.ceil(count / 3) : isCrowded ? Math.ceil(all / 3) : drawing.n;
  layers.dots.geometry.setDrawRange(0, Math.min(drawing.n, dots));
  const ballPixels = 5 * tubeRadius(drawing) * pixelsPerUnit(distance()), least = level === "density" ? 1 : 1.6;
  dotMaterial.uniforms.dotSize.value = Math.min(14, Math.max(least, ballPixels)) * view.renderer.getPixelRatio();
}

function showMeshes(drawing, level, isFirst) {
  const hasTubes = level === "tubes" || (!view.moving && drawing.segments > kMostTubes);
  for (const name in meshes) {
    const isShown = isFirst && (hasTubes || name.startsWith("chosen"));
    meshes[name].visible = isShown && meshes[name].count > 0;
  }
}

export function drawFrame(time) {
  const {drawing, renderer} = view;
  if (!renderer || !drawing || !drawing.n) {
    drawInk();
    return;
  }
  adaptBudget(time);
  adaptResolution(drawing);
  shapeDepth();
  aimLamps();
  work.budget = work.budget || enoughLines() / 3;
  if (view.moving || view.fresh) work.done = 0;
  const level = levelOfDetail(drawing), enough = level === "lines" ? enoughLines() : Infinity;
  const all = Math.round(Math.min(layers.held, enough));
  const most = view.moving ? Math.min(all, Math.round(work.budget)) : kAtOnce;
  const first = work.done, count = Math.min(all - first, most), isFirst = first === 0;
  work.done += count;
  showLayers(drawing, {level, isFirst, isCrowded: layers.held > enough, all, first, count});
  showMeshes(drawing, level, isFirst);
  renderer.autoClear = isFirst;
  renderer.render(scene, view.camera);
  view.level = level;
  if (isFirst) drawInk();
  view.fresh = false;
  if (view.moving) return;
  if (work.done < all && level !== "tubes") askForFrame();
  else settle(drawing, level, all);
}

/// The resting picture is whole: says what it shows.
function settle(drawing, level, shown) {
  const sample = ` an even sample of ${withCommas(shown)} of ${withCommas(drawing.segments)} segments;`;
  const part = shown < drawing.segments ? sample : "";
  const words = {
    tubes: "",
    lines: meshes.tubes.count ? "Near edges are tubes, far ones lines."
      : `Edges are lines at this size;${part} zoom in for tubes.`,
    density: `Edges are a cloud of points at this size;${part} zoom in for lines and tubes.`,
  };
  byId("detail").textContent = words[level];
  view.settled = view.settled || performance.now();
}
