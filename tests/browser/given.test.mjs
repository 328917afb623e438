// What the page of `ar3d play` does without its program: links, commands, GraphML, its policy. The program in it: play.test.mjs.
import assert from "node:assert/strict";
import {execFileSync, spawnSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {tmpdir} from "node:os";
import {after, before, test} from "node:test";
import {fileURLToPath} from "node:url";
import {complaints, launch, nameless, newPage, program, requests} from "./chromium.mjs";

const root = fileURLToPath(new URL("../../", import.meta.url));
const module = "data:text/javascript," + encodeURIComponent(readFileSync(join(root, "apps/play/given.js"), "utf8"));
const {commandOf, linked, linkOf} = await import(module);
let folder, browser, page;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "ar3d-given-"));
  browser = await launch();
  page = await newPage(browser);
});
after(async () => {
  await browser?.close();
  rmSync(folder, {recursive: true, force: true});
});
const hashOf = (command, input = "") => JSON.parse(execFileSync("bash", ["-c", command.replace("-o drawing.html", "--level extents")],
  {cwd: folder, input, env: {...process.env, PATH: `${dirname(program)}:${process.env.PATH}`}}).toString()).drawing_hash;

test("a link says the same when it is read, and the design's own is read", () => {
  for (const [given, line] of [[{family: "random-cubic", n: 100, seed: 7}, ""], [{family: "petersen"}, "IheA@GUAo"], [{text: "D~{\n", name: "<stdin>"}, "D~{"]]) {
    const said = {given, algorithm: "grid", effort: 0};
    assert.deepEqual(linked(linkOf(said, line)), said);
  }
  assert.deepEqual(linked("#g6=D~{&a=compact&effort=2"), {given: {text: "D~{\n", name: "<stdin>"}, algorithm: "compact", effort: 2});
  assert.equal(linked("#"), null);
  assert.equal(linkOf({given: {text: "", name: "x.s6"}, algorithm: "grid", effort: 1}, ""), "");
});

test("the commands draw what they say", () => {
  writeFileSync(join(folder, "it's k5.g6"), "D~{\n");
  const k5 = hashOf("ar3d draw - --algorithm compact --set effort=2 -o drawing.html", "D~{\n");
  const drawn = {algorithm: "compact", options: "effort=2"};
  assert.equal(hashOf(commandOf({...drawn, given: {text: "", name: "<stdin>"}}, "D~{")), k5);
  assert.equal(hashOf(commandOf({...drawn, given: {text: "", name: "it's k5.g6"}}, "")), k5);
  const cubic = {given: {family: "random-cubic", n: 40, seed: 3}, algorithm: "grid", options: ""};
  assert.equal(hashOf(commandOf(cubic, "")), hashOf("ar3d generate random-cubic -n 40 --seed 3 | ar3d draw - --algorithm grid -o drawing.html"));
  assert.ok(hashOf(commandOf({given: {family: "petersen"}, algorithm: "grid", options: ""}, "")));
});

test("GraphML becomes DOT that is the same graph with the same names; what is no undirected graph is refused", async () => {
  const xml = `<?xml version="1.0"?><graphml xmlns="http://graphml.graphdrawing.org/xmlns"><key id="k" for="node" attr.name="label"/>
    <graph edgedefault="undirected"><node id="b"><data key="k">a "quoted" name</data></node><node id="a"/><node id="c"/>
    <edge source="c" target="b"/><edge source="b" target="a"/></graph></graphml>`;
  const dotOf = text => page.evaluate(async ([code, words]) => (await import(code)).dotOfGraphml(words, "g.graphml"), [module, text]);
  const drawn = text => execFileSync(program, ["draw", "-", "--algorithm", "grid"], {input: text}).toString();
  assert.equal(drawn(await dotOf(xml)), drawn(xml));
  for (const [text, why] of [[xml.replace("undirected", "directed"), "g.graphml: edgedefault is 'directed': only undirected graphs are read"],
    [xml.replace('target="a"', 'target="x"'), "'x' is no node of this graph"], ["<graphml>", "no well-formed XML"], ["<a/>", "no <graph> element inside"]]) {
    await assert.rejects(dotOf(text), error => error.message.includes(why));
  }
});

test("the page runs nothing but its own scripts, asks for nothing, and says so where the program cannot start", async () => {
  const core = join(folder, "core.js"), wasm = join(folder, "core.wasm"), made = join(folder, "play.html");
  writeFileSync(core, "const ar3dCore = null;\n");
  writeFileSync(wasm, "no program");
  execFileSync("node", [join(root, "apps/play/page.mjs"), core, wasm, made]);
  const policy = readFileSync(made, "utf8").match(/Content-Security-Policy" content="([^"]*)"/)[1];
  assert.match(policy, /^default-src 'none'; script-src 'sha256-[^']+' 'sha256-[^']+' 'wasm-unsafe-eval'; worker-src blob:; style-src 'sha256-[^']+'; img-src data: blob:;/);
  await page.goto("file://" + made);
  await page.locator("#problem").waitFor();
  assert.deepEqual(await nameless(page), []);
  assert.match(await page.locator("#problem").textContent(), /^The program cannot be started in this browser: /);
  assert.equal(await page.evaluate(() => {
    document.body.append(Object.assign(document.createElement("script"), {textContent: "globalThis.planted = true"}));
    return globalThis.planted;
  }), undefined);
  assert.deepEqual(requests.filter(url => !url.startsWith("file://" + made) && !url.startsWith("data:")), []);
  assert.equal(complaints.filter(text => !/planted|inline script/.test(text)).length, 0, complaints.join("\n"));
});

test("`ar3d play` names the page, writes it, replaces only its own kind", () => {
  const bin = join(folder, "root", "bin"), text = '<!doctype html>\n<meta name="generator" content="ar3d play">\n';
  execFileSync("bash", ["-c", `mkdir -p "${bin}" "${bin}/../share/ar3d" && cp "${program}" "${bin}/ar3d"`]);
  const env = {...process.env, DISPLAY: "", WAYLAND_DISPLAY: ""};
  delete env.DISPLAY;
  delete env.WAYLAND_DISPLAY;
  const play = (...words) => spawnSync(join(bin, "ar3d"), ["play", ...words], {env, cwd: folder, encoding: "utf8"});
  assert.match(play().stderr, /^ar3d: there is no play.html: .* makes it\n$/);
  const installed = join(folder, "root/share/ar3d/play.html");
  writeFileSync(installed, text);
  assert.equal(play().stdout, `file://${installed}\n`);
  for (let i = 0; i < 2; ++i) assert.equal(play("-o", "mine.html").stdout, "wrote mine.html\n");
  assert.equal(readFileSync(join(folder, "mine.html"), "utf8"), text);
  writeFileSync(join(folder, "other.html"), "<p>mine</p>");
  assert.equal(play("-o", "other.html").status, 2);
  assert.equal(readFileSync(join(folder, "other.html"), "utf8"), "<p>mine</p>");
});
