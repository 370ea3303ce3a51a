// SPDX-License-Identifier: Apache-2.0
// The tour: its scenes run, its controls are keys of scenes, and what it claims is so, by the command line.
import assert from "node:assert/strict";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { TOUR } from "../../../lab/page/guide/tour_steps.ts";
import { avo } from "../data/native.mjs";

const FILE = join(mkdtempSync(join(tmpdir(), "avo-tour-")), "tour.yaml");
const library = { builtinText: (name) => String(avo("scenes", name).stdout) };

function summary(step, ...options) {
  writeFileSync(FILE, TOUR[step].scene(library));
  const { status, stdout, stderr } = avo("run", FILE, "--json", "--quiet", ...options);
  assert.equal(status, 0, String(stderr));
  return JSON.parse(String(stdout));
}

test("every step explains its robot at its time, also at the ends of its controls", () => {
  assert.equal(TOUR.length, 6);
  TOUR.forEach((step, k) => {
    writeFileSync(FILE, step.scene(library));
    const settings = step.tries.flatMap(({ path, range, words }) =>
      (words ?? [range.least, range.start, range.most]).map((value) => `${path}=${value}`));
    for (const setting of settings) {
      const { status, stderr } = avo("explain", FILE, "--robot", step.robot, "--time", step.time, "--set", setting, "--json");
      assert.equal(status, 0, `step ${k + 1}, ${setting}: ${stderr}`);
    }
  });
});

/** How far the velocity that the robot of the step chooses is from the preferred one, m/s. */
function turnedAside(step, text) {
  writeFileSync(FILE, text);
  const { status, stdout, stderr } = avo("explain", FILE, "--robot", step.robot, "--time", step.time, "--json");
  assert.equal(status, 0, String(stderr));
  const { new_velocity, preferred_velocity } = JSON.parse(String(stdout));
  return Math.hypot(new_velocity[0] - preferred_velocity[0], new_velocity[1] - preferred_velocity[1]);
}

test("in the first two steps the robot turns aside, because of the obstacle", () => {
  for (const step of TOUR.slice(0, 2)) {
    const text = step.scene(library);
    const alone = text.replace(/moving_obstacles:\n.*\n/, "");
    assert.notEqual(alone, text);
    assert.ok(turnedAside(step, text) > 0.5, `${step.title}: ${turnedAside(step, text)} m/s`);
    assert.ok(turnedAside(step, alone) < 1e-9, `${step.title} without it: ${turnedAside(step, alone)} m/s`);
  }
});

test("the velocity obstacle asks for more than a_max, the acceleration-velocity obstacle does not; neither is touched", () => {
  const [first, second] = [summary(0), summary(1)];
  assert.ok(first.max_acceleration > 5, String(first.max_acceleration));
  assert.ok(second.max_acceleration <= 1 + 1e-9, String(second.max_acceleration));
  assert.deepEqual([first.mover_collisions, second.mover_collisions], [0, 0]);
  assert.ok(first.arrived === 1 && second.arrived === 1);
});

test("two robots exchange places without a contact", () => {
  const { collision_pairs, arrived } = summary(2);
  assert.deepEqual([collision_pairs, arrived], [0, 2]);
});

test("the dense streams collide by the paper's method and by orca, and by avo never", () => {
  const paper = summary(4, "--duration", "20"), orca = summary(4, "--duration", "30", "--set", "method=orca");
  assert.ok(paper.collision_pairs > 0 && Math.abs(paper.first_collision_time - 13) < 1, JSON.stringify(paper.first_collision_time));
  assert.ok(paper.decisions.least_unsafe > 0 && paper.decisions.overlapping > 0);
  assert.ok(orca.collision_pairs > 0 && orca.max_acceleration > 16, String(orca.max_acceleration));
  const own = summary(5);
  assert.equal(own.collision_pairs, 0);
  assert.ok(own.max_acceleration <= 1 + 1e-9 && own.decisions.refused > 0);
});
