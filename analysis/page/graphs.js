// Rows of the study: what a graph is, the lines that draw it again, its drawing in 3D, and the points of charts that stand for rows.
import {all, byId, count, duration, element, firstOf, number, rawTable, rowsOf} from "./values.js";

const table = rawTable("graphs"), rowName = table.columns.map(column => column.name);
const placeOfRow = new Map(table.rows.map((row, i) => [row[0], i]));

/** The graph of a row of /runs; nothing if the page does not know it. */
export const graphOf = row => {
  const at = placeOfRow.get(row);
  return at === undefined ? undefined : Object.fromEntries(rowName.map((name, i) => [name, table.rows[at][i]]));
};
let pointsByCurve = null;
/** The graphs that stand in the growth figures of a curve. */
export const pointsOf = curve => {
  if (!pointsByCurve) {
    const ofCurve = rowName.indexOf("curve"), isPoint = rowName.indexOf("is_point");
    pointsByCurve = new Map();
    for (const row of table.rows) {
      if (!row[isPoint]) continue;
      if (!pointsByCurve.has(row[ofCurve])) pointsByCurve.set(row[ofCurve], []);
      pointsByCurve.get(row[ofCurve]).push(row[0]);
    }
  }
  return (pointsByCurve.get(curve) ?? []).map(graphOf);
};
/** A graph's name where it has one. */
export const nameOf = row => graphOf(row)?.name ?? `row ${row}`;

/** What a graph is called beside its family: its name, or how many vertices it has. */
export const graphText = (row, n) => graphOf(row)?.name ?? `n = ${count(n)}`;

const settingOf = curve => rowsOf("settings")[curve.setting]?.setting ?? curve.algorithm;
const box = (graph, before) => ["x", "y", "z"].map(axis => graph[before + axis]);
const boxText = values => values.every(value => value !== null) ? values.map(value => number(value, 6)).join(" \u00d7 ") : "";

const describe = row => {
  const graph = graphOf(row), curve = rowsOf("bounds")[graph.curve];
  const lines = [curve.label ?? curve.family, settingOf(curve)];
  if (graph.name) lines.push(graph.name);
  lines.push(`${count(graph.n)} vertices, ${count(graph.m)} edges, seed ${graph.seed}`);
  if (graph.status) lines.push(graph.status.replaceAll("_", " "));
  for (const [name, before] of [["box ", ""], ["its own bound ", "own_"], ["the theorem's ", "theorem_"], ["the published ", "published_"]]) {
    const text = boxText(box(graph, before));
    if (text) lines.push(name + text);
  }
  if (graph.seconds !== null) lines.push(duration(graph.seconds));
  return lines;
};
const shellWord = text => /^[\w./,:@%+=-]+$/.test(text) ? text : "'" + text.replaceAll("'", "'\\''") + "'";
const commands = row => {
  const graph = graphOf(row), curve = rowsOf("bounds")[graph.curve];
  const again = `ar3d replay ${shellWord(firstOf("study").file)} ${row} -o drawing.html`;
  return curve.command ? `${curve.command}${graph.n} --seed ${graph.seed}${curve.command_end}\n${again}` : again;
};

const tip = byId("tip"), panel = byId("replay"), dialog = byId("shown"), opener = byId("open");
let viewer = null;

/** What packed_text packed. */
export const inflated = packed => {
  const bytes = Uint8Array.from(atob(packed), c => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate")));
};
/** The viewer's page, unpacked when it is first asked for; a frame of its own shows it, which is gone when it is closed. */
export const viewerText = () => viewer ??= inflated(byId("viewer").textContent).text();
const showDrawing = async row => {
  panel.hidden = true;
  const frame = element("iframe", {title: "The drawing in 3D"});
  dialog.querySelector("p").textContent = describe(row).slice(0, 3).join(" \u00b7 ");
  dialog.querySelector("button").onclick = () => { dialog.close(); replay(row); };
  dialog.querySelector("iframe")?.remove();  // the event of a dialog that was just closed comes later
  dialog.append(frame);
  dialog.showModal();
  frame.srcdoc = (await viewerText()).replace("<body>", `<body data-page="${Number(graphOf(row).drawing)}">`);
  frame.addEventListener("load", () => {
    frame.focus();  // where Escape closes the dialog, too, unless it takes a selection away
    frame.contentWindow.addEventListener("keydown", event => { if (event.key === "Escape" && !event.defaultPrevented) dialog.close(); });
  });
};
export const isDrawn = row => (graphOf(row)?.drawing ?? null) !== null;

/** Shows what the row is and the lines that draw it again. */
export function replay(row) {
  panel.hidden = false;
  panel.querySelector("p").textContent = describe(row).join(" \u00b7 ");
  panel.querySelector("code").textContent = commands(row);
  opener.hidden = !isDrawn(row);
  opener.onclick = () => showDrawing(row);
}
export const open = row => isDrawn(row) ? showDrawing(row) : replay(row);

/** A button that opens the drawing of a row, or says how it is drawn again. Who hears its text hears the graph's name, too. */
export const graphButton = (row, text) => {
  if (graphOf(row) === undefined) return element("span", {}, text);
  const name = graphOf(row).name ?? "", label = text.includes(name) ? null : `${text}, ${name}`;
  const button = element("button", {type: "button", class: "graph", "data-r": row, "aria-label": label}, text);
  button.addEventListener("click", () => open(row));
  return button;
};

// Points of charts.
const mark = document.createElementNS("http://www.w3.org/2000/svg", "circle");
mark.setAttribute("class", "on");
mark.setAttribute("r", 4);
let current = null;
const show = point => {
  current = point;
  tip.hidden = !point;
  mark.remove();
  if (!point) return;
  mark.setAttribute("cx", point.x);
  mark.setAttribute("cy", point.y);
  point.svg.append(mark);
  tip.textContent = describe(point.row).join("\n");
  const at = mark.getBoundingClientRect(), size = tip.getBoundingClientRect();
  const x = Math.min(at.right + 10, innerWidth - size.width - 6), y = at.top - size.height - 8;
  tip.style.left = Math.max(4, x) + "px";
  tip.style.top = (y < 4 ? at.bottom + 10 : y) + "px";
};
const placesOf = svg => all("path.points", svg).flatMap(path => path.places.map(place => ({svg, ...place})))
  .filter(place => placeOfRow.has(place.row)).sort((a, b) => a.x - b.x || b.y - a.y);
const nearest = (svg, event) => {
  const at = svg.getBoundingClientRect(), scale = svg.viewBox.baseVal.width / at.width;
  const x = (event.clientX - at.x) * scale, y = (event.clientY - at.y) * scale;
  let best = null, least = (18 * scale) ** 2;
  for (const point of placesOf(svg)) {
    const distance = (point.x - x) ** 2 + (point.y - y) ** 2;
    if (distance < least) [least, best] = [distance, point];
  }
  return best;
};
const step = (svg, event) => {
  const those = placesOf(svg), by = {ArrowRight: 1, ArrowLeft: -1}[event.key];
  if (event.key === "Enter" && current) replay(current.row);
  if (!by || !those.length) return;
  event.preventDefault();
  const start = by > 0 ? -1 : 0;
  const place = current?.svg === svg ? those.findIndex(point => point.row === current.row && point.x === current.x) : start;
  show(those[(place + by + those.length) % those.length]);
};

/** Makes charts answer the pointer and the arrow keys, and closes what Escape closes. */
export const listen = () => {
  document.addEventListener("painted", ({detail: svg}) => {
    if (!svg.querySelector("path.points")) return;
    svg.addEventListener("pointermove", event => show(nearest(svg, event)));
    svg.addEventListener("pointerleave", () => show(null));
    svg.addEventListener("blur", () => show(null));
    svg.addEventListener("click", event => {
      const point = nearest(svg, event);
      show(point);
      if (point) replay(point.row);
    });
    svg.addEventListener("keydown", event => step(svg, event));
  });
  const close = () => { panel.hidden = true; show(null); };
  panel.querySelector("button").addEventListener("click", () => {
    getSelection().selectAllChildren(panel.querySelector("code"));
    document.execCommand("copy");
  });
  panel.querySelector("button:last-of-type").addEventListener("click", close);
  document.addEventListener("keydown", event => { if (event.key === "Escape") close(); });
  addEventListener("scroll", () => show(null), {passive: true});
  dialog.querySelector("button:last-of-type").addEventListener("click", () => dialog.close());
  dialog.addEventListener("close", () => { if (!dialog.open) dialog.querySelector("iframe")?.remove(); });
};
