// What accuracy costs: misses of real types, predicted and seen, certificates, levels of detail, efforts.
import {byId, count, distinct, duration, element, firstOf, grouped, number, percent, raised, rowsOf, shortName} from "./values.js";
import {folded, makeTable, withSmall} from "./tables.js";
import {colour, figure} from "./charts.js";
import {effortChart, effortTable} from "./compared.js";
import {realStudy} from "./real.js";

const kLimits10 = [-30, -27, -24, -21, -18, -15, -12, -9, -6, -3, -2, -1], kMostOpenRates = 80;
const kMostSentences = 40, kMostOpenLevels = 24, kMostPoints = 3000;
let made;
const real = () => made ??= realStudy(rowsOf("real_drawings"), rowsOf("bounds"), rowsOf("curves"));
const typeName = type => real().types[type].type;
const limitText = limit => limit === 1 ? "1" : "10" + raised(Math.round(Math.log10(limit)));

const missChart = unit => {
  const about = real(), isMiss = unit === "miss", of = rows => [...grouped(rows.filter(row => row[unit] > 0), row => row.type)];
  const predicted = isMiss ? [] : real().predicted, misses = of(real().misses);
  const points = rows => rows.map(row => ({x: row.n, y: row[unit], row: row.row}));
  return {file: isMiss ? "miss" : "miss-in-roundings", title: isMiss ? "Largest miss of an angle against n" : "The same in units of each type's rounding",
    note: isMiss ? about.family + ": medians, and one point per drawing" : `${about.family}: miss in radians \u00b7 2^p, p bits; shaded: \u03baC from the drawings in ${about.model} alone`,
    x: {title: "vertices n"}, y: {title: isMiss ? "largest miss in degrees" : "miss in roundings of the type", format: "power"},
    bands: predicted.length ? [{name: "predicted", points: predicted.map(row => ({x: row.n, low: row.low, high: row.high, median: row.median}))}] : [],
    dots: misses.map(([type, rows]) => ({name: typeName(type), css: "points", stroke: colour(type), points: points(rows.slice(0, kMostPoints))})),
    symbols: misses.map(([type, rows]) => ({name: typeName(type) + " broken", css: "broken", fill: "var(--bound)", shape: "times", points: points(rows.filter(row => row.broken))})).filter(one => one.points.length),
    lines: of(real().medians).map(([type, rows]) => ({name: typeName(type) + " median", label: typeName(type), stroke: colour(type), points: rows.map(row => ({x: row.n, y: row[unit]}))}))};
};

const accuracyChart = () => {
  const rows = real().accuracies.filter(row => row.time !== null && row.miss > 0), last = Math.max(...rows.map(row => row.n));
  const misses = rows.map(row => row.miss), ends = [Math.min(...misses), Math.max(...misses)], exact = real().compared.find(at => at.family === real().family && at.n === last)?.exact ?? [];
  return {file: "accuracy-against-time", title: "What accuracy costs", note: real().family + ": medians, a line of types for each n; dashed: nothing is faster and more accurate" +
    (exact.length ? `; upright lines: exact integers at n = ${count(last)}, which miss nothing` : ""),
    x: {title: "drawing time a vertex", format: "seconds"}, y: {title: "largest miss in degrees", format: "power"},
    lines: [...exact.map(({setting, time}) => ({name: shortName(setting) + ", exact", label: shortName(setting), css: "exact", stroke: colour(setting), width: 1.4, points: ends.map(y => ({x: time, y}))})),
      ...[...grouped(rows, row => row.n)].map(([n, those]) => ({name: `front at n = ${n}`, css: "front", stroke: "var(--muted)", dash: "3 3", width: 1.2, curve: "step-after",
      points: those.filter(row => row.front).sort((a, b) => a.time - b.time).map(row => ({x: row.time, y: row.miss}))}))],
    symbols: rows.map(row => ({name: `${typeName(row.type)} at n = ${row.n}`, label: row.n === last ? typeName(row.type) : "", fill: colour(row.type), points: [{x: row.time, y: row.miss}]}))};
};
const missCell = point => {
  if (!point) return "\u2013";
  const time = point.time ?? point.cpu;
  return withSmall(number(point.largest, 2), time === null ? "" : duration(time));
};
/** Family × n × type: the largest miss and (grey) the time a vertex; beside them the exact algorithms on the same graphs. */
const accuracyTable = () => {
  const rows = real().compared, isTimed = rows.some(row => row.types.some(one => one.time !== null)), settings = distinct(rows.flatMap(row => row.exact.map(one => one.setting)));
  const of = type => row => row.types.find(one => one.type === type);
  return folded("Largest miss and time by family, n and type", rows.length <= kMostOpenRates, element("p", {class: "muted"}, "Largest miss of an angle in degrees over the drawings, and (grey) the " +
    `${isTimed ? "drawing time of the timing phase" : "CPU time of the metrics phase, where rows ran beside others,"} a vertex. log2 C is what the family's condition costs at its largest n: the number of bits that angles lose.`),
  makeTable([{name: "Family", show: row => row.family}, {name: "n", value: row => row.n, show: row => count(row.n)},
    ...real().types.map((type, i) => ({name: type.type, value: row => of(i)(row)?.largest ?? null, show: row => missCell(of(i)(row))})),
    ...settings.map(setting => ({name: `${shortName(setting)}, exact`, value: row => row.exact.find(one => one.setting === setting)?.time ?? null, show: row => {
      const own = row.exact.find(one => one.setting === setting);
      return own ? withSmall("0", duration(own.time)) : "\u2013";
    }})), {name: "log2 C", value: row => real().bits_lost.get(row.family), show: row => number(real().bits_lost.get(row.family))}], rows));
};

/** What follows from the drawings, a sentence a type. */
const conclusionList = () => element("ul", {id: "accuracy"}, real().conclusions.map(row => {
  const limit = miss => `10${raised(kLimits10.find(power => miss <= 10 ** power))} degrees`, where = `n = ${count(row.worst_n)} of ${row.worst_family}`;
  const isRight = row.held_n === row.last_n, broken = row.broken ? `, and ${count(row.broken)} of ${count(row.drawings)} drawings ${row.broken === 1 ? "is" : "are"} broken` : "";
  const held = row.held_n === null ? "" : `is right to ${limit(row.held_miss)} in all drawings up to n = ${count(row.held_n)}${isRight ? `, its largest: it misses most, ${number(row.miss, 2)}, at ${where}` : "; beyond, it "}`;
  const right = held + (isRight ? "" : `misses ${Number.isFinite(row.miss) ? `${number(row.miss, 2)} degrees` : "more than can be told"} at ${where}`);
  return element("li", {}, `${typeName(row.type)} ${right}${broken}.`,
    row.beside ? ` It takes ${number(row.beside.ratio, 2)} times as long as ${shortName(row.beside.setting)}, which draws ${row.beside.family} at n = ${count(row.beside.n)} in exact integers and misses nothing.` : "");
}));

const placeText = (row, what) => ({inside: "n = " + count(row[what]), beyond: "n beyond " + count(row.last_n), least: "the least n, " + count(row.first_n)})[row[what + "_at"]];
const kVerdictCss = {confirmed: "pass", refuted: "violated", open: "incomplete"};
const verdictOf = row => element(row.verdict === "refuted" ? "b" : "span", {class: kVerdictCss[row.verdict]}, row.verdict);

const onsetChart = () => {
  const rows = real().onsets.filter(row => row.predicted !== null && row.seen !== null), all = rows.flatMap(row => [row.predicted, row.seen]);
  const [low, high] = [Math.min(...all), Math.max(...all)];
  const diagonal = (name, factor, stroke) => ({name, css: factor === 1 ? "bound" : "front", stroke, dash: "7 4", width: 1.3, points: [{x: Math.max(low, low / factor), y: Math.max(low * factor, low)},
    {x: Math.min(high, high / factor), y: Math.min(high * factor, high)}]});
  return {file: "onsets", title: "Where misses pass a limit: predicted and seen", note: "one point per family, type and limit; dashed: equal, twice and half", x: {title: "predicted n"}, y: {title: "seen n"},
    lines: [diagonal("as predicted", 1, "var(--bound)"), diagonal("twice", 2, "var(--muted)"), diagonal("half", 0.5, "var(--muted)")],
    symbols: [...grouped(rows, row => row.type)].map(([type, those]) => ({name: typeName(type), label: typeName(type), fill: colour(type), size: 2.5, points: those.map(row => ({x: row.predicted, y: row.seen}))}))};
};

const onsetPart = () => {
  const rows = real().onsets, about = real();
  if (!rows.length) return [];
  const told = [...rows.filter(row => row.family === about.family), ...rows.filter(row => row.family !== about.family && row.verdict === "refuted")];
  const sentence = row => element("li", {}, `${typeName(row.type)} passes ${limitText(row.limit)} degrees on ${row.family} at ${placeText(row, "seen")}; predicted at ${placeText(row, "predicted")}: `, verdictOf(row), ".",
    row.verdict === "refuted" ? ` \u03ba is ${number(row.kappa_seen, 2)} there, and ${number(row.kappa, 2)} in the family's drawings in the widest type.` : "");
  return [element("h3", {}, "Where misses pass a limit"), element("p", {}, `Predicted from \u03ba and C of the family's drawings in ${about.model} alone; seen where the median miss passes the limit, both by interpolation. ` +
    `Within a factor of 2 in n: ${count(about.confirmed)} of ${count(rows.length)} predictions; ${count(about.refuted)} are refuted; ${count(about.open)} are open, since one of the two lies beyond the sizes that were drawn.`),
  rows.some(row => row.predicted !== null && row.seen !== null) ? element("div", {class: "figures"}, figure(onsetChart)) : null,
  element("ul", {class: "crossings"}, told.slice(0, kMostSentences).map(sentence), told.length > kMostSentences ? element("li", {}, `\u2026 and ${count(told.length - kMostSentences)} more refuted ones`) : null),
  folded("All predictions", false, makeTable([{name: "Family", show: row => row.family}, {name: "Type", show: row => typeName(row.type)}, {name: "Degrees", value: row => row.limit, show: row => limitText(row.limit)},
    {name: "Predicted", show: row => placeText(row, "predicted")}, {name: "Seen", show: row => placeText(row, "seen")}, {name: "Verdict", show: verdictOf},
    {name: "\u03ba", value: row => row.kappa, show: row => number(row.kappa, 2)}, {name: "\u03ba seen", value: row => row.kappa_seen, show: row => number(row.kappa_seen, 2)}], rows))];
};

const shareTable = () => {
  const within = name => ({name: name.replace("1e_", "10\u207b").replace("12", "\u00b9\u00b2").replace("9", "\u2079").replace("6", "\u2076").replace("3", "\u00b3"), value: row => row["within_" + name],
    show: row => withSmall(percent(row["within_" + name]), "\u00b7 " + percent(row["all_" + name]))});
  return folded("Shares", true, element("p", {class: "muted"},
    "Arithmetic mean over the drawings of the share of a drawing's angles that miss by at most so many degrees, and (grey) share of drawings all of whose angles do, over all families. " +
    "Broken: drawings with a crossing or a segment of length zero."), makeTable([{name: "Type", show: row => typeName(row.type)}, {name: "n", value: row => row.n, show: row => count(row.n)},
    {name: "Drawings", value: row => row.drawings, show: row => count(row.drawings)}, within("1e_12"), within("1e_9"), within("1e_6"), within("1e_3"), {name: "Broken", value: row => row.broken, show: row => count(row.broken)}],
      real().shares));
};

const realPart = () => {
  const about = real(), types = about.medians, leftOut = firstOf("precision").left_out;
  if (!about.drawings) return [];
  const charts = [types.some(row => row.miss > 0) && (() => missChart("miss")), about.predictors > 0 && (() => missChart("roundings")), real().accuracies.some(row => row.time !== null && row.miss > 0) && accuracyChart];
  return [element("p", {}, `${count(about.drawings)} drawings in real types, judged without tolerance: their coordinates are dyadic rationals, every inner product and every decision is exact. ` +
    `${count(about.broken)} of them are broken, by a crossing or a segment of length zero.` + (leftOut ? ` ${count(leftOut)} more rows were left out.` : "")),
  about.predictors > 0 ? element("p", {}, "A coordinate rounded to p bits turns an angle by about \u03ba 2", element("sup", {}, "\u2212p"),
    ` C radians, C being the drawing's condition. From ${count(about.predictors)} drawings in ${about.model}: ` +
    `\u03ba has the median ${number(about.kappa, 2)}, and eight in ten lie between ${number(about.kappa_low, 2)} and ${number(about.kappa_high, 2)}. What the other types miss is predicted with these.`) : null,
  conclusionList(), element("div", {class: "figures"}, charts.filter(Boolean).map(chart => figure(chart))), accuracyTable(), onsetPart(), shareTable()];
};

/** Programs of the user's own, whose coordinates are judged as they write them: floats and doubles, too. */
const programPart = () => {
  const inRealTypes = new Set(rowsOf("real_drawings").map(row => rowsOf("bounds")[row.curve].setting)), metrics = rowsOf("metrics").map(row => row.metric);
  const programs = rowsOf("settings").map((row, setting) => ({...row, place: setting})).filter(row => row.own_unit && row.drawn > 0 && !inRealTypes.has(row.place));
  if (!programs.length) return [];
  const of = (row, metric) => rowsOf("metric_values").find(one => one.setting === row.place && one.metric === metrics.indexOf(metric));
  const column = (name, metric, key, show) => ({name, value: row => of(row, metric)?.[key] ?? null, show: row => of(row, metric) ? show(of(row, metric)[key]) : "\u2013"});
  return [element("h3", {}, "Programs"), element("p", {}, "The coordinates of these programs are judged exactly as they are written, whatever type they were computed in. " +
    "Graphs of the largest n; an edge is optimal if all its angles are at least the best that exist."),
    makeTable([{name: "Program", show: row => shortName(row.place)}, {name: "n", value: row => of(row, "crossings")?.n ?? null, show: row => count(of(row, "crossings")?.n)},
      column("Least angle at a vertex", "smallest_vertex_angle", "least", value => number(value, 6)), column("at a bend", "smallest_bend_angle", "least", value => number(value, 6)),
      column("Optimal edges, median", "optimal_edges", "median", count), column("Crossings, most", "crossings", "largest", count)], programs)];
};

const spanCell = name => row => row[name] === null ? ["\u2013"] : withSmall(duration(row[name]), `${duration(row[name + "_low"])} \u2013 ${duration(row[name + "_high"])}`);
const kCells = [{name: "Algorithm", show: row => row.algorithm}, {name: "n", value: row => row.n, show: row => count(row.n)}], kRows = {name: "Rows", value: row => row.rows, show: row => count(row.rows)};
const certificatePart = () => {
  const rows = rowsOf("judgements").filter(row => row.certificate !== "measured"), modes = distinct(rows.map(row => row.certificate));
  if (!rows.length || modes.join() === "exact") return [];
  return [element("h3", {}, "Certificate modes"), element("p", {}, "Only ", element("code", {}, "exact"), " proves. Wall time of judging and measuring a drawing; median, and (grey) from 10 to 90 %."),
    makeTable([...kCells, {name: "Certificate", show: row => row.certificate}, kRows, {name: "Violated", value: row => row.violated, show: row => count(row.violated)},
      {name: "Time per vertex", value: row => row.certify, show: spanCell("certify")}], rows)];
};
const levelPart = () => {
  const rows = rowsOf("judgements").filter(row => row.has_levels), span = (name, key) => ({name, value: row => row[key], show: spanCell(key)});
  if (!rows.length) return [];
  return [element("h3", {}, "Levels of detail"), element("p", {}, "What a row stores of its drawing: nothing, positions, all bends. Times per vertex (drawing in CPU time), medians and (grey) from 10 to 90 %; " +
    "memory is the peak beyond what was resident when the row began, where the row had a process or a measurement of its own."),
  folded("The table", rows.length <= kMostOpenLevels, makeTable([...kCells, {name: "Level", show: row => row.level}, kRows, span("Drawing", "draw"), span("Storing", "store"), span("Certifying", "certify"),
    {name: "Bytes per vertex", value: row => row.bytes, show: row => row.bytes === null ? "\u2013" : row.bytes.toFixed(0)}], rows))];
};

export const precisionSection = () => {
  const parts = [realPart(), programPart(), certificatePart(), levelPart()].flat(2);
  if (!parts.length) return;
  const section = byId("precision");
  section.hidden = false;
  if (rowsOf("efforts").length) {
    parts.push(element("h3", {}, "Effort"));
    if (rowsOf("efforts").some(row => row.time !== null)) parts.push(element("div", {class: "figures"}, figure(effortChart)));
    parts.push(effortTable());
  }
  section.lastElementChild.append(...parts.filter(Boolean));
};
