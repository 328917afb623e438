// The page of a history: changes with figures, every cell with a small picture, results, environments.
import {byId, change, count, distinct, duration, element, fill, firstOf, grouped, number, rowsOf} from "./values.js";
import {fillNavigation, makeTable} from "./tables.js";
import {colour, drawFigures, figure} from "./charts.js";

const kMostFigures = 60, kMostChanges = 1000, kMostCells = 5000;
const kLeastHeight = 0.02;  // of the values: less is not stretched to the whole height
const kMeasures = [["time", "Time"], ["instructions", "Instructions"], ["cycles", "Estimated cycles"], ["volume", "Volume"], ["bends", "Bends per edge"],
  ["crossings", "Crossings"], ["angle", "Smallest angle"]];
const kSpark = {width: 132, height: 30, air: 4};

const values = grouped(rowsOf("history"), row => row.line), changesOf = grouped(rowsOf("changes"), row => row.line);
const lines = rowsOf("lines").map((line, place) => ({...line, place}));
const resultName = result => rowsOf("results")[result].name;
const valueText = (measure, value) => measure === "time" ? duration(value) : number(value, 5);
const intervalText = row => row.change === null ? "" : row.low === row.high ? change(row.change) : `${change(row.change)} [${change(row.low)}, ${change(row.high)}]`;
const effectText = row => {
  const {measure} = lines[row.line];
  if (measure === "time") return intervalText(row);
  if (row.change === 0) return "some graphs more, others less";
  return [intervalText(row), `${valueText(measure, row.old_value)} to ${valueText(measure, row.new_value)}`].filter(Boolean).join(", ");
};

/** Lowest and highest value of a picture, at least kLeastHeight apart. */
const heightOf = numbers => {
  const low = Math.min(...numbers), high = Math.max(...numbers), middle = (low + high) / 2;
  const half = Math.max(high - low, middle > 0 ? kLeastHeight * middle : 1) / 2;
  return [middle - half, middle + half];
};

const lineChart = line => {
  const rows = values.get(line), about = lines[line], hasRatio = rows[0].change !== null, changes = changesOf.get(line) ?? [];
  const points = rows.map((row, i) => ({x: i, y: hasRatio ? row.change : row.value, level: hasRatio ? row.level : row.value}));
  const [low, high] = hasRatio ? heightOf(points.map(point => 1 + point.y)).map(y => y - 1) : heightOf(points.map(point => point.y));
  const step = Math.ceil(rows.length / 6), end = rows.length - 1;
  const levels = [...grouped(points, point => point.level)].map(([level, those]) => ({name: "level", stroke: colour(0), points: those.map(point => ({x: point.x, y: level}))}));
  return {file: `${about.measure}-${about.cell}`, title: `${about.measure} of ${about.cell}`, narrow: true,
    note: [`first value ${valueText(about.measure, rows[0].value)}; environment ${about.environment}`, ...changes.map(row => effectText(row) + (row.gradual ? " (gradual)" : ""))].join("; "),
    x: {type: "linear", domain: [-0.3, end + 0.3], title: "commits", ticks: rows.map((_, i) => i).filter(i => i % step === 0), show: i => resultName(rows[i].result).slice(0, 8)},
    y: {type: "linear", domain: [low, high], title: hasRatio ? "against the first value" : about.measure, format: hasRatio ? "change" : "count"},
    bands: changes.map(row => ({name: "95 %", fill: colour(1), points: [row.first - 0.52, row.last - 0.48].map(x => ({x, low, high}))})),
    lines: [...levels, ...changes.map(row => ({name: "change", css: "bound", stroke: "var(--bound)", dash: "7 4", points: [{x: row.at - 0.5, y: low}, {x: row.at - 0.5, y: high}]}))],
    dots: [{name: "values", css: "points", stroke: colour(0), size: 5.2, points: points.map(({x, y}) => ({x, y}))}]};
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
  for (const row of changesOf.get(line.place) ?? []) shape("path", {class: "bound", d: `M${x(row.at - 0.5)} ${air}V${height - air}`});
  shape("polyline", {class: "median", points: rows.map((row, i) => `${x(i).toFixed(1)},${y(row.value).toFixed(1)}`).join(" ")});
  const turn = () => svg.classList.toggle("large");
  svg.addEventListener("click", turn);
  svg.addEventListener("keydown", event => { if (event.key === "Enter") turn(); });
  return svg;
};

const headPart = () => {
  const about = firstOf("summary"), verdict = document.querySelector(".verdict"), many = (number_, name) => `${count(number_)} ${name}${number_ === 1 ? "" : "s"}`;
  fill("folder", about.folder);
  verdict.textContent = many(about.changes, "change");
  verdict.classList.add(about.judged === 0 ? "incomplete" : about.changes === 0 ? "pass" : "violated");
  byId("counts").textContent = `${count(about.results)} results, ${many(about.environments, "environment")}; ${count(about.judged)} of ${count(about.lines)} lines judged`;
  byId("unjudged").hidden = about.unjudged === 0;
  byId("unjudged").textContent = `${count(about.unjudged)} lines are not judged: times need ${about.shortest} results of one environment, the others two, and where all results have counts, these are judged and times are not.`;
};

const changesPart = () => {
  const changes = rowsOf("changes"), [part, figures] = [byId("changes").querySelector("div"), byId("changes").querySelector(".figures")];
  if (!changes.length) {
    part.append(element("p", {}, "Nothing that was judged."));
    return;
  }
  const names = (before, after) => [element("code", {}, before), " \u2192 ", element("code", {}, after)];
  const between = row => [row.gradual ? "gradual, about " : "", names(row.before, row.after), row.surely_before === row.before && row.surely_after === row.after ? ""
    : [element("br"), element("small", {}, "95 %: ", names(row.surely_before, row.surely_after))]];
  if (changes.length > kMostChanges) part.append(element("p", {}, `The ${count(kMostChanges)} largest of ${count(changes.length)} changes.`));
  part.append(makeTable([{name: "Change", css: "note", show: row => element("span", {class: row.worse ? "violated" : "pass"}, row.direction)}, {name: "Effect", show: effectText},
    {name: "Cell", css: "note", show: row => lines[row.line].cell}, {name: "Between", show: between}, {name: "Environment", value: row => lines[row.line].environment},
    {name: "Compare the results", css: "note", show: row => element("code", {}, row.command)}], changes.slice(0, kMostChanges)));
  figures.append(...distinct(changes.map(row => row.line)).slice(0, kMostFigures).map(line => figure(() => lineChart(line))));
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
    {name: "Machine, times as slow as usual", value: row => row.slowness, show: row => row.slowness.toFixed(2)}, {name: "Times left out", css: "note", show: row => row.untimed}], rowsOf("results")));
  const settings = [...grouped(rowsOf("environments"), row => row.name)], environments = firstOf("summary").environments, part = byId("environments").querySelector("div");
  if (environments > 1) part.append(element("p", {}, "What differs between them."));
  part.append(makeTable([{name: "Setting", show: ([name]) => name}, ...Array.from({length: environments}, (_, i) => ({name: String(i + 1), css: "note", show: ([,
    rows]) => rows.find(row => row.environment === i + 1)?.value ?? ""}))], settings));
};

headPart();
changesPart();
cellsPart();
resultsPart();
fillNavigation();
addEventListener("DOMContentLoaded", drawFigures);
