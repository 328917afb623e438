// The report: its first screen at once, then its sections, then its figures.
import {all, byId, change, count, element, fill, firstOf, grouped, number, percent, rowsOf, settingName, shortName} from "./values.js";
import {fillNavigation, folded, makeTable, withSmall} from "./tables.js";
import {drawFigures} from "./charts.js";
import {graphButton, graphText, listen} from "./graphs.js";
import {answersPart} from "./answers.js";
import {turningPart} from "./turning.js";
import {exponentCell, settingSections, violations} from "./growth.js";
import {collectionSections, scalingSection, tradeSection} from "./compared.js";
import {precisionSection} from "./precision.js";

const kShownFindings = 20, kOpenFindings = 5, kShownCells = 60, kShownLines = 20;
const showSection = (id, ...children) => {
  const section = byId(id);
  section.hidden = false;
  section.querySelector("div").append(...children.flat().filter(Boolean));
};

const verdictPart = () => {
  const verdict = firstOf("verdict"), study = firstOf("study"), word = document.querySelector(".verdict");
  word.textContent = verdict.word;
  word.classList.add(verdict.word.toLowerCase());
  fill("study", study.study);
  byId("counts").append(`${count(verdict.rows)} rows: ${count(verdict.proved)} proved right and inside their bounds, ${count(verdict.violated)} violated, ` +
    `${count(verdict.incomplete)} incomplete, ${count(verdict.refused)} refused (the graph lies outside the theorem)`);
  if (verdict.unproved > 0) {
    byId("counts").append(`, ${count(verdict.unproved)} `, element("b", {}, "not proved"),
      ` (their certificate proves nothing${verdict.accepts_unproved ? "; the study accepts that" : ""})`);
  }
  byId("counts").append(verdict.measured > 0 ? `, ${count(verdict.measured)} measured without a guarantee.` : ".",
    verdict.rows === 0 ? " Nothing was measured, so nothing is shown." : "");
  if (study.files_given > 0) byId("counts").append(` Graphs were read from ${count(study.files_read)} of ${count(study.files_given)} files.`);
  const begun = document.querySelector("[data-fill=begun]");
  begun.append(`${study.created} \u00b7 program ${study.program}`, study.dirty ? element("b", {class: "incomplete"}, " with uncommitted changes") : "");
  const notes = [];
  if (study.kept_graphs > 0) {
    notes.push(`There are sizes with more than ${count(study.kept_graphs)} graphs: medians, bands and points of these are of ${count(study.kept_graphs)} graphs drawn at random. ` +
      "Counts, verdict, extreme values and the means of logarithms that are fitted are of all.");
  }
  if (study.left_out_rows > 0) notes.push(`${count(study.left_out_rows)} rows of further families and sizes are in the verdict, but in no table or plot.`);
  byId("sampled").hidden = !notes.length;
  byId("sampled").textContent = notes.join(" ");
};

const closestPart = () => {
  const closest = rowsOf("settings").filter(row => row.share !== null).reduce((best, row) => !best || row.share > best.share ? row : best, null);
  if (!rowsOf("settings").length) return;
  if (!closest) {
    byId("closest").textContent = "No row has a bound to compare with.";
    return;
  }
  byId("closest").append("The closest to a bound is ", graphButton(closest.closest_row, `${closest.setting} on ${closest.closest_family}, ${graphText(closest.closest_row, closest.closest_n)}`),
    `: its ${closest.closest_axis} extent is ${count(closest.closest_extent)} of ${(closest.closest_bound < 1000 ? number : count)(closest.closest_bound, 6)}, `,
  element("b", {}, percent(closest.share)), " of what the theorem allows.");
};

const findingsPart = () => {
  const findings = rowsOf("findings").slice(0, kShownFindings), rest = firstOf("verdict").findings - findings.length;
  if (!findings.length) return;
  byId("findings").hidden = false;
  const items = findings.map(row => element("li", {}, element("b", {class: row.is_violation ? "violated" : "incomplete"}, row.kind), ": ",
    row.row === null ? "" : [graphButton(row.row, `row ${row.row}, ${row.subject}`), " "], row.message, row.row === null ? "" : [element("br"), element("code", {}, row.command)]));
  byId("findings").querySelector("ol").append(...items.slice(0, kOpenFindings));
  if (items.length > kOpenFindings) byId("findings").append(folded(`${count(items.length - kOpenFindings)} more`, false, element("ol", {start: kOpenFindings + 1}, items.slice(kOpenFindings))));
  if (rest > 0) byId("findings").append(element("p", {}, `\u2026 and ${count(rest)} more; `, element("code", {}, "ar3d check"), " counts them all."));
};

const frontPart = () => {
  const settings = rowsOf("settings"), exponents = rowsOf("exponents");
  if (!settings.length) return;
  const exponent = (name, quantity) => {
    const of = row => exponents.find(one => one.setting === row.place && one.quantity === quantity);
    if (!exponents.some(one => one.quantity === quantity && !one.untimed)) return null;
    return {name, value: row => of(row)?.largest ?? null, show: row => of(row) && of(row).largest !== null ? of(row).largest.toFixed(2) : "\u2013"};
  };
  const column = (name, key) => ({name, value: row => row[key], show: row => count(row[key])}), bands = grouped(rowsOf("bands").filter(row => row.quantity === "bends per edge"), row => row.setting);
  const bends = row => bands.has(row.place) ? Math.max(...bands.get(row.place).map(at => at.largest)) : null;
  showSection("closeness", makeTable([{name: "Setting", show: row => element("a", {href: "#a" + row.place}, shortName(row.place))},
    {name: "Share", value: row => row.share, show: row => percent(row.share)},
    {name: "Closest graph", css: "note", show: row => row.closest_row === null ? "\u2013" : graphButton(row.closest_row, `${row.closest_family}, ${graphText(row.closest_row, row.closest_n)}`)},
    column("Families", "families"), column("Graphs", "drawn"), column("Largest n", "largest_n"), {name: "Violations", value: row => row.violations, show: violations},
    {name: "Bends", value: bends, show: row => number(bends(row))}, exponent("Side n^a", "longest side"), exponent("Volume n^a", "volume"), exponent("Time n^a", "drawing time")].filter(Boolean),
  settings.map((row, place) => ({...row, place}))));
  const promises = rowsOf("promises");
  if (!promises.length) return;
  const text = value => value ?? "\u2013";
  showSection("promises", makeTable([{name: "Setting", show: row => settingName(row.setting)}, {name: "Axis", show: row => row.axis}, {name: "Paper", css: "num", show: row => text(row.paper)},
    {name: "Proved", css: "num", show: row => row.proved}, {name: "Measured exponent", css: "note", value: row => row.exponent, show: row => row.exponent === null ? "\u2013" : exponentCell(row)},
    {name: "Of family", show: row => text(row.family)}, {name: "Measured constant", value: row => row.constant, show: row => number(row.constant)}, {name: "Of family", show: row => text(row.constant_family)},
    {name: "Largest share", value: row => row.share, show: row => percent(row.share)}], promises.map(row => row.growth?.startsWith("apparent") ? {...row, growth: "apparent"} : row)));
};

/** Files that were left out, by what was wrong with them. */
const skippedPart = () => {
  const skipped = rowsOf("skipped_files"), kShownFiles = 10;
  if (!skipped.length) return;
  const kind = row => row.reason.slice(row.reason.indexOf(": ") + 2).replace(/'[^']*'/g, "\u2026").replace(/\d+/g, "N");
  const kinds = [...grouped(skipped, row => `${row.collection}: ${kind(row)}`).values()].sort((a, b) => b.length - a.length);
  showSection("skipped", makeTable([{name: "Collection", show: rows => rows[0].collection}, {name: "Files", value: rows => rows.length, show: rows => count(rows.length)},
    {name: "Reason of the first", css: "note", show: rows => rows[0].reason},
    {name: "Which", css: "note", show: rows => rows.slice(0, kShownFiles).map(row => row.file).join(", ") + (rows.length > kShownFiles ? ", \u2026" : "")}], kinds));
};

const sinceLines = (lines, css) => lines.length ? element("ul", {}, lines.slice(0, kShownLines).map(line => element("li", {class: css}, line.text)),
  lines.length > kShownLines ? element("li", {class: css}, `\u2026 and ${count(lines.length - kShownLines)} more`) : null) : null;
const ratio = value => change(value === null ? null : value - 1);

const sinceTables = () => {
  const bad = key => ({name: key[0].toUpperCase() + key.slice(1), value: row => row[key],
    show: row => ["violated", "regressed"].includes(key) && row[key] > 0 ? element("b", {class: "violated"}, count(row[key])) : count(row[key])});
  const of = (name, key) => ({name, value: row => row[key], show: row => ratio(row[key])}), cells = rowsOf("since_cells");
  return [makeTable([{name: "Setting", show: row => row.setting}, ...["violated", "regressed", "inconclusive", "unjudged", "improved", "pass"].map(bad),
    of("Largest change of time", "time"), of("of volume", "volume")], rowsOf("since_settings")),
  cells.length ? folded(`Where something changed (${count(cells.length)})`, false, makeTable([{name: "Verdict", show: row => row.verdict}, {name: "Setting", show: row => row.setting},
    {name: "Graphs", show: row => row.n === null ? `${row.family}, all n` : `${row.family}, n = ${count(row.n)}`}, of("Time", "time"), of("Instructions", "instructions"), of("Cycles", "cycles"),
    of("Volume", "volume"), {name: "Why", css: "note", show: row => row.reason}], cells.slice(0, kShownCells)),
  cells.length > kShownCells ? element("p", {}, `\u2026 and ${count(cells.length - kShownCells)} more; `, element("code", {}, "ar3d compare"), " says them all.") : null) : null];
};

const sincePart = () => {
  const since = firstOf("since"), environment = rowsOf("since_environment");
  if (since.why_none !== null) {
    showSection("reference", element("p", {class: "incomplete"}, "Not compared: " + since.why_none),
      element("p", {class: "muted"}, element("code", {}, "ar3d report RESULTS --reference FILE"), " compares with another results file of the same study."));
    return;
  }
  byId("since").hidden = false;
  for (const name of ["file", "word", "judged"]) fill("since-" + name, since[name]);
  const unlike = environment.some(row => row.differs) ? "The environments differ" : "The machine was busy with other work";
  showSection("reference", element("p", {}, element("b", {}, since.word), ` against ${since.file} of ${since.created}: ${count(since.rows)} measurements that both hold, in ${count(since.cells)} cells.` +
    `${since.is_copy ? " The two hold the same measurements." : ""} Judged: ${since.judged}.`),
  environment.length ? [element("p", {class: "incomplete"}, `${unlike}, so times are ${since.time_judged ? "judged only because that was asked for" : "shown and not judged"}:`),
    element("ul", {}, environment.map(row => element("li", {}, `${row.name}: ${row.base}${row.differs ? " \u2192 " + row.now : " in both"}`)))] : null,
  sinceLines(rowsOf("since_remarks").filter(row => row.incomplete), "incomplete"), sinceLines(rowsOf("since_remarks").filter(row => !row.incomplete), "muted"), sinceTables(),
  element("p", {class: "muted"}, "NEW is this study, BASE the reference. A cell is a setting on one family at one size, or at all sizes where a size has too few pairs. The rule is that of ", element("code", {}, "ar3d compare"),
    ": any change for the worse of status, certificate, bends or volume, and a slow-down that is significant. The largest change is the one farthest from none, judged or not."));
};

const backgroundPart = () => {
  const study = firstOf("study"), environment = rowsOf("environment"), ofMetric = grouped(rowsOf("metric_values"), row => row.metric), settings = rowsOf("settings");
  if (settings.length) {
    const largest = new Map(rowsOf("metric_values").map(row => [row.setting, row.n])), of = (row, i) => ofMetric.get(row.place)?.find(one => one.setting === i);
    byId("metrics").hidden = false;
    byId("metrics").querySelector("details").append(makeTable([{name: "Metric", show: row => row.metric}, {name: "Unit", show: row => row.unit}, {name: "Definition", css: "note", show: row => row.definition},
      ...settings.map((setting, i) => ({name: [setting.setting, element("br"), `n = ${count(largest.get(i))}`], value: row => of(row, i)?.median ?? null,
        show: row => of(row, i) ? withSmall(number(of(row, i).median, 4), `${number(of(row, i).least, 4)} \u2013 ${number(of(row, i).largest, 4)}`) : "\u2013"}))],
    rowsOf("metrics").map((row, place) => ({...row, place}))));
  }
  showSection("environment", environment.length ? element("div", {class: "scroll"}, element("table", {}, element("tbody", {}, environment.map(row =>
    element("tr", {}, element("th", {scope: "row"}, row.name), element("td", {class: "note"}, row.value)))))) : element("p", {}, "The file names none."));
  fill("spec-hash", study.spec_hash);
  byId("spec").querySelector("pre").textContent = study.spec;
  for (const {dataset: {name}, textContent: text} of all("script.study")) {
    byId("studies").append(element("a", {href: "data:text/plain;charset=utf-8," + encodeURIComponent(text), download: name + ".toml"}, name + ".toml"), " ");
  }
};

verdictPart();
closestPart();
findingsPart();
frontPart();
skippedPart();
sincePart();
listen();
const rest = () => {
  answersPart();
  collectionSections();
  tradeSection();
  precisionSection();
  settingSections();
  scalingSection();
  backgroundPart();
  fillNavigation();
  if (location.hash) document.getElementById(decodeURIComponent(location.hash.slice(1)))?.scrollIntoView();
  drawFigures();
  setTimeout(turningPart, 0);
};
addEventListener("DOMContentLoaded", () => requestAnimationFrame(() => setTimeout(rest, 0)));
