// Pictures of drawings as their pages show them, for README and docs/open-questions.md: FOLDER/view-*.png; docs/figures holds them.
//   tests/browser/run --install && node tools/gallery-views.mjs PROGRAM FOLDER
import {execFileSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {dirname, join, resolve} from "node:path";
import {fileURLToPath} from "node:url";
import {chromium} from "./browser.mjs";

const [program, figures] = process.argv.slice(2).map(word => resolve(word)), folder = mkdtempSync(join(tmpdir(), "ar3d-views-"));
const views = [["k5", "diamond", 0, 0], ["petersen", "routed-120", 1.25, 0.1], ["octahedron", "routed", 0.5, 0.05],
  ["k5", "two-bends", 0.4, 0.1]];
const root = join(dirname(fileURLToPath(import.meta.url)), "..");  // k5-two-bends: the first of the finished drawings
const finished = readFileSync(join(root, "docs", "open-questions", "small_drawings.jsonl"), "utf8").split("\n")[0];
const browser = await chromium.launch({executablePath: "/usr/bin/chromium", args: ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]});
const page = await browser.newPage({viewport: {width: 640, height: 560}});
for (const [graph, algorithm, right, up] of views) {
  const file = join(folder, graph + ".html");
  if (algorithm === "two-bends") execFileSync(program, ["view", "-", "-o", file], {input: finished});
  else execFileSync(program, ["draw", "-", "--algorithm", algorithm, "-o", file], {input: execFileSync(program, ["generate", graph])});
  await page.goto("file://" + file);
  await page.waitForFunction(() => globalThis.ar3d.view.ready && globalThis.ar3d.view.settled);
  await page.evaluate(([right, up]) => {
    globalThis.ar3d.turn(right, up);
    globalThis.ar3d.fit();
    document.querySelectorAll("header, nav, #unfold, #panel, #keys").forEach(part => { part.style.display = "none"; });
  }, [right, up]);
  await page.waitForTimeout(2500);
  await page.screenshot({path: join(figures, `view-${graph}-${algorithm}.png`)});
}
await browser.close();
rmSync(folder, {recursive: true, force: true});
