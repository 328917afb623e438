// Colours, boxes, and what the controls say.
import {fromTarget, lookFrom} from "./cameras.js";
import {factsOfPage} from "./data.js";
import {withCommas} from "./exact.js";
import {ink, kMostNames} from "./ink.js";
import {directionClasses, kOtherDirections, kPalette, scene, setLayerColours, sidesOf} from "./layers.js";
import {showViolation} from "./select.js";
import {byId, pageCount, redraw, stage, view} from "./state.js";
import {meshes} from "./tubes.js";

const kLight = {paper: [251, 250, 247], mark: [176, 0, 109], ball: [44, 49, 57], box: [110, 118, 128]};
const kDark = {paper: [20, 23, 28], mark: [255, 111, 193], ball: [226, 230, 236], box: [150, 160, 175]};

const shares = colour => colour.map(part => part / 255);
const solidColour = colour => new THREE.Color().setRGB(...shares(colour), "srgb");

/// The roles' own colours or those of the directions, lighter in the dark.
function paletteNow() {
  const {drawing, dark} = view, isByRole = drawing && drawing.n && view.colours === "role";
  const roles = isByRole ? drawing.about.roles.list.map(role => role.colour) : [];
  return kPalette.map((colour, i) => (roles[i] || colour).map(part => dark ? part + 0.28 * (255 - part) : part));
}

export function applyTheme() {
  const theme = view.dark ? kDark : kLight, paper = solidColour(theme.paper);
  document.documentElement.classList.toggle("dark", view.dark);
  byId("theme").textContent = view.dark ? "light" : "dark";
  view.palette = paletteNow();
  view.solidPalette = view.palette.map(solidColour);
  view.markColour = solidColour(theme.mark);
  view.ballColour = solidColour(theme.ball);
  setLayerColours(view.palette.map(shares), shares(theme.ball), shares(theme.paper));
  scene.fog.color.copy(paper);
  meshes.halo.material.color.copy(paper);
  if (view.renderer) view.renderer.setClearColor(paper);
  for (const mesh of [meshes.chosenTubes, meshes.chosenBalls]) mesh.material.emissive.copy(view.markColour);
  for (const lines of Object.values(boxes)) if (lines) lines.material.color.copy(solidColour(theme.box));
}

/// The drawing's box and the theorem's, each named as its control.
const boxes = {box: null, bound: null};

/// The twelve edges of a box about the origin.
function boxLines(size) {
  const corner = k => size.map((side, i) => (k >> i & 1 ? 0.5 : -0.5) * side), ends = [];
  for (let k = 0; k < 8; ++k) {
    for (let i = 0; i < 3; ++i) if (!(k >> i & 1)) ends.push(...corner(k), ...corner(k | 1 << i));
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(ends), 3));
  const lines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({fog: false}));
  lines.frustumCulled = false;
  return lines;
}
export function buildBoxes(drawing) {
  const {bound} = drawing.about, {size, matrix} = view.space;
  const sides = bound ? sidesOf(matrix, bound.extents) : [0, 0, 0];
  view.boundSize = sides.map((side, i) => Math.max(side, size[i]));
  view.boundRadius = Math.hypot(...sides) / 2;
  const made = {box: boxLines(size), bound: bound ? boxLines(sides) : null};
  for (const name in boxes) {
    if (boxes[name]) scene.remove(boxes[name]);
    boxes[name] = made[name];
    if (!made[name]) continue;
    made[name].visible = byId(name).checked;
    scene.add(made[name]);
  }
}
export function showBox(name, isShown) {
  if (!boxes[name]) return;
  byId(name).checked = boxes[name].visible = isShown;
  byId("bound-text").hidden = !byId("bound").checked;
  if (name === "bound") lookFrom(fromTarget(), isShown ? view.boundSize : undefined);
  redraw();
}

/// Style and word of a verdict that counts no violations.
const kVerdicts = {certified: ["certified", "certified"], "not judged": ["unknown", "not judged"]};

export function fillHeader(drawing) {
  const {algorithm, title, verdict, bends, extents} = drawing.about;
  byId("title").textContent = algorithm ? `${algorithm} \u00b7 ${title}` : title;
  document.title = `${title} \u2013 ar3d`;
  byId("verdict").hidden = byId("facts").hidden = !verdict;
  if (!verdict) return;
  const count = verdict.violations.length;
  const [style, word] = kVerdicts[verdict.kind] || ["violated", `${count} violation${count === 1 ? "" : "s"}`];
  Object.assign(byId("verdict"), {className: style, textContent: word, title: verdict.text});
  byId("facts").textContent = `${withCommas(drawing.n)} vertices, ${withCommas(drawing.m)} edges, ` +
    `${withCommas(bends)} bends, box ${extents.map(withCommas).join(" \u00d7 ")}`;
}

/// The colours that the drawing has: [number of the colour, name].
function legendOf(drawing) {
  const {names, classes} = view.colours === "direction" ? directionClasses(drawing)
    : {names: drawing.about.roles.list.map(role => role.name), classes: drawing.role};
  const used = new Set(classes), entries = [...names.entries()];
  if (view.colours === "direction") entries.push([kOtherDirections, "other directions"]);
  return entries.filter(([number]) => used.has(number));
}
export function fillLegend(drawing) {
  byId("legend").replaceChildren(...legendOf(drawing).map(([number, name]) => {
    const item = document.createElement("li"), swatch = document.createElement("i");
    swatch.style.background = `rgb(${view.palette[number].map(Math.round)})`;
    item.append(swatch, name);
    return item;
  }));
}

function fillViolations({violations}) {
  byId("violations").hidden = !violations.length;
  byId("violation-list").replaceChildren(...violations.map((violation, number) => {
    const item = document.createElement("li"), button = document.createElement("button");
    const kind = document.createElement("b");
    kind.textContent = violation.kind.replace(/_/g, " ") + ": ";
    button.append(kind, violation.message);
    button.onclick = () => showViolation(number);
    item.append(button);
    return item;
  }));
}

export function fillPanel(drawing) {
  const {bound, roles, verdict} = drawing.about, [byRole] = byId("colours").options;
  fillViolations(verdict);
  byId("bound-label").hidden = !bound;
  byId("bound-text").textContent = bound ? "at most " + bound.text : "";
  byRole.disabled = !roles.title;
  byRole.textContent = roles.title || "role: not known of this algorithm";
  byId("grow").max = drawing.n;
  byId("names").disabled = drawing.n > kMostNames;
}

export function fillPages() {
  byId("pages").hidden = pageCount < 2;
  for (let page = 0; page < pageCount; ++page) {
    const {algorithm, title, verdict, error} = factsOfPage(page), option = document.createElement("option");
    const remark = error !== undefined ? " (not drawn)" : verdict.kind === "violated" ? " (violated)" : "";
    option.value = page;
    option.textContent = `${page + 1} of ${pageCount}: ${algorithm ? `${algorithm} \u00b7 ` : ""}${title}${remark}`;
    byId("which").append(option);
  }
}

export function savePicture() {
  const picture = document.createElement("canvas");
  picture.width = stage.width;
  picture.height = stage.height;
  const context = picture.getContext("2d");
  context.drawImage(stage, 0, 0);
  if (ink.style.display !== "none") context.drawImage(ink, 0, 0, picture.width, picture.height);
  picture.toBlob(blob => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = `${view.drawing.about.algorithm || "drawing"}-${view.page + 1}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  });
}
