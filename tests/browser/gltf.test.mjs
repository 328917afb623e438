// What `ar3d draw -o x.glb` writes, judged by the validator of the Khronos Group. AR3D_PROGRAM names the program.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {test} from "node:test";
import validator from "gltf-validator";

const program = process.env.AR3D_PROGRAM;
const run = (args, input = "") => execFileSync(program, args, {input, maxBuffer: 1 << 28});

for (const [algorithm, family] of [["diamond", "random-4-regular"], ["compact", "random-4-regular"], ["grid", "random-cubic"], ["two-bend", "random-cubic"]]) {
  test(`${algorithm}: no errors, no warnings, every vertex and segment`, async () => {
    const graph = run(["generate", family, "-n", "50", "--seed", "5"]);
    const drawing = JSON.parse(run(["draw", "-", "--algorithm", algorithm], graph));
    const glb = run(["draw", "-", "--algorithm", algorithm, "--format", "glb"], graph);
    const report = await validator.validateBytes(new Uint8Array(glb));
    assert.equal(report.issues.numErrors, 0, JSON.stringify(report.issues.messages.slice(0, 3)));
    assert.equal(report.issues.numWarnings, 0, JSON.stringify(report.issues.messages.slice(0, 3)));
    const json = JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)));
    const count = primitive => json.accessors[primitive.indices].count;
    const [points, ...lines] = json.meshes[0].primitives;
    assert.equal(count(points), 50);
    const segments = drawing.edges.reduce((sum, edge) => sum + edge[2].length + 1, 0);
    assert.equal(lines.reduce((sum, primitive) => sum + count(primitive), 0), 2 * segments);
    const binary = glb.subarray(28 + glb.readUInt32LE(12)), at = json.bufferViews[json.accessors[points.attributes.POSITION].bufferView].byteOffset;
    const place = v => [0, 4, 8].map(i => binary.readFloatLE(at + 12 * v + i));
    const apart = (p, q) => p.map((c, i) => q[i] - c);
    if (algorithm !== "two-bend") assert.deepEqual(apart(place(0), place(49)), apart(drawing.vertices[0], drawing.vertices[49]));
  });
}
