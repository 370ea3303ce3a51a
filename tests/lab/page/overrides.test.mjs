// SPDX-License-Identifier: Apache-2.0
// What the command line sets beside a scene is part of its text once it is open: it comes to the same states, and gives
// way to what is changed then.
import assert from "node:assert/strict";
import { test } from "node:test";
import { valueAt } from "../../../lab/page/text/scene_text.ts";
import { first } from "../../../lab/page/run/input.ts";
import { folded } from "../../../lab/page/text/overrides.ts";
import { library } from "../wasm/module.mjs";

const LISTED = `version: 1
time_horizon: 3.0   # s
robots:
  - {position: [-8, 0], goal: [8, 0]}   # one
  - position: [8, 0.3]
    goal: [-8, 0]
obstacles:
  - {disc: {center: [0, 5], radius: 1}}
`;
const MIXED = `${LISTED}groups:
  - {number: 3, placement: {line: {from: [0, 9], to: [9, 9]}}, goals: antipodal}
`;
const BARE = "version: 1\nsensing:\nobstacles:   # none\ngroups:\n  - {number: 2, placement: {circle: {spacing: 9}}, goals: antipodal}\n";
const circle = library.builtinText("circle-10");

/** A scene, overrides, and those that stay. */
const CASES = [
  [circle, ["time_horizon=5", "robots.0.radius=0.3"], ["robots.0.radius=0.3"]],
  [circle, ["groups.0.placement.circle.min_radius=12.3456789012345678", "groups.0.placement.circle.center=[1,\n -2e0 ]"], []],
  [circle, ["groups.0.placement={grid: {corner: [0, 0], spacing: 4, columns: 3}}", "groups.0.goals={offset: {by: [9, 0]}}", "groups.0.jitter=0.1", "seed=18446744073709551615"], []],
  [circle, ["robots.3.max_speed=1", "method=orca", "robots.3.max_speed=1.5", "certificate=none"], ["robots.3.max_speed=1", "robots.3.max_speed=1.5"]],
  [circle, ["groups.0.number=4", "sensing.noise.position=0.02", "sensing.noise.velocity=0.05", "sensing.delay=1", "name='two, or: more #'"], []],
  [circle, ["groups=[{number: 3, placement: {line: {from: [0, 0], to: [9, 0]}}, goals: antipodal}]"], []],
  [circle, ["obstacles=\n- polyline:\n  - [30, 0]\n  - [30, 1]\n", "obstacles.0.polyline.1.1=2.5", "robots=[{position: [50, 0], goal: [60, 0]}]", "robots.0.radius=1"], []],
  [LISTED, ["robots.0.radius=0.3", "robots.1.position=[9, 1]", "robots.1.position.1=0.50", "obstacles.0.disc.radius=2", "time_step=.2e-1"], []],
  [LISTED, ["robots.0.model=car", "robots.0.car={reverse: true}", "robots.0.car.wheelbase=0.75", "obstacles=[]"], []],
  [MIXED, ["robots.1.radius=0.3", "robots.2.radius=0.4", "robots.4.max_speed=1"], ["robots.2.radius=0.4", "robots.4.max_speed=1"]],
  [MIXED, ["robots.2.radius=0.4", "robots=[{position: [1, 2], goal: [3, 4]}]", "seed=3"], ["robots.2.radius=0.4", "robots=[{position: [1, 2], goal: [3, 4]}]"]],
  [BARE, ["sensing.noise.position=0.01", "obstacles=[{disc: {center: [0, 0], radius: 1}}]", "navigation=true"], []],
  [JSON.stringify({ version: 1, robots: [{ position: [0, 0], goal: [9, 0] }] }), ["robots.0.radius=0.3", "method=orca", "name=\"5\""], []],
];

/** State by state, to the end of the state that is saved. */
function comesTo(yaml, options) {
  const simulation = library.simulate(yaml, { name: "scene", ...options });
  const states = [simulation.save()];
  for (let k = 0; k < 5; ++k) simulation.step();
  return { states: [...states, simulation.save()], hash: simulation.stateHash(), info: simulation.info() };
}

for (const [yaml, overrides, kept] of CASES) {
  test(`${overrides.join(" ").replace(/\s+/g, " ")}: the text says the same`, () => {
    const scene = folded(yaml, { overrides });
    assert.deepEqual(scene.options.overrides, kept);
    assert.deepEqual(comesTo(scene.yaml, scene.options), comesTo(yaml, { overrides }), scene.yaml);
    const comments = (text) => text.match(/#.*/g)?.filter((comment) => comment !== '#"');
    assert.deepEqual(comments(scene.yaml), comments(yaml));
  });
}

test("what the library refuses stays, to be refused in its words", () => {
  for (const override of ["robots.*.radius=1", "nothing", "robots.2.radius=1", "time_horizon=[", "robots.x.radius=1", "time_horizon.s=1"]) {
    assert.deepEqual(folded(LISTED, { overrides: [override] }), { yaml: LISTED, options: { overrides: [override] } });
    const lab = first(library);
    lab.openText(LISTED, "scene", { overrides: [override] });
    assert.match(lab.error.message, /^--set /, override);
  }
});

test("what is set in the page wins over the command line, and is saved", () => {
  const lab = first(library);
  lab.openText(circle, "circle-10", { overrides: ["time_horizon=5", "groups.0.radius=0.3"] });
  assert.equal(lab.info.options.time_horizon, 5);
  assert.equal(valueAt(lab.text, "time_horizon"), 5);
  lab.set("time_horizon", 2);
  lab.set("robots.*.radius", 0.4);
  assert.equal(lab.info.options.time_horizon, 2);
  assert.ok(lab.info.robots.every(({ radius }) => radius === 0.4));
  assert.deepEqual(library.simulate(lab.text, { name: lab.name }).info(), lab.info);
});
