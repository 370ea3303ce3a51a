// SPDX-License-Identifier: Apache-2.0
// node check.mjs MODULE SIMD STATES STEPS SCENE...: the module uses the instructions SIMD, comes to the same bits as the native library, saves and
// goes on, and says what it refuses.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { load } from "../../lab/wasm/load.mjs";

const [module, simd, states, steps, ...scenes] = process.argv.slice(2);
const compiled = await WebAssembly.compile(readFileSync(module));
const folder = mkdtempSync(join(tmpdir(), "avo-wasm-"));
try {
  assert.equal((await load(compiled)).simdTarget(), simd);
  const lines = execFileSync(states, [folder, steps, ...scenes], { encoding: "utf8" }).trim().split("\n");
  assert.ok(lines.length >= scenes.length);
  for (const line of lines) {
    const [scene, time, hash] = line.split(" ");
    const avo = await load(compiled);
    avo.restore(readFileSync(join(folder, scene)));
    const first = avo.positions();
    let halfway;
    while (avo.time() < Number(time) - 1e-6) {
      avo.step();
      if (halfway === undefined && avo.time() >= Number(time) / 2) halfway = avo.save();
    }
    assert.equal(avo.stateHash(), BigInt(hash), `${scene}: state hash after ${avo.time()} s`);
    assert.notDeepEqual(avo.positions(), first, `${scene}: somebody moved`);
    const again = await load(compiled);
    again.restore(halfway);
    while (again.time() < avo.time()) again.step();
    assert.equal(again.stateHash(), avo.stateHash(), `${scene}: back and forth`);
    console.log(`${scene}: ${avo.robots()} robots, ${avo.time().toFixed(1)} s, same bits`);
  }
  const avo = await load(compiled);
  assert.throws(() => avo.restore(new Uint8Array([1, 2, 3])), { name: "Error", message: /^saved/ });
} finally {
  rmSync(folder, { recursive: true });
}
