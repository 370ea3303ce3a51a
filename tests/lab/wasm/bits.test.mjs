// SPDX-License-Identifier: Apache-2.0
// The module comes to the same bits as the native library, from a scene's text and from a state that was saved there.
//   AVO_STATES: the program that saves and steps natively; AVO_SIMD_NAME: whose instructions the kernels use
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { builtin, library, native, steps } from "./module.mjs";

const STEPS = Number(process.env.AVO_STEPS ?? 200);
const folder = mkdtempSync(join(tmpdir(), "avo-states-"));
after(() => rmSync(folder, { recursive: true }));

const scenes = (process.env.AVO_SCENES ?? "all").split(" ");
const lines = native(process.env.AVO_STATES, [folder, String(STEPS), ...scenes]).trim().split("\n");

test("the kernels use the instructions that they were built for", () => {
  assert.equal(library.simdTarget, process.env.AVO_SIMD_NAME);
  assert.ok(scenes[0] === "all" ? lines.length > 20 : lines.length === scenes.length);
});

for (const line of lines) {
  const [scene, time, hash] = line.split(" ");
  test(scene, () => {
    const simulation = builtin(scene);
    const first = simulation.moment();
    let halfway;
    while (simulation.time < Number(time) - 1e-6) {
      simulation.step();
      if (halfway === undefined && simulation.time >= Number(time) / 2) halfway = simulation.save();
    }
    assert.equal(simulation.stateHash(), BigInt(hash), `state hash after ${simulation.time} s`);
    assert.notDeepEqual(simulation.moment().position, first.position, "somebody moved");
    const again = builtin(scene);
    again.restore(halfway);
    while (again.time < simulation.time) again.step();
    assert.equal(again.stateHash(), simulation.stateHash(), "back and forth");
    const native = builtin(scene);
    native.restore(readFileSync(join(folder, scene)));
    assert.equal(steps(native, 20).stateHash(), steps(builtin(scene), 20).stateHash(), "from the native library's bytes");
  });
}
