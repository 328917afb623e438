// What the page does when somebody points, clicks, types or saves. The embedded rows are the element #rows, the files
// of the figures #figures, which rows have a drawing #drawings, and the viewer with these drawings #viewer.
"use strict";
(() => {
  const json = id => JSON.parse(document.getElementById(id).textContent);
  const data = json("rows"), figures = json("figures");
  const tip = document.getElementById("tip"), panel = document.getElementById("replay");
  const all = (selector, within = document) => [...within.querySelectorAll(selector)];

  // What a row is, and the lines that draw it again.
  const seconds = s => s < 1e-3 ? (s * 1e6).toPrecision(3) + " µs" : s < 1 ? (s * 1e3).toPrecision(3) + " ms"
    : s.toPrecision(3) + " s";
  const describe = id => {
    const [curve, n, m, seed, status, box, own, theorem, published, time, name] = data.rows[id];
    const lines = [data.curves[curve][0], `${n} vertices, ${m} edges, seed ${seed}`];
    if (name) lines.splice(1, 0, name);
    if (status) lines.push(status.replaceAll("_", " "));
    if (box[0] >= 0) lines.push("box " + box.join(" × "));
    if (own) lines.push("its own bound " + own.join(" × "));
    if (theorem) lines.push("the theorem's " + theorem.join(" × "));
    if (published) lines.push("the published " + published.join(" × "));
    if (time) lines.push(seconds(time));
    return lines;
  };
  const commands = id => {
    const [curve, n, , seed] = data.rows[id];
    const [, before, behind] = data.curves[curve], again = data.replay + id;
    return before ? before + n + " --seed " + seed + behind + "\n" + again + " -o drawing.html" : again + " -o drawing.html";
  };
  const replay = id => {
    panel.hidden = false;
    panel.querySelector("p").textContent = describe(id).join(" · ");
    panel.querySelector("code").textContent = commands(id);
    opener.hidden = !(id in drawn);
    opener.onclick = () => showDrawing(id);
  };

  // The viewer's page, unpacked when it is first asked for, in a frame of its own that is gone when it is closed.
  const drawn = json("drawings"), dialog = document.getElementById("shown"), opener = document.getElementById("open");
  let viewer = null;
  const unpacked = () => {
    const bytes = Uint8Array.from(atob(document.getElementById("viewer").textContent), c => c.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).text();
  };
  const showDrawing = async id => {
    panel.hidden = true;
    viewer ??= unpacked();
    const frame = document.createElement("iframe");
    frame.title = "The drawing in 3D";
    dialog.querySelector("p").textContent = describe(id).slice(0, 2).join(" · ");
    dialog.querySelector("button").onclick = () => { dialog.close(); replay(id); };
    dialog.append(frame);
    dialog.showModal();
    frame.srcdoc = (await viewer).replace("<body>", `<body data-page="${drawn[id]}">`);
    frame.addEventListener("load", () => frame.focus());
  };
  dialog.querySelector("button:last-of-type").addEventListener("click", () => dialog.close());
  dialog.addEventListener("close", () => dialog.querySelector("iframe").remove());
  const open = id => id in drawn ? showDrawing(id) : replay(id);
  const copy = panel.querySelector("button");
  copy.addEventListener("click", () => {
    getSelection().selectAllChildren(panel.querySelector("code"));
    document.execCommand("copy");
  });

  // Points of plots.
  const mark = document.createElementNS("http://www.w3.org/2000/svg", "circle");
  mark.setAttribute("class", "on");
  mark.setAttribute("r", 4);
  let current = null;
  const visible = path => !path.closest(".family") || getComputedStyle(path.closest(".family")).display !== "none";
  const points = svg => all("path.points", svg).filter(visible).flatMap(path => {
    const rows = path.dataset.r.split(" ");
    return [...path.getAttribute("d").matchAll(/M([\d.-]+) ([\d.-]+)h0/g)]
      .map((match, i) => ({svg, x: +match[1], y: +match[2], id: rows[i]}));
  }).sort((a, b) => a.x - b.x || b.y - a.y);
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
  for (const svg of all("svg.plot")) {
    svg.addEventListener("pointermove", event => show(nearest(svg, event)));
    svg.addEventListener("pointerleave", () => show(null));
    svg.addEventListener("blur", () => show(null));
    svg.addEventListener("click", event => {
      const point = nearest(svg, event);
      show(point);
      if (point) replay(point.id);
    });
    svg.addEventListener("keydown", event => {
      const those = points(svg), step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
      if (event.key === "Enter" && current) replay(current.id);
      if (!step || !those.length) return;
      event.preventDefault();
      const place = current && current.svg === svg ? those.findIndex(p => p.id === current.id && p.x === current.x)
        : step > 0 ? -1 : 0;
      show(those[(place + step + those.length) % those.length]);
    });
  }

  // Buttons and cells that stand for a graph.
  for (const place of all("button[data-r], td[data-r]")) {
    place.addEventListener("click", () => open(place.dataset.r));
    if (place.tagName === "TD") place.addEventListener("keydown", event => { if (event.key === "Enter") open(place.dataset.r); });
  }
  const close = () => { panel.hidden = true; show(null); };
  panel.querySelector("button:last-of-type").addEventListener("click", close);
  document.addEventListener("keydown", event => { if (event.key === "Escape") close(); });
  addEventListener("scroll", () => show(null), {passive: true});

  // The group of settings and the n of the trade; where the group has not that n, the nearest that it has.
  const group = document.getElementById("trade-group"), size = document.getElementById("trade-n");
  const choose = () => {
    const compared = all("figure[data-group]"), own = compared.filter(figure => figure.dataset.group === group.value);
    const distance = figure => Math.abs(Math.log(figure.dataset.n / size.value));
    const trades = own.filter(figure => figure.dataset.n).sort((a, b) => distance(a) - distance(b));
    for (const figure of compared) figure.hidden = !own.includes(figure) || (!!figure.dataset.n && figure !== trades[0]);
  };
  for (const select of [group, size]) select?.addEventListener("change", choose);

  // The two settings of a scatter.
  for (const select of all("select.pick")) {
    select.addEventListener("change", () => {
      for (const figure of all(`figure[data-pick=${select.name}]`)) figure.hidden = figure.dataset.value !== select.value;
    });
  }

  // Families that the plots and tables of a section show: those whose name holds one of the words.
  for (const input of all("input.filter")) {
    input.addEventListener("input", () => {
      const section = input.closest("section"), words = input.value.toLowerCase().split(",").map(w => w.trim()).filter(w => w);
      const names = all("datalist option", section).map(option => option.value.toLowerCase());
      const chosen = new Set(names.flatMap((name, i) => words.some(word => name.includes(word)) ? [String(i)] : []));
      for (const family of all("g.family", section)) family.classList.toggle("on", chosen.has(family.dataset.f));
      for (const svg of all("svg.plot", section)) svg.classList.toggle("filtered", words.length > 0);
      for (const row of all("tr[data-f]", section)) row.hidden = words.length > 0 && !chosen.has(row.dataset.f);
    });
  }

  // Saving a figure.
  const save = (name, type, text) => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], {type}));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  };
  const standalone = svg => {
    const copied = svg.cloneNode(true), [, , width, height] = svg.getAttribute("viewBox").split(" ");
    for (const family of all("g.family:not(.extreme):not(.on)", copied)) family.remove();
    const style = document.createElementNS("http://www.w3.org/2000/svg", "style");
    style.textContent = json("figure-style");
    copied.prepend(style);
    copied.setAttribute("width", width);
    copied.setAttribute("height", height);
    return "<?xml version='1.0' encoding='UTF-8'?>\n" + new XMLSerializer().serializeToString(copied);
  };
  // A sheet of the figure's size for the browser's own printer, which saves it as PDF with texts and lines.
  const print = (name, svg) => {
    const [, , width, height] = svg.getAttribute("viewBox").split(" "), frame = document.createElement("iframe");
    frame.className = "sheet";
    const style = document.createElement("style");
    style.textContent = `@page{size:${width}px ${height}px;margin:0}body{margin:0}svg{display:block}`;
    frame.srcdoc = `<!doctype html><title>${name}</title>` + style.outerHTML + standalone(svg).replace(/^.*\n/, "");
    frame.addEventListener("load", () => {
      frame.contentWindow.addEventListener("afterprint", () => frame.remove());
      frame.contentWindow.print();
    });
    document.body.append(frame);
  };
  for (const figure of all("figure[data-fig]")) {
    const name = figure.dataset.fig, [csv, matplotlib, pgfplots] = figures[name];
    const row = document.createElement("span");
    row.className = "save";
    const files = {
      SVG: () => save(name + ".svg", "image/svg+xml", standalone(figure.querySelector("svg.plot"))),
      PDF: () => print(name, figure.querySelector("svg.plot")),
      CSV: () => save(name + ".csv", "text/csv", csv),
      matplotlib: () => save(name + ".py", "text/x-python", matplotlib),
      pgfplots: () => save(name + "-pgfplots.tex", "text/x-tex", pgfplots),
    };
    for (const [label, click] of Object.entries(files)) {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = label;
      button.title = label === "PDF" ? "Print this figure alone, to be saved as PDF" : "Save as " + label;
      button.addEventListener("click", click);
      row.append(button);
    }
    figure.querySelector("figcaption").after(row);
  }
})();
