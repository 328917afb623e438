#include "ar3d/analysis/report/style.h"

namespace ar3d::report {

// The eight series colours are Okabe and Ito's palette, safe for the common kinds of colour
// blindness; yellow is darkened on white and all are lightened on black.
const char* const kStyle = R"css(
:root{color-scheme:light dark;--bg:#fff;--fg:#1c2127;--muted:#57606a;--line:#d6dbe1;--faint:#eceff2;
--panel:#f6f8fa;--link:#0a58a8;--bound:#b3261e;--ok:#14722f;--warn:#8a5a00;--bad:#b3261e;
--c0:#0072b2;--c1:#d55e00;--c2:#009e73;--c3:#b6588c;--c4:#b37c00;--c5:#3a9bd1;--c6:#6b4c9a;--c7:#6b7000}
@media (prefers-color-scheme:dark){:root{--bg:#11161c;--fg:#e4e8ec;--muted:#9ba6b2;--line:#333c47;
--faint:#222a33;--panel:#19202a;--link:#79b8ff;--bound:#ff8a80;--ok:#56d27b;--warn:#e8b44c;--bad:#ff8a80;
--c0:#58b1e8;--c1:#ff9152;--c2:#35cf9f;--c3:#e69ac4;--c4:#f0b93f;--c5:#8fd3f7;--c6:#b99ae0;--c7:#c6ca55}}
*{box-sizing:border-box}
body{margin:0 auto;max-width:1240px;padding:1.2rem 1rem 4rem;background:var(--bg);color:var(--fg);
font:15px/1.5 system-ui,"Segoe UI",Roboto,"Helvetica Neue","DejaVu Sans",Arial,sans-serif}
p,h1,h2,h3,dd{overflow-wrap:anywhere}
h1{font-size:1.6rem;line-height:1.2;margin:.2rem 0 .4rem}
h2{font-size:1.25rem;margin:2.6rem 0 .4rem;padding-top:.9rem;border-top:1px solid var(--line)}
h3{font-size:1rem;margin:1.6rem 0 .3rem}
p{max-width:46rem;margin:.4rem 0 .8rem}a{color:var(--link)}
.muted,figcaption span{color:var(--muted)}
nav{display:flex;flex-wrap:wrap;gap:.2rem 1.1rem;margin:.6rem 0}
.verdict{display:inline-block;font-weight:650;padding:.15rem .6rem;border-radius:.35rem;border:1.5px solid}
.pass{color:var(--ok)}.violated{color:var(--bad)}.incomplete{color:var(--warn)}
.figures{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(340px,100%),1fr));gap:1rem 1.4rem;margin:.6rem 0}
figure{margin:0;min-width:0;break-inside:avoid}figcaption{font-size:.87rem;line-height:1.35;overflow-wrap:anywhere}
figcaption b{font-weight:620;display:block}
svg.plot{width:100%;height:auto;max-width:460px;display:block;touch-action:pan-y}
svg text,.labels text{font-size:11.5px;fill:var(--muted);font-variant-numeric:tabular-nums}
.grid path{stroke:var(--line);stroke-width:.8;fill:none}.grid .minor{stroke:var(--faint)}
svg polyline{fill:none}.median{stroke-width:1.8;stroke-linejoin:round}
.bound{stroke:var(--bound);stroke-width:1.6;stroke-dasharray:7 4}
.fit{stroke:var(--fg);stroke-width:1.1;stroke-dasharray:1.5 3}
.band{opacity:.2}.points{fill:none;stroke-width:4.4;stroke-linecap:round;stroke-opacity:.55}
.d1{stroke-dasharray:6 2}.d2{stroke-dasharray:2 2}.points.d1,.points.d2{stroke-dasharray:none}
.dots{fill:none;stroke-linecap:round}.dots.d1,.dots.d2{stroke-dasharray:none}.big{stroke-width:8;stroke-opacity:.9}.cut{stroke:var(--bound);stroke-opacity:.9}.unused{stroke:var(--muted);stroke-opacity:.5}
.whisker{fill:none;stroke-width:1.2;stroke-opacity:.6}
circle.on{fill:none;stroke:var(--fg);stroke-width:2}svg.defs{position:absolute;width:0;height:0}
.s0{stroke:var(--c0)}.s1{stroke:var(--c1)}.s2{stroke:var(--c2)}.s3{stroke:var(--c3)}
.s4{stroke:var(--c4)}.s5{stroke:var(--c5)}.s6{stroke:var(--c6)}.s7{stroke:var(--c7)}
.f0{fill:var(--c0)}.f1{fill:var(--c1)}.f2{fill:var(--c2)}.f3{fill:var(--c3)}
.f4{fill:var(--c4)}.f5{fill:var(--c5)}.f6{fill:var(--c6)}.f7{fill:var(--c7)}
.legend{display:flex;flex-wrap:wrap;gap:.1rem 1.1rem;font-size:.87rem;margin:.3rem 0}
.legend svg{width:26px;height:10px;vertical-align:middle;margin-right:.35rem}
.scroll{overflow-x:auto;margin:.4rem 0 1rem}
table{border-collapse:collapse;font-size:.87rem;font-variant-numeric:tabular-nums}
th,td{padding:.22rem .7rem .22rem 0;text-align:left;vertical-align:top;border-bottom:1px solid var(--faint)}
thead th{border-bottom:1px solid var(--line);font-weight:620;vertical-align:bottom}
.num,th.num{text-align:right;white-space:nowrap}td small{color:var(--muted)}
code,pre{font:12.5px/1.45 ui-monospace,"SF Mono",Menlo,"DejaVu Sans Mono",monospace}
pre{background:var(--panel);padding:.7rem .9rem;border-radius:.4rem;overflow-x:auto;max-width:100%}
th,td code{white-space:nowrap}thead th,td{white-space:nowrap}
tbody th{white-space:normal;overflow-wrap:anywhere;min-width:9rem;max-width:14rem}td.note{min-width:11rem;white-space:normal}td details{margin:0}
details{margin:.5rem 0}summary{cursor:pointer;color:var(--link)}
.bars text{fill:var(--fg)}.bars rect{fill:var(--c0)}
#tip,#replay{position:fixed;z-index:2;background:var(--panel);color:var(--fg);border:1px solid var(--line);
border-radius:.4rem;box-shadow:0 2px 12px #0004;font-size:.84rem;line-height:1.4}
#tip{padding:.4rem .6rem;pointer-events:none;max-width:min(20rem,90vw);white-space:pre-line}
#replay{left:50%;bottom:1rem;transform:translateX(-50%);padding:.6rem .9rem;width:min(60rem,94vw)}
#replay code{display:block;overflow-x:auto;white-space:pre;padding:.3rem 0}
#replay button{font:inherit;margin-right:.6rem}[hidden]{display:none!important}
:focus-visible{outline:2px solid var(--link);outline-offset:2px}
@media print{:root{color-scheme:light}nav,#tip,#replay{display:none!important}body{max-width:none;font-size:10pt}
.scroll{overflow:visible}h2{break-after:avoid}}
)css";

const char* const kScript = R"js(
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
)js";

}  // namespace ar3d::report
