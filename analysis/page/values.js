// The tables of the page, elements, and numbers as people read them. What a results file says is text here, never markup.
"use strict";

import {realType} from "./real.js";

const stored = JSON.parse(document.getElementById("tables").textContent).tables;
const read = new Map();

/** The rows of a table as objects; none if the page has no such table. */
export const rowsOf = name => {
  if (!read.has(name)) {
    const {columns, rows} = stored[name] ?? {columns: [], rows: []};
    const names = columns.map(column => column.name);
    read.set(name, rows.map(row => Object.fromEntries(names.map((column, i) => [column, row[i]]))));
  }
  return read.get(name);
};
/** The first row of a table; an empty object without any. */
export const firstOf = name => rowsOf(name)[0] ?? {};
/** A table as it stands in the page: columns and rows of cells. */
export const rawTable = name => stored[name] ?? {columns: [], rows: []};
/** Rows by what `key` makes of them, in their order. */
export const grouped = (rows, key) => {
  const groups = new Map();
  for (const row of rows) {
    const at = key(row);
    if (!groups.has(at)) groups.set(at, []);
    groups.get(at).push(row);
  }
  return groups;
};
export const distinct = values => [...new Set(values)];

/** An element; children are elements, texts, or lists of them, attributes that are false or null are left out. */
export const element = (tag, attributes = {}, ...children) => {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === true) made.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(name, value);
  }
  made.append(...children.flat(3).filter(child => child !== null && child !== undefined && child !== ""));
  return made;
};
export const byId = id => document.getElementById(id);
export const all = (selector, within = document) => [...within.querySelectorAll(selector)];
export const fill = (name, text) => {
  for (const place of all(`[data-fill=${name}]`)) place.textContent = text;
};

const kNothing = "\u2013";
const isMissing = value => value === null || value === undefined || Number.isNaN(value);
/** "1,234,567" */
export const count = value => isMissing(value) ? kNothing : Math.round(value).toLocaleString("en-US");
/** "215", "4.6k", "46k": where there is little room. */
export const shortCount = value => {
  const short = (part, unit) => (part < 9.95 ? part.toFixed(1).replace(/\.0$/, "") : part.toFixed(0)) + unit;
  if (value < 1000) return String(value);
  return value < 1e6 ? short(value / 1e3, "k") : short(value / 1e6, "M");
};
/** Three significant digits. */
export const number = (value, digits = 3) => {
  if (isMissing(value)) return kNothing;
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e6 || size < 1e-4)) return value.toExponential(digits - 1).replace(/\.?0+e/, "e").replace("e+", "e");
  return String(Number(value.toPrecision(digits)));
};
/** "93.1 %" */
export const percent = (share, digits = 1) => isMissing(share) ? kNothing : (100 * share).toFixed(digits) + " %";
/** "+12.3 %" of a ratio less 1, "× 25.4" from ten-fold on. */
export const change = (less, digits = 1) => {
  if (isMissing(less)) return kNothing;
  return less >= 9 ? "\u00d7 " + number(less + 1) : (less >= 0 ? "+" : "") + (100 * less).toFixed(digits) + " %";
};
/** "1.23 µs", "45.6 ms", "7.8 s" */
export const duration = seconds => {
  if (isMissing(seconds)) return kNothing;
  for (const [unit, least] of [["s", 1], ["ms", 1e-3], ["\u00b5s", 1e-6]]) {
    if (Math.abs(seconds) >= least) return number(seconds / least) + " " + unit;
  }
  return number(seconds / 1e-9) + " ns";
};
const kRaised = {"-": "\u207b", "0": "\u2070", "1": "\u00b9", "2": "\u00b2", "3": "\u00b3", "4": "\u2074", "5": "\u2075",
  "6": "\u2076", "7": "\u2077", "8": "\u2078", "9": "\u2079"};
export const raised = exponent => [...String(exponent)].map(letter => kRaised[letter] ?? letter).join("");
/** "10⁶", "2·10⁶" */
export const power = value => {
  if (value === 1) return "1";
  const exponent = Math.floor(Math.log10(value) + 1e-9), digits = Number((value / 10 ** exponent).toPrecision(3));
  return (digits === 1 ? "" : digits + "\u00b7") + "10" + raised(exponent);
};
/** "n", "√n", "n^1.5" of a power of n. */
export const powerOfN = order => order === 1 ? "n" : order === 0.5 ? "\u221an" : order === 0 ? "1"
  : Number.isInteger(order) ? "n" + raised(order) : "n^" + number(order);
/** "0.98 – 1.02", or one number where both read alike. */
export const range = (low, high, digits = 2) => {
  if (isMissing(low)) return kNothing;
  const [first, last] = [low.toFixed(digits), high.toFixed(digits)];
  return first === last ? first : `${first} \u2013 ${last}`;
};
export const interval = (low, high, digits = 3) => isMissing(low) ? "" : `[${low.toFixed(digits)}, ${high.toFixed(digits)}]`;
/** "", "2nd ", "3rd ": a rank before what it is of. */
export const ordinal = rank => rank === 1 ? "" : rank + (["th", "st", "nd", "rd"][rank % 100 > 10 && rank % 100 < 14 ? 0 : rank % 10] ?? "th") + " ";
/** "15", or "15 – 31" of sizes that stand together. */
export const span = row => row.first_n === row.last_n ? count(row.first_n) : `${count(row.first_n)} \u2013 ${count(row.last_n)}`;
/** The name of a row of the table settings. */
export const settingName = setting => rowsOf("settings")[setting].setting;
/** The same without options where the algorithm has only this setting; with the name of its real type. */
export const shortName = setting => {
  const {algorithm} = rowsOf("settings")[setting], curve = rowsOf("bounds").find(row => row.setting === setting);
  if (curve && realType(curve).bits) return `${algorithm} (${realType(curve).type})`;
  return rowsOf("settings").filter(row => row.algorithm === algorithm).length > 1 ? settingName(setting) : algorithm;
};
