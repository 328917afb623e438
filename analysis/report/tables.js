// Tables that sort by a click on a head, and small pictures that grow: for the report and for the page of a history.
"use strict";
(() => {
  const all = (selector, within = document) => [...within.querySelectorAll(selector)];

  // Sorting: by the number in the cell, with its prefix, or by the text.
  const units = {"ns": 1e-9, "µs": 1e-6, "ms": 1e-3, "s": 1};
  const value = cell => {
    const text = cell.textContent.trim(), found = text.replaceAll(",", "").match(/^[-+]?\d+(\.\d+)?(e[+-]?\d+)?/);
    if (!found) return text === "–" || text === "" ? -Infinity : text;
    return +found[0] * (units[text.slice(found[0].length).trim().split(" ")[0]] ?? 1);
  };
  const compare = (a, b) => typeof a === typeof b ? (a < b ? -1 : a > b ? 1 : 0) : typeof a === "number" ? -1 : 1;
  for (const head of all("table.sortable thead th")) {
    head.tabIndex = 0;
    const sort = () => {
      const table = head.closest("table"), body = table.tBodies[0], column = head.cellIndex;
      const falling = head.getAttribute("aria-sort") !== "descending";
      for (const other of all("th", head.parentElement)) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", falling ? "descending" : "ascending");
      const keyed = [...body.rows].map(row => [value(row.cells[column]), row]);
      keyed.sort((a, b) => falling ? compare(b[0], a[0]) : compare(a[0], b[0]));
      body.append(...keyed.map(([, row]) => row));
    };
    head.addEventListener("click", sort);
    head.addEventListener("keydown", event => { if (event.key === "Enter") sort(); });
  }

  // The small pictures of a history.
  for (const svg of all("svg.spark")) {
    const turn = () => svg.classList.toggle("large");
    svg.addEventListener("click", turn);
    svg.addEventListener("keydown", event => { if (event.key === "Enter") turn(); });
  }
})();
