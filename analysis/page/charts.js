// Charts by Observable Plot: logarithmic axes, lines with their names behind them, points that stand for rows, and files of both.
// Figures are drawn one after the other when the page has loaded, so that its first screen waits for none.
import {all, duration, element, number, percent, power, shortCount} from "./values.js";

const kNarrow = globalThis.innerWidth < 500, kWidth = kNarrow ? 360 : 482, kHeight = kNarrow ? 200 : 252, kLeft = 58, kRight = 126, kTop = 22, kBottom = 34;
const kColours = 8;
const formats = {count: value => value < 1 ? number(value) : shortCount(Number(number(value))), power, seconds: duration,
  share: value => percent(value, 0), change: value => (value > 0 ? "+" : "") + percent(value, Math.abs(value) < 0.02 ? 2 : 1)};

export const colour = index => `var(--c${index % kColours})`;

/** Smallest and largest of what a logarithmic axis can show, with a little air. */
const logDomain = values => {
  const shown = values.filter(value => value > 0 && Number.isFinite(value)).map(Math.log10);
  if (!shown.length) return [1, 10];
  let low = Infinity, high = -Infinity;
  for (const value of shown) [low, high] = [Math.min(low, value), Math.max(high, value)];
  const air = high - low < 0.02 ? 0.25 : 0.04 * (high - low);
  return [10 ** (low - air), 10 ** (high + air)];
};

/** Decades, every k-th if there are many; else 1, 2, 5 of each; else even steps. */
const logTicks = ([low, high], most = 6) => {
  const first = Math.ceil(Math.log10(low) - 1e-9), last = Math.floor(Math.log10(high) + 1e-9), ticks = [];
  if (last - first >= 2) {
    const every = Math.ceil((last - first + 1) / most);
    for (let k = Math.ceil(first / every) * every; k <= last; k += every) ticks.push(10 ** k);
    return ticks;
  }
  for (let k = first - 1; k <= last; ++k) ticks.push(10 ** k, 2 * 10 ** k, 5 * 10 ** k);
  const inside = ticks.filter(value => value >= low && value <= high);
  if (inside.length > 2) return inside;
  const unit = 10 ** Math.floor(Math.log10((high - low) / most)), even = [];
  const step = unit * [1, 2, 5, 10].find(factor => (high - low) / (factor * unit) <= most);
  for (let k = Math.ceil(low / step); k * step <= high; ++k) even.push(k * step);
  return even;
};

const axisOf = (axis, values) => {
  const {type = "log", format = "count", title, domain} = axis;
  const shown = domain ?? (type === "log" ? logDomain(values) : [Math.min(...values), Math.max(...values)]);
  return {type, domain: shown, label: title, tickFormat: axis.show ?? formats[format], ticks: axis.ticks ?? (type === "log" ? logTicks(shown) : 5)};
};

/** A mark of Plot: points of one family as one path, for what is many. A point is {x, y, row}. */
const pointsMark = (points, css, stroke, size) => (_, {x, y}) => {
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  const shown = points.map(point => ({point, x: x(point.x), y: point.y === null ? kTop + 2 : y(point.y)}))
    .filter(at => Number.isFinite(at.x) && Number.isFinite(at.y));
  path.setAttribute("class", css);
  path.setAttribute("d", shown.map(at => `M${at.x.toFixed(1)} ${at.y.toFixed(1)}h0`).join(""));
  path.style.stroke = stroke;
  path.style.strokeWidth = size;
  path.places = shown.filter(at => at.point.row !== undefined && at.point.row !== null)
    .map(at => ({x: at.x, y: at.y, row: at.point.row}));
  return path;
};

/** Moves names that stand on each other apart, up and down. */
const spread = svg => {
  const texts = all("g.ends text", svg).map(text => {
    const [, x, y] = text.getAttribute("transform").match(/translate\(([-\d.]+),([-\d.]+)\)/).map(Number);
    return {text, x, y};
  }).sort((a, b) => a.y - b.y);
  const top = kTop + 4, bottom = kHeight - kBottom + 6, step = 12;
  let last = top - step;
  for (const label of texts) last = label.y = Math.max(label.y, last + step);
  let least = bottom + step;
  for (const label of texts.reverse()) least = label.y = Math.min(label.y, least - step);
  for (const {text, x, y} of texts) text.setAttribute("transform", `translate(${x},${y})`);
};

/** A name shortened at its end; options, which tell settings apart, come first then. */
const cut = text => {
  if (text.length <= 20) return text;
  const [, name, options] = /^(.*?) \((.*)\)$/.exec(text) ?? [null, text, ""];
  return (options ? `${options} ${name}` : name).slice(0, 19) + "\u2026";
};

const lineMarks = line => {
  const {points, css = "", stroke, width = 1.8, dash} = line;
  return Plot.line(points, {x: "x", y: "y", stroke, strokeWidth: width, strokeDasharray: dash, className: ("line " + css).trim(),
    curve: line.curve ?? "linear", strokeOpacity: line.opacity ?? 1});
};

const symbolMarks = symbol => Plot.dot(symbol.points, {x: "x", y: "y", fill: symbol.hollow ? "var(--bg)" : symbol.fill,
  stroke: symbol.hollow ? "var(--fg)" : symbol.fill, r: symbol.size ?? 4.5, symbol: symbol.shape ?? "circle", className: symbol.css ?? "symbol"});

const ends = labels => Plot.text(labels, {x: "x", y: "y", text: label => cut(label.text), title: "text", dx: 6, textAnchor: "start",
  fill: "colour", className: "ends", clip: false});

/**
 * The svg of a chart {x, y: axes; bands: [{points: [{x, low, high}]}], lines: [{name, points, stroke, dash, label}],
 * symbols, dots: [{points, css, stroke}], bars}.
 */
const draw = chart => {
  const {bands = [], lines = [], symbols = [], dots = [], bars = []} = chart;
  const xs = [], ys = [];
  for (const {points} of [...lines, ...symbols, ...dots]) for (const {x, y} of points) {
    xs.push(x);
    ys.push(y);
  }
  for (const {points} of bands) for (const {x, low, high} of points) {
    xs.push(x);
    ys.push(low, high);
  }
  const labels = [...lines, ...symbols].filter(one => one.label && one.points.length)
    .map(one => ({...one.points.at(-1), text: one.label, colour: (one.stroke ?? one.fill).replace("--c", "--t")}));
  const options = {width: kWidth, height: kHeight, marginLeft: kLeft, marginRight: chart.narrow ? 16 : kRight, marginTop: kTop, marginBottom: kBottom,
    style: {background: "none", color: "var(--muted)"}, ariaLabel: chart.title, color: {type: "identity"}};
  if (bars.length) {
    return Plot.plot({...options, x: {type: "band", label: chart.x.title}, y: {label: chart.y.title, tickFormat: formats.share, grid: true}, marks: [
      Plot.barY(bars, {x: "x", y: "y", fill: colour(0)}), Plot.text(bars, {x: "x", y: "y", text: bar => percent(bar.y), dy: -6, fill: "var(--fg)"})]});
  }
  const x = axisOf(chart.x, xs), y = axisOf(chart.y, ys);
  const svg = Plot.plot({...options, x, y: {...y, grid: false}, marks: [
    Plot.gridX(x.ticks, {stroke: "var(--line)", strokeOpacity: 1}), Plot.gridY(Array.isArray(y.ticks) ? y.ticks : undefined, {stroke: "var(--line)", strokeOpacity: 1}),
    ...bands.map(band => Plot.areaY(band.points, {x: "x", y1: "low", y2: "high", fill: band.fill ?? colour(0), fillOpacity: 0.2, className: "band"})),
    ...lines.map(lineMarks), ...dots.map(({points, css, stroke, size = 4.4}) => pointsMark(points, css, stroke, size)),
    ...symbols.map(symbolMarks), labels.length ? ends(labels) : null].filter(Boolean)});
  spread(svg);
  return svg;
};

/** The numbers of a chart as lines of CSV. */
const csvOf = chart => {
  const field = value => value === undefined || value === null ? "" : /[",\n]/.test(value) ? `"${String(value).replaceAll('"', '""')}"` : value;
  const lines = [["series", "kind", "x", "y", "low", "high"]];
  const add = (kind, list) => {
    for (const one of list ?? []) for (const point of one.points) lines.push([one.name ?? kind, kind, point.x, point.y ?? point.median, point.low, point.high]);
  };
  add("band", chart.bands);
  add("line", chart.lines);
  add("point", chart.symbols);
  add("point", chart.dots);
  for (const bar of chart.bars ?? []) lines.push(["edges", "bar", bar.x, bar.y]);
  return lines.map(line => line.map(field).join(",")).join("\r\n") + "\r\n";
};

const save = (name, type, text) => {
  const link = element("a", {href: URL.createObjectURL(new Blob([text], {type})), download: name});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
};

/** The picture as a document of its own, in the colours of a white page. */
const standalone = svg => {
  const root = [...document.styleSheets[0].cssRules].find(rule => rule.selectorText === ":root").style;
  const copied = svg.cloneNode(true);
  copied.style.color = root.getPropertyValue("--muted");
  copied.setAttribute("font-family", "Helvetica, Arial, sans-serif");
  const text = new XMLSerializer().serializeToString(copied).replace(/var\((--\w+)\)/g, (_, name) => root.getPropertyValue(name).trim());
  return "<?xml version='1.0' encoding='UTF-8'?>\n" + text.replace(/stroke-linecap: ?round|class="points/g, found =>
    found.startsWith("class") ? 'stroke-linecap="round" ' + found : found);
};

const waiting = [];
const names = new Map();

/**
 * A figure that is drawn later. @param make  makes the chart {title, note, file, …}: anew whenever the figure is drawn.
 * @param below  elements under the chart.
 */
export const figure = (make, attributes = {}, ...below) => {
  const place = element("div", {class: "place"}), caption = element("figcaption");
  const made = element("figure", attributes, caption, place, below);
  const paint = () => {
    if (made.hidden) return;
    const chart = make();
    const slug = chart.file.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");
    if (!made.dataset.fig) {
      names.set(slug, (names.get(slug) ?? 0) + 1);
      made.dataset.fig = names.get(slug) > 1 ? `${slug}-${names.get(slug)}` : slug;
    }
    const svg = draw(chart);
    svg.classList.add("plot");
    svg.setAttribute("tabindex", 0);
    const button = (label, click) => {
      const one = element("button", {type: "button", title: "Save as " + label}, label);
      one.addEventListener("click", click);
      return one;
    };
    caption.replaceChildren(element("b", {}, chart.title), " ", element("span", {}, chart.note ?? ""));
    place.replaceChildren(element("span", {class: "save"},
      button("SVG", () => save(made.dataset.fig + ".svg", "image/svg+xml", standalone(svg))),
      button("CSV", () => save(made.dataset.fig + ".csv", "text/csv", csvOf(chart)))), svg);
    made.dispatchEvent(new CustomEvent("painted", {detail: svg, bubbles: true}));
  };
  made.paint = paint;
  waiting.push(made);
  return made;
};

const paintSome = until => {
  while (waiting.length && performance.now() < until) waiting.shift().paint();
  if (!waiting.length) document.documentElement.dataset.drawn = "";
};
/** Draws all figures, in pieces that leave room for the reader. */
export const drawFigures = () => {
  const step = () => {
    paintSome(performance.now() + 24);
    if (waiting.length) setTimeout(step, 0);
  };
  setTimeout(step, 0);
};
addEventListener("beforeprint", () => paintSome(Infinity));

