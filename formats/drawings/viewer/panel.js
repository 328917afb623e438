// Colours, boxes, and what the controls say.

let solidPalette = [];

/// Colours for eyes: lighter in the dark; the scene's own are linear.
function applyTheme() {
  const dark = view.dark, d = view.drawing, root = document.documentElement;
  root.classList.toggle("dark", dark);
  byId("theme").textContent = dark ? "light" : "dark";
  const paper = dark ? [20, 23, 28] : [251, 250, 247], chosen = dark ? [255, 111, 193] : [176, 0, 109], ball = dark ? [226, 230, 236] : [44, 49, 57];
  const set = c => new THREE.Color().setRGB(c[0] / 255, c[1] / 255, c[2] / 255, "srgb");
  const lighter = c => dark ? c.map(x => x + 0.28 * (255 - x)) : c;
  const byRole = d && d.n && view.colours === "role" ? d.about.roles.list.map(role => role.colour) : [];
  view.palette = kPalette.map((colour, i) => lighter(byRole[i] || colour));
  solidPalette = view.palette.map(set);
  shared.palette.value = view.palette.flatMap(c => c.map(x => x / 255));
  for (const material of [lineMaterial, densityMaterial]) material.uniforms.palette.value = shared.palette.value;
  dotMaterial.uniforms.palette.value = kPalette.flatMap(() => ball.map(x => x / 255));
  for (const material of [lineMaterial, densityMaterial, dotMaterial]) material.uniforms.paper.value = paper.map(x => x / 255);
  view.mark = set(chosen);
  view.ballColour = set(ball);
  scene.fog = scene.fog || new THREE.Fog(0, 0, 1);
  scene.fog.color.copy(set(paper));
  meshes.halo.material.color.copy(set(paper));
  if (renderer) renderer.setClearColor(set(paper));
  for (const mesh of [meshes.chosenTubes, meshes.chosenBalls]) mesh.material.emissive.copy(view.mark);
  for (const box of Object.values(boxes)) if (box) box.material.color.copy(set(dark ? [150, 160, 175] : [110, 118, 128]));
}

const boxes = {box: null, bound: null};
function boxLines(size, middle) {
  const corner = k => [0, 1, 2].map(i => middle[i] + (k >> i & 1 ? 0.5 : -0.5) * size[i]), points = [];
  for (let k = 0; k < 8; ++k) for (let i = 0; i < 3; ++i) if (!(k >> i & 1)) points.push(...corner(k), ...corner(k | 1 << i));
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(points), 3));
  const lines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({fog: false}));
  lines.frustumCulled = false;
  return lines;
}
function buildBoxes(d) {
  for (const name in boxes) if (boxes[name]) { scene.remove(boxes[name]); boxes[name] = null; }
  const {size, matrix} = view.space, bound = d.about.bound;
  boxes.box = boxLines(size, [0, 0, 0]);
  if (bound) {
    const sides = matrix.map(row => row.reduce((sum, c, j) => sum + Math.abs(c) * bound.extents[j], 0));
    view.boundSize = sides.map((side, i) => Math.max(side, size[i]));
    view.boundRadius = Math.hypot(...sides) / 2;
    boxes.bound = boxLines(sides, [0, 0, 0]);
  }
  for (const name in boxes) if (boxes[name]) { boxes[name].visible = byId(name).checked; scene.add(boxes[name]); }
}
function showBox(name, shown) {
  if (!boxes[name]) return;
  byId(name).checked = boxes[name].visible = shown;
  byId("bound-text").hidden = !byId("bound").checked;
  if (name === "bound") lookFrom(camera.position.clone().sub(controls.target), shown ? view.boundSize : undefined);
  redraw();
}

const kWords = {certified: ["certified", "certified"], violated: ["violated", "violated"], "not judged": ["unknown", "not judged"]};
const withCommas = x => String(x).replace(/\B(?=(\d{3})+$)/g, ",");

function fillHeader(d) {
  const facts = d.about;
  byId("title").textContent = facts.algorithm ? `${facts.algorithm} \u00b7 ${facts.title}` : facts.title;
  document.title = `${facts.title} \u2013 ar3d`;
  byId("verdict").hidden = byId("facts").hidden = !facts.verdict;
  if (!facts.verdict) return;
  const [style, word] = kWords[facts.verdict.kind], count = facts.verdict.violations.length;
  byId("verdict").className = style;
  byId("verdict").textContent = style === "violated" ? `${count} violation${count === 1 ? "" : "s"}` : word;
  byId("verdict").title = facts.verdict.text;
  byId("facts").textContent = `${withCommas(d.n)} vertices, ${withCommas(d.m)} edges, ${withCommas(facts.bends)} bends, box ` +
    facts.extents.map(withCommas).join(" \u00d7 ");
}

function fillLegend(d) {
  const roles = d.about.roles, direction = view.colours === "direction", list = byId("legend");
  const names = direction ? [...directionClasses(d).names, "other directions"] : roles.list.map(role => role.name);
  const used = new Set(direction ? directionClasses(d).classes : d.role);
  list.replaceChildren(...names.map((name, i) => {
    if (!used.has(direction && i === names.length - 1 ? 7 : i)) return "";
    const item = document.createElement("li"), swatch = document.createElement("i");
    swatch.style.background = `rgb(${view.palette[direction && i === names.length - 1 ? 7 : i].map(Math.round)})`;
    item.append(swatch, name);
    return item;
  }));
}

function fillViolations(d) {
  const list = d.about.verdict ? d.about.verdict.violations : [];
  byId("violations").hidden = !list.length;
  byId("violation-list").replaceChildren(...list.map((violation, k) => {
    const item = document.createElement("li"), button = document.createElement("button"), kind = document.createElement("b");
    kind.textContent = violation.kind.replace(/_/g, " ") + ": ";
    button.append(kind, violation.message);
    button.onclick = () => showViolation(k);
    item.append(button);
    return item;
  }));
}

function fillPanel(d) {
  fillViolations(d);
  byId("bound-label").hidden = !d.about.bound;
  byId("bound-text").textContent = d.about.bound ? "at most " + d.about.bound.text : "";
  byId("colours").options[0].disabled = !d.about.roles.title;
  byId("colours").options[0].textContent = d.about.roles.title || "role: not known of this algorithm";
  byId("grow").max = d.n;
  byId("names").disabled = d.n > 400;
}

function savePicture() {
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
