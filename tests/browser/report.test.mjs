// The report in headless Chromium: what a reader sees, points at, clicks and types.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {dirname, join, resolve} from "node:path";
import {after, before, test} from "node:test";
import {complaints, cutOff, launch, nameless, newPage, paleTexts, program, requests, shot} from "./chromium.mjs";

const spec = `study = "browser"
seed = 1
[[sweep]]
families = ["random-cubic", "random-4-regular", "prism"]
sizes = { from = 16, to = 1600, per_decade = 5 }
algorithms = [{ algorithm = "diamond", effort = [0, 1, 2] }, "two-bend", "grid"]
instances = 3
timed_repetitions = 1
`;

let folder, browser, page;
/// Waits until every figure is drawn.
const drawn = of => of.waitForFunction(() => "drawn" in document.documentElement.dataset);

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "ar3d-browser-"));
  writeFileSync(join(folder, "study.toml"), spec);
  execFileSync(program, ["study", "run", join(folder, "study.toml"), "-q", "--force-timing", "-o", join(folder, "study.h5")]);
  browser = await launch();
  page = await newPage(browser);
  copyFileSync(join(folder, "study.h5"), join(folder, "again.h5"));
  execFileSync(program, ["report", join(folder, "study.h5"), "--reference", join(folder, "again.h5")]);
  await page.goto("file://" + join(folder, "study.html"));
  await drawn(page);
});

after(async () => {
  await browser?.close();
  if (folder) rmSync(folder, {recursive: true, force: true});
});

/// The place of a plot's point on the screen; `place` counts from the left.
const placeOf = async (plot, place) => {
  await plot.scrollIntoViewIfNeeded();
  await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
  return plot.evaluate((svg, i) => {
    const dots = [...svg.querySelector("path.points").getAttribute("d").matchAll(/M([\d.-]+) ([\d.-]+)h0/g)];
    const box = svg.getBoundingClientRect(), scale = box.width / svg.viewBox.baseVal.width;
    return {x: box.x + dots[i][1] * scale, y: box.y + dots[i][2] * scale};
  }, place);
};
const firstPlotWithPoints = () => page.locator("section#a0 svg.plot:has(path.points)").first();

test("one small file that asks for nothing else", () => {
  assert.ok(statSync(join(folder, "study.html")).size < 2e6);
  assert.deepEqual(requests.filter(url => !url.startsWith("file://" + folder)), []);
});

test("the first screen answers whether all is certified, what comes closest to a bound, and what changed", async () => {
  for (const [id, answer] of [["p:has(.verdict) + p", /\d+ proved right .* 0 violated/], ["#closest", /closest to a bound is .* on .*, n = [\d,]+: its [xyz] extent is [\d,]+ of/],
    ["#since", /Since the reference again.h5: PASS/]]) {
    assert.match(await page.locator(id).textContent(), answer);
    assert.ok((await page.locator(id).boundingBox()).y < 500, id);
  }
  const since = page.locator("#reference");
  assert.match(await since.locator("p").first().textContent(), /The two hold the same measurements/);
  assert.equal(await since.locator("tbody tr").count(), 5, "one line a setting");
});

test("the verdict and every kind of figure are there", async () => {
  assert.equal(await page.locator(".verdict").textContent(), "PASS");
  assert.equal(await page.locator("section.setting").count(), 5);
  for (const css of ["g.line.family path", "g.line.middle path", "g.line.bound path", "g.band path", "path.points", "#trade g.line.front path",
    "#trade g.crossing circle", "figure.bars rect", "table.heat td[data-r]", "#closeness button.graph"]) {
    assert.ok(await page.locator(css).count() > 0, css);
  }
  const lines = await page.evaluate(() => [...document.querySelectorAll("g.line.family path")]
    .map(line => line.getBoundingClientRect().width));
  assert.ok(lines.every(width => width > 50), "every line has a width");
  const legends = await page.evaluate(() => Math.max(...[...document.querySelectorAll("g.ends")]
    .map(legend => legend.children.length)));
  assert.ok(legends <= 8, `a legend of ${legends} entries`);
  await shot(page, "top-1280");
  for (const id of ["closeness", "trade", "a0"]) {
    await page.locator("#" + id).scrollIntoViewIfNeeded();
    await page.evaluate(i => document.getElementById(i).scrollIntoView(), id);
    await shot(page, id + "-1280");
  }
});

test("another n shows another trade", async () => {
  const title = () => page.locator("#trade-figure figcaption b").textContent();
  const options = await page.locator("#trade-n option").evaluateAll(all => all.map(option => option.value));
  assert.ok(options.length > 3);
  for (const n of [options[0], options.at(-2)]) {
    await page.locator("#trade-n").selectOption(n);
    assert.equal(await title(), `Volume against drawing time, n = ${Number(n).toLocaleString("en-US")}`);
  }
});

/// The tables of a page: rows as objects.
const tablesOf = of => of.evaluate(() => Object.fromEntries(Object.entries(JSON.parse(document.getElementById("tables").textContent).tables)
  .map(([name, {columns, rows}]) => [name, rows.map(row => Object.fromEntries(columns.map((column, i) => [column.name, row[i]])))])));

test("the front table has one number a cell; labels and intervals are in the detail", async () => {
  const cells = await page.locator("#closeness tbody td.num").allTextContents();
  assert.equal(cells.length, 5 * 9);
  for (const cell of cells) assert.match(cell, /^(\d[\d,.]*( %)?|none|\u2013)$/);
  const details = await page.locator("section#a0 table:has(th:text-is('Exponents')) tbody tr").allTextContents();
  assert.equal(details.length, 3);
  for (const row of details) assert.match(row, /^(longest side|volume|drawing time)(-?\d\.\d\d){4}\d/);
  const promised = await page.locator("#promises tbody td.note").allTextContents();
  for (const cell of promised) assert.match(cell, /^\d+\.\d{3} \[-?\d.*\] (power law|apparent)/);
  assert.match(await page.locator("#promises > p").textContent(), /geometric mean extent/);
});

test("three sentences for each setting, whose numbers are those of the tables", async () => {
  const tables = await tablesOf(page), find = (table, setting, quantity) => tables[table].find(row => row.setting === setting && row.quantity === quantity);
  const near = (text, value, digits) => assert.ok(Math.abs(parseFloat(text.replaceAll(",", "")) - value) <= 0.5000001 * 10 ** -digits, `${text} is not ${value}`);
  assert.equal(await page.locator("#answers p").count(), 5);
  const asSeconds = text => parseFloat(text) * {s: 1, ms: 1e-3, "\u00b5s": 1e-6, ns: 1e-9}[text.split(" ")[1]];
  for (const [setting, row] of tables.settings.entries()) {
    const [promise, growth, beside] = await Promise.all(["promise", "growth", "beside"].map(css => page.locator(`#answers p[data-s="${setting}"] .${css}`).textContent()));
    const of = promise.match(/^The promise holds on all ([\d,]+) graphs that were drawn: angles of at least ([\d.]+)\u00b0, at most (\d+) bends an edge, at most ([\d.]+) % of the box in (.), on (.+), n = ([\d,]+)\.$/);
    assert.ok(of, promise);
    near(of[1], row.drawn, 0);
    near(of[2], row.angle, 2);
    assert.deepEqual([Number(of[3]), of[5], of[6]], [row.most_bends, row.closest_axis, row.closest_family]);
    near(of[4], 100 * row.share, 1);
    near(of[7], row.closest_n, 0);
    const volume = find("exponents", setting, "volume"), side = find("exponents", setting, "longest side"), time = find("exponents", setting, "drawing time");
    for (const [begin, law] of [["Volume grows", volume], ["longest side grows", side], ["time grows", time]]) {
      const told = growth.match(new RegExp(begin + " like n\\^([\\d.]+)(?: to n\\^([\\d.]+))? \\[(-?[\\d.]+), ([\\d.]+)\\], (a power law|an apparent exponent) in (\\d+) of (\\d+) families"));
      assert.ok(told, growth);
      near(told[1], law.least, 2);
      near(told[2] ?? told[1], law.largest, 2);
      near(told[3], law.low, 2);
      near(told[4], law.high, 2);
      assert.deepEqual([told[5], Number(told[6]), Number(told[7])], [law.power ? "a power law" : "an apparent exponent", law.power || law.apparent, law.power + law.logarithm + law.apparent + law.undecided]);
    }
    const order = growth.match(/, (the order of the bound \(n\^|below the bound's n\^|above the bound's n\^)([\d.]+)/);
    near(order[2], volume.order, 2);
    assert.equal(order[1].slice(0, 5), volume.high < volume.order ? "below" : volume.low > volume.order ? "above" : "the o");
    const used = Math.max(...tables.bounds.filter(curve => curve.setting === setting).map(curve => 100 * curve.volume_share));
    assert.ok(Math.abs(growth.match(/uses at most ([\d.e-]+) % of the theorem's box/)[1] - used) <= (used < 1 ? 0.05 * used : 0.5));
    const bends = tables.bends_by_n.filter(one => one.setting === setting).map(one => one.median), told = growth.match(/edges have ([\d.]+)(?: to ([\d.]+))? bends in the mean/);
    near(told[1], Math.min(...bends), 2);
    near(told[2] ?? told[1], Math.max(...bends), 2);
    const [, seconds, n] = growth.match(/, to ([\d.]+ \S*s) at n = ([\d,]+)\.$/), last = tables.bands.filter(one => one.setting === setting && one.quantity === "drawing time").at(-1);
    near(n, last.n, 0);
    assert.ok(Math.abs(asSeconds(seconds) / (last.median * last.n) - 1) < 0.006, seconds);
    const [, others, , rank, , fast] = beside.match(/^Beside (\d) others at n = ([\d,]+)(?: \u2013 [\d,]+)? its volume is the (\w*) ?least(, [\d.e]+ times that of .+?)?, and it is the (\w*) ?fastest\.$/);
    const sets = tables.trade.filter(one => one.setting === setting).map(own => tables.trade.filter(one => one.group === own.group && one.n === own.n));
    const rows = sets.sort((x, y) => y.length - x.length || y[0].n - x[0].n)[0], own = rows.find(one => one.setting === setting);
    const place = key => { const above = rows.filter(one => one[key] < own[key]).length; return ["", "2nd", "3rd", "4th", "5th"][above]; };
    assert.deepEqual([Number(others), rank, fast], [rows.length - 1, place("volume"), place("time")]);
  }
});

test("a reader finds angle, bends, share, exponent and time of diamond on the first screen, and a drawing that turns", async () => {
  await page.evaluate(() => scrollTo(0, 0));
  const first = page.locator("#answers p").first(), box = await first.boundingBox();
  assert.ok(box.y + box.height < 900, `the answers of diamond end at ${box.y + box.height}`);
  const text = await first.textContent();
  for (const part of [/^diamond/, /angles of at least 109\.47\u00b0/, /at most \d bends an edge/, /at most [\d.]+ % of the box/, /like n\^\d\.\d\d/, /\d (s|ms|\u00b5s) at n = /]) assert.match(text, part);
  const figures = await page.locator("#panels figure").all();
  assert.equal(figures.length, 3, "volume, bends and time");
  for (const one of figures) {
    const {y, height} = await one.boundingBox();
    assert.ok(y + height < 900);
    assert.equal(await one.locator("g.answer path").count(), 5, "all settings");
  }
  for (const one of figures.slice(0, 2)) assert.equal(await one.locator("g.bound path").count(), 5, "the bounds of volume and bends are dashed");
  const canvas = page.locator("#turning canvas"), {y} = await canvas.boundingBox();
  assert.ok(y < 700);
  await page.waitForFunction(() => document.querySelector("#turning canvas").dataset.angle);
  const angle = await canvas.getAttribute("data-angle");
  await page.waitForFunction(before => document.querySelector("#turning canvas").dataset.angle !== before, angle);
  const inked = () => canvas.evaluate(of => of.getContext("2d").getImageData(0, 0, of.width, of.height).data.filter((value, i) => i % 4 === 3 && value > 0).length);
  assert.ok(await inked() > 500, "lines are drawn");
  const options = await page.locator("#turning option").allTextContents();
  assert.equal(options.length, 5, "one of each setting");
  await page.locator("#turning select").selectOption("3");
  await page.getByRole("button", {name: "Look closer"}).click();
  await page.frameLocator("#shown iframe").locator("#verdict").waitFor();
  assert.equal(options[3].split(" ")[0], (await page.locator("#shown p").textContent()).split(" \u00b7 ")[1].split(" ")[0], "its algorithm");
  await page.locator("#shown").getByRole("button", {name: "Close"}).click();
});

test("the specifications of the program are linked, each as it is installed", async () => {
  const links = await page.locator("#studies a").evaluateAll(all => all.map(link => [link.download, decodeURIComponent(link.href.split(",").slice(1).join(","))]));
  assert.ok(links.length > 10);
  for (const [name, text] of links) assert.equal(text, execFileSync(program, ["list", "studies", name.replace(".toml", "")], {encoding: "utf8"}));
});

test("the figure of the sides shows the share that the first screen tells", async () => {
  const tables = await tablesOf(page);
  for (const [setting, row] of tables.settings.entries()) {
    const side = row.closest_axis + " extent", curves = tables.curves.filter(one => one.quantity === side && tables.bounds[one.curve].setting === setting && one.bound !== null);
    const share = Math.max(...curves.map(one => one.largest / one.bound));
    assert.ok(Math.abs(share - row.share) < 2e-3, `${share} and ${row.share}`);
    assert.match(await page.locator(`section#a${setting} figcaption b`).first().textContent(), new RegExp(`${side}, the nearest to its bound$`));
  }
});

test("times that no timing phase measured are neither ranked nor drawn", async () => {
  const spec_ = spec.replace("timed_repetitions = 1", "").replace("1600", "200");
  writeFileSync(join(folder, "untimed.toml"), spec_);
  execFileSync(program, ["study", "run", join(folder, "untimed.toml"), "-q", "-o", join(folder, "untimed.h5")]);
  const untimed = await newPage(browser);
  await untimed.goto("file://" + join(folder, "untimed.html"));
  await drawn(untimed);
  assert.ok(await untimed.locator("#trade-untimed").isVisible());
  assert.ok(await untimed.locator("#trade-figure").isHidden());
  assert.deepEqual((await untimed.locator("thead th").allTextContents()).filter(text => /time/i.test(text)), [], "no column of times");
  assert.doesNotMatch(await untimed.locator("#answers").textContent(), /time grows|fastest/);
  const titles = await untimed.locator("figcaption b").allTextContents();
  assert.deepEqual(titles.filter(title => /time/.test(title)), []);
  await untimed.close();
});

test("families are highlighted by part of their name", async () => {
  const section = page.locator("section#a0");
  await section.locator("input.filter").fill("prism");
  assert.equal(await section.locator("g.family.on path").count(), 4, "side, volume, time and bends");
  assert.deepEqual(await section.locator("table.heat tbody tr:visible th").allTextContents(), ["prism"]);
  await section.locator("svg.plot").first().scrollIntoViewIfNeeded();
  await shot(page, "filter-1280");
  await section.locator("input.filter").fill("no such family");
  assert.equal(await section.locator("table.heat tbody tr:visible").count(), 0);
  await section.locator("input.filter").fill("");
  assert.equal(await section.locator("g.family.on").count(), 0);
  assert.equal(await section.locator("table.heat tbody tr:visible").count(), 3);
});

test("a table that scrolls shows on which side", async () => {
  const attachments = await page.locator("#closeness .scroll").evaluate(part => getComputedStyle(part).backgroundAttachment);
  assert.equal(attachments, "local, local, scroll, scroll");
});

test("tables sort by a click on a head, numbers as numbers", async () => {
  await page.locator("#metrics summary").click();
  const table = page.locator("#metrics table");
  const column = () => table.locator("tbody tr td:nth-child(4)").allTextContents();
  const head = table.locator("thead th").nth(3);
  await head.click();
  const falling = (await column()).map(text => parseFloat(text.replaceAll(",", ""))).filter(number => !isNaN(number));
  assert.deepEqual(falling, [...falling].sort((a, b) => b - a));
  assert.equal(await head.getAttribute("aria-sort"), "descending");
  await head.click();
  assert.equal(await head.getAttribute("aria-sort"), "ascending");
  const first = page.locator("#closeness thead th").first();
  await first.click();
  const names = await page.locator("#closeness tbody th").allTextContents();
  assert.deepEqual(names, [...names].sort().reverse());
});

test("a number of the heat map shows its graph", async () => {
  const cell = page.locator("section#a0 table.heat td[data-r]:not(.shown)").last();
  await cell.scrollIntoViewIfNeeded();
  await shot(page, "heat-1280");
  await cell.click();
  assert.ok(await page.locator("#open").isHidden(), "no drawing of this graph is in the page");
  assert.match(await page.locator("#replay code").textContent(), /^ar3d generate .* \| ar3d draw - --algorithm /);
  await page.keyboard.press("Escape");
  await cell.focus();
  await page.keyboard.press("Enter");
  assert.ok(await page.locator("#replay").isVisible());
  await page.locator("#replay button").first().click();
  assert.equal(await page.evaluate(() => getSelection().toString()), await page.locator("#replay code").textContent());
  await page.keyboard.press("Escape");
});

test("an underlined number of the heat map opens its drawing in 3D", async () => {
  const cell = page.locator("section#a0 table.heat td.shown").first();
  const n = (await page.locator("section#a0 table.heat thead th").nth(await cell.evaluate(td => td.cellIndex)).getAttribute("title")).slice(4);
  await cell.click();
  const viewer = page.frameLocator("#shown iframe");
  await viewer.locator("#verdict").waitFor();
  const frame = page.frames().find(one => one.parentFrame());
  await frame.waitForFunction(() => globalThis.ar3d.view.ready && globalThis.ar3d.view.settled);
  assert.equal(await viewer.locator("#verdict").textContent(), "certified");
  const [, , vertices, edges, seed, ...rest] = await page.evaluate(id => JSON.parse(document.getElementById("tables").textContent).tables.graphs.rows
    .find(graph => graph[0] === Number(id)), await cell.getAttribute("data-r"));
  const box = rest.slice(8, 11), grouped = value => value.toLocaleString("en-US");
  assert.match(await viewer.locator("#title").textContent(), new RegExp(`n = ${vertices}, seed ${seed}$`));
  assert.ok((await page.locator("#shown p").textContent()).includes(`${grouped(vertices)} vertices, ${grouped(edges)} edges`));
  assert.equal(await frame.evaluate(() => globalThis.ar3d.view.drawing.m), edges);
  const [low, high] = n.split(" \u2013 ").map(text => Number(text.replaceAll(",", "")));
  assert.ok(low <= vertices && vertices <= (high ?? low), n);
  assert.equal((await viewer.locator("#facts").textContent()).split("box ")[1], box.map(c => c.toLocaleString("en")).join(" \u00d7 "));
  await shot(page, "shown-1280");
  await page.locator("#shown").getByRole("button", {name: "Close"}).click();
  assert.equal(await page.locator("iframe").count(), 0);
  await cell.click();
  await page.locator("#shown").getByRole("button", {name: "Draw it again"}).click();
  assert.ok(await page.locator("#replay").isVisible());
  await page.locator("#open").click();
  await page.frameLocator("#shown iframe").locator("#verdict").waitFor();
  await page.locator("#shown").getByRole("button", {name: "Close"}).click();
});

test("Escape closes a drawing's dialog from its frame, where Tab leaves it, and from its buttons", async () => {
  const cell = page.locator("section#a0 table.heat td.shown").first(), frames = page.locator("#shown iframe"), close = page.locator("#shown").getByRole("button", {name: "Close"});
  const within = selector => page.frameLocator("#shown iframe").locator(selector);
  const isIn = selector => within(selector).evaluate(part => part.contains(document.activeElement));
  const open = async () => {
    await cell.focus();
    await page.keyboard.press("Enter");
    await within("#verdict").waitFor();
    await page.waitForFunction(() => document.activeElement.tagName === "IFRAME" && document.activeElement.contentWindow.ar3d.view.ready);
  };
  /// Presses a key until `reached`, at most as often as the dialog and the frame have controls.
  const until = async (key, reached) => {
    for (let i = 0; i < 40; ++i) {
      await page.keyboard.press(key);
      if (await reached()) return;
    }
    assert.fail(`${key} never gets there`);
  };
  const isClosed = async () => {
    await frames.waitFor({state: "detached"});
    assert.ok(await page.locator("#shown").isHidden());
    assert.ok(await cell.evaluate(td => td === document.activeElement), "the focus is where it was");
  };
  const onClose = () => close.evaluate(button => button === document.activeElement);
  await open();
  assert.deepEqual([await nameless(page), await nameless(page.frameLocator("#shown iframe"))], [[], []]);
  await page.keyboard.press("Escape");
  await isClosed();
  await open();
  await until("Tab", onClose);
  await until("Shift+Tab", () => isIn("#panel"));
  await until("Shift+Tab", onClose);
  await page.keyboard.press("Escape");
  await isClosed();
  await open();
  await page.keyboard.press(".");
  assert.match(await within("#selected").textContent(), /^vertex 0 at /);
  await page.keyboard.press("Escape");
  assert.ok(await within("#selection").isHidden());
  assert.ok(await page.locator("#shown").isVisible(), "the first Escape took the selection away");
  await page.keyboard.press("Escape");
  await isClosed();
});

/// A collection in three levels of folders, of which a user's program draws every graph wrong, at three levels of detail.
test("the page of a large collection with findings: 390 pixels, not endless, and a graph's name on every button", async () => {
  const sized = n => execFileSync(program, ["generate", "random-cubic", "-n", String(n), "--count", "39"]).toString().trim().split("\n");
  const graphs = Array.from({length: 50}, (_, i) => sized(10 + 2 * i)).flat();
  for (let i = 0; i < graphs.length; ++i) {
    const town = join(folder, "towns", `region-${i % 13}`, `district-${i % 5}`, `town-${i % 3}`);
    mkdirSync(town, {recursive: true});
    writeFileSync(join(town, `the-streets-of-town-${i}-and-of-its-neighbours.g6`), graphs[i] + "\n");
  }
  writeFileSync(join(folder, "towns.toml"), `study = "towns"
[[algorithm]]
name = "moment-curve"
command = ["/usr/bin/python3", "${resolve("../apps/moment_curve.py")}"]
guarantee = { max_degree = 4, max_bends = 3, cosine = [-1, 3] }
[[sweep]]
graphs = { files = "towns", name = "towns" }
algorithms = ["diamond", "grid", "moment-curve"]
level = ["extents", "positions", "full"]
`);
  assert.throws(() => execFileSync(program, ["study", "run", join(folder, "towns.toml"), "-q", "-o", join(folder, "towns.h5")], {stdio: "ignore"}), {status: 4});
  const towns = await newPage(browser);
  await towns.goto("file://" + join(folder, "towns.html"));
  await drawn(towns);
  assert.equal(await towns.locator("#findings li").count(), 20);
  for (const width of [1280, 390]) {
    await towns.setViewportSize({width, height: 900});
    const height = await towns.evaluate(() => document.documentElement.scrollHeight);
    process.stdout.write(`# the page is ${height} pixels high at ${width}\n`);
    assert.ok(height < (width === 390 ? 14000 : 10000));
  }
  await towns.evaluate(() => document.querySelectorAll("details").forEach(part => { part.open = true; }));
  for (const width of [390, 1280]) {
    await towns.setViewportSize({width, height: 900});
    assert.deepEqual(await cutOff(towns), [], `cut at ${width}`);
    await shot(towns, "findings-" + width);
  }
  assert.ok(await towns.locator("#precision tbody tr").count() <= 16 * 3 * 3, "bins of n");
  assert.ok(await towns.locator("button.graph").count() > 20);
  assert.equal(await towns.getByRole("button", {name: /the-streets-of-town-\d+/, includeHidden: true}).count(), await towns.locator("button.graph").count());
  assert.equal(await towns.locator("td[data-r]:not([title*=the-streets])").count(), 0);
  assert.deepEqual(await nameless(towns), []);
  await towns.locator("td.shown").first().click();
  const options = towns.frameLocator("#shown iframe").locator("#which option");
  await options.first().waitFor({state: "attached"});
  for (const text of await options.allTextContents()) assert.match(text, /^\d+ of \d+: (diamond|grid) \u00b7 towns, the-streets-of-town-\d+/);
  await towns.close();
});

test("the page of every algorithm and family: not long, all columns on the screen, no heat map of zeros", async () => {
  execFileSync(program, ["study", "run", "smoke", "-q", "-o", join(folder, "smoke.h5")]);
  const smoke = await newPage(browser);
  await smoke.goto("file://" + join(folder, "smoke.html"));
  await drawn(smoke);
  const height = await smoke.evaluate(() => document.documentElement.scrollHeight);
  process.stdout.write(`# the page of all families is ${height} pixels high\n`);
  assert.ok(height <= 30000, `${height} pixels`);
  await smoke.evaluate(() => document.querySelectorAll("section.setting details").forEach(part => { part.open = true; }));
  const wide = await smoke.evaluate(() => [...document.querySelectorAll("section.setting .scroll, #closeness .scroll")].filter(box => box.scrollWidth > box.clientWidth + 1).map(box => box.textContent.slice(0, 60)));
  assert.deepEqual(wide, []);
  const maps = await smoke.evaluate(() => [...document.querySelectorAll("table.heat")].map(map => [...map.querySelectorAll("td")].map(cell => cell.textContent)));
  for (const cells of maps) assert.ok(cells.some(text => text !== "0" && text !== ""));
  assert.match(await smoke.locator("section:has(h2:text-is('grid (effort=1)'))").textContent(), /No graph uses more than [\d.]+ % of the theorem's bound on any axis/);
  await smoke.close();
});

test("accuracy is told of all families beside exact integers, scaling with its spread and what it could not measure", async () => {
  writeFileSync(join(folder, "accuracy.toml"), `study = "accuracy"
seed = 1
accept_unproved = true
[[sweep]]
families = ["prism", "nested-truncation"]
sizes = [10, 32, 100]
algorithms = ["diamond", "two-bend", { algorithm = "two-bend-paper", type = [0, 1] }]
timed_repetitions = 2
[[sweep]]
families = "prism"
sizes = 100
algorithms = "diamond"
strong = { threads = [1, 2], drawings = 4, repetitions = 3 }
`);
  execFileSync("taskset", ["-c", "0", program, "study", "run", join(folder, "accuracy.toml"), "-q", "--force-timing", "-o", join(folder, "accuracy.h5")]);
  const accuracy = await newPage(browser);
  await accuracy.goto("file://" + join(folder, "accuracy.html"));
  await drawn(accuracy);
  const tables = await tablesOf(accuracy), lines = await accuracy.locator("#accuracy li").allTextContents();
  assert.equal(lines.length, 2);
  assert.match(lines[0], /^float is right to 10\u207b. degrees in all drawings up to n = 10; beyond, it misses 120 degrees at n = 100 of nested-truncation, and 1 of 6 drawings is broken\. It takes [\d.]+ times as long as (diamond|two-bend), which draws (prism|nested-truncation) at n = 100 in exact integers and misses nothing\.$/);
  const table = accuracy.locator("#precision table").first(), heads = await table.locator("th").allTextContents();
  for (const head of ["float", "double", "diamond, exact", "two-bend, exact"]) assert.ok(heads.includes(head), head);
  assert.equal(await table.locator("tbody tr").count(), 2 * 3, "families and n");
  for (const row of await table.locator("tbody tr").allTextContents()) assert.match(row, /^[a-z-]+\d+([\d.e-]+ [\d.]+ (ns|\u00b5s|ms)){2}(0 [\d.]+ (ns|\u00b5s|ms)){2}/);
  assert.equal(await accuracy.locator("g.line.exact path").count(), 2);
  const [first, second] = tables.scaling;
  assert.ok(second.crowded && !first.crowded && Math.abs(second.efficiency - second.ideal / second.batch) < 1e-4 && second.batch_low <= second.batch && second.batch <= second.batch_high);
  assert.ok(await accuracy.locator("#crowded").isVisible());
  assert.match(await accuracy.locator("#strong-weak tbody tr").nth(1).textContent(), /not told: too few cores/);
  const ticks = await accuracy.locator("#strong-weak g[aria-label='x-axis tick label'] text").allTextContents();
  assert.deepEqual(ticks, ["1", "2"]);
  assert.doesNotMatch(await accuracy.locator("body").textContent(), /\[object /);
  await accuracy.close();
});

test("every figure is saved as SVG and CSV", async () => {
  const figure = page.locator("section#a0 figure").first();
  const saved = async label => {
    const [download] = await Promise.all([page.waitForEvent("download"), figure.getByRole("button", {name: label}).click()]);
    const path = join(folder, download.suggestedFilename());
    await download.saveAs(path);
    return path;
  };
  const svg = await saved("SVG"), csv = readFileSync(await saved("CSV"), "utf8");
  assert.match(csv, /^series,kind,x,y,low,high\r\nall families,band,/);
  assert.match(csv, /\r\ntheorem's bound,line,/);
  const text = readFileSync(svg, "utf8");
  assert.ok(text.startsWith("<?xml") && !text.includes("var("));
  const shown = await newPage(browser);
  await shown.goto("file://" + svg);
  assert.equal(await shown.evaluate(() => document.documentElement.nodeName), "svg");
  assert.ok(await shown.locator("path").count() > 10);
  await shown.close();
  assert.equal(await page.locator(".save").count(), await page.locator("figure:visible, details:not([open]) figure").count());
});

test("names in a results file are text and nothing else", async () => {
  const attack = "<img src=x onerror=globalThis.bad=1>", written = attack.replaceAll("<", "\\u003c").replaceAll(">", "\\u003e");
  writeFileSync(join(folder, "bad.html"), readFileSync(join(folder, "study.html"), "utf8").replaceAll('"prism"', `"${written}"`));
  const bad = await newPage(browser);
  await bad.goto("file://" + join(folder, "bad.html"));
  await drawn(bad);
  assert.equal(await bad.locator("img").count(), 0);
  assert.equal(await bad.evaluate(() => globalThis.bad), undefined);
  assert.ok((await bad.locator("table.heat tbody th").allTextContents()).some(text => text.startsWith("<img")));
  await bad.close();
});

test("pointing at a row shows it", async () => {
  const plot = firstPlotWithPoints();
  const {x, y} = await placeOf(plot, 4);
  await page.mouse.move(x, y);
  const tip = page.locator("#tip");
  await tip.waitFor({state: "visible"});
  const text = await tip.textContent();
  for (const part of ["vertices", "seed", "box ", "the theorem's ", "the published "]) {
    assert.ok(text.includes(part), `${part} in ${text}`);
  }
  await shot(page, "hover-1280");
  await page.mouse.move(2, 2);
  assert.ok(await tip.isHidden());
});

test("a click gives a command that draws the row again", async () => {
  const {x, y} = await placeOf(firstPlotWithPoints(), 7);
  await page.mouse.click(x, y);
  const code = await page.locator("#replay code").textContent();
  const [command, replay] = code.split("\n");
  assert.match(command, /^ar3d generate [a-z0-9-]+ -n \d+ --seed \d+ \| ar3d draw - --algorithm diamond/);
  await shot(page, "click-1280");
  const path = {...process.env, PATH: dirname(program) + ":" + process.env.PATH};
  const verdict = execFileSync("bash", ["-c", command + " | ar3d verify -"], {env: path}).toString();
  assert.match(verdict, /1 certified, 0 violated/);
  const again = execFileSync("bash", ["-c", replay], {env: path, cwd: folder});
  assert.match(again.toString(), /equal, bit for bit/);
  assert.match(readFileSync(join(folder, "drawing.html"), "utf8"), /ar3d viewer/);
  await page.locator("#replay button").last().click();
  assert.ok(await page.locator("#replay").isHidden());
});

test("the keyboard does all of it", async () => {
  const plot = firstPlotWithPoints();
  await page.mouse.move(2, 2);
  await plot.focus();
  await page.keyboard.press("ArrowRight");
  const first = await page.locator("#tip").textContent();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  assert.ok(await page.locator("#tip").isVisible());
  assert.notEqual(await page.locator("#tip").textContent(), first);
  await page.keyboard.press("Enter");
  assert.match(await page.locator("#replay code").textContent(), /^ar3d generate /);
  await page.keyboard.press("Escape");
  assert.ok(await page.locator("#replay").isHidden());
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press("Tab");
  assert.notEqual(await page.evaluate(() => document.activeElement.tagName), "BODY");
});

test("it reads at 1280 and 390 pixels, light and dark", async () => {
  for (const width of [1280, 390]) {
    await page.setViewportSize({width, height: 900});
    const small = await page.evaluate(() => Math.min(...[...document.querySelectorAll("svg.plot")]
      .map(svg => svg.getBoundingClientRect().width).filter(w => w > 0)));
    assert.ok(small >= 300, `a plot of ${small} pixels at ${width}`);
    // Whatever is wider than the page scrolls by itself: nothing is cut.
    assert.deepEqual(await cutOff(page), [], `cut at ${width}`);
    // The front table is wider than a telephone, and the shade at its edge, which goes when it is scrolled, lies under nothing opaque.
    const front = await page.evaluate(() => {
      const box = document.querySelector(".scroll"), style = getComputedStyle(box);
      return {wider: box.scrollWidth > box.clientWidth, attached: style.backgroundAttachment, shades: style.backgroundImage.split("linear-gradient").length - 1,
        covers: [...box.querySelectorAll("*")].filter(e => getComputedStyle(e).backgroundColor !== "rgba(0, 0, 0, 0)").map(e => e.outerHTML.slice(0, 60))};
    });
    if (width === 390) assert.deepEqual(front, {wider: true, attached: "local, local, scroll, scroll", shades: 4, covers: []});
    await page.evaluate(() => scrollTo(0, 0));
    await shot(page, "page-" + width);
    for (const id of ["trade", "a0"]) {
      await page.evaluate(i => document.getElementById(i).scrollIntoView(), id);
      await shot(page, id + "-" + width);
    }
    await page.locator("section#a0 table.heat").scrollIntoViewIfNeeded();
    await shot(page, "heat-" + width);
  }
  await page.setViewportSize({width: 1280, height: 900});
  const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  // One name of a series in each of the colours that there are, beside those of the page.
  await page.evaluate(() => document.querySelector("g.ends").append(...Array.from({length: 8}, (_, i) => {
    const name = document.createElementNS("http://www.w3.org/2000/svg", "text");
    name.setAttribute("fill", `var(--t${i})`);
    name.textContent = "series";
    return name;
  })));
  const light = await background();
  assert.deepEqual(await paleTexts(page), []);
  await page.emulateMedia({colorScheme: "dark"});
  assert.notEqual(await background(), light);
  assert.deepEqual(await paleTexts(page), []);
  await shot(page, "dark-1280");
  await page.emulateMedia({colorScheme: "light"});
});

test("on paper nothing is cut", async () => {
  await page.emulateMedia({media: "print"});
  await page.setViewportSize({width: 718, height: 1000});  // A4 less margins of 1 cm
  for (const css of ["nav", ".save", "#tip", "#replay", "#shown"]) assert.ok(await page.locator(css).first().isHidden(), css);
  const cut = await page.evaluate(() => [...document.querySelectorAll("body *")].filter(e => {
    const box = e.getBoundingClientRect();
    return box.width > 0 && (box.right > innerWidth + 1 || (e.scrollWidth > e.clientWidth + 1 && getComputedStyle(e).overflowX !== "visible"));
  }).map(e => e.outerHTML.slice(0, 90)));
  assert.deepEqual(cut.slice(0, 8), []);
  await shot(page, "print-718");
  const pdf = await page.pdf({format: "A4", margin: {top: "1cm", bottom: "1cm", left: "1cm", right: "1cm"}});
  assert.equal(pdf.subarray(0, 5).toString(), "%PDF-");
  await page.emulateMedia({media: "screen"});
  await page.setViewportSize({width: 1280, height: 900});
});

test("the console stays silent", () => assert.deepEqual(complaints, []));
