// The page of `ar3d history report` in headless Chromium.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {after, before, test} from "node:test";
import {complaints, cutOff, launch, nameless, newPage, paleTexts, program, requests} from "./chromium.mjs";

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

test("a commit has one heading, and its settings stand under it", async () => {
  const text = readFileSync(join(folder, "history", "history.html"), "utf8"), file = join(folder, "changed.html");
  const stored = text.match(/id=tables>(.*?)<\/script>/s)[1], tables = JSON.parse(stored);
  const {lines, changes} = tables.tables, measure = lines.columns.findIndex(column => column.name === "measure");
  const line = lines.rows.findIndex(row => row[measure] === "volume"), setting = lines.rows[line][2];
  changes.rows = [[5, 4, setting, "volume", "larger volume", true, 2, 4, 463, 0.5, 463, line, "ar3d compare a b"],
    [5, 4, "", "volume", "smaller volume", false, 8, 8, -0.2, -0.3, -0.1, line, "ar3d compare a b"],
    [1, 0, setting, "bends", "other drawings", false, 1, 4, 0, 0, 0, line, "ar3d compare c d"]];
  writeFileSync(file, text.replace(stored, JSON.stringify(tables)));
  const changed = await newPage(browser);
  await changed.goto("file://" + file);
  assert.deepEqual((await changed.locator("#changes h3").allTextContents()).map(head => head.split(",")[0]), ["v6 after v5", "v2 after v1"]);
  assert.match(await changed.locator("#changes table").first().textContent(), /larger volume\u00d7 464 \[\+50\.0 %, \u00d7 464\]2 of 4.*all settings.*-20\.0 %/s);
  assert.match(await changed.locator("#changes table").last().textContent(), /some graphs more, others less/);
  await changed.locator("#changes svg.plot").first().waitFor();
  assert.equal(await changed.locator("#changes svg.plot .line.bound").count(), 2);
  await changed.close();
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

test("it reads at 390 pixels, light and dark, and every control has a name", async () => {
  await page.setViewportSize({width: 390, height: 800});
  assert.deepEqual([await cutOff(page), await nameless(page)], [[], []]);
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({colorScheme});
    assert.deepEqual(await paleTexts(page), []);
  }
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
