// SPDX-License-Identifier: Apache-2.0
// More than a thousand decisions by chance, over all methods, certificates and motion models, are told by the module
// as `avo explain --json` tells them, to the byte.
//   AVO_DECISIONS: the program that tells them natively
import assert from "node:assert/strict";
import { test } from "node:test";
import { randomNumbers } from "../data/native.mjs";
import { builtin, native, refused, steps } from "./module.mjs";

const SCENES = {
  "circle-20": 20, "uniform-50": 50, office: 20, doorway: 20, person: 24, "moving-obstacle": 1,
  "cars-100": 100, "reversing-cars": 16, "drives-100": 100, "planes-12": 12, "mixed-yard": 24,
};
const VARIANTS = [
  [], ["certificate=none"], ["method=avo_paper"], ["method=velocity_obstacle"], ["method=orca"],
  ["method=orca_clamped"], ["method=reciprocal_velocity_obstacle"], ["method=buffered_voronoi"],
  ["motion=exponential"], ["clock=free"], ["sensing={noise: {position: 0.02}}".replaceAll(" ", "")],
];
const TIMES = 4, ROBOTS = 4;

const random = randomNumbers(18);
const asked = [];
for (const [scene, robots] of Object.entries(SCENES)) {
  for (const overrides of VARIANTS) {
    const times = Array.from({ length: TIMES }, () => Math.floor(random() * 160)).sort((a, b) => a - b);
    for (const count of times) {
      for (let k = 0; k < Math.min(ROBOTS, robots); ++k)
        asked.push({ scene, overrides, count, robot: Math.floor(random() * robots) });
    }
  }
}

test("decisions are told alike", () => {
  const list = asked.map(({ scene, robot, count, overrides }) => [scene, robot, count, ...overrides].join(" ") + "\n").join("");
  const told = native(process.env.AVO_DECISIONS, [], list).split("--\n");
  assert.equal(told.pop(), "");
  assert.equal(told.length, asked.length);
  const methods = new Set(), models = new Set();
  let decisions = 0, refusals = 0, simulation, key;
  for (const [k, { scene, robot, count, overrides }] of asked.entries()) {
    if (!told[k].startsWith("{")) {  // the scene is refused with these overrides, or the robot has left or is parked
      ++refusals;
      assert.ok(refused(() => steps(builtin(scene, { overrides }), count).explain(robot)));
      continue;
    }
    const wanted = [scene, ...overrides].join(" ");
    if (key !== wanted) [simulation, key] = [builtin(scene, { overrides }), wanted];
    while (simulation.steps < count) simulation.step();
    assert.equal(simulation.explain(robot), told[k], `${wanted}, robot ${robot} after ${count} steps`);
    methods.add(simulation.info().options.method);
    models.add(simulation.info().robots.find((one) => one.robot === robot).model);
    ++decisions;
  }
  assert.ok(decisions >= 1000, `${decisions} decisions, ${refusals} refused`);
  assert.equal(methods.size, 7);
  assert.equal(models.size, 4);
});
