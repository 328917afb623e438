// Tables: made of columns and rows, sorted by a click on a head, in a box that scrolls where they are wider than the page.
import {all, element} from "./values.js";

const kSortable = "sortable";

/** Where a cell stands among others: its value, else its text. */
const sortKey = cell => {
  if (cell.dataset.v !== undefined) return cell.dataset.v === "" ? -Infinity : Number(cell.dataset.v);
  return cell.textContent.trim();
};
const compare = (a, b) => {
  if (typeof a !== typeof b) return typeof a === "number" ? -1 : 1;
  return a < b ? -1 : a > b ? 1 : 0;
};

const sortBy = head => {
  const body = head.closest("table").tBodies[0], column = head.cellIndex;
  const falling = head.getAttribute("aria-sort") !== "descending";
  for (const other of all("th", head.parentElement)) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", falling ? "descending" : "ascending");
  const keyed = [...body.rows].map(row => [sortKey(row.cells[column]), row]);
  keyed.sort((a, b) => falling ? compare(b[0], a[0]) : compare(a[0], b[0]));
  body.append(...keyed.map(([, row]) => row));
};

const headOf = column => {
  const head = element("th", {class: column.value ? "num" : null, tabindex: 0, title: column.title}, column.name);
  head.addEventListener("click", () => sortBy(head));
  head.addEventListener("keydown", event => { if (event.key === "Enter") sortBy(head); });
  return head;
};

const cellOf = (column, row, isFirst) => {
  const shown = column.show ? column.show(row) : column.value(row);
  const attributes = {class: column.css ?? null};
  if (column.value) {
    attributes.class = ["num", column.css].filter(Boolean).join(" ");
    attributes["data-v"] = column.value(row) ?? "";
  }
  return isFirst && !column.value ? element("th", {scope: "row"}, shown) : element("td", attributes, shown);
};

/**
 * A table in its box. Columns are {name, value(row): a number to sort by, show(row): what stands there, css, title}; the first one
 * names the row. @param attributes  of a row's element.
 */
export const makeTable = (columns, rows, attributes = () => ({}), css = "") => element("div", {class: "scroll"},
  element("table", {class: [kSortable, css].filter(Boolean).join(" ")},
    element("thead", {}, element("tr", {}, columns.map(headOf))),
    element("tbody", {}, rows.map(row => element("tr", attributes(row), columns.map((column, i) => cellOf(column, row, i === 0)))))));

/** The number, and in grey what stands behind it. */
export const withSmall = (text, small) => small ? [text, " ", element("small", {}, small)] : [text];

/** A folded part; what is in it is made when it is opened first, or at once if `open`. */
export const folded = (title, open, ...children) => element("details", {open}, element("summary", {}, title), children);

/** Links to the sections that are seen. */
export const fillNavigation = () => {
  const seen = all("section[data-nav]").filter(section => !section.hidden);
  document.querySelector("nav").replaceChildren(
    ...seen.map(section => element("a", {href: "#" + section.id}, section.dataset.nav)));
};
