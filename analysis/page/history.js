// The page of a history: changes by commit, what times can show, every cell with a small picture, results, environments.
import {byId, change, count, distinct, duration, element, fill, firstOf, grouped, number, rowsOf} from "./values.js";
import {fillNavigation, makeTable} from "./tables.js";
import {colour, drawFigures, figure} from "./charts.js";

const kMostFigures = 60, kMostCommits = 200, kMostCells = 5000;
const kLeastHeight = 0.02;  // of the values: less is not stretched to the whole height
const kMeasures = [["time", "Time"], ["instructions", "Instructions"], ["cycles", "Estimated cycles"], ["volume", "Volume"], ["bends", "Bends per edge"],
  ["crossings", "Crossings"], ["angle", "Smallest angle"]];
const kSpark = {width: 132, height: 30, air: 4};

const results = rowsOf("results"), values = grouped(rowsOf("history"), row => row.line);
const lines = rowsOf("lines").map((line, place) => ({...line, place}));
const valueText = (measure, value) => measure === "time" ? duration(value) : number(value, 5);
const resultName = result => results[result].name;
/** Whether a change is of the line: of its setting, or of this cell alone. */
const isOf = (row, line) => row.measure === line.measure && results[row.at].environment === line.environment && results[row.at].study === line.study &&
  (row.setting === "" || row.setting === line.setting) && (row.cells > 1 || row.of === 1 || row.line === line.place);
const changesOf = line => rowsOf("changes").filter(row => isOf(row, line));
const effectText = row => row.change === null ? "" : row.change === 0 ? "some graphs more, others less" : row.low === row.high ? change(row.change) : `${change(row.change)} [${change(row.low)}, ${change(row.high)}]`;

/** Lowest and highest value of a picture, at least kLeastHeight apart. */
const heightOf = numbers => {
  const low = Math.min(...numbers), high = Math.max(...numbers), middle = (low + high) / 2;
  const half = Math.max(high - low, middle > 0 ? kLeastHeight * middle : 1) / 2;
  return [middle - half, middle + half];
};

const lineChart = line => {
  const rows = values.get(line.place), hasRatio = rows[0].change !== null, changes = changesOf(line);
  const points = rows.map((row, i) => ({x: i, y: hasRatio ? 1 + row.change : row.value})), all = points.map(point => point.y);
  const isWide = hasRatio && Math.max(...all) > 3 * Math.min(...all), [low, high] = heightOf(all);
  const step = Math.ceil(rows.length / 6), end = rows.length - 1, at = row => rows.findIndex(value => value.result === row.at) - 0.5;
  return {file: `${line.measure}-${line.cell}`, title: `${line.measure} of ${line.cell}`, narrow: true,
    note: `first value ${valueText(line.measure, rows[0].value)}; environment ${line.environment}`,
    x: {type: "linear", domain: [-0.3, end + 0.3], title: "commits", ticks: rows.map((_, i) => i).filter(i => i % step === 0), show: i => resultName(rows[i].result).slice(0, 8)},
    y: {...isWide ? {type: "log"} : {type: "linear", domain: [low, high]}, title: hasRatio ? "times the first value" : line.measure, format: "count"},
    lines: changes.map(row => ({name: "change", css: "bound", stroke: "var(--bound)", dash: "7 4", points: [{x: at(row), y: Math.min(...all)}, {x: at(row), y: Math.max(...all)}]})),
    dots: [{name: "values", css: "points", stroke: colour(0), size: 5.2, points}]};
};

/** A small picture of a line; a click or Enter makes it large. */
const sparkline = line => {
  const rows = values.get(line.place), [low, high] = heightOf(rows.map(row => row.value)), {width, height, air} = kSpark;
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg"), shape = (tag, attributes) => {
    const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    svg.append(made);
    return made;
  };
  const x = i => air + i / Math.max(1, rows.length - 1) * (width - 2 * air), y = value => height - air - (value - low) / (high - low) * (height - 2 * air);
  for (const [name, value] of [["class", "spark"], ["viewBox", `0 0 ${width} ${height}`], ["role", "img"], ["tabindex", "0"]]) svg.setAttribute(name, value);
  const [first, last] = [rows[0], rows.at(-1)].map(row => `${valueText(line.measure, row.value)} (${resultName(row.result)})`);
  shape("title", {}).textContent = `${line.measure} of ${line.cell}: ${first} to ${last}`;
  for (const row of changesOf(line)) shape("path", {class: "bound", d: `M${x(rows.findIndex(value => value.result === row.at) - 0.5)} ${air}V${height - air}`});
  shape("polyline", {class: "median", points: rows.map((row, i) => `${x(i).toFixed(1)},${y(row.value).toFixed(1)}`).join(" ")});
  const turn = () => svg.classList.toggle("large");
  svg.addEventListener("click", turn);
  svg.addEventListener("keydown", event => { if (event.key === "Enter") turn(); });
  return svg;
};

const headPart = () => {
  const about = firstOf("summary"), verdict = document.querySelector(".verdict"), many = (number_, name) => `${count(number_)} ${name}${number_ === 1 ? "" : "s"}`;
  const changes = rowsOf("changes").length;
  fill("folder", about.folder);
  verdict.textContent = many(changes, "change");
  verdict.classList.add(about.judged === 0 ? "incomplete" : changes === 0 ? "pass" : "violated");
  byId("counts").textContent = `${count(about.results)} results, ${many(about.environments, "environment")}; ${count(about.judged)} of ${count(about.lines)} lines judged`;
};

/** One line a commit; its settings under it. */
const changesPart = () => {
  const commits = [...grouped(rowsOf("changes"), row => JSON.stringify([row.at, row.before])).values()], [part, figures] = [byId("changes").querySelector("div"), byId("changes").querySelector(".figures")];
  if (!commits.length) part.append(element("p", {}, "Nothing that was judged."));
  if (commits.length > kMostCommits) part.append(element("p", {}, `The last ${count(kMostCommits)} of ${count(commits.length)} commits with changes.`));
  const settingOf = row => row.setting === "" ? "all settings" : row.cells === 1 ? lines[row.line].cell : row.setting;
  for (const rows of commits.slice(0, kMostCommits)) {
    const {at, before, command} = rows[0];
    part.append(element("h3", {}, element("code", {}, resultName(at)), " after ", element("code", {}, resultName(before)), `, environment ${results[at].environment}`),
      makeTable([{name: "Setting", show: settingOf}, {name: "Change", css: "note", show: row => element("span", {class: row.worse ? "violated" : "pass"}, row.direction)}, {name: "Effect", show: effectText},
        {name: "Cells", value: row => row.cells, show: row => `${count(row.cells)} of ${count(row.of)}`}, {name: "Most in", css: "note", show: row => lines[row.line].cell}], rows), element("p", {}, element("code", {}, command)));
  }
  figures.append(...distinct(rowsOf("changes").map(row => row.line)).slice(0, kMostFigures).map(line => figure(() => lineChart(lines[line]))));
};

const sightPart = () => {
  const shown = value => value === null ? "\u2013" : change(value);
  byId("sight").querySelector("div").append(makeTable([{name: "Setting", show: row => row.setting}, {name: "Study", show: row => row.study},
    {name: "Environment", value: row => row.environment}, {name: "Cells", value: row => row.cells, show: row => count(row.cells)},
    {name: "Results", value: row => row.results, show: row => count(row.results)}, {name: "In the last result", value: row => row.at_once, show: row => shown(row.at_once)},
    {name: "With most results on either side", value: row => row.best, show: row => shown(row.best)}], rowsOf("sights")));
  byId("sight").hidden = !rowsOf("sights").length;
};

const cellsPart = () => {
  const cells = [...grouped(lines, line => JSON.stringify([line.environment, line.study, line.setting, line.family, line.n, line.graphs])).values()], part = byId("cells").querySelector("div");
  if (cells.length > kMostCells) part.append(element("p", {}, `The first ${count(kMostCells)} of ${count(cells.length)} cells; `, element("code", {}, "--json"), " has all."));
  const measure = ([key, name]) => {
    const of = cell => cell.find(line => line.measure === key), last = cell => values.get(of(cell).place).at(-1).value;
    return {name, value: cell => of(cell) ? last(cell) : null, show: cell => of(cell) ? [valueText(key, last(cell)), of(cell).judged ? "" : element("small", {}, " not judged"), element("br"), sparkline(of(cell))] : "\u2013"};
  };
  part.append(makeTable([{name: "Algorithm", show: cell => cell[0].setting}, {name: "Family", css: "note", show: cell => cell[0].family}, {name: "n", value: cell => cell[0].n, show: cell => count(cell[0].n)},
    {name: "Study", show: cell => cell[0].study}, {name: "Environment", value: cell => cell[0].environment}, ...kMeasures.map(measure)], cells.slice(0, kMostCells)));
};

const resultsPart = () => {
  byId("results").querySelector("div").append(makeTable([{name: "Place", value: row => row.place}, {name: "Name", show: row => row.name}, {name: "Commit", show: row => element("code", {}, row.commit)},
    {name: "Study", show: row => row.study}, {name: "Begun", show: row => row.created}, {name: "Environment", value: row => row.environment}, {name: "Unfinished rows", value: row => row.unfinished, show: row => count(row.unfinished)},
    {name: "Machine, times as slow as usual", value: row => row.slowness, show: row => row.slowness.toFixed(2)}, {name: "Times left out", css: "note", show: row => row.untimed}], results));
  const settings = [...grouped(rowsOf("environments"), row => row.name)], environments = firstOf("summary").environments, part = byId("environments").querySelector("div");
  if (environments > 1) part.append(element("p", {}, "What differs between them."));
  part.append(makeTable([{name: "Setting", show: ([name]) => name}, ...Array.from({length: environments}, (_, i) => ({name: String(i + 1), css: "note", show: ([,
    rows]) => rows.find(row => row.environment === i + 1)?.value ?? ""}))], settings));
};

headPart();
changesPart();
sightPart();
cellsPart();
resultsPart();
fillNavigation();
addEventListener("DOMContentLoaded", drawFigures);
