// The page of `ar3d play` (build/playground/play.html) in headless Chromium: paste, drop, link, mistakes, saving, cancel, size.
import assert from "node:assert/strict";
import {execFileSync, spawnSync} from "node:child_process";
import {readFileSync} from "node:fs";
import {dirname} from "node:path";
import {after, before, test} from "node:test";
import {fileURLToPath} from "node:url";
import {gzipSync} from "node:zlib";
import {complaints, cutOff, launch, nameless, newPage, paleTexts, program, requests, shot} from "./chromium.mjs";

const file = fileURLToPath(new URL("../../build/playground/play.html", import.meta.url)), address = "file://" + file;
const native = (args, input = "") => spawnSync(program, args, {input, encoding: "utf8", maxBuffer: 1 << 30});
let browser, page;

/// Waits until the drawing of the last change is shown, or its mistake told.
const done = () => page.waitForFunction(() => !document.getElementById("draw").disabled && globalThis.ar3d.view.ready &&
  (globalThis.ar3d.view.settled || !document.getElementById("error").hidden), null, {timeout: 120000});
const open = async (hash = "") => {
  await page.goto("about:blank");
  await page.goto(address + hash);
  await done();
};
const act = async doing => {
  await page.evaluate(() => { globalThis.ar3d.view.settled = 0; });
  await doing();
  await page.waitForTimeout(700);  // a field waits for the end of typing
  await done();
};
const text = id => page.locator("#" + id).textContent();
const hash = async () => (await text("measures")).match(/hash([0-9a-f]{32})/)[1];
const nativeHash = (input, ...words) => JSON.parse(native(["draw", "-", "--level", "extents", ...words], input).stdout).drawing_hash;
const paste = words => page.evaluate(words => {
  const data = new DataTransfer();
  data.setData("text/plain", words);
  document.body.dispatchEvent(new ClipboardEvent("paste", {clipboardData: data, bubbles: true, cancelable: true}));
}, words);
const drop = (name, base64) => page.evaluate(([name, base64]) => {
  const data = new DataTransfer();
  data.items.add(new File([Uint8Array.from(atob(base64), c => c.charCodeAt(0))], name));
  document.body.dispatchEvent(new DragEvent("drop", {dataTransfer: data, bubbles: true, cancelable: true}));
}, [name, Buffer.from(base64).toString("base64")]);

before(async () => {
  browser = await launch();
  page = await newPage(browser, {colorScheme: "light"});
});
after(() => browser?.close());

test("one file of at most 1.6 MB packed shows a proved drawing when it is opened", async () => {
  const packed = gzipSync(readFileSync(file), {level: 9}).length, begin = performance.now();
  assert.ok(packed < 1.6e6);
  await open();
  process.stdout.write(`# ${packed} bytes packed; first drawing after ${Math.round(performance.now() - begin)} ms\n`);
  assert.equal(await text("proof-word"), "proved");
  assert.match(await text("proof-text"), /^every angle is exactly 120\u00b0, no edge has more than 3 bends, no two edges meet: judged in exact integers/);
  await shot(page, "play-1280");
});

test("what is pasted is drawn as the program draws it; its command and its link draw it again", async () => {
  await act(() => page.locator("#text").fill("0 1\n1 2\n2 0\n"));
  assert.equal(await hash(), nativeHash("0 1\n1 2\n2 0\n", "--algorithm", "grid"));
  await act(() => paste("D~{\n"));
  await act(() => page.locator("#algorithm").selectOption("compact"));
  await act(() => page.locator("#effort").selectOption("2"));
  const drawn = await hash(), link = await page.evaluate(() => location.hash);
  assert.equal(drawn, nativeHash("D~{\n", "--algorithm", "compact", "--set", "effort=2"));
  const command = (await text("command")).replace("-o drawing.html", "--level extents");
  const env = {...process.env, PATH: `${dirname(program)}:${process.env.PATH}`};
  assert.equal(JSON.parse(execFileSync("bash", ["-c", command], {env}).toString()).drawing_hash, drawn);
  await open(link);
  assert.equal(await hash(), drawn);
  await open("#g6=D~{&a=compact&effort=2");
  assert.equal(await hash(), drawn);
});

test("files are dropped: packed, of several graphs, GraphML", async () => {
  await open();
  const cubic = native(["generate", "random-cubic", "-n", "300", "--count", "3"]).stdout;
  await act(() => drop("cubic.s6.gz", gzipSync(cubic)));
  assert.match(await text("read-what"), /^cubic.s6.gz: sparse6, 3 graphs/);
  await act(() => page.locator("#place").fill("3").then(() => page.keyboard.press("Tab")));
  assert.equal(await hash(), nativeHash(cubic.split("\n")[2] + "\n", "--algorithm", "grid"));
  const xml = native(["draw", "-", "--algorithm", "diamond", "--format", "graphml"], "D~{\n").stdout;
  await act(() => drop("k5.graphml", Buffer.from(xml)));
  assert.equal(await hash(), nativeHash("D~{\n", "--algorithm", "diamond"));
});

test("families and named graphs, numbers of them, sizes they do not have", async () => {
  await open();
  await act(() => page.locator("#family").selectOption("dodecahedron"));
  assert.match(await text("command"), /^ar3d generate dodecahedron \|\s+ar3d draw - --algorithm grid/);
  await act(() => page.locator("#family").selectOption("random-cubic"));
  await act(() => page.locator("#n").fill("51").then(() => page.keyboard.press("Tab")));
  assert.equal(await text("read-what"), "random-cubic has no graph with 51 vertices for these parameters: this has 50");
  assert.equal(await page.evaluate(() => globalThis.ar3d.view.drawing.n), 50);
});

test("mistakes are told in the program's own line, and the last drawing stays", async () => {
  await act(() => page.locator("#algorithm").selectOption("diamond"));
  for (const words of ["0 1\n1 x\n", "0 0\n", "0 1\n0 2\n0 3\n0 4\n0 5\n", "hello world\nb\n", "D~\n"]) {
    await act(() => page.locator("#text").fill(words));
    assert.equal(await text("error") + "\n", native(["draw", "-", "--algorithm", "diamond"], words).stderr, words);
  }
  assert.equal(await page.evaluate(() => globalThis.ar3d.view.drawing.n), 50);
  await act(() => drop("bad.graphml", Buffer.from("<graphml><graph edgedefault='directed'/></graphml>")));
  assert.equal(await text("error"), "ar3d: bad.graphml: edgedefault is 'directed': only undirected graphs are read");
  await shot(page, "play-1280-error");
});

test("every format is saved as the program writes it", async () => {
  await open("#g6=D~{&a=diamond&effort=1");
  for (const format of ["jsonl", "svg", "tikz", "glb", "stl", "png"]) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.locator("#saves button", {hasText: format}).click()]);
    const bytes = readFileSync(await download.path());
    if (format === "png") assert.equal(bytes.subarray(1, 4).toString(), "PNG");
    else assert.ok(bytes.equals(execFileSync(program, ["draw", "-", "--algorithm", "diamond", "--format", format], {input: "D~{\n"})), format);
  }
});

test("by keyboard alone: a graph is typed, its algorithm chosen, the drawing turned", async () => {
  await open();
  await page.locator("#text").focus();
  await act(() => page.keyboard.type("0 1\n1 2\n2 3\n3 0\n0 2\n"));
  assert.equal(await page.evaluate(() => globalThis.ar3d.view.drawing.n), 4, "keys of the viewer are letters in the field");
  for (let i = 0; i < 12 && await page.evaluate(() => document.activeElement.id) !== "algorithm"; ++i) await page.keyboard.press("Tab");
  await act(() => page.keyboard.press("ArrowDown"));
  assert.match(await text("title"), /^diamond/);
  await page.locator("#stage").focus();
  const before = await page.evaluate(() => globalThis.ar3d.camera());
  await page.keyboard.press("ArrowLeft");
  assert.notDeepEqual(await page.evaluate(() => globalThis.ar3d.camera()), before);
});

test("10^5 vertices by diamond are drawn, proved and shown while the page answers; a long work is cancelled", async () => {
  await page.evaluate(() => {
    globalThis.longest = 0;
    let last = performance.now();
    setInterval(() => {
      globalThis.longest = Math.max(globalThis.longest, performance.now() - last);
      last = performance.now();
    }, 10);
  });
  const begin = performance.now();
  await page.evaluate(() => { globalThis.ar3d.view.settled = 0; location.hash = "#family=random-4-regular&n=100000&seed=1&a=diamond&effort=1"; });
  await page.waitForFunction(() => globalThis.ar3d.view.drawing.n === 100000 && globalThis.ar3d.view.settled, null, {timeout: 120000});
  const longest = await page.evaluate(() => Math.round(globalThis.longest));
  process.stdout.write(`# 10^5 vertices shown after ${Math.round(performance.now() - begin)} ms; longest wait for the page ${longest} ms; ${await text("measures")}\n`);
  assert.equal(await text("proof-word"), "proved");
  await shot(page, "play-1280-large");
  for (const long of ["n=100000&seed=1&a=compact", "n=300&seed=1&a=routed"]) {
    await page.evaluate(words => { location.hash = `#family=random-4-regular&${words}&effort=2`; }, long);
    await page.locator("#cancel").click();
    await page.locator("#error", {hasText: "cancelled"}).waitFor();
  }
  await act(() => page.evaluate(() => { location.hash = "#g6=D~{&a=routed"; }));
  assert.equal(await page.evaluate(() => globalThis.ar3d.view.drawing.n), 5);
  assert.equal(await text("proof-word"), "proved");
  await shot(page, "play-1280-routed");
});

test("it reads at 1280 and 390 pixels, light and dark", async () => {
  for (const width of [1280, 390]) {
    for (const colorScheme of ["light", "dark"]) {
      await page.setViewportSize({width, height: width === 390 ? 800 : 900});
      await page.emulateMedia({colorScheme});
      await open();
      assert.equal(await page.evaluate(() => document.documentElement.classList.contains("dark")), colorScheme === "dark");
      assert.deepEqual([await cutOff(page, "header *, #source *, #fold", "pre"), await nameless(page), await paleTexts(page)], [[], [], []]);
      await shot(page, `play-${width}-${colorScheme}`);
    }
  }
  await page.locator("#fold").click();
  assert.ok(await page.locator("#source").isHidden());
});

test("nothing was asked for but the file, and nothing complained", () => {
  assert.deepEqual(requests.filter(url => !url.startsWith(address) && !url.startsWith("blob:") && url !== "about:blank"), []);
  assert.deepEqual(complaints, []);
});
