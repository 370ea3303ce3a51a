// SPDX-License-Identifier: Apache-2.0
// node tests/lab/run.mjs build/bench bench/wasm/steps.mjs AVO MODULE: how much longer a step takes in WebAssembly than natively by SSE4, both on one
// thread. AVO is the command line, MODULE avo.wasm. The two take turns, because other
// work on the machine slows them down alike; the least of all rounds counts.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { load } from "../../lab/avo/avo.ts";

const ROUNDS = 3;
const RUNS = 3;    // of the same steps in a round; a step counts with the median of its times, as in `avo bench`
const FIRST = 10;  // steps that do not count, as in `avo bench`
const SCENES = { "circle-1000": 3000, "uniform-1000": 300 };

const [command, module] = process.argv.slice(2);
const library = await load(readFileSync(module));

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
function moduleStep(scene, steps) {
  const runs = [];
  for (let run = 0; run < RUNS; ++run) {
    const simulation = library.simulate(library.builtinText(scene), { name: scene });
    for (let k = 0; k < FIRST; ++k) simulation.step();
    runs.push(Array.from({ length: steps }, () => {
      const begin = performance.now();
      simulation.step();
      return performance.now() - begin;
    }));
  }
  return median(runs[0].map((_, k) => median(runs.map((run) => run[k]))));
}

for (const [scene, steps] of Object.entries(SCENES)) {
  let native = Infinity;
  let wasm = Infinity;
  for (let round = 0; round < ROUNDS; ++round) {
    native = Math.min(native, nativeStep(scene, steps));
    wasm = Math.min(wasm, moduleStep(scene, steps));
  }
  console.log(`${scene}: SSE4 ${native.toFixed(2)} ms, WebAssembly ${wasm.toFixed(2)} ms a step, ` +
    `ratio ${(wasm / native).toFixed(2)}`);
}
