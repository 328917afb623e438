// One section a setting: how its quantities grow, the share of the bound by family and n, its bounds by family, its bends.
import {all, byId, count, distinct, element, grouped, interval, number, percent, powerOfN, rowsOf, shortCount} from "./values.js";
import {folded, makeTable, withSmall} from "./tables.js";
import {colour, figure} from "./charts.js";
import {graphButton, graphOf, graphText, isDrawn, open, pointsOf} from "./graphs.js";

const kMostOpenRows = 24, kMostOpenMap = 80;
const kShort = {volume: "volume", "drawing time": "time"};

/** What an exponent is called: "1.02 [1.00, 1.04] power law". */
export const exponentCell = (growth, digits = 3) => {
  if (!growth || growth.exponent === null) return ["\u2013"];
  const label = growth.growth + (growth.growth.startsWith("apparent") && growth.smallest_n ? ` on n = ${count(growth.smallest_n)} \u2013 ${count(growth.largest_n)}` : "");
  return withSmall(growth.exponent.toFixed(digits), [interval(growth.low, growth.high, digits), " ", label].filter(Boolean));
};

/** "none", or what is not right or not proved. */
export const violations = row => {
  const rest = row.unproved > 0 ? `${count(row.unproved)} of ${count(row.ok)} not proved` : "";
  if (row.violations > 0) return [element("b", {class: "violated"}, count(row.violations)), rest && "; " + rest];
  if (!row.ok) return [row.measured > 0 ? "measured, not judged" : "\u2013"];
  return [rest ? "none found, " + rest : element("span", {class: "pass"}, "none")];
};

/** The line of a family, its graphs as points, and its unfinished rows at the upper edge. */
const familyLine = (growth, quantity, points, chosen) => {
  const family = rowsOf("bounds")[growth.curve], isOn = Boolean(chosen?.has(growth.curve)), key = kShort[quantity] ?? "side", graphs = pointsOf(growth.curve);
  const stroke = growth.named ? colour(growth.named) : "var(--muted)", opacity = chosen && !isOn ? 0.15 : 1;
  return {line: {name: family.label, label: family.name, stroke, opacity, width: isOn ? 2.6 : 1.4, css: "family" + (isOn ? " on" : ""),
    points: points.map(row => ({x: row.n, y: row.median, low: row.least, high: row.largest}))},
  dots: [{name: family.label, css: "points", stroke, points: graphs.filter(graph => !graph.status && graph[key] !== null)
    .map(graph => ({x: graph.n, y: graph[key], row: graph.row}))},
  {name: family.label + ", unfinished", css: "points cut", stroke: "var(--bound)", size: 7,
    points: graphs.filter(graph => graph.status).map(graph => ({x: graph.n, y: null, row: graph.row}))}]};
};

const growthChart = (setting, quantity, chosen) => {
  const mine = row => row.setting === setting && row.quantity === quantity;
  const about = rowsOf("figures").find(mine), label = rowsOf("settings")[setting].setting, divisor = powerOfN(about.order), band = rowsOf("bands").filter(mine);
  const curves = grouped(rowsOf("curves").filter(row => row.quantity === quantity), row => row.curve);
  const families = growthRows(setting, quantity).filter(growth => (growth.named || chosen?.has(growth.curve)) && curves.has(growth.curve))
    .map(growth => familyLine(growth, quantity, curves.get(growth.curve), chosen));
  const lines = [...families.map(family => family.line), {name: "all families", css: "middle", stroke: colour(0), width: 2.6,
    points: band.map(row => ({x: row.n, y: row.median, low: row.least, high: row.largest}))}];
  const bound = rowsOf("bound_lines").filter(mine).map(row => ({x: row.n, y: row.bound}));
  if (about.beyond === null) lines.push({name: "theorem's bound", label: "theorem's bound", css: "bound", stroke: "var(--bound)", dash: "7 4", points: bound});
  const format = quantity === "volume" || band.some(row => row.least < 0.01) ? "power" : "count";
  return {file: `${label}-${quantity}`, title: `${label}: ${quantity}${quantity.endsWith("extent") ? ", the nearest to its bound" : ""}`,
    x: {title: "vertices n"}, lines, dots: families.flatMap(family => family.dots).filter(one => one.points.length),
    y: {title: `${quantity} / ${divisor}, ${about.unit}`, format: quantity === "drawing time" ? "seconds" : format},
    bands: [{name: "all families", points: band.map(row => ({x: row.n, low: row.least, high: row.largest, median: row.median}))}],
    note: `${count(about.families)} families` + (about.beyond === null ? "" : `; the theorem's bound lies at least ${number(about.beyond)} times above`)};
};

let growthByCurve = null;
const growthOf = (curve, quantity) => {
  growthByCurve ??= grouped(rowsOf("growth"), row => row.curve);
  return growthByCurve.get(curve)?.find(row => row.quantity === quantity);
};
const shownCurves = setting => rowsOf("bounds").map((row, curve) => ({...row, curve})).filter(row => row.setting === setting && row.is_shown);
function growthRows(setting, quantity) {
  return shownCurves(setting).map(row => growthOf(row.curve, quantity)).filter(Boolean);
}

const bandChart = setting => {
  const rows = rowsOf("volume_bands").filter(row => row.setting === setting), label = rowsOf("settings")[setting].setting;
  const of = rowsOf("figures").find(row => row.setting === setting && row.quantity === "volume");
  return {file: label + "-volume-band", title: label + ": volume between its bounds", x: {title: "vertices n"},
    note: "below: proved impossible; above: excluded by the theorem; line: drawn, median", y: {title: `volume / ${powerOfN(of.order)}, ${of.unit}`, format: "power"},
    bands: [{name: "from at least to at most", points: rows.map(row => ({x: row.n, low: row.least, high: row.most, median: row.drawn}))}],
    lines: [["drawn", "drawn", 2.6], ["proved: at least", "least", 1], ["theorem: at most", "most", 1]].map(([name, key, width]) => ({name, label: name, css: "middle", stroke: colour(0), width,
      points: rows.map(row => ({x: row.n, y: row[key]}))}))};
};

/** Bends per edge against n; of chosen families their own lines. */
const bendsByNChart = (setting, chosen) => {
  const band = rowsOf("bands").filter(row => row.setting === setting && row.quantity === "bends per edge"), {setting: label, promised_bends: promised} = rowsOf("settings")[setting];
  const bound = promised === null ? [] : [{name: "theorem's bound", label: "theorem's bound", css: "bound", stroke: "var(--bound)", dash: "7 4", points: [band[0], band.at(-1)].map(({n}) => ({x: n, y: promised}))}];
  const lines = [...grouped(rowsOf("bends_by_n").filter(row => row.setting === setting && chosen?.has(row.curve)), row => row.curve)].map(([curve, rows], i) => ({name: rowsOf("bounds")[curve].label,
    label: rowsOf("bounds")[curve].name, stroke: colour(i + 1), css: "family on", points: rows.map(row => ({x: row.n, y: row.median, low: row.least, high: row.largest}))}));
  return {file: label + "-bends-by-n", title: label + ": bends per edge", note: "least, median and largest of the families", x: {title: "vertices n"},
    y: {title: "bends per edge", type: "linear", domain: [0, 1.05 * Math.max(promised, ...band.map(row => row.largest))]},
    bands: [{name: "all families", points: band.map(row => ({x: row.n, low: row.least, high: row.largest, median: row.median}))}],
    lines: [...lines, {name: "all families", css: "middle", stroke: colour(0), width: 2.6, points: band.map(row => ({x: row.n, y: row.median, low: row.least, high: row.largest}))}, ...bound]};
};

const bendChart = setting => {
  const rows = rowsOf("bends").filter(row => row.setting === setting), label = rowsOf("settings")[setting].setting;
  return {file: label + "-bends", title: label + ": edges by bends", note: "share of all its edges", x: {title: "bends"}, y: {title: "edges"}, narrow: true,
    bars: rows.map(row => ({x: row.bends === 7 ? "7 or more" : String(row.bends), y: row.share}))};
};

const shareCell = row => {
  if (!row) return element("td");
  const shade = Math.min(9, Math.max(0, Math.floor(row.share * 10)));
  const cell = element("td", {class: `h${shade}${row.share > 1 ? " violated" : ""}${isDrawn(row.row) ? " shown" : ""}`, "data-r": row.row, "data-v": row.share, tabindex: 0, title: graphOf(row.row)?.name},
    percent(row.share, 0).replace(" %", ""));
  cell.addEventListener("click", () => open(row.row));
  cell.addEventListener("keydown", event => {
    if (event.key !== "Enter") return;
    event.preventDefault();  // else it also presses the dialog's first button
    open(row.row);
  });
  return cell;
};

/** Families × n: the largest share of the bound; the family that comes closest stands first. */
const heatMap = setting => {
  const shares = rowsOf("shares").filter(row => row.setting === setting);
  if (!shares.length) return null;
  if (shares.every(row => percent(row.share, 0) === "0 %")) {
    return element("p", {class: "muted"}, `No graph uses more than ${percent(Math.max(...shares.map(row => row.share)), 2)} of the theorem's bound on any axis.`);
  }
  const bins = distinct(shares.map(row => row.first_n)).sort((a, b) => a - b), ofCurve = grouped(shares, row => row.curve);
  const last = new Map(shares.map(row => [row.first_n, row.last_n])), top = curve => Math.max(...ofCurve.get(curve).map(row => row.share));
  const curves = [...ofCurve.keys()].sort((a, b) => top(b) - top(a));
  const columns = [{name: "Family"}, ...bins.map(bin => ({value: () => 0, title: `n = ${count(bin)}` + (last.get(bin) === bin ? "" : ` \u2013 ${count(last.get(bin))}`),
    name: last.get(bin) === bin ? shortCount(bin) : [shortCount(bin) + "\u2013", element("br"), shortCount(last.get(bin))]}))];
  const made = makeTable(columns, [], undefined, "heat");
  made.querySelector("tbody").append(...curves.map(curve => element("tr", {"data-f": curve}, element("th", {scope: "row"}, rowsOf("bounds")[curve].name),
    bins.map(bin => shareCell(ofCurve.get(curve).find(row => row.first_n === bin))))));
  return folded("Share of the theorem's bound by family and n", curves.length <= kMostOpenMap, element("p", {class: "muted"},
    "Per cent, the worst graph and axis; the family that comes closest stands first. A click on an underlined number opens its drawing in 3D; " +
    "on another one it shows the lines that draw it."), made);
};

const kStatuses = ["ok", "violated", "refused", "timeout", "out_of_memory", "crashed", "measured"];
const statuses = row => kStatuses.filter(name => row[name] > 0).map(name => `${count(row[name])} ${name.replaceAll("_", " ")}`).join(", ");
const fillColumn = axis => ({name: axis, value: row => row["share_" + axis],
  show: row => withSmall(element(row["share_" + axis] > 1 ? "b" : "span", {class: row["share_" + axis] > 1 ? "violated" : null}, percent(row["share_" + axis])),
    row["share_" + axis] === null ? "" : "\u00b7 " + percent(row["median_share_" + axis]))});

const boundsTable = rows => folded("Bounds table", rows.length <= kMostOpenRows, element("p", {class: "muted"},
  "Share of the theorem's bound that the worst and (grey) the median graph use, by axis; then the worst share over the axes of the proof's own bound for the very graph " +
  "and of the published bound. 100 % touches the bound."), makeTable([
  {name: "Family", show: row => row.label},
  {name: "n", value: row => row.largest_n, show: row => `${count(row.smallest_n)} \u2013 ${count(row.largest_n)}`},
  {name: "Rows", show: statuses}, {name: "Violations", value: row => row.violations, show: violations},
  fillColumn("x"), fillColumn("y"), fillColumn("z"),
  {name: "Own bound", value: row => row.own_share, show: row => percent(row.own_share)},
  {name: "Published", value: row => row.published_share, show: row => percent(row.published_share)},
  {name: "Worst graph", css: "note", show: row => row.worst_row === null ? "\u2013" : graphButton(row.worst_row, graphText(row.worst_row, row.worst_n))},
], rows, row => ({"data-f": row.curve})));

const timeLabel = growth => {
  if (!growth) return "\u2013";
  if (growth.untimed) return "not timed";
  return element("small", {}, [growth.reason, growth.next && "would decide: " + growth.next, fitted(growth)].filter(Boolean).join("; "));
};
const fitted = growth => {
  if (!growth || (growth.untimed && !growth.sizes)) return "";
  if (!growth.sizes) return "no finished size";
  return `${growth.sizes} of ${growth.of_sizes} sizes, n = ${count(growth.smallest_n)} \u2013 ${count(growth.largest_n)}` +
    (growth.unfinished ? `; ${count(growth.unfinished)} unfinished rows` : "");
};

/** What the first screen's exponents are of: least and largest of the families, the interval that covers all, and the labels. */
const exponentTable = setting => {
  const rows = rowsOf("exponents").filter(row => row.setting === setting && !row.untimed), labels = [["Power law", "power"], ["With logarithm", "logarithm"], ["Apparent", "apparent"], ["Undecided", "undecided"]];
  const value = (name, key) => ({name, value: row => row[key], show: row => row[key] === null ? "\u2013" : row[key].toFixed(2)});
  return rows.length ? makeTable([{name: "Exponents", show: row => row.quantity}, value("Least", "least"), value("Largest", "largest"), value("Interval from", "low"), value("to", "high"),
    ...labels.filter(([, key]) => rows.some(row => row[key] > 0)).map(([name, key]) => ({name, value: row => row[key], show: row => count(row[key])}))], rows) : null;
};

/** Bends per edge of a family at its largest n. */
const lastBends = curve => rowsOf("bends_by_n").findLast(row => row.curve === curve)?.median ?? null;

const growthTable = rows => {
  const of = quantity => row => growthOf(row.curve, quantity), isTimed = rows.some(row => of("drawing time")(row) && !of("drawing time")(row).untimed);
  const column = quantity => ({name: quantity[0].toUpperCase() + quantity.slice(1), css: "note", value: row => of(quantity)(row)?.exponent ?? null, show: row => exponentCell(of(quantity)(row))});
  const grown = rows.filter(row => of("longest side")(row) || of("drawing time")(row));
  if (!grown.length) return null;
  return folded("Growth, and how sure it is", rows.length <= kMostOpenRows, element("p", {class: "muted"},
    "Exponent a of n^a over the fitted sizes, with its 95 % interval and its label; the interval of a power law covers larger n, too. Volume is the number of lattice points of the box, " +
    "here also at the largest n as its share of the theorem's own box, and over what any drawing with this guarantee needs; small graphs also over their known optimum, median. Bends per edge are those at the largest n."), makeTable([
    {name: "Family", show: row => row.label}, column("longest side"), column("volume"),
    {name: "Share of the theorem's", value: row => row.volume_share, show: row => percent(row.volume_share)},
    {name: "Over the least", value: row => row.volume_over_least, show: row => number(row.volume_over_least)},
    ...grown.some(row => row.times_the_optimum !== null) ? [{name: "Times the optimum", value: row => row.times_the_optimum, show: row => number(row.times_the_optimum)}] : [],
    {name: "Bends per edge", value: row => lastBends(row.curve), show: row => number(lastBends(row.curve))},
    ...isTimed ? [column("drawing time"), {name: "Why, and the fit of the time", css: "note", show: row => timeLabel(of("drawing time")(row))}] : [],
  ], grown, row => ({"data-f": row.curve})));
};

/** Families that the figures and tables of a section show: those whose name holds one of the words. */
const highlight = (section, input, curves, state) => {
  const words = input.value.toLowerCase().split(",").map(word => word.trim()).filter(Boolean);
  state.chosen = words.length ? new Set(curves.filter(row => words.some(word => row.label.toLowerCase().includes(word))).map(row => row.curve)) : null;
  for (const shown of all("figure.growth", section)) shown.paint();
  for (const row of all("tr[data-f]", section)) row.hidden = Boolean(state.chosen) && !state.chosen.has(Number(row.dataset.f));
};

const settingSection = (row, setting) => {
  const curves = shownCurves(setting), state = {chosen: null}, id = "a" + setting, quantities = rowsOf("figures").filter(one => one.setting === setting);
  const figures = quantities.map(one => figure(() => growthChart(setting, one.quantity, state.chosen), {class: "growth"}));
  if (rowsOf("bands").some(one => one.setting === setting && one.quantity === "bends per edge")) figures.push(figure(() => bendsByNChart(setting, state.chosen), {class: "growth"}));
  const hasBound = quantities.some(one => one.beyond === null && rowsOf("bound_lines").some(line => line.setting === setting && line.quantity === one.quantity)) || row.promised_bends !== null;
  if (rowsOf("volume_bands").some(one => one.setting === setting)) figures.push(figure(() => bandChart(setting)));
  const growth = figures.length ? [element("div", {class: "figures"}, figures), element("p", {class: "muted"},
    "Band and thick line: least, median and largest of the families' medians. Lines: families, named at their end." + (hasBound ? " Dashed: the theorem's bound." : "")), exponentTable(setting)] : [];
  const input = element("input", {type: "search", class: "filter", placeholder: "part of a name", list: id + "-families"});
  const section = element("section", {id, class: "setting", "data-nav": row.setting}, element("h2", {}, row.setting),
    row.theorem ? element("p", {}, `Theorem's box: ${row.theorem}.`, element("br"), `Published box: ${row.published || "none"}.`) : null,
    row.shown < row.curves ? element("p", {class: "incomplete"}, `The ${count(row.shown)} of ${count(row.curves)} families that come closest to the bound; `,
      element("code", {}, "ar3d report --csv"), " lists all.") : null,
    element("p", {}, element("label", {class: "choice"}, "Highlight families ", input),
      element("datalist", {id: id + "-families"}, curves.map(curve => element("option", {value: curve.label})))),
    curves.length && curves.every(curve => curve.is_collection) ? folded("Growth", false, growth) : growth,
    heatMap(setting), boundsTable(curves), growthTable(curves),
    rowsOf("bends").some(one => one.setting === setting) ? folded("Bends", false, figure(() => bendChart(setting), {class: "bars"})) : null);
  input.addEventListener("input", () => highlight(section, input, curves, state));
  return section;
};

export const settingSections = () => byId("settings").append(...rowsOf("settings").map(settingSection));
