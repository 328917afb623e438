// The site of the pages (tools/site) in headless Chromium: its four parts, search, dark and light, a narrow screen.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {existsSync, mkdtempSync, readFileSync, rmSync, statSync} from "node:fs";
import {createServer} from "node:http";
import {tmpdir} from "node:os";
import {dirname, extname, join, resolve} from "node:path";
import {after, before, test} from "node:test";
import {fileURLToPath} from "node:url";
import {complaints, launch, newPage, paleTexts, program, requests, shot} from "./chromium.mjs";

const tool = join(dirname(fileURLToPath(import.meta.url)), "..", "..", "tools", "site");
const kinds = {".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".json": "application/json", ".svg": "image/svg+xml"};
const sample = ["index.html", "docs/commands.html", "docs/algorithms.html", "docs/theorem1.html", "docs/python-functions.html", "results/SCHEMA.html", "cpp/annotated.html"];
let folder, server, origin, browser, page, built;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "ar3d-site-test-"));
  built = execFileSync(tool, [program, folder], {encoding: "utf8"});
  server = createServer((request, answer) => {
    const path = resolve(folder, "." + decodeURIComponent(new URL(request.url, "http://x").pathname));
    const file = existsSync(path) && statSync(path).isDirectory() ? join(path, "index.html") : path;
    answer.writeHead(existsSync(file) ? 200 : path.endsWith("favicon.ico") ? 204 : 404, {"Content-Type": kinds[extname(file)] ?? "application/octet-stream"});
    answer.end(existsSync(file) ? readFileSync(file) : "");
  }).listen(0, "127.0.0.1");
  await new Promise(done => server.once("listening", done));
  origin = `http://127.0.0.1:${server.address().port}/`;
  browser = await launch();
  page = await newPage(browser, {colorScheme: "light"});
  page.on("response", answer => { if (answer.status() >= 400) complaints.push(answer.url()); });
});

after(async () => {
  await browser?.close();
  server?.close();
  if (folder) rmSync(folder, {recursive: true, force: true});
});

test("every link leads somewhere, and users have fewer than 15,000 words to read", () => {
  const [, links, dead, , words] = built.match(/(\d+) links, (\d+) dead, (\d+) to other sites not followed; (\d+) words/);
  assert.ok(Number(links) > 1000 && dead === "0" && Number(words) < 15000, built);
});

test("four parts; the first screen has the picture, the two commands and a table", async () => {
  await page.goto(origin);
  assert.deepEqual((await page.locator(".md-tabs__link").allTextContents()).map(text => text.trim()), ["Use", "Reference", "Proofs", "Laboratory"]);
  assert.ok(await page.locator("article img").first().evaluate(image => image.naturalWidth > 100));
  assert.match(await page.locator("article pre").first().textContent(), /ar3d study run quick[^]*run-tests/);
  assert.equal(await page.locator("article table").first().locator("th").count(), 5);
  await shot(page, "site-1280");
});

test("search finds a word of the proofs and a command", async () => {
  for (const [asked, found] of [["kempe", /docs\/theorem3/], ["replay", /docs\/(commands|study|contracts)/]]) {
    await page.goto(origin);
    const first = page.locator(".md-search-result__item a").first();
    for (let i = 0; i < 20 && !await first.isVisible(); ++i) {  // what is typed before the index has come is lost
      await page.locator("input.md-search__input").fill("");
      await page.locator("input.md-search__input").fill(asked);
      await first.waitFor({timeout: 5000}).catch(() => {});
    }
    const places = await page.locator(".md-search-result__item a").evaluateAll(links => links.map(link => link.href));
    assert.ok(places.some(place => found.test(place)), `${asked}: ${places}`);
  }
});

test("dark where the system is dark, and by the button", async () => {
  const scheme = () => page.evaluate(() => document.body.getAttribute("data-md-color-scheme"));
  await page.goto(origin + "docs/theorem1.html");
  assert.equal(await scheme(), "default");
  await page.locator("label[for=__palette_2]").click();
  assert.equal(await scheme(), "slate");
  await page.evaluate(() => Promise.all(document.getAnimations().map(one => one.finished)));  // colours fade in
  assert.deepEqual(await paleTexts(page, "article p a[href]"), []);
  await shot(page, "site-1280-dark");
});

test("at 390 pixels nothing is wider than the screen, but tables and code that scroll", async () => {
  await page.setViewportSize({width: 390, height: 800});
  for (const place of sample) {
    await page.goto(origin + place);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390, place);
    await shot(page, "site-390-" + place.replace(/\W/g, "-"));
  }
});

test("C++ is there, and nothing is asked of other sites", async () => {
  await page.setViewportSize({width: 1280, height: 900});
  await page.goto(origin + "cpp/annotated.html");
  assert.match(await page.textContent("body"), /Certificate/);
  await shot(page, "site-1280-cpp");
  assert.deepEqual(requests.filter(url => !url.startsWith(origin)), []);
  assert.deepEqual(complaints, []);
});
