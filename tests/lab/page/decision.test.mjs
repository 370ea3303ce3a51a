// SPDX-License-Identifier: Apache-2.0
// Decisions as `avo explain --json` of the command line tells them, as the inspector reads and judges them.
import assert from "node:assert/strict";
import { test } from "node:test";
import { labelOf, minus, norm, parseDecision, violation, wallName } from "../../../lab/page/inspector/decision.ts";
import { why } from "../../../lab/page/inspector/why.ts";
import { avo } from "../data/native.mjs";

function explained(scene, robot, time, method = "avo") {
  const atOnce = method === "avo" ? ["--set", "response_time=0"] : [];  // the choice itself is told
  const { stdout, status, stderr } = avo("explain", scene, "--robot", robot, "--time", time, "--set", `method=${method}`, ...atOnce, "--json", "--quiet");
  assert.equal(status, 0, String(stderr));
  const decision = parseDecision(String(stdout));
  const law = { method, time_step: 0.1 };
  return { decision, law, found: why(decision, law, { walls: decision.walls }) };
}
const binding = ({ cuts }) => cuts.filter((cut) => cut.binds).map((cut) => cut.of).sort();
const discsOf = (decision) => [decision.acceleration_disc, decision.speed_disc].filter((disc) => disc !== null);

test("robot 5 of circle-10 at 8.4 s", () => {
  const { decision, found } = explained("circle-10", 5, 8.4);
  assert.deepEqual(binding(found), ["robots.4", "robots.6"]);
  assert.equal(decision.trace.rule, "keeps_right");
  assert.equal(decision.sentence, "Robot 5 keeps its velocity: it keeps to the right of robot 4 in traffic; the half-planes of robots 4 and 6 " +
    "bind. Braking keeps clear of all others (safe).");
});

test("what the paper's program chooses keeps to all half-planes, and rests on those that bind", () => {
  let bound = 0;
  for (const method of ["avo_paper", "orca"])
    for (const scene of ["crossing-streams", "uniform-100"])
      for (const [robot, time] of [[0, 6], [3, 7.5], [9, 9], [14, 11], [20, 5], [33, 8]]) {
        const { decision, found } = explained(scene, robot, time, method);
        const choices = found.cuts.filter((cut) => cut.forbids);
        if (decision.status !== "optimal") continue;
        const name = `${method} ${scene} ${robot} ${time}`;
        // exact: a choice that is not the wish, nor on a disc, rests on a line
        const onDisc = discsOf(decision).some(({ center, radius }) => Math.abs(norm(minus(decision.new_velocity, center)) - radius) < 1e-6);
        const isWish = norm(minus(decision.new_velocity, decision.preferred_velocity)) < 1e-6;
        if (!isWish && !onDisc) assert.ok(binding(found).length > 0, name);
        bound += binding(found).length > 0 ? 1 : 0;
        for (const cut of choices) assert.ok(violation(cut, decision.new_velocity) < 1e-6, name);
      }
  assert.ok(bound > 5, `${bound} decisions rest on half-planes`);
});

test("statuses and states in words", () => {
  const overlapping = explained("circle-100", 3, 22, "avo_paper");
  assert.equal(overlapping.decision.status, "overlapping");
  assert.match(overlapping.decision.sentence, /in contact .*robot 15 \(doomed\)\.$/);
  const union = explained("moving-obstacle", 0, 4, "velocity_obstacle");
  assert.deepEqual(binding(union.found), []);
  assert.match(union.decision.sentence, /goes around moving obstacle 0\./);
  const unsafe = explained("crossing-streams", 3, 8, "orca");
  assert.match(unsafe.decision.sentence, /misses them by the least, 0\.0\d+ m\/s, because of robots? /);
  const certified = explained("crossing-streams", 34, 10);
  assert.equal(certified.decision.status, "least_unsafe");
  assert.match(certified.decision.sentence, /0\.08\d* m\/s.*; the certificate holds\. .*\(safe\)\.$/);
});

test("half-planes of walls are those of the scene's walls, and only forbid where the method heeds them", () => {
  const { decision, found } = explained("doorway", 3, 9, "orca");
  const walls = [{ a: [9, 9], b: [9, 8], radius: 0 }, ...decision.walls.map(({ a, b, radius }) => ({ a: b, b: a, radius }))];
  assert.deepEqual(decision.walls.map((_, k) => wallName(decision, k, walls)), decision.walls.map((_, k) => `walls.${k + 1}`));
  assert.ok(found.cuts.some((cut) => cut.label === "obstacle 1" && cut.short === "w1"), "people read the obstacle's id");
  assert.equal(labelOf("walls.0", decision.walls), `obstacle ${decision.walls[0].obstacle}`);
  const moved = { ...decision, walls: [{ a: [0, 0], b: [1, 1], radius: 0, obstacle: 4 }, { a: [2, 2], b: [2, 2], radius: 1, robot: 7 }] };
  assert.deepEqual([wallName(moved, 0, walls), wallName(moved, 1, walls)], ["obstacles.4", "robots.7"]);
  assert.ok(found.cuts.some((cut) => cut.of.startsWith("walls.") && cut.forbids));
  const own = explained("doorway", 3, 9);
  for (const plane of own.decision.wall_half_planes) {
    const cut = own.found.cuts.find((other) => other.normal === plane.normal);
    assert.equal(cut.forbids, plane.kind === "speed");
  }
});
