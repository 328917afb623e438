// What the page says of drawings in real types: the module analysis/page/real.js alone, without a page.
import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {test} from "node:test";

const source = readFileSync(new URL("../../analysis/page/real.js", import.meta.url));
const {judgeOnset, realStudy, realType} = await import("data:text/javascript;base64," + source.toString("base64"));

const kBits = [24, 53, 64, 113, 237];
const curves = kBits.map((_, type) => ({algorithm: "two-bend-paper", options: "type=" + type, family: "random-cubic", parameters: ""}));

/** A drawing whose condition is n^2 and whose miss is `kappa` of what that allows. */
const drawing = (type, n, instance, kappa) => ({row: 1000 * type + n + instance, curve: type, n, vertices: n, broken: false, condition: n * n,
  miss: kappa * 180 / Math.PI * n * n * 2 ** -kBits[type], within_1e_12: 0.25, within_1e_9: 0.5, within_1e_6: 0.75, within_1e_3: 1, cpu: 1e-6 * n * (type + 1)});
/** Five types, n = 16, 32, …, 4096, three graphs each; kappa of one type as told, else 0.2. */
const drawings = (other = -1, kappa = 0.2) => Array.from({length: 9}, (_, i) => 16 << i).flatMap(n => kBits.flatMap((_, type) =>
  [0, 1, 2].map(instance => drawing(type, n, instance, type === other ? kappa : 0.2))));
const onsetOf = (study, type, limit) => study.onsets.find(row => row.type === type && Math.abs(row.limit / limit - 1) < 1e-6);

test("every type is predicted from the widest", () => {
  const study = realStudy(drawings(), curves, []);
  assert.deepEqual([study.drawings, study.broken, study.model, study.predictors, study.refuted], [135, 0, "237 bits", 27, 0]);
  assert.ok(Math.abs(study.kappa - 0.2) < 1e-6);
  // 0.2 * 57.3 * 2^-24 n^2 = 10^-3 at n = 38; 10^-9 in double at n = 886.
  const single = onsetOf(study, 0, 1e-3), twice = onsetOf(study, 1, 1e-9);
  assert.deepEqual([single.seen, single.predicted, single.verdict], [38, 38, "confirmed"]);
  assert.deepEqual([twice.seen, twice.predicted], [887, 887]);
  assert.deepEqual([study.misses.length, study.medians.length, study.predicted.length], [135, 45, 9]);
  assert.ok(study.accuracies.every(row => row.time === null && !row.front), "no timing phase");
  for (const row of study.shares) assert.deepEqual([row.drawings, row.within_1e_12, row.all_1e_12, row.all_1e_3], [3, 0.25, 0, 1]);
});

test("times of the timing phase are ranked", () => {
  const timed = type => Array.from({length: 9}, (_, i) => ({curve: type, quantity: "drawing time", n: 16 << i, median: type === 2 ? 9 : type === 5 ? 0.01 : 1 + type, divisor: 16 << i}));
  const exact = {algorithm: "two-bend", options: "", family: "random-cubic", parameters: "", setting: 5, ok: 27};
  const {accuracies, conclusions, compared} = realStudy(drawings(), [...curves.map((curve, setting) => ({...curve, setting, ok: 27})), exact], [0, 1, 2, 3, 4, 5].flatMap(timed)), last = accuracies.filter(row => row.n === 4096);
  assert.deepEqual([...new Set(accuracies.map(row => row.n))], [16, 64, 512, 4096]);
  assert.deepEqual(last.map(row => row.time), [1, 2, 9, 4, 5]);
  assert.deepEqual(last.map(row => row.front), [true, true, false, true, true]);
  assert.equal(compared.length, 9, "a row for each n of the family");
  assert.deepEqual(compared.at(-1).exact, [{setting: 5, time: 0.01}]);
  const single = conclusions[0];
  assert.deepEqual([single.held_n, single.held_miss < 0.1], [256, true], "0.18 degrees at n = 512");
  assert.deepEqual([single.drawings, single.worst_n, single.last_n, single.beside.n, single.beside.setting], [27, 4096, 4096, 4096, 5]);
  assert.ok(Math.abs(single.beside.ratio - 100) < 1e-9 && Math.abs(single.miss - 0.2 * 180 / Math.PI * 4096 ** 2 * 2 ** -24) < 1e-9);
});

test("predictions that fail are refuted", () => {
  const study = realStudy(drawings(1, 0.2 * 25), curves, []), twice = onsetOf(study, 1, 1e-9);
  assert.deepEqual([twice.seen, twice.predicted, twice.verdict], [177, 887, "refuted"], "25 times as large passes at a fifth of n");
  assert.ok(Math.abs(twice.kappa_seen - 5) < 1e-6 && Math.abs(twice.kappa - 0.2) < 1e-6);
  assert.equal(onsetOf(study, 0, 1e-3).verdict, "confirmed");
});

test("what lies beyond the sizes is open unless it is far", () => {
  const verdict = (predicted, seen) => judgeOnset(predicted, seen, 1, 3);
  for (const [predicted, seen] of [[2, 2.3]]) assert.equal(verdict(predicted, seen), "confirmed");
  for (const [predicted, seen] of [[2, 2.302], [2.302, 2], [Infinity, 2.6], [2.6, Infinity], [1.4, -Infinity], [-Infinity, Infinity]]) {
    assert.equal(verdict(predicted, seen), "refuted", `${predicted} ${seen}`);
  }
  for (const [predicted, seen] of [[Infinity, 2.8], [2.8, Infinity], [-Infinity, 1.2]]) assert.equal(verdict(predicted, seen), "open", `${predicted} ${seen}`);
});

test("drawings that miss nothing, broken ones, and conditions that are infinite", () => {
  const rows = drawings().map(row => row.curve > 0 || row.n > 32 ? row : {...row, miss: row.n === 16 ? 0 : 30, condition: null, broken: row.n === 32});
  const study = realStudy(rows, curves, []);
  assert.equal(study.broken, 3);
  assert.equal(study.medians.find(row => row.type === 0 && row.n === 16).miss, 0);
  assert.equal(study.compared[1].types[0].largest, 30);
});

test("one type alone is shown and predicts nothing else; no drawings are nothing", () => {
  const study = realStudy(drawings().filter(row => row.curve === 1), curves, []);
  assert.deepEqual([study.medians.length, study.onsets.length], [9, 0]);
  assert.deepEqual([realStudy([], curves, []).drawings, realStudy([], curves, []).onsets], [0, []]);
});

test("types are those of the algorithm", () => {
  const type = (algorithm, options) => realType({algorithm, options}).type;
  assert.equal(type("two-bend-paper", "type=0"), "float");
  assert.equal(type("two-bend-paper", "type=4;level=full"), "237 bits");
  assert.equal(type("two-bend-paper", "type=5"), "two-bend-paper (type=5)");
  assert.equal(type("mine", "type=0"), "mine (type=0)");
  assert.deepEqual(realType({algorithm: "mine", options: ""}), {type: "mine", bits: 0});
});
