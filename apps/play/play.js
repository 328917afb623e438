// The page of `ar3d play`: a graph is given, a worker draws and judges it, the viewer shows it.
import {shapeCameras} from "../../formats/drawings/viewer/cameras.js";
import {bytesOfBase64, decoded, inflated} from "../../formats/drawings/viewer/data.js";
import {withCommas} from "../../formats/drawings/viewer/exact.js";
import {showLoaded, startViewer} from "../../formats/drawings/viewer/page.js";
import {savePicture} from "../../formats/drawings/viewer/panel.js";
import {byId, redraw, tellProblem, view} from "../../formats/drawings/viewer/state.js";
import {commandOf, linked, linkOf, readable, textOf} from "./given.js";

const kLongText = 100000;  // longer ones are not put into the field, which would be slow
const kFirst = {given: {family: "petersen"}, algorithm: "", effort: 1};
const kFormats = ["jsonl", "svg", "tikz", "glb", "stl", "png"];

const isNarrow = () => innerWidth <= 700;

const session = {
  module: null,  // the compiled program
  worker: null,
  catalogue: null,
  isAsking: false,  // the worker has not answered yet
  begin: 0,  // of the work that goes on, 0: none
  given: null,  // {text, name} or {family, n, seed}
  drawn: null,  // what is shown: {given, algorithm, effort, options, line}
};

/// A worker that is ready.
async function newWorker() {
  const source = ["core", "worker"].map(id => byId(id).textContent);
  const url = URL.createObjectURL(new Blob(source, {type: "text/javascript"}));
  const worker = new Worker(url);
  await new Promise((done, fail) => {
    worker.onmessage = done;
    worker.onerror = fail;
    worker.postMessage(session.module);
  });
  URL.revokeObjectURL(url);
  return worker;
}

/// Asks the program. @return {answer, made}; throws its line if it has an error; never settles if it is cancelled.
async function ask(request, text = "") {
  session.worker ||= newWorker();
  const worker = await session.worker;
  session.isAsking = true;
  const reply = await new Promise((done, fail) => {
    worker.onmessage = ({data}) => done(data);
    worker.onerror = event => fail(new Error(event.message || "the program ended: perhaps too little memory"));
    worker.postMessage({request, text});
  }).finally(() => { session.isAsking = false; });
  if (reply.answer.error !== undefined) throw new Error(reply.answer.error);
  return reply;
}

const seconds = time => time < 0.1 ? `${(1000 * time).toFixed(1)} ms` : `${time.toFixed(2)} s`;

function tellError(message) {
  byId("error").textContent = message && `ar3d: ${message}`;
  byId("error").hidden = !message;
  if (message) byId("error").scrollIntoView({block: "nearest"});
}
function showWork() {
  const isBusy = session.begin > 0;
  byId("cancel").hidden = !isBusy;
  byId("draw").disabled = isBusy;
  const time = ((performance.now() - session.begin) / 1000).toFixed(1);
  byId("clock").textContent = isBusy ? `drawing and judging: ${time} s` : "";
  if (isBusy) setTimeout(showWork, 100);
}
async function stopWorker() {
  const worker = session.worker;
  Object.assign(session, {worker: null, isAsking: false});
  if (worker) (await worker).terminate();
}
async function cancel() {
  session.begin = 0;
  await stopWorker();
  showWork();
  tellError("cancelled");
}

function rowOf(name, value) {
  const row = document.createElement("tr"), head = document.createElement("th"), cell = document.createElement("td");
  head.scope = "row";
  head.textContent = name;
  cell.textContent = value;
  row.append(head, cell);
  return row;
}

const boxOf = sides => sides.map(side => withCommas(Math.ceil(side))).join(" \u00d7 ");
const degreesOf = cosine => `${(Math.acos(cosine) * 180 / Math.PI).toFixed(2).replace(/\.00$/, "")}\u00b0`;

const algorithmCalled = name => session.catalogue.algorithms.find(row => row.name === name);

/// What the theorem of an algorithm says, for the sentence before a drawing and behind "proved".
function promiseOf({bends, exactly, cosine}) {
  return `every angle ${exactly ? "is exactly" : "is at least"} ${degreesOf(cosine)}, ` +
    `no edge has more than ${bends} bend${bends === 1 ? "" : "s"}, no two edges meet`;
}

function fillResult({about, hash, seconds: took}) {
  const {verdict, bound, extents, bends, algorithm} = about, row = algorithmCalled(algorithm);
  const isProved = verdict.kind === "certified";
  byId("proof-word").textContent = isProved ? "proved" : verdict.kind;
  byId("proof-word").className = isProved ? "" : verdict.kind === "violated" ? "violated" : "unknown";
  byId("proof-text").textContent = `${isProved ? promiseOf(row) + ": " : ""}${verdict.text}.`;
  byId("measures").replaceChildren(
    rowOf("box", boxOf(extents)), ...bound ? [rowOf("theorem", `at most ${boxOf(bound.extents)}`)] : [],
    rowOf("bends", withCommas(bends)),
    rowOf("time", `drawn in ${seconds(took.draw)}, judged in ${seconds(took.judge)}`), rowOf("hash", hash));
  byId("command").textContent = commandOf(session.drawn, session.drawn.line);
  byId("copy-link").hidden = !linkOf(session.drawn, session.drawn.line);
  byId("result").hidden = false;
}

function tellGiven({graphs, note, format}) {
  const {given} = session, from = given.name === "<stdin>" ? "read as" : `${given.name}:`;
  const what = given.family ? note : `${from} ${format}`;
  byId("read").hidden = !what;
  byId("read-what").textContent = what + (graphs > 1 ? `, ${withCommas(graphs)} graphs; ` : "");
  byId("place-label").hidden = !(graphs > 1);
  byId("place").max = graphs || 1;
}

function titleOf({family, n, name}) {
  if (family) return n === undefined ? family : `${family}, n = ${n}`;
  return name === "<stdin>" ? "your graph" : name;
}

/// Draws what is given, shows it; or says why not.
async function draw() {
  if (session.isAsking) await stopWorker();
  const {given} = session, row = algorithmCalled(byId("algorithm").value);
  const effort = Number(byId("effort").value), begin = performance.now();
  tellError("");
  session.begin = begin;
  showWork();
  try {
    const options = effort === 1 ? "" : `effort=${effort}`;
    const request = {do: "draw", algorithm: row ? row.name : "", options, title: titleOf(given)};
    const graph = given.family ? given : {name: given.name, place: Number(byId("place").value)};
    const {answer, made} = await ask({...request, ...graph}, given.family ? "" : readable(given));
    if (session.begin !== begin) return;
    const {algorithm} = answer.about;
    session.drawn = {given, algorithm, effort, options: answer.options, line: answer.line};
    tellProblem("");
    tellGiven(answer);
    fillResult(answer);
    await showLoaded(answer.about.n ? decoded(answer.about, made) : {about: answer.about, n: 0, m: 0, segments: 0});
    if (session.begin !== begin) return;
    byId("verdict").textContent = byId("proof-word").textContent;
    history.replaceState(null, "", linkOf(session.drawn, session.drawn.line) || "#");
  } catch (error) {
    if (session.begin !== begin) return;
    tellError(error.message);
  }
  session.begin = 0;
  showWork();
}

function give(given) {
  session.given = given;
  byId("place").value = 1;
  byId("place-label").hidden = byId("read").hidden = true;
  byId("family").value = given.family || "";
  byId("sizes").hidden = !(given.family in session.sizes);
  if (given.family) {
    byId("text").value = "";
    byId("n").value = given.n || byId("n").value;
    byId("seed").value = given.seed || byId("seed").value;
    byId("seed-label").hidden = !session.sizes[given.family];
  } else {
    byId("text").value = given.text.length > kLongText ? "" : given.text;
  }
  return draw();
}
const giveText = text => text.trim() && give({text, name: "<stdin>"});
async function giveFile(file) {
  try {
    await give({text: await textOf(file), name: file.name});
  } catch (error) {
    tellError(error.message);
  }
}
function giveFamily() {
  const family = byId("family").value;
  const size = family in session.sizes ? {n: Number(byId("n").value), seed: Number(byId("seed").value)} : {};
  if (family) give({family, ...size});
}

function chooseAlgorithm(name, effort = 1) {
  byId("algorithm").value = name;
  const row = algorithmCalled(name), highest = row ? row.efforts : 1;
  const efforts = row && !row.efforts ? [1] : Array.from({length: highest + 1}, (_, i) => i);
  byId("effort").replaceChildren(...efforts.map(i => new Option(i, i, false, i === Math.min(effort, highest || 1))));
  byId("promise").textContent = row ? `Degree at most ${row.degree}: ${promiseOf(row)}.`
    : "grid for degree at most 3 (all angles 120\u00b0), else diamond (109.47\u00b0, degree 4).";
}
function followLink() {
  const {given, algorithm, effort} = linked(location.hash) || kFirst;
  chooseAlgorithm(algorithm, effort);
  return give(given);
}

/// A list of choices under a heading.
function choices(heading, rows) {
  const group = document.createElement("optgroup");
  group.label = heading;
  group.append(...rows.map(({name, summary}) => Object.assign(new Option(name, name), {title: summary})));
  return group;
}
function fillChoices({algorithms, families, named}) {
  session.sizes = Object.fromEntries(families.map(({name, random}) => [name, random]));
  const groups = [choices("Named graphs", named), choices("Families", families)];
  byId("family").replaceChildren(new Option("\u2013", ""), ...groups);
  byId("algorithm").replaceChildren(new Option("the one that fits", ""), choices("Algorithms", algorithms));
  for (const format of kFormats) {
    const button = document.createElement("button");
    button.textContent = format;
    button.onclick = () => save(format);
    byId("saves").append(button);
  }
}

async function save(format) {
  if (session.isAsking) return;
  if (format === "png") {
    savePicture();
    return;
  }
  tellError("");
  try {
    const {made} = await ask({do: "save", format}), link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([made]));
    link.download = `${view.drawing.about.algorithm}.${format}`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  } catch (error) {
    tellError(error.message);
  }
}
async function copy(button, text) {
  const words = button.textContent;
  await navigator.clipboard.writeText(text).then(() => { button.textContent = "Copied"; }, () => {
    getSelection().selectAllChildren(byId("command"));
    button.textContent = "Press Ctrl+C";
  });
  setTimeout(() => { button.textContent = words; }, 1500);
}

/// Shows or hides the graph's controls. Where the page is narrow the viewer's and these do not stand over each other.
function fold(isHidden = !byId("source").hidden) {
  if (!isHidden && isNarrow() && !byId("panel").hidden) byId("unfold").click();
  byId("source").hidden = isHidden;
  byId("fold").setAttribute("aria-expanded", String(!isHidden));
  if (!view.controls) return;
  shapeCameras();
  redraw();
}

function listenToText() {
  let timer = 0;
  byId("text").oninput = ({target}) => {
    clearTimeout(timer);
    timer = setTimeout(() => giveText(target.value), 500);
  };
  addEventListener("paste", event => {
    const text = event.clipboardData.getData("text/plain"), [file] = event.clipboardData.files;
    const isShort = event.target === byId("text") && text.length <= kLongText;
    const isField = event.target instanceof HTMLInputElement || isShort;
    if (isField && !file) return;
    event.preventDefault();
    if (file) giveFile(file);
    else giveText(text);
  });
}
function listenToFiles() {
  byId("choose").onclick = () => byId("file").click();
  byId("file").onchange = ({target}) => {
    if (target.files[0]) giveFile(target.files[0]);
    target.value = "";
  };
  const isFile = ({dataTransfer: {types}}) => types.includes("Files") || types.includes("text/plain");
  addEventListener("dragover", event => {
    if (!isFile(event)) return;
    event.preventDefault();
    byId("dropping").hidden = false;
  });
  addEventListener("dragleave", event => { if (!event.relatedTarget) byId("dropping").hidden = true; });
  addEventListener("drop", event => {
    event.preventDefault();
    byId("dropping").hidden = true;
    const [file] = event.dataTransfer.files;
    if (file) giveFile(file);
    else giveText(event.dataTransfer.getData("text/plain"));
  });
}
function listenToChoices() {
  byId("family").onchange = byId("n").onchange = byId("seed").onchange = giveFamily;
  byId("algorithm").onchange = ({target}) => {
    chooseAlgorithm(target.value, Number(byId("effort").value));
    draw();
  };
  byId("effort").onchange = byId("place").onchange = byId("draw").onclick = draw;
  byId("cancel").onclick = cancel;
  byId("fold").onclick = () => fold();
  byId("unfold").addEventListener("click", () => {
    if (isNarrow() && !byId("panel").hidden) fold(true);
  });
  byId("copy-command").onclick = ({target}) => copy(target, byId("command").textContent);
  byId("copy-link").onclick = ({target}) => copy(target, location.href);
  addEventListener("hashchange", followLink);
}

async function startPlay() {
  byId("pages").hidden = true;
  try {
    session.module = await WebAssembly.compile(await inflated(bytesOfBase64(byId("program").textContent)));
    session.catalogue = (await ask({do: "catalogue"})).answer;
  } catch (error) {
    tellProblem(`The program cannot be started in this browser: ${error.message}`);
    return;
  }
  fillChoices(session.catalogue);
  listenToText();
  listenToFiles();
  listenToChoices();
  await followLink();
}
startViewer(startPlay);
