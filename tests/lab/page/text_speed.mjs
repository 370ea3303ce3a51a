// SPDX-License-Identifier: Apache-2.0
// What a user waits for while scenes are read and edited, held to bounds; for scripts/lab-check, beside nothing else.
//   a key of a thousand robots <= 300 ms, of ten thousand <= 50 times as long; a text that wants too much is refused
//   within 20 s. Exit status 1: one is missed.
import { withRobotKey } from "../../../lab/page/text/scene_text.ts";
import { library, refused } from "../wasm/module.mjs";

let missed = 0;
function tell(what, value, unit, most) {
  const kept = value <= most;
  console.log(`${what.padEnd(46)} ${value.toFixed(2).padStart(8)} ${unit.padEnd(4)} <= ${most} ${kept ? "kept" : "MISSED"}`);
  if (!kept) ++missed;
}

/** ms */
function took(action) {
  const begin = performance.now();
  action();
  return performance.now() - begin;
}

const keyOf = (count) => {
  const yaml = `version: 1\nrobots:\n${"  - {position: [-8, 0], goal: [8, 0]}\n".repeat(count)}`;
  return took(() => withRobotKey(yaml, "radius", 0.4));
};
const thousand = Math.min(keyOf(1000), keyOf(1001), keyOf(1002));
tell("a key of 1000 robots", thousand, "ms", 300);
tell("a key of 10000, of the time of 1000", keyOf(10000) / thousand, "", 50);
for (const [piece, times] of [["[", 100000], ["{", 100000], ["- ", 100000], ["? ", 100000], ["!", 100000], ["&a ", 100000], ["---\n", 20000]]) {
  const time = took(() => refused(() => library.simulate(piece.repeat(times), { name: "bomb" })));
  tell(`${times} times ${JSON.stringify(piece)} refused`, time / 1000, "s", 20);
}
process.exitCode = missed > 0 ? 1 : 0;
