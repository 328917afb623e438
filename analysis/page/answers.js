// The first screen: what the tables say of each setting in three sentences, and volume, bends and time of all of them against n.
import {byId, count, duration, element, grouped, interval, number, ordinal, percent, range, rowsOf, shortName, span} from "./values.js";
import {colour, figure} from "./charts.js";
import {folded} from "./tables.js";
import {graphButton, graphText} from "./graphs.js";

const kOpenAnswers = globalThis.innerWidth < 500 ? 2 : 6;
const find = (table, setting, quantity) => rowsOf(table).find(row => row.setting === setting && row.quantity === quantity);
/** The setting's medians of a quantity by n, not divided by a power of n. */
const growing = (setting, quantity) => {
  const order = find("figures", setting, quantity)?.order ?? 0, scale = row => row.n ** order;
  return rowsOf("bands").filter(row => row.setting === setting && row.quantity === quantity)
    .map(row => ({n: row.n, least: row.least * scale(row), median: row.median * scale(row), largest: row.largest * scale(row)}));
};

/** "n^2.98 to n^3.02 [2.95, 3.05], a power law in 48 of 59 families"; nothing where no family has enough sizes. */
const law = row => {
  if (!row || row.untimed || row.least === null) return "";
  const families = row.power + row.logarithm + row.apparent + row.undecided, label = row.power > 0 ? ["a power law", row.power] : ["an apparent exponent", row.apparent];
  return `n^${range(row.least, row.largest).replace(" \u2013 ", " to n^")} ${interval(row.low, row.high, 2)}, ${label[0]} in ${count(label[1])} of ${count(families)} families`;
};
/** How a growth stands beside the order of the theorem's bound. */
const besideOrder = (row, order) => {
  if (row.high < order) return `below the bound's n^${number(order)}`;
  return row.low > order ? `above the bound's n^${number(order)} at these sizes` : `the order of the bound (n^${number(order)})`;
};

/** "22 %", "0.012 %" */
const smallPercent = share => share < 0.01 ? number(100 * share, 2) + " %" : percent(share, 0);

const promiseSentence = row => {
  const of = `${row.angle === null ? "" : `angles of at least ${number(row.angle, 5)}\u00b0, `}at most ${count(row.most_bends)} bends an edge`;
  if (row.violations > 0) return [`The promise is broken in ${count(row.violations)} of ${count(row.ok + row.violations)} rows: ${of}.`];
  if (!row.ok) return [row.measured > 0 ? `Nothing was promised; measured on ${count(row.drawn)} graphs: ${of}.` : "Nothing was drawn."];
  const word = row.unproved > 0 ? `No row breaks the promise, ${count(row.unproved)} of ${count(row.ok)} are not proved` : `The promise holds on all ${count(row.drawn)} graphs that were drawn`;
  if (row.share === null) return [`${word}: ${of}.`];
  return [`${word}: ${of}, at most ${row.share < 0.01 ? smallPercent(row.share) : percent(row.share)} of the box in ${row.closest_axis}, on `,
    graphButton(row.closest_row, `${row.closest_family}, ${graphText(row.closest_row, row.closest_n)}`), "."];
};

const growthSentence = (row, setting) => {
  const [side, volume, time] = ["longest side", "volume", "drawing time"].map(quantity => find("exponents", setting, quantity)), parts = [];
  const shares = rowsOf("bounds").filter(curve => curve.setting === setting && curve.volume_share !== null).map(curve => curve.volume_share);
  if (law(volume)) parts.push(`Volume grows like ${law(volume)}${row.theorem ? ", " + besideOrder(volume, volume.order) : ""}`);
  if (shares.length) parts.push(`${parts.length ? "at" : "At"} the largest n it uses at most ${smallPercent(Math.max(...shares))} of the theorem's box`);
  if (law(side)) parts.push(`the longest side grows like ${law(side)}`);
  const bends = growing(setting, "bends per edge"), times = growing(setting, "drawing time");
  if (bends.length) parts.push(`edges have ${range(Math.min(...bends.map(at => at.least)), Math.max(...bends.map(at => at.largest))).replace("\u2013", "to")} bends in the mean`);
  if (times.length) parts.push(`time${law(time) ? ` grows like ${law(time)}, to` : " is"} ${duration(times.at(-1).median)} at n = ${count(times.at(-1).n)}`);
  return parts.length ? [parts.join("; ") + "."] : ["There are too few sizes to tell a growth."];
};

const besideSentence = (row, setting) => {
  const mine = rowsOf("trade").filter(one => one.setting === setting), sizes = [...grouped(rowsOf("trade"), one => `${one.group} ${one.n}`).values()]
    .filter(rows => rows.length > 1 && rows.some(one => mine.includes(one))).sort((a, b) => a.length - b.length || a[0].n - b[0].n);
  const rows = sizes.at(-1);
  if (!rows) return ["No other setting drew the same graphs."];
  const own = rows.find(one => one.setting === setting), rank = (key, those) => ordinal(1 + those.filter(one => one[key] < own[key]).length);
  const least = rows.reduce((best, one) => one.volume < best.volume ? one : best), timed = rows.filter(one => one.time !== null);
  return [`Beside ${count(rows.length - 1)} ${rows.length === 2 ? "other" : "others"} at n = ${span(own)} its volume is the ${rank("volume", rows)}least` +
    (least === own ? "" : `, ${number(own.volume / least.volume)} times that of ${shortName(least.setting)}`) +
    (own.time !== null && timed.length > 1 ? `, and it is the ${rank("time", timed)}fastest` : "") + "."];
};

/** The theorem's bound of a setting over the n of these points. */
const boundPoints = (setting, quantity, points) => quantity === "bends per edge"
  ? [points[0], points.at(-1)].filter(() => rowsOf("settings")[setting].promised_bends !== null).map(({x}) => ({x, y: rowsOf("settings")[setting].promised_bends}))
  : rowsOf("bound_lines").filter(row => row.setting === setting && row.quantity === quantity).map(row => ({x: row.n, y: row.bound * row.n ** find("figures", setting, quantity).order}));

/** Volume, bends or time of all settings against n; bounds are dashed. */
const answerChart = (quantity, title, y) => {
  const all = rowsOf("settings").map((row, setting) => ({name: shortName(setting), stroke: colour(setting), setting, points: growing(setting, quantity).map(at => ({x: at.n, y: at.median, low: at.least, high: at.largest}))}))
    .filter(line => line.points.length);
  if (!all.length) return null;
  const bounds = all.map(({name, stroke, setting, points}) => ({name: name + ", theorem's bound", stroke, dash: "5 4", width: 1, css: "bound", points: boundPoints(setting, quantity, points)}))
    .filter(line => line.points.length);
  return () => ({file: "answer-" + quantity, title, note: "medians of the families" + (bounds.length ? "; dashed: the theorems' bounds" : ""), x: {title: "vertices n"},
    y: {...y, domain: y.type === "linear" ? [0, 1.05 * Math.max(...[...all, ...bounds].flatMap(line => line.points.map(at => at.y)))] : undefined},
    lines: [...all.map(line => ({...line, label: line.name, css: "answer"})), ...bounds]});
};

export const answersPart = () => {
  const settings = rowsOf("settings");
  if (!settings.length) return;
  const answers = settings.map((row, setting) => element("p", {"data-s": setting}, element("a", {href: "#a" + setting}, element("b", {}, shortName(setting))), ": ",
    element("span", {class: "promise"}, promiseSentence(row)), " ", element("span", {class: "growth"}, growthSentence(row, setting)), " ", element("span", {class: "beside"}, besideSentence(row, setting))));
  byId("answers").append(...answers.slice(0, kOpenAnswers));
  if (answers.length > kOpenAnswers) byId("answers").append(folded(`${count(answers.length - kOpenAnswers)} more settings`, false, answers.slice(kOpenAnswers)));
  const unit = new Set(rowsOf("figures").filter(row => row.quantity === "volume").map(row => row.unit));
  byId("panels").append(...[answerChart("volume", "Volume against n", {title: [...unit].join(" or "), format: "power"}),
    answerChart("bends per edge", "Bends per edge against n", {title: "bends per edge", type: "linear"}),
    answerChart("drawing time", "Drawing time against n", {title: "drawing time", format: "seconds"})].filter(Boolean).map(make => figure(make)));
};
