// SPDX-License-Identifier: Apache-2.0
// What the user changes while a scene runs changes that, and nothing else.
import assert from "node:assert/strict";
import { test } from "node:test";
import { addRobot, addWall, moveGoal, moveRobot, removeRobot } from "../../../lab/page/map/changes.ts";
import { makeLab } from "../../../lab/page/run/make_lab.ts";
import { withMethod } from "../../../lab/page/text/method_text.ts";
import { library } from "../wasm/module.mjs";

const SCENE = `version: 1
robots:
  - {position: [-9, 9], goal: [9, 9]}
groups:
  - {number: 8, placement: {circle: {min_radius: 6}}, goals: antipodal}
moving_obstacles:
  - {position: [20, 1], velocity: [-1, 0], radius: 0.4}
`;
const open = (text = SCENE) => makeLab(library, text, "scene", {});
const state = ({ moment: { robot, position, velocity, goal, moving_obstacles } }) => ({ robot, position, velocity, goal, moving_obstacles });
const place = (lab, robot, column = "position") => {
  const k = lab.moment.robot.indexOf(robot);
  return [...lab.moment[column].subarray(2 * k, 2 * k + 2)];
};
function go(lab, steps) {
  for (let k = 0; k < steps; ++k) lab.stepForward();
}
/** One tick of a slider, with which everything but its own setting stays. */
function slide(lab) {
  const before = state(lab);
  lab.set("time_horizon", lab.info.options.time_horizon === 5 ? 4 : 5);
  assert.equal(lab.error, null);
  assert.deepEqual(state(lab), before);
}

test("a slider leaves robots, goals and moving obstacles where they are", () => {
  const lab = open();
  go(lab, 30);
  moveGoal(lab, 3, [5, 5]);
  removeRobot(lab, 2);
  addRobot(lab, [0, 12], [0, -12]);
  assert.deepEqual([...lab.moment.robot], [0, 1, 3, 4, 5, 6, 7, 8, 9]);
  slide(lab);
  go(lab, 10);
  slide(lab);
  assert.deepEqual(place(lab, 3, "goal"), [5, 5]);
  assert.ok(lab.run.handmade);
  const hash = lab.live.stateHash();
  lab.seek(0);
  assert.ok(!lab.run.handmade);
  lab.seek(4);
  assert.equal(lab.live.stateHash(), hash, "there again");
});

test("at the start what the text cannot say stays as well", () => {
  const lab = open();
  moveRobot(lab, 5, [1, 1]);
  slide(lab);
  removeRobot(lab, 7);
  slide(lab);
  moveRobot(lab, 0, [-8, 8]);  // in the text
  assert.match(lab.text, /position: \[ ?-8, 8 ?\]/);
  removeRobot(lab, 0);
  slide(lab);
  assert.deepEqual([...lab.moment.robot], [1, 2, 3, 4, 5, 6, 8]);
  assert.deepEqual(place(lab, 5), [1, 1]);
});

test("a robot of the list leaves the text, where nobody is numbered anew by that", () => {
  const lab = open();
  addRobot(lab, [0, 12], [0, -12]);
  go(lab, 5);
  slide(lab);
  addRobot(lab, [2, 12], [2, -12]);
  assert.ok(!lab.run.handmade, "the text says it");
  lab.seek(0);  // where the text does not have the second one yet
  removeRobot(lab, 0);
  assert.doesNotMatch(lab.text, /\[-9, 9\]/);
  assert.equal(lab.moment.robot.length, 9);
});

test("another method decides on the same state, without the certificate that it cannot have", () => {
  const lab = open(`certificate: braking_trajectories\n${SCENE}`);
  go(lab, 30);
  moveGoal(lab, 3, [5, 5]);
  const other = lab.live.carriedInto(withMethod(lab, "orca"), {});
  assert.equal(other.info().options.method, "orca");
  assert.deepEqual(state({ moment: other.moment() }), state(lab));
  assert.match(withMethod(lab, "avo"), /certificate: braking_trajectories/);
});

test("the text is that of the moment, back and forth", () => {
  const lab = open();
  const told = [];
  lab.on("text", () => told.push(lab.text));
  go(lab, 10);
  lab.set("time_horizon", 5);
  go(lab, 10);
  addWall(lab, [-30, -30], [-20, -30]);
  const [base, horizon, wall] = [SCENE, ...told];
  assert.match(horizon, /time_horizon: 5/);
  assert.match(wall, /polyline/);
  lab.seek(1.5);
  assert.deepEqual([lab.text, told.at(-1), lab.info.walls.length], [horizon, horizon, 0]);
  lab.seek(0.5);
  assert.deepEqual([lab.text, lab.info.options.time_horizon], [base, null]);
  lab.play();
  for (let k = 0; k < 60; ++k) lab.frame(0.05);
  assert.deepEqual([lab.text, told.at(-1), lab.info.walls.length], [wall, wall, 1], "it plays on over both");
  lab.pause();
  lab.seek(1.5);
  removeRobot(lab, 3);  // from here it goes another way, without the wall
  go(lab, 20);
  assert.deepEqual([lab.text, lab.info.walls.length], [horizon, 0]);
});

test("a robot that is parked is dragged with its goal", () => {
  const lab = open("version: 1\nrobots:\n  - {position: [0, 0], goal: [0, 0], parked: true}\n  - {position: [5, 0], goal: [9, 0]}\n");
  assert.ok(moveRobot(lab, 0, [1, 2]), lab.error?.message);
  assert.deepEqual(place(lab, 0, "goal"), [1, 2]);
});

test("a robot that is added after others have left is in the text as well", () => {
  const lab = open();
  go(lab, 5);
  addRobot(lab, [0, 12], [0, -12]);
  removeRobot(lab, 9);
  removeRobot(lab, 2);
  addRobot(lab, [2, 12], [2, -12]);
  assert.deepEqual([...lab.moment.robot], [0, 1, 3, 4, 5, 6, 7, 8, 10]);
  lab.set("robots.*.radius", 0.3);
  assert.equal(lab.error, null);
  assert.deepEqual(lab.info.robots.map(({ radius }) => radius), Array(9).fill(0.3));
});
