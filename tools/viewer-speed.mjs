// How fast pages of `ar3d draw --format html` open and turn in headless Chromium, drawn in software.
//   tests/browser/run --install && node tools/viewer-speed.mjs PROGRAM [N | PAGE.html]…     (N: 100000 if left out)
// One line a drawing: bytes of the page; milliseconds from the request to the first picture (ready) and to the whole one (settled), the
// median of three; frames a second and processor time a frame of all of Chromium while it turns for five seconds, beside those of
// an empty canvas of the same size measured in turns with it; what one such frame holds (draw calls, lines, points, triangles, pixels).
import {execFileSync} from "node:child_process";
import {mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync} from "node:fs";
import {loadavg, tmpdir} from "node:os";
import {join, resolve} from "node:path";
import {chromium} from "./browser.mjs";

const [named, ...counts] = process.argv.slice(2), program = resolve(named), folder = mkdtempSync(join(tmpdir(), "ar3d-speed-"));
const server = await chromium.launchServer({executablePath: "/usr/bin/chromium",
  args: ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run"]});
const browser = await chromium.connect(server.wsEndpoint());
const median = list => [...list].sort((a, b) => a - b)[list.length >> 1];

/// Processor milliseconds of the browser and all that it started, so far.
function processorTime() {
  const parent = new Map(), ticks = new Map();
  for (const pid of readdirSync("/proc").filter(name => /^\d+$/.test(name)).map(Number)) {
    try {
      const fields = readFileSync(`/proc/${pid}/stat`, "utf8").replace(/^.*\) /, "").split(" ");
      parent.set(pid, Number(fields[1]));
      ticks.set(pid, Number(fields[11]) + Number(fields[12]));
    } catch { continue; }  // it has ended
  }
  const mine = pid => pid === server.process().pid || (parent.has(pid) && mine(parent.get(pid)));
  return 10 * [...ticks].filter(([pid]) => mine(pid)).reduce((sum, [, count]) => sum + count, 0);
}

/// Frames a second, and processor milliseconds a frame, while the page runs globalThis.step() before each frame.
async function turning(page, seconds) {
  const before = processorTime();
  const frames = await page.evaluate(milliseconds => new Promise(done => {
    let count = 0, begin = 0;
    const frame = now => {
      begin = begin || now;
      if (now - begin >= milliseconds) return done(1000 * count / (now - begin));
      ++count;
      globalThis.step();
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }), 1000 * seconds);
  return [frames, (processorTime() - before) / (frames * seconds)];
}

writeFileSync(join(folder, "empty.html"), `<!doctype html><style>html,body{margin:0;height:100%}canvas{position:fixed;inset:0;width:100%;height:100%}</style>
<canvas width=1280 height=900></canvas><script>
const gl = document.querySelector("canvas").getContext("webgl2", {alpha: false, antialias: false, preserveDrawingBuffer: true});
let shade = 0;
globalThis.step = () => { shade = (shade + 0.01) % 1; gl.clearColor(shade, 1, 1, 1); gl.clear(gl.COLOR_BUFFER_BIT); };
</script>`);

async function opened(file) {
  const page = await browser.newPage({viewport: {width: 1280, height: 900}});
  await page.goto("file://" + file);
  await page.waitForFunction(() => globalThis.ar3d.view.ready && globalThis.ar3d.view.settled, null, {timeout: 120000});
  const times = await page.evaluate(() => [globalThis.ar3d.view.ready, globalThis.ar3d.view.settled]);
  return {page, times};
}

async function measure(file) {
  const ready = [], settled = [], frames = [], processor = [], empty = [], emptyProcessor = [];
  const floor = await browser.newPage({viewport: {width: 1280, height: 900}});
  await floor.goto("file://" + join(folder, "empty.html"));
  for (let round = 0; round < 3; ++round) {
    const {page, times} = await opened(file);
    ready.push(times[0]);
    settled.push(times[1]);
    await page.evaluate(() => { globalThis.step = () => globalThis.ar3d.turn(0.02, 0); });
    await turning(page, 2);  // the number of lines finds its level
    const [f, p] = await turning(page, 5);
    frames.push(f);
    processor.push(p);
    measure.holds = await page.evaluate(() => ({...globalThis.ar3d.cost(), level: globalThis.ar3d.view.level}));
    await page.close();
    await floor.bringToFront();
    const [e, q] = await turning(floor, 3);
    empty.push(e);
    emptyProcessor.push(q);
  }
  await floor.close();
  return {ready: median(ready), settled: median(settled), frames: median(frames), processor: median(processor), empty: median(empty), emptyProcessor: median(emptyProcessor)};
}

async function report(name, file) {
  const m = await measure(file), h = measure.holds;
  console.log(`${name.padEnd(20)}${String(statSync(file).size).padStart(10)}${m.ready.toFixed(0).padStart(6)} ms${m.settled.toFixed(0).padStart(6)} ms` +
    `${m.frames.toFixed(1).padStart(9)}${m.processor.toFixed(1).padStart(12)}       (${m.empty.toFixed(1)}, ${m.emptyProcessor.toFixed(1)})   ` +
    `${h.level}: ${h.calls} calls, ${h.lines} lines, ${h.points} points, ${h.triangles} triangles, ${h.pixels} pixels`);
}

console.log(`${await browser.version()}, load ${loadavg()[0].toFixed(1)}`);
console.log("drawing                bytes    ready  settled  frames/s  CPU ms/frame  (empty canvas: frames/s, CPU ms/frame)  a frame");
for (const what of counts.length ? counts : ["100000"]) {
  if (what.endsWith(".html")) {
    await report(what.split("/").at(-1), resolve(what));
    continue;
  }
  for (const [algorithm, family] of [["diamond", "random-4-regular"], ["compact", "random-4-regular"], ["grid", "random-cubic"], ["two-bend", "random-cubic"]]) {
    const file = join(folder, `${algorithm}.html`);
    const graph = execFileSync(program, ["generate", family, "-n", what, "--seed", "1"], {maxBuffer: 2 ** 31});
    execFileSync(program, ["draw", "-", "--algorithm", algorithm, "-o", file], {input: graph});
    await report(`${algorithm} n=${what}`, file);
    rmSync(file);
  }
}
await browser.close();
await server.close();
rmSync(folder, {recursive: true, force: true});
