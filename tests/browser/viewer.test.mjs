// The page of `ar3d draw --format html` and `ar3d view` in headless Chromium.
import assert from "node:assert/strict";
import {execFileSync, spawnSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync, statSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {after, before, test} from "node:test";
import {complaints, cutOff, launch, nameless, newPage as pageOf, paleTexts, program, requests, shot} from "./chromium.mjs";

const minus = text => text.replace(/-/g, "\u2212");

let folder, browser, page, k5;
const at = name => join(folder, name);
const ar3d = (args, input = "") => execFileSync(program, args, {input, maxBuffer: 1 << 30}).toString();

const newPage = options => pageOf(browser, options);
const settled = () => page.waitForFunction(() => globalThis.ar3d.view.ready && globalThis.ar3d.view.settled && !globalThis.ar3d.view.moving, null, {timeout: 60000});
const open = async name => {
  await page.goto("file://" + at(name));
  await settled();
};
/// What the 3D picture shows, as a hash of its pixels at rest.
const picture = async () => {
  await page.waitForFunction(() => !globalThis.ar3d.view.moving);
  await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
  return page.evaluate(() => {
    const url = document.getElementById("stage").toDataURL();
    let hash = 0;
    for (let i = 0; i < url.length; ++i) hash = (hash * 31 + url.charCodeAt(i)) | 0;
    return hash;
  });
};
const placeOnScreen = (...args) => page.evaluate(list => globalThis.ar3d.screenOf(...list), args);
const tipAt = async place => {
  await page.mouse.move(2, 450);
  await page.mouse.move(place.x, place.y, {steps: 2});
  await page.locator("#tip").waitFor({state: "visible"});
  return page.locator("#tip").textContent();
};

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "ar3d-viewer-"));
  writeFileSync(at("k5.g6"), "D~{\n");
  ar3d(["draw", at("k5.g6"), "--algorithm", "diamond", "-o", at("k5.html")]);
  k5 = JSON.parse(ar3d(["draw", at("k5.g6"), "--algorithm", "diamond"]));
  const broken = structuredClone(k5);
  broken.edges[0][2][1][2] += 2;
  const unknown = {...k5, algorithm: "</script><script>alert(1)</script>"};
  writeFileSync(at("several.jsonl"), [k5, broken, unknown, {n: 7, error: "a vertex of degree 6"}].map(line => JSON.stringify(line) + "\n").join(""));
  ar3d(["view", at("several.jsonl")]);
  writeFileSync(at("broken.jsonl"), JSON.stringify(broken) + "\n");
  browser = await launch();
  page = await newPage();
});

after(async () => {
  await browser?.close();
  if (folder) rmSync(folder, {recursive: true, force: true});
});

test("a small page opens from disk and asks for nothing else", async () => {
  await open("k5.html");
  assert.ok(statSync(at("k5.html")).size < 1e6);
  assert.equal(await page.locator("#verdict").textContent(), "certified");
  assert.match(await page.locator("#facts").textContent(), /^5 vertices, 10 edges, 30 bends, box /);
  assert.deepEqual(requests.filter(url => url !== "file://" + at("k5.html") && !url.startsWith("blob:")), []);
  await shot(page, "viewer-k5-light");
});

test("turning, moving and zooming change the picture", async () => {
  const seen = new Set([await picture()]);
  await page.mouse.move(500, 450);
  await page.mouse.down();
  await page.mouse.move(620, 480, {steps: 5});
  await page.mouse.up();
  seen.add(await picture());
  await page.mouse.wheel(0, -300);
  seen.add(await picture());
  for (const key of ["ArrowLeft", "ArrowUp", "Shift+ArrowRight", "+", "p", "1", "2", "3"]) {
    await page.keyboard.press(key);
    await page.waitForTimeout(700);
    seen.add(await picture());
  }
  assert.equal(seen.size, 11);
  await page.keyboard.press("p");
  await page.keyboard.press("0");
  await page.waitForTimeout(700);
});

test("hovering names vertex, bend and edge with exact coordinates and angles", async () => {
  const [x, y, z] = k5.vertices[3];
  const vertex = await tipAt(await placeOnScreen(3));
  assert.ok(vertex.startsWith(minus(`vertex 3 at (${x}, ${y}, ${z})\ndegree 4\n`)), vertex);
  assert.ok(vertex.endsWith("6 angles of 109.47\u00b0 (cos = \u22121/3)"), vertex);
  const all = [];
  for (let e = 0; e < 10; ++e) for (const i of [1, 2, 3]) all.push(await tipAt(await placeOnScreen(0, e, i)).catch(() => ""));
  const bends = all.filter(text => text.startsWith("bend "));
  assert.ok(bends.length > 15, `${bends.length} bends are seen`);
  for (const text of bends) {
    const [, b, u, v] = text.match(/^bend (\d) of 3 of edge (\d)\u2013(\d)/).map(Number);
    const [, , points] = k5.edges.find(edge => edge[0] === u && edge[1] === v);
    assert.ok(text.includes(minus(`at (${points[b - 1].join(", ")})`)), text);
    assert.ok(text.includes("109.47\u00b0 (cos = \u22121/3)"), text);
  }
});

test("a click selects, shows angles, and an edge is followed", async () => {
  const place = await placeOnScreen(1);
  await page.mouse.click(place.x, place.y);
  assert.match(await page.locator("#selected").textContent(), /^vertex 1 at /);
  await shot(page, "viewer-k5-angles");
  await page.keyboard.press("e");
  assert.match(await page.locator("#selected").textContent(), /^edge \d\u20131|^edge 1\u2013\d/);
  const before = await page.evaluate(() => globalThis.ar3d.camera());
  await page.keyboard.press("f");
  await page.waitForTimeout(1500);
  assert.notDeepEqual(await page.evaluate(() => globalThis.ar3d.camera()), before);
  await page.keyboard.press("Escape");
  assert.ok(await page.locator("#selection").isHidden());
  await page.waitForTimeout(1000);
});

test("a vertex is chosen by keyboard, and every control has a name", async () => {
  await open("k5.html");
  assert.deepEqual(await nameless(page), []);
  for (let i = 0; i < 3 && await page.evaluate(() => document.activeElement.id) !== "stage"; ++i) await page.keyboard.press("Tab");
  for (const [key, vertex] of [[".", 0], [".", 1], [",", 0], [",", 4]]) {
    await page.keyboard.press(key);
    assert.match(await page.getByRole("status").first().textContent(), new RegExp(minus(`^vertex ${vertex} at \\(${k5.vertices[vertex].join(", ")}\\)`)));
  }
  await page.keyboard.press("Escape");
  assert.ok(await page.locator("#selection").isHidden());
});

test("a colour that the legend names is that colour, light and dark", async () => {
  const kHues = {red: [-15, 15], orange: [15, 45], yellow: [45, 70], green: [80, 170], blue: [190, 250], purple: [260, 330]};
  const seen = new Set();
  await open("k5.html");
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({colorScheme});
    for (const [text, colour] of await page.locator("#legend li").evaluateAll(items => items.map(item => [item.textContent, item.querySelector("i").style.background]))) {
      const [r, g, b] = colour.match(/\d+/g).map(Number), hue = Math.atan2(Math.sqrt(3) * (g - b), 2 * r - g - b) * 180 / Math.PI, [word] = text.split(":");
      seen.add(word);
      const [low, high] = kHues[word];
      assert.ok((hue - low + 720) % 360 < high - low, `${text} is ${colour}`);
    }
  }
  assert.deepEqual([...seen], ["green", "orange"]);
  await page.emulateMedia({colorScheme: "light"});
});

test("the slider grows the drawing in the construction's order", async () => {
  await open("k5.html");
  const whole = await picture();
  await page.locator("#grow").fill("2");
  assert.equal(await page.locator("#grown").textContent(), "2 of 5 vertices, in order of the green order, X = (x + y) / 2");
  const part = await picture();
  assert.notEqual(part, whole);
  const order = k5.vertices.map(([x, y], v) => [x + y, v]).sort((a, b) => a[0] - b[0]).map(pair => pair[1]);
  assert.match(await tipAt(await placeOnScreen(order[0])), new RegExp("^vertex " + order[0]));
  const hidden = await placeOnScreen(order[4]);
  await page.mouse.move(hidden.x, hidden.y);
  await page.waitForTimeout(300);
  assert.doesNotMatch((await page.locator("#tip").isVisible()) ? await page.locator("#tip").textContent() : "", /^vertex/);
  await page.locator("#play").click();
  await page.waitForFunction(() => globalThis.ar3d.view.grown === 5, null, {timeout: 20000});
  assert.equal(await picture(), whole);
});

test("boxes, numbers, colours and thickness change the picture", async () => {
  for (const act of [() => page.keyboard.press("b"), () => page.locator("#colours").selectOption("direction"), () => page.locator("#thickness").fill("6")]) {
    const before = await picture();
    await act();
    assert.notEqual(await picture(), before);
  }
  assert.equal(await page.locator("#legend li").count(), 4, "four directions of the diamond lattice");
  await page.keyboard.press("t");
  assert.match(await page.locator("#bound-text").textContent(), /16\/3 n, 16\/3 n, 8 n/);
  await page.locator("#names").check();
  await shot(page, "viewer-k5-boxes");
});

test("violations are listed as verify lists them, and a click flies there", async () => {
  await open("several.html");
  await page.keyboard.press("PageDown");
  await page.waitForFunction(() => document.getElementById("verdict").className === "violated");
  await settled();
  const verified = spawnSync(program, ["verify", at("broken.jsonl")]).stdout.toString().trim().split("\n").slice(0, -1);
  const listed = await page.locator("#violation-list button").allTextContents();
  assert.ok(listed.length > 0);
  assert.deepEqual(listed.map(text => text.replace(/^[^:]*: /, "")), verified.map(line => line.replace(/^.*?:1: [^:]*: /, "")));
  const before = await page.evaluate(() => globalThis.ar3d.camera());
  await page.locator("#violation-list button").first().click();
  await page.waitForTimeout(900);
  assert.notDeepEqual(await page.evaluate(() => globalThis.ar3d.camera()), before);
  await shot(page, "viewer-violation");
  await page.keyboard.press("v");
  assert.equal(await page.locator("#violation-list button[aria-current=true]").count(), 1);
});

test("drawings of one file are pages; hostile names are only text; what was not drawn says why", async () => {
  await page.keyboard.press("PageDown");
  await page.waitForFunction(() => document.getElementById("verdict").className === "unknown");
  assert.ok((await page.locator("#title").textContent()).startsWith("</script>"));
  assert.equal(await page.locator("#verdict").textContent(), "not judged");
  await page.locator("#which").selectOption("3");
  await page.waitForFunction(() => !document.getElementById("problem").hidden);
  assert.match(await page.locator("#problem").textContent(), /7 vertices was not drawn: a vertex of degree 6/);
  await page.locator("#next").click();
  await page.waitForFunction(() => document.getElementById("verdict").className === "certified");
  assert.ok(await page.locator("#problem").isHidden());
});

test("a picture is saved", async () => {
  const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("s")]);
  assert.equal(download.suggestedFilename(), "diamond-1.png");
  assert.equal(readFileSync(await download.path()).subarray(1, 4).toString(), "PNG");
});

test("it reads at 1280 and 390 pixels, light and dark", async () => {
  await open("k5.html");
  const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await background(), picturedLight = await picture();
  await page.emulateMedia({colorScheme: "dark"});
  await page.waitForFunction(() => document.documentElement.classList.contains("dark"));
  assert.notEqual(await background(), light);
  assert.deepEqual(await paleTexts(page), []);
  assert.notEqual(await picture(), picturedLight);
  await shot(page, "viewer-k5-dark");
  await page.keyboard.press("d");
  assert.equal(await background(), light);
  assert.deepEqual(await paleTexts(page), []);
  await page.emulateMedia({colorScheme: "light"});
  await page.setViewportSize({width: 390, height: 800});
  await open("several.html");
  assert.ok(await page.locator("#panel").isHidden(), "the controls are folded away");
  for (const open of [false, true]) {
    if (open) await page.locator("#unfold").click();
    assert.deepEqual(await cutOff(page, "header *, #panel *, #pages *"), []);
    await shot(page, open ? "viewer-390-controls" : "viewer-390");
  }
  await page.setViewportSize({width: 1280, height: 900});
});

test("it prints the picture without the controls", async () => {
  await open("k5.html");
  await page.emulateMedia({media: "print"});
  for (const id of ["panel", "pages", "unfold"]) assert.ok(await page.locator("#" + id).isHidden(), id);
  assert.ok(await page.locator("#verdict").isVisible());
  const pdf = await page.pdf({format: "A4", landscape: true, printBackground: true});
  await page.emulateMedia({media: "screen"});
  const hidden = await page.addStyleTag({content: "#stage { visibility: hidden; }"});
  await page.emulateMedia({media: "print"});
  const without = await page.pdf({format: "A4", landscape: true, printBackground: true});
  assert.ok(pdf.length > without.length + 20000, `the picture takes ${pdf.length - without.length} bytes of the PDF`);
  await page.emulateMedia({media: "screen"});
  await hidden.evaluate(style => style.remove());
});

test("without WebGL the page says so", async () => {
  for (const none of [() => null, () => { throw new Error("no"); }]) {
    const poor = await newPage();
    await poor.addInitScript(`HTMLCanvasElement.prototype.getContext = ${none}`);
    await poor.goto("file://" + at("k5.html"));
    assert.match(await poor.locator("#problem").textContent(), /WebGL 2, which this browser does not offer/);
    await poor.close();
  }
});

test("the page makes one WebGL context", async () => {
  const counted = await newPage();
  await counted.addInitScript(() => {
    const make = HTMLCanvasElement.prototype.getContext;
    globalThis.contexts = 0;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
      if (kind.startsWith("webgl")) ++globalThis.contexts;
      return make.call(this, kind, ...rest);
    };
  });
  await counted.goto("file://" + at("k5.html"));
  await counted.waitForFunction(() => globalThis.ar3d.view.settled);
  assert.equal(await counted.evaluate(() => globalThis.contexts), 1);
  await counted.close();
});

test("a drawing of 10^4 vertices is shown as lines, and as tubes from near", async () => {
  const graph = ar3d(["generate", "random-4-regular", "-n", "10000", "--seed", "1"]);
  ar3d(["draw", "-", "--algorithm", "compact", "-o", at("large.html")], graph);
  await open("large.html");
  assert.notEqual(await page.evaluate(() => globalThis.ar3d.view.level), "tubes");
  assert.match(await page.locator("#detail").textContent(), /sample of [\d,]+ of 120,000 segments/);
  await shot(page, "viewer-10000");
  // A frame of the turning drawing: few draw calls, no tubes, fewer lines than the picture at rest.
  const cost = await page.evaluate(() => new Promise(done => {
    let frames = 0;
    const step = () => {
      globalThis.ar3d.turn(0.02, 0);
      if (++frames < 12) requestAnimationFrame(step);
      else done(globalThis.ar3d.cost());
    };
    requestAnimationFrame(step);
  }));
  assert.ok(cost.calls <= 3 && cost.triangles === 0 && cost.lines <= 60000 && cost.lines >= 2000, JSON.stringify(cost));
  await settled();
  const far = await picture();
  await page.keyboard.press(".");
  for (let i = 0; i < 24; ++i) await page.keyboard.press("+");
  await page.waitForTimeout(600);
  assert.notEqual(await picture(), far);
  await shot(page, "viewer-10000-near");
});

test("no other script runs, and nothing is fetched", async () => {
  const text = readFileSync(at("k5.html"), "utf8");
  const [, policy] = text.match(/<meta http-equiv="Content-Security-Policy" content="([^"]*)">/);
  assert.match(policy, /^default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-[^']{44}' 'sha256-[^']{44}'; img-src data: blob:$/);
  const planted = `<script>globalThis.ran = 1</script><script src="https://ar3d.invalid/x.js"></script><img src="https://ar3d.invalid/x.png" ` +
    `onerror="globalThis.ran = 2"><img src="data:," onerror="globalThis.ran = 3"><iframe src="https://ar3d.invalid/"></iframe>`;
  writeFileSync(at("planted.html"), text.replace("<header>", planted + "<header>"));
  assert.equal(text.split("<header>").length, 2);
  const told = complaints.length, asked = [];
  await page.context().route("https://ar3d.invalid/**", route => { asked.push(route.request().url()); return route.abort(); });
  await open("planted.html");
  assert.equal(await page.locator("#verdict").textContent(), "certified");
  assert.equal(await page.evaluate(() => globalThis.ran), undefined);
  await page.evaluate(() => globalThis.fetch("https://ar3d.invalid/y").catch(() => 0));
  assert.deepEqual(asked, []);
  const refused = complaints.splice(told);
  assert.ok(refused.length >= 6 && refused.every(line => line.includes("Content Security Policy")), refused.join("\n"));
});

test("the console stays silent", () => assert.deepEqual(complaints, []));
