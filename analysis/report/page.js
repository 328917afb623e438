// What the page does when somebody points, clicks or types: the embedded rows are the element #rows.
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("rows").textContent);
  const tip = document.getElementById("tip"), panel = document.getElementById("replay");
  const mark = document.createElementNS("http://www.w3.org/2000/svg", "circle");
  mark.setAttribute("class", "on");
  mark.setAttribute("r", 4);
  let current = null;
  const seconds = s => s < 1e-3 ? (s * 1e6).toPrecision(3) + " µs" : s < 1 ? (s * 1e3).toPrecision(3) + " ms"
    : s.toPrecision(3) + " s";
  const describe = id => {
    const [cell, n, m, seed, status, box, own, theorem, published, time] = data.rows[id];
    const lines = [data.cells[cell][0], `${n} vertices, ${m} edges, seed ${seed}`];
    if (status) lines.push(status.replaceAll("_", " "));
    if (box[0] >= 0) lines.push("box " + box.join(" × "));
    if (own) lines.push("its own bound " + own.join(" × "));
    if (theorem) lines.push("the theorem's " + theorem.join(" × "));
    if (published) lines.push("the published " + published.join(" × "));
    if (time) lines.push(seconds(time));
    return lines;
  };
  const commands = id => {
    const [cell, n, , seed] = data.rows[id];
    return data.cells[cell][1] + n + " --seed " + seed + data.cells[cell][2] + "\nar3d replay RESULTS.h5 " + id;
  };
  const known = new Map();
  const points = svg => {
    if (!known.has(svg)) {
      known.set(svg, [...svg.querySelectorAll("path.points")].flatMap(path => {
        const rows = path.dataset.r.split(" ");
        return [...path.getAttribute("d").matchAll(/M([\d.-]+) ([\d.-]+)h0/g)]
          .map((match, i) => ({svg, x: +match[1], y: +match[2], id: rows[i]}));
      }).sort((a, b) => a.x - b.x || b.y - a.y));
    }
    return known.get(svg);
  };
  const show = point => {
    current = point;
    tip.hidden = !point;
    mark.remove();
    if (!point) return;
    mark.setAttribute("cx", point.x);
    mark.setAttribute("cy", point.y);
    point.svg.append(mark);
    tip.textContent = describe(point.id).join("\n");
    const box = mark.getBoundingClientRect(), size = tip.getBoundingClientRect();
    const x = Math.min(box.right + 10, innerWidth - size.width - 6);
    const y = box.top - size.height - 8;
    tip.style.left = Math.max(4, x) + "px";
    tip.style.top = (y < 4 ? box.bottom + 10 : y) + "px";
  };
  const nearest = (svg, event) => {
    const box = svg.getBoundingClientRect(), scale = svg.viewBox.baseVal.width / box.width;
    const x = (event.clientX - box.x) * scale, y = (event.clientY - box.y) * scale;
    let best = null, least = (18 * scale) ** 2;
    for (const point of points(svg)) {
      const distance = (point.x - x) ** 2 + (point.y - y) ** 2;
      if (distance < least) { least = distance; best = point; }
    }
    return best;
  };
  const replay = point => {
    if (!point) return;
    panel.hidden = false;
    panel.querySelector("p").textContent = describe(point.id).join(" · ");
    panel.querySelector("code").textContent = commands(point.id);
  };
  for (const svg of document.querySelectorAll("svg.plot")) {
    svg.addEventListener("pointermove", event => show(nearest(svg, event)));
    svg.addEventListener("pointerleave", () => show(null));
    svg.addEventListener("blur", () => show(null));
    svg.addEventListener("click", event => { const point = nearest(svg, event); show(point); replay(point); });
    svg.addEventListener("keydown", event => {
      const all = points(svg), step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
      if (event.key === "Enter") replay(current);
      if (!step || !all.length) return;
      event.preventDefault();
      const place = current && current.svg === svg ? all.indexOf(current) : step > 0 ? -1 : 0;
      show(all[(place + step + all.length) % all.length]);
    });
  }
  const copy = panel.querySelector("button");
  copy.addEventListener("click", () => {
    getSelection().selectAllChildren(panel.querySelector("code"));
    document.execCommand("copy");
  });
  const close = () => { panel.hidden = true; show(null); };
  panel.querySelector("button:last-of-type").addEventListener("click", close);
  document.addEventListener("keydown", event => { if (event.key === "Escape") close(); });
  addEventListener("scroll", () => show(null), {passive: true});
})();
