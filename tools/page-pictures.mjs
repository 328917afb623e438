// Pictures of the report and of the viewer for the docs, small: FOLDER/page-*.png; docs/figures holds them.
//   tests/browser/run --install && node tools/page-pictures.mjs PROGRAM FOLDER
import {execFileSync} from "node:child_process";
import {mkdtempSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {dirname, join, resolve} from "node:path";
import {fileURLToPath} from "node:url";
import {chromium} from "./browser.mjs";

const [program, figures] = process.argv.slice(2).map(word => resolve(word)), folder = mkdtempSync(join(tmpdir(), "ar3d-pictures-"));
const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const reference = join(root, "results", "reference", "0.2.0-volume.h5");
execFileSync(program, ["report", reference, "-o", join(folder, "report.html")], {cwd: root});
const graph = execFileSync(program, ["generate", "petersen"]);
execFileSync(program, ["draw", "-", "--algorithm", "grid", "-o", join(folder, "drawing.html")], {input: graph});
const browser = await chromium.launch({executablePath: "/usr/bin/chromium",
  args: ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]});

async function take(name, width, colours, prepare, scale = width > 500 ? 0.5 : 0.75) {
  const context = await browser.newContext({viewport: {width, height: width > 500 ? 860 : 800}, deviceScaleFactor: scale, colorScheme: colours});
  context.setDefaultTimeout(120000);  // other work may keep the cores busy
  const page = await context.newPage();
  await prepare(page);
  await page.screenshot({path: join(figures, `page-${name}-${width}-${colours}.png`)});
  await context.close();
}
const settled = page => page.waitForFunction(() => globalThis.ar3d.view.ready && globalThis.ar3d.view.settled && !globalThis.ar3d.view.moving);
const report = selector => async page => {
  await page.goto("file://" + join(folder, "report.html"));
  await page.waitForFunction(() => "drawn" in document.documentElement.dataset);
  await page.evaluate(css => document.querySelector(css).scrollIntoView(), selector);
};
const viewer = async page => {
  await page.goto("file://" + join(folder, "drawing.html"));
  await settled(page);
  await page.keyboard.press(".");
  await page.waitForTimeout(1500);
};
for (const colours of ["light", "dark"]) {
  for (const width of [1280, 390]) {
    await take("report", width, colours, report("body"));
    await take("viewer", width, colours, viewer, width > 500 ? 0.4 : 0.7);
  }
}
await take("heat-map", 1280, "light", report("section#a0 details:has(table.heat)"));
await take("shown", 1280, "light", async page => {
  await report("section#a0 details:has(table.heat)")(page);
  await page.locator("td.shown").first().click();
  await page.frameLocator("#shown iframe").locator("#verdict").waitFor();
  await settled(page.frames().find(frame => frame.parentFrame()));
  await page.waitForTimeout(500);
}, 0.4);
const page = await browser.newPage({viewport: {width: 1280, height: 860}});
await report("body")(page);
const [paint] = await page.evaluate(() => performance.getEntriesByType("paint").map(entry => entry.startTime));
console.log(`report: first paint after ${paint.toFixed(0)} ms`);
await browser.close();
rmSync(folder, {recursive: true, force: true});
