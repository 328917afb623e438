// The program as WebAssembly (build/playground, tools/playground) beside the native one: drawing hashes, verdicts, messages.
import assert from "node:assert/strict";
import {execFileSync, spawnSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {createRequire} from "node:module";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {after, before, test} from "node:test";
import {fileURLToPath} from "node:url";

const program = process.env.AR3D_PROGRAM, alone = {...process.env, OMP_NUM_THREADS: "1"};
const folder = mkdtempSync(join(tmpdir(), "ar3d-core-"));
const native = (args, input = "") => spawnSync(program, args, {input, maxBuffer: 1 << 30, env: alone, encoding: "utf8"});
const build = fileURLToPath(new URL("../../build/playground/", import.meta.url));
let core, catalogue;

/// The answer to a request, as apps/play/worker.js gives it.
const ask = (request, text = "") => {
  const bytes = new TextEncoder().encode(JSON.stringify(request) + "\n" + text), place = core._malloc(bytes.length);
  core.HEAPU8.set(bytes, place);
  const answer = core.UTF8ToString(core._ar3d_answer(place, bytes.length));
  core._free(place);
  return JSON.parse(answer);
};
const draw = (text, algorithm, options) => ask({do: "draw", name: "<stdin>", title: "", algorithm, options}, text);

before(async () => {
  core = await createRequire(import.meta.url)(join(build, "ar3d_play.js"))({wasmBinary: readFileSync(join(build, "ar3d_play.wasm"))});
  catalogue = ask({do: "catalogue"});
});
after(() => rmSync(folder, {recursive: true, force: true}));

/// Graphs as lines of graph6: all of up to 7 vertices and degree 4, the named ones, every family at several sizes.
function sample() {
  let lines = "";
  for (let n = 1; n <= 7; ++n) lines += execFileSync("nauty-geng", ["-q", "-D4", String(n)], {encoding: "utf8"});
  const made = [...catalogue.named.map(({name}) => [name])];
  for (const {name, random} of catalogue.families) {
    for (const n of [4, 9, 16, 25, 40, 64, 90]) for (let seed = 1; seed <= (random ? 3 : 1); ++seed) made.push([name, "-n", String(n), "--seed", String(seed)]);
  }
  for (let seed = 1; lines.split("\n").length + made.length <= 2000; ++seed) made.push(["random-4-regular", "-n", "30", "--seed", String(seed)]);
  for (const words of made) lines += native(["generate", ...words, "--format", "graph6"]).stdout;
  return lines;
}

test("2,000 graphs by every algorithm at every effort, one in 40 by routed: the same hashes, verdicts and messages", () => {
  const all = sample().trimEnd().split("\n"), some = all.filter((_, i) => i % 40 === 0);  // of those that search
  writeFileSync(join(folder, "all.g6"), all.join("\n") + "\n");
  writeFileSync(join(folder, "some.g6"), some.join("\n") + "\n");
  assert.ok(all.length >= 2000, `${all.length} graphs`);
  let equal = 0, refused = 0;
  for (const {name, efforts} of catalogue.algorithms) {
    const searches = name.startsWith("routed"), graphs = searches ? some : all;
    for (let effort = 0; effort <= efforts; ++effort) {
      const options = efforts ? `effort=${effort}` : "", words = efforts ? ["--set", options] : [];
      const expected = native(["draw", join(folder, searches ? "some.g6" : "all.g6"), "--algorithm", name, ...words, "--level", "extents"]).stdout.trimEnd().split("\n");
      assert.equal(expected.length, graphs.length);
      graphs.forEach((line, i) => {
        const wanted = JSON.parse(expected[i]), got = draw(line + "\n", name, options);
        const told = `${name} ${options} on ${line}`;
        if (wanted.error !== undefined) {
          assert.equal(got.error, "<stdin>:1: " + wanted.error, told);
          ++refused;
          return;
        }
        assert.equal(got.hash, wanted.drawing_hash, `${told}: ${got.error}`);
        assert.equal(got.about.verdict.kind, {proved: "certified", measured: "not judged"}[wanted.verdict], told);
        ++equal;
      });
    }
  }
  process.stdout.write(`# ${all.length} graphs: ${equal} drawings equal, ${refused} refused in the same words\n`);
});

test("families, formats and mistakes are the program's", () => {
  for (const [family, n, seed] of [["petersen", 10, 1], ["random-cubic", 1000, 7], ["random-4-regular", 20000, 3]]) {
    const {line, hash, about} = ask({do: "draw", family, n, seed, algorithm: "", options: "", title: ""});
    const graph = native(["generate", family, "-n", String(n), "--seed", String(seed)]).stdout;
    const wanted = JSON.parse(native(["draw", "-", "--algorithm", about.algorithm, "--level", "extents"], graph).stdout);
    assert.equal(hash, wanted.drawing_hash);
    assert.ok(n > 100 || line);
  }
  const texts = ["0 1\n1 2\n2 0\n", "a b\nb c\n", "graph { a -- b; b -- c }\n", "0 1\n1 x\n", "0 0\n", "D~\n", "?", "", "hello world\nb\n", "0 1\n0 2\n0 3\n0 4\n0 5\n"];
  for (const text of texts) {
    const wanted = native(["draw", "-", "--algorithm", "diamond", "--level", "extents"], text), got = draw(text, "diamond", "");
    if (wanted.status === 0) assert.equal(got.hash, JSON.parse(wanted.stdout).drawing_hash, text);
    else assert.equal("ar3d: " + got.error + "\n", wanted.stderr, text);
  }
});
