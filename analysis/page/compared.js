// Settings beside each other: what they trade, and collections of graphs.
import {byId, count, distinct, duration, element, grouped, number, percent, powerOfN, rowsOf, settingName, shortName, span} from "./values.js";
import {folded, makeTable, withSmall} from "./tables.js";
import {colour, figure} from "./charts.js";
import {graphButton, nameOf} from "./graphs.js";

const kMostCrossings = 8, kMostGroupRows = 24;
const kShapes = {0: "square", 1: "circle", 2: "circle", 3: "triangle", 4: "square2", 5: "diamond"};
const shapeOf = bends => kShapes[bends] ?? "star";
const bendText = bends => bends === 0 ? "straight edges" : bends < 6 ? `at most ${Math.max(2, bends)} bends an edge` : "more bends an edge";

const groupText = group => `${group.families === 1 ? group.family + ", which" : count(group.families) + " families that"} ${count(group.settings)} settings drew`;

const tradeChart = (group, n) => {
  const rows = rowsOf("trade").filter(row => row.group === group && row.n === n && row.time !== null), about = rowsOf("groups")[group];
  const front = rows.filter(row => row.front).sort((a, b) => a.time - b.time);
  return {file: "trade-n-" + n, title: `Volume against drawing time, n = ${span(rows[0])}`, x: {title: "drawing time", format: "seconds"},
    note: `medians over ${groupText(about)}; marks: ${distinct(rows.map(row => bendText(row.bends))).join(", ")}; line: nothing is smaller and faster`,
    y: {title: "volume in " + about.unit, format: "power"},
    lines: [{name: "Pareto front", css: "front", stroke: "var(--muted)", dash: "3 3", width: 1.2, curve: "step-after", points: front.map(row => ({x: row.time, y: row.volume}))}],
    symbols: rows.map(row => ({name: settingName(row.setting), label: shortName(row.setting), fill: colour(row.setting), shape: shapeOf(row.bends),
      points: [{x: row.time, y: row.volume}]}))};
};

const volumeChart = group => {
  const about = rowsOf("groups")[group], divisor = powerOfN(about.order), rows = grouped(rowsOf("trade").filter(row => row.group === group), row => row.setting);
  const crossings = rowsOf("crossings").filter(row => row.group === group);
  return {file: "volume", title: "Volume against n", note: `in ${about.unit}, divided by ${divisor}; medians over ${groupText(about)}`,
    x: {title: "vertices n"}, y: {title: "volume / " + divisor, format: "power"},
    lines: [...rows].map(([setting, points]) => ({name: settingName(setting), label: shortName(setting), stroke: colour(setting), points: points.map(row => ({x: row.n, y: row.over}))})),
    symbols: crossings.length ? [{name: "crossings", css: "crossing", hollow: true, size: 4, points: crossings.map(row => ({x: row.n, y: row.over}))}] : []};
};

const crossingList = group => element("ul", {class: "crossings"}, rowsOf("crossings").filter(row => row.group === group).slice(0, kMostCrossings)
  .map(row => element("li", {}, `${settingName(row.below)} needs less volume than ${settingName(row.above)} from about n = ${count(row.n)} on ` +
    `(there ${count(row.smaller)} of ${count(row.graphs)} graphs that both drew)`)));

/** Sizes at which two settings of the group have a time, with how many. */
const tradeSizes = group => [...grouped(rowsOf("trade").filter(row => row.group === group && row.time !== null), row => row.n)]
  .filter(([, rows]) => rows.length >= 2).map(([n, rows]) => ({n, text: span(rows[0]), settings: rows.length})).sort((a, b) => a.n - b.n);

/** The largest n at which most settings are compared. */
const firstShown = sizes => sizes.reduce((best, one) => !best || one.settings >= best.settings ? one : best, null)?.n;

export const tradeSection = () => {
  const groups = rowsOf("groups"), section = byId("trade"), groupChoice = byId("trade-group"), sizeChoice = byId("trade-n");
  if (!groups.length) return;
  section.hidden = false;
  byId("own-unit").hidden = !groups.some(group => group.unit.startsWith("cubes"));
  groupChoice.append(...groups.map((group, i) => element("option", {value: i}, groupText(group))));
  const trade = figure(() => tradeChart(Number(groupChoice.value), Number(sizeChoice.value)), {id: "trade-figure"});
  const list = element("div", {}, crossingList(0)), volume = figure(() => volumeChart(Number(groupChoice.value)), {}, list);
  const offer = () => {
    const sizes = tradeSizes(Number(groupChoice.value)), before = Number(sizeChoice.value);
    sizeChoice.replaceChildren(...sizes.map(({n, text}) => element("option", {value: n}, text)));
    if (sizes.length) sizeChoice.value = sizes.some(({n}) => n === before) ? before : firstShown(sizes);
    trade.hidden = byId("trade-at").hidden = !sizes.length;
    byId("trade-untimed").hidden = sizes.length > 0;
  };
  offer();
  sizeChoice.addEventListener("change", () => trade.paint());
  groupChoice.addEventListener("change", () => {
    offer();
    list.replaceChildren(crossingList(Number(groupChoice.value)));
    for (const one of [trade, volume]) one.paint();
  });
  section.querySelector(".figures").append(trade, volume);
};

/** What efforts buy, over the first one of their algorithm. */
export const effortChart = () => {
  const rows = rowsOf("efforts").filter(row => row.time !== null);
  const algorithms = [...grouped(rows, row => row.algorithm)];
  return {file: "effort", title: "What effort buys", note: "time and volume over those of the algorithm's first effort, at its largest n", x: {title: "times the drawing time"}, y: {title: "times the volume"},
    lines: algorithms.map(([algorithm, those], i) => ({name: algorithm, label: `${algorithm}, n = ${count(those[0].n)}`, stroke: colour(i), points: those.map(row => ({x: row.time, y: row.volume}))})),
    symbols: algorithms.map(([algorithm, those], i) => ({name: algorithm, fill: colour(i), points: those.map(row => ({x: row.time, y: row.volume}))}))};
};
export const effortTable = () => makeTable([{name: "Setting", show: row => settingName(row.setting)}, {name: "n", value: row => row.n, show: row => count(row.n)},
  {name: "Times the volume", value: row => row.volume, show: row => number(row.volume)},
  ...rowsOf("efforts").some(row => row.time !== null) ? [{name: "Times the drawing time", value: row => row.time, show: row => number(row.time)}] : []], rowsOf("efforts"));

const kMeasures = {volume: {title: "Volume", format: "power", show: value => number(value)}, "drawing time": {title: "Drawing time", format: "seconds", show: duration, unit: "s"},
  "total edge length": {title: "Total edge length", format: "power", show: value => number(value), unit: "smallest vertex distances"},
  "smallest angle at a vertex": {title: "Smallest angle at a vertex", format: "count", show: value => number(value), unit: "degrees"},
  "smallest angle at a bend": {title: "Smallest angle at a bend", format: "count", show: value => number(value), unit: "degrees"},
  "longest over mean edge": {title: "Longest over mean edge", format: "count", show: value => number(value), unit: "mean edges"},
  crossings: {title: "Crossings", format: "count", show: value => number(value), unit: "crossings", added: 1}, bends: {title: "Bends", format: "count", show: value => number(value), unit: "bends", added: 1}};
const unitOf = (name, measure) => kMeasures[measure].unit ?? rowsOf("collections").find(row => row.collection === name).unit;

const profileChart = (name, measure, rows, isCommon) => ({file: `${name}-profile-${measure}${isCommon ? "-common" : ""}`, title: "Within a factor of the best: " + kMeasures[measure].title + (kMeasures[measure].added ? " + 1" : ""),
  note: `share of ${count(rows[0].graphs)} graphs that ${isCommon ? "every" : "some"} setting drew`,
  x: {title: "factor of the best", format: rows.at(-1).factor < 1000 ? "count" : "power"}, y: {title: "share of graphs", type: "linear", domain: [0, 1], format: "share"},
  lines: [...grouped(rows, row => row.setting)].map(([setting, points], i) => ({name: settingName(setting), label: settingName(setting), stroke: colour(i), points: points.map(row => ({x: row.factor, y: row.share}))}))});

/** A choice between figures, and the one that is chosen. */
const chosenFigure = (label, choices, below = () => null) => {
  if (!choices.length) return null;
  const select = element("select", {class: "pick"}, choices.map(({text}, i) => element("option", {value: i}, text)));
  const chosen = () => choices[Number(select.value)], list = element("div", {}, below(choices[0]));
  const shown = figure(() => chosen().chart(), {}, list);
  select.addEventListener("change", () => {
    list.replaceChildren(...[below(chosen())].flat().filter(Boolean));
    shown.paint();
  });
  return element("div", {}, element("label", {class: "choice"}, label + " ", select), shown);
};

const profilePart = (name, of) => chosenFigure("Quality beside the best drawing of a graph ", [["profile", false], ["common_profile", true]].flatMap(([table, isCommon]) => of(table).map(([measure, rows]) =>
  ({text: `${kMeasures[measure].title}, graphs that ${isCommon ? "every" : "some"} setting drew`, chart: () => profileChart(name, measure, rows, isCommon)}))));

const pairChart = (name, measure, pair) => {
  const mine = row => row.collection === name && row.measure === measure && row.setting === pair.setting && row.other === pair.other;
  const rows = rowsOf("pairs").filter(mine), points = rows.filter(row => !row.outlier), ends = rows.filter(row => row.outlier);
  const values = rows.flatMap(row => [row.value, row.other_value]), low = Math.min(...values), high = Math.max(...values), format = kMeasures[measure].format;
  return {file: `${name}-${measure}-${settingName(pair.setting)}-${settingName(pair.other)}`, title: `${kMeasures[measure].title}: ${settingName(pair.other)} against ${settingName(pair.setting)}`,
    note: `${count(pair.graphs)} graphs that both drew; above the diagonal ${percent(pair.share)}`, x: {title: settingName(pair.setting), format}, y: {title: settingName(pair.other), format},
    lines: [{name: "equal", css: "bound", stroke: "var(--bound)", dash: "7 4", points: [{x: low, y: low}, {x: high, y: high}]}],
    dots: [{name: "graphs", css: "points", stroke: colour(0), points: points.map(row => ({x: row.value, y: row.other_value, row: row.other_row}))}],
    symbols: ends.map(row => ({name: nameOf(row.row), label: nameOf(row.row), css: "crossing", hollow: true, size: 4, stroke: colour(1), points: [{x: row.value, y: row.other_value}]}))};
};

const outlierList = (name, measure, pair) => element("ul", {class: "crossings"}, rowsOf("pairs").filter(row => row.outlier && row.collection === name && row.measure === measure &&
  row.setting === pair.setting && row.other === pair.other).map(row => element("li", {}, `${nameOf(row.row)}: \u00d7 ${number(row.ratio)} `,
  graphButton(row.row, settingName(pair.setting)), " ", graphButton(row.other_row, settingName(pair.other)))));

/** What the graphs that both settings drew say together. */
const pairSentence = pair => `On ${count(pair.graphs)} graphs that both drew: ${kMeasures[pair.measure].title.toLowerCase()}${kMeasures[pair.measure].added ? " + 1" : ""} of ${settingName(pair.other)} is ${number(pair.ratio)} times ` +
  `that of ${settingName(pair.setting)} in the median (95 %: ${number(pair.ratio_low)} to ${number(pair.ratio_high)}), larger for ${percent(pair.share)}, equal for ${count(pair.ties)}; sign test p = ${number(pair.p)}.`;

/** The choice of two settings of a scatter, and its figure. */
const pairPart = name => chosenFigure("One graph, two settings ", rowsOf("pair_counts").filter(row => row.collection === name).map(pair => ({pair, chart: () => pairChart(name, pair.measure, pair),
  text: `${kMeasures[pair.measure].title}: ${settingName(pair.other)} against ${settingName(pair.setting)}`})), ({pair}) => [element("p", {}, pairSentence(pair)), outlierList(name, pair.measure, pair)]);

const binChart = (name, measure, rows) => ({file: `${name}-by-n-${measure}`, title: kMeasures[measure].title + " against n", note: "medians over bins of n", x: {title: "vertices n"},
  y: {title: unitOf(name, measure), format: kMeasures[measure].format},
  lines: [...grouped(rows, row => row.setting)].map(([setting, points], i) => ({name: settingName(setting), label: settingName(setting), stroke: colour(i), points: points.map(row => ({x: row.n, y: row.median}))}))});

const groupTable = (name, measure, rows, isFirst) => {
  const groups = [...grouped(rows, row => row.group).values()], settings = distinct(rows.map(row => row.setting)), {title, show} = kMeasures[measure];
  const of = setting => group => group.find(row => row.setting === setting);
  return folded(`${title} by group`, isFirst, element("p", {class: "muted"}, `In ${unitOf(name, measure)}: median and (grey) the tenths at either end, over the graphs that the setting drew.`),
    makeTable([{name: "Group", show: group => group[0].group}, {name: "Graphs", value: group => group[0].graphs, show: group => count(group[0].graphs)},
      ...settings.map(setting => ({name: settingName(setting), value: group => of(setting)(group)?.median ?? null, show: group => of(setting)(group)
        ? withSmall(show(of(setting)(group).median), `${show(of(setting)(group).low)} \u2013 ${show(of(setting)(group).high)}`) : "\u2013"}))], groups.slice(0, kMostGroupRows)),
    groups.length > kMostGroupRows ? element("p", {}, `The first ${kMostGroupRows} of ${count(groups.length)} groups.`) : null);
};

const collectionSection = ([name, settings], place) => {
  const of = table => [...grouped(rowsOf(table).filter(row => row.collection === name), row => row.measure)];
  const column = (title, key) => ({name: title, value: row => row[key], show: row => count(row[key])});
  return element("section", {id: "c" + place, "data-nav": place === 0 ? "What of the collection?" : name}, element("h2", {}, "Collection " + name),
    element("p", {}, "Who drew how many of its graphs, and how good the drawings are beside the best one of the same graph."),
    makeTable([{name: "Setting", show: row => settingName(row.setting)}, column("Graphs", "graphs"), column("Drawn", "drawn"), {name: "Share", value: row => row.share, show: row => percent(row.share)},
      column("Refused rows", "refused"), column("Violated rows", "violated"), column("Unfinished rows", "unfinished")], settings),
    element("div", {class: "figures"}, profilePart(name, of), pairPart(name),
      of("bins").map(([measure, rows]) => figure(() => binChart(name, measure, rows)))),
    of("group_medians").map(([measure, rows], i) => groupTable(name, measure, rows, i === 0)));
};

export const collectionSections = () => byId("collections").append(...[...grouped(rowsOf("collections"), row => row.collection)].map(collectionSection));

/** Batches of equal drawings that threads or ranks share. */
export const scalingSection = () => {
  const rows = rowsOf("scaling"), section = byId("strong-weak");
  if (!rows.length) return;
  section.hidden = false;
  const charts = [...grouped(rows, row => `${row.algorithm}: ${row.kind} scaling${row.shared_by === "ranks" ? " over ranks" : ""}`)].map(([title, those]) => figure(() => {
    const most = Math.max(...those.map(row => row.sharers)), {shared_by: by, kind} = those[0];
    return {file: title, title, note: kind === "strong" ? `the same drawings shared by more ${by}` : `as many drawings for each of the ${by}`, 
      x: {title: by, ticks: distinct(those.map(row => row.sharers)).sort((a, b) => a - b), show: count}, y: {title: "drawings at a time"},
      symbols: those.filter(row => row.crowded).map(row => ({name: "crowded", css: "crossing", hollow: true, size: 5, points: [{x: row.sharers, y: row.at_a_time}]})),
      lines: [...[...grouped(those, row => `n = ${count(row.n)}, ${row.family}`)].map(([name, points], i) => ({name, label: i < 8 ? name : "", stroke: colour(i), points: points.map(row => ({x: row.sharers, y: row.at_a_time}))})),
        {name: "ideal", label: "ideal", css: "bound", stroke: "var(--bound)", dash: "7 4", points: [{x: 1, y: 1}, {x: most, y: most}]}]};
  }));
  section.querySelector(".figures").append(...charts);
  const serialPart = row => row.serial === null || row.crowded ? "\u2013" : withSmall(percent(row.serial), `${percent(row.serial_low)} \u2013 ${percent(row.serial_high)}`);
  const by = row => `${count(row.sharers)} ${row.sharers === 1 ? row.shared_by.slice(0, -1) : row.shared_by}`;
  section.lastElementChild.append(makeTable([{name: "Algorithm", show: row => row.algorithm}, {name: "Kind", show: row => row.kind}, {name: "Family", show: row => row.family},
    {name: "n", value: row => row.n, show: row => count(row.n)}, {name: "Shared by", value: row => row.sharers, show: by},
    {name: "Batch", value: row => row.batch, show: row => withSmall(duration(row.batch), row.batch_low === null ? "" : `${duration(row.batch_low)} \u2013 ${duration(row.batch_high)}`)},
    {name: "Ideal", value: row => row.ideal, show: row => duration(row.ideal)}, {name: "Efficiency", value: row => row.efficiency, show: row => row.crowded ? "not told: too few cores" : percent(row.efficiency)},
    ...rows.some(row => row.serial !== null) ? [{name: "Serial part", value: row => row.serial, show: serialPart}] : []], rows));
  byId("crowded").hidden = !rows.some(row => row.crowded);
  byId("crowded").textContent = "Batches of more threads than cores that the study could use share these cores: their efficiency says nothing of the program. Hollow marks show them.";
};
