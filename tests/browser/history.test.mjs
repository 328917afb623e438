// The page of `ar3d history report` in headless Chromium.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {after, before, test} from "node:test";
import {complaints, launch, newPage, program, requests} from "./chromium.mjs";

const spec = `study = "browser"
[[sweep]]
families = ["cycle", "random-cubic"]
sizes = [20, 50]
algorithms = ["grid", "two-bend"]
`;

let folder, browser, page;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "ar3d-browser-"));
  const history = join(folder, "history");
  writeFileSync(join(folder, "study.toml"), spec);
  for (let place = 1; place <= 9; ++place) {
    const results = join(folder, "study" + place + ".h5");
    execFileSync(program, ["study", "run", join(folder, "study.toml"), "-q", "-o", results]);
    execFileSync(program, ["history", "add", results, "--folder", history, "--place", String(place), "--name", "v" + place]);
  }
  execFileSync(program, ["history", "report", "--folder", history]);
  browser = await launch();
  page = await newPage(browser);
  await page.goto("file://" + join(history, "history.html"));
});

after(async () => {
  await browser?.close();
  if (folder) rmSync(folder, {recursive: true, force: true});
});

test("every cell is there, and nothing changed", async () => {
  assert.equal(await page.locator("#cells tbody tr").count(), 8);
  assert.ok(await page.locator("svg.spark").count() >= 16);  // volume and bends; times unless the machine is busy
  assert.equal(await page.locator(".verdict").textContent(), "0 changes");
});

test("a picture grows by a click and by Enter", async () => {
  const picture = page.locator("svg.spark").last();
  const small = (await picture.boundingBox()).width;
  await picture.click();
  assert.ok((await picture.boundingBox()).width > 2 * small);
  await picture.focus();
  await page.keyboard.press("Enter");
  assert.equal((await picture.boundingBox()).width, small);
});

test("tables sort", async () => {
  const head = page.locator("#cells thead th", {hasText: /^n$/});
  await head.click();
  const sizes = (await page.locator("#cells tbody tr td:nth-child(3)").allTextContents()).map(Number);
  assert.deepEqual(sizes, [...sizes].sort((a, b) => b - a));
});

test("it reads at 390 pixels", async () => {
  await page.setViewportSize({width: 390, height: 800});
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390);
});

test("names are only text, and a script that is planted does not run", async () => {
  const attack = "</script><img src=x onerror=globalThis.bad=1>", file = join(folder, "bad.html");
  const written = attack.replaceAll("<", "\\u003c").replaceAll(">", "\\u003e");
  const planted = "<script>globalThis.bad = 2</script><img src='data:,' onerror='globalThis.bad = 3'>";
  const text = readFileSync(join(folder, "history", "history.html"), "utf8");
  assert.match(text, /Content-Security-Policy content="default-src 'none';[^"]* script-src 'sha256-/);
  writeFileSync(file, text.replaceAll('"random-cubic"', `"${written}"`).replaceAll('"v3"', `"${written}"`) + planted);
  const bad = await browser.newPage();
  await bad.goto("file://" + file);
  assert.ok((await bad.locator("#cells tbody td").allTextContents()).some(cell => cell.includes(attack)));
  assert.equal(await bad.locator("img").count(), 1);  // the planted one
  assert.equal(await bad.evaluate(() => globalThis.bad), undefined);
  await bad.close();
});

test("nothing was asked for and nothing complained", () => {
  assert.deepEqual(complaints, []);
  assert.deepEqual(requests.filter(url => !url.startsWith("file://" + folder)), []);
});
