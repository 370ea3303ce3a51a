// SPDX-License-Identifier: Apache-2.0
// node steps.mjs AVO STATES MODULE: how much longer a step takes in WebAssembly than natively by SSE4, both on one
// thread. AVO is the command line, STATES the program wasm_states, MODULE avo.wasm. The two take turns, because other
// work on the machine slows them down alike; the least of all rounds counts.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { load } from "../../lab/wasm/load.mjs";

const ROUNDS = 3;
const RUNS = 3;    // of the same steps in a round; a step counts with the median of its times, as in `avo bench`
const FIRST = 10;  // steps that do not count, as in `avo bench`
const SCENES = { "circle-1000": 3000, "uniform-1000": 300 };

const [command, states, module] = process.argv.slice(2);
const compiled = await WebAssembly.compile(readFileSync(module));

function median(numbers) {
  return [...numbers].sort((a, b) => a - b)[numbers.length >> 1];
}

/** ms */
function nativeStep(scene, steps) {
  const text = execFileSync(command, ["bench", scene, "--threads", "1", "--steps", `${steps}`, "--json"],
    { env: { ...process.env, AVO_SIMD: "sse4" }, encoding: "utf8" });
  return JSON.parse(text).step_milliseconds_median;
}

/** ms */
async function moduleStep(saved, steps) {
  const avo = await load(compiled);
  const runs = [];
  for (let run = 0; run < RUNS; ++run) {
    avo.restore(saved);
    for (let k = 0; k < FIRST; ++k) avo.step();
    runs.push(Array.from({ length: steps }, () => {
      const begin = performance.now();
      avo.step();
      return performance.now() - begin;
    }));
  }
  return median(runs[0].map((_, k) => median(runs.map((run) => run[k]))));
}

const folder = mkdtempSync(join(tmpdir(), "avo-wasm-"));
try {
  execFileSync(states, [folder, "0", ...Object.keys(SCENES)]);
  for (const [scene, steps] of Object.entries(SCENES)) {
    const saved = readFileSync(join(folder, scene));
    let native = Infinity;
    let wasm = Infinity;
    for (let round = 0; round < ROUNDS; ++round) {
      native = Math.min(native, nativeStep(scene, steps));
      wasm = Math.min(wasm, await moduleStep(saved, steps));
    }
    console.log(`${scene}: SSE4 ${native.toFixed(2)} ms, WebAssembly ${wasm.toFixed(2)} ms a step, ` +
      `ratio ${(wasm / native).toFixed(2)}`);
  }
} finally {
  rmSync(folder, { recursive: true });
}
