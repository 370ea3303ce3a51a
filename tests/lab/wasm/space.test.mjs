// SPDX-License-Identifier: Apache-2.0
// Scenes of space in the module: the same bits, summaries and words as the command line.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { test } from "node:test";
import { cutOfPair } from "../../../lab/page/inspector/cut.ts";
import { dot3, minus3, norm3, plus3, times3 } from "../../../lab/page/map/vec3.ts";
import { library, native, refused, steps } from "./module.mjs";

const EXAMPLES = new URL("../examples/space/", `file://${process.env.AVO_LAB}`);
const example = (name) => readFileSync(fileURLToPath(new URL(`${name}.yaml`, EXAMPLES)), "utf8");
const DRONES = `version: 1
space: 3
groups:
  - {count: 30, sphere: {radius: 6}, goal: antipodal, jitter: 0.2, vertical: 0.7, downwash: 1.2}
obstacles: [{floor: -8.5}, {box: {min: [-1, -1, -1], max: [1, 1, 1], heading: 0.4}}]
`;
const SCENES = { drones: DRONES, window: example("window"), building: example("building"), helicopter: example("helicopter") };
const SECONDS = 3;

/** The summary without the times that steps took. */
const untimed = (summary) => JSON.parse(JSON.stringify(summary, (key, value) => (/milliseconds|step_ms/.test(key) ? undefined : value)));

for (const [name, yaml] of Object.entries(SCENES)) {
  const file = `${name}.yaml`;
  writeFileSync(file, yaml);
  test(`${name}: the bits and the summary of avo run`, () => {
    const table = `${name}.csv`;
    const told = native(process.env.AVO_BINARY, ["run", file, "--duration", String(SECONDS), "--record", table, "--json"]);
    const simulation = library.simulate(yaml, { name: file, metrics: true, overrides: [`duration=${SECONDS}`] });
    assert.equal(simulation.dimensions, 3);
    while (simulation.canStep()) simulation.step();
    const summary = JSON.parse(told);
    assert.equal(simulation.steps, summary.steps);
    const { position, velocity } = simulation.moment();
    const rows = readFileSync(table, "utf8").trim().split("\n").slice(-summary.robots).map((row) => row.split(",").map(Number));
    assert.deepEqual(rows.map((row) => row.slice(2, 5)).flat(), [...position]);
    assert.deepEqual(rows.map((row) => row.slice(5)).flat(), [...velocity]);
    assert.deepEqual(untimed(JSON.parse(simulation.summary())), untimed(summary));
  });
}

test("a decision is told as avo explain tells it, to the byte, and changes nothing", () => {
  const simulation = library.simulate(DRONES, { name: "drones.yaml" });
  for (const seconds of [0, 1.5, 3]) {
    while (simulation.time < seconds - 1e-9) simulation.step();
    const hash = simulation.stateHash();
    for (const robot of [0, 11, 29]) {
      const told = native(process.env.AVO_BINARY, ["explain", "drones.yaml", "--robot", String(robot), "--time", String(seconds), "--json"]);
      assert.equal(simulation.explain(robot), told);
    }
    assert.equal(simulation.stateHash(), hash);
  }
});

test("a decision beside moving obstacles and with errors of sensing is told, too", () => {
  const yaml = SCENES.helicopter + "sensing: {noise: {position: 0.02, velocity: 0.04}, delay: 1}\n";
  const simulation = steps(library.simulate(yaml), 120);
  const told = Array.from({ length: 24 }, (_, robot) => JSON.parse(simulation.explain(robot)));
  assert.ok(told.some(({ neighbors }) => neighbors.some(({ neighbor }) => neighbor === "moving_obstacles.0")));
  const { velocity } = steps(simulation, 1).moment();
  told.forEach(({ next_velocity }, robot) => assert.deepEqual([...velocity.slice(3 * robot, 3 * robot + 3)], next_velocity));
});

test("a state can be kept, and gone back to", () => {
  const simulation = steps(library.simulate(DRONES), 10);
  const kept = simulation.save();
  const after = steps(simulation, 15).stateHash();
  simulation.restore(kept);
  assert.equal(simulation.steps, 10);
  assert.equal(steps(simulation, 15).stateHash(), after);
});

test("a moment: three numbers for a vector, goals, clearances with downwash", () => {
  const simulation = library.simulate(`version: 1
space: 3
arrival_distance: 0.4
robots:
  - {position: [0, 0, 5], goal: [9, 0, 5], downwash: 2}
  - {position: [0, 0, 1], goal: [0, 0, 1]}
moving_obstacles: [{position: [30, 0, 1], velocity: [-1, 0, 0], radius: 0.7}]
`);
  const { dimensions, position, goal, clearance, arrived, moving_obstacles, heading, decided } = simulation.moment();
  assert.equal(dimensions, 3);
  assert.deepEqual([...position], [0, 0, 5, 0, 0, 1]);
  assert.deepEqual([...goal], [9, 0, 5, 0, 0, 1]);
  assert.deepEqual([...clearance], [1, 1]);  // 4 m between centers, less 2 m of air and both radii
  assert.deepEqual([...arrived], [0, 1]);
  assert.deepEqual([...moving_obstacles], [30, 0, 1, -1, 0, 0]);
  assert.deepEqual([...heading, ...decided], [0, 0, 0, 0]);
  assert.deepEqual([...steps(simulation, 1).moment().decided], [1, 1]);
  assert.deepEqual(simulation.contacts(), []);
  assert.equal(simulation.allAtGoal(), false);
});

test("the certificate admits what the decision takes, and nothing beyond one step", () => {
  const simulation = steps(library.simulate(DRONES), 30);
  const { velocity } = simulation.moment();
  const reach = 0.1;  // m/s: a_max and the time step
  let refusedNodes = 0;
  for (let robot = 0; robot < 30; ++robot) {
    const { next_velocity } = JSON.parse(simulation.explain(robot));
    const around = (place, size) => simulation.admittedInCut(robot, { place, along: [1, 0, 0], across: [0, 0, 1] }, [-size, -size, size, size], 9, 9);
    assert.equal(around(next_velocity, 1e-12)[40], 1, `robot ${robot}`);
    const own = [...velocity.slice(3 * robot, 3 * robot + 3)], nodes = around(own, 2 * reach);
    assert.equal(nodes.length, 81);
    for (const corner of [0, 8, 72, 80]) assert.equal(nodes[corner], 0);
    const near = around(own, 0.3 * reach);
    refusedNodes += near.length - near.reduce((sum, node) => sum + node, 0);
  }
  assert.ok(refusedNodes > 20, `${refusedNodes} velocities within limits are refused`);
});

// A half-space takes half of what the obstacle demands, as all robots are alike. Its normal is that of least support.
test("the half-space of a neighbor touches its obstacle, which lies beyond it", () => {
  const simulation = steps(library.simulate(DRONES.replace(", vertical: 0.7, downwash: 1.2", "")), 25);
  const step = 4 / 1000;  // m/s: outlines are as exact
  let found = 0;
  for (let robot = 0; robot < 30; robot += 3) {
    const decision = JSON.parse(simulation.explain(robot));
    for (const { neighbor, normal, offset } of decision.half_spaces) {
      const plane = cutOfPair(decision, neighbor);
      const cut = { place: times3(plane.offset, plane.normal), along: plane.along, across: plane.across };
      const [x, y] = [plane.along, plane.across].map((axis) => dot3(decision.velocity, axis));
      const rings = simulation.outlineInCut(robot, `robots.${neighbor}`, cut, [x - 4, y - 4, x + 4, y + 4]);
      const demands = 2 * (offset - dot3(normal, decision.velocity));  // m/s
      // within reach, D(v, δ a_max)
      const reaches = rings.flat().map(([a, b]) => minus3(plus3(cut.place, plus3(times3(a, cut.along), times3(b, cut.across))), decision.velocity))
        .filter((w) => norm3(w) <= 2 * 1.0).map((w) => dot3(normal, w));
      if (reaches.length === 0) continue;
      const most = Math.max(...reaches);
      assert.ok(most <= demands + 4 * step, `robot ${robot}, ${neighbor}: ${most} ${demands}`);
      if (most > demands - 4 * step) ++found;
    }
  }
  assert.ok(found > 30, `${found} obstacles are touched`);
});

test("there is no outline with downwash, of nobody, nor of what accelerates", () => {
  const outline = (simulation, other) => simulation.outlineInCut(0, other, { place: [0, 0, 0], along: [1, 0, 0], across: [0, 0, 1] }, [-3, -3, 3, 3]);
  assert.deepEqual(outline(library.simulate(DRONES), "robots.1"), []);
  const two = (more) => library.simulate(`version: 1\nspace: 3\nrobots:\n  - {position: [0, 0, 0], goal: [9, 0, 0]}\nmoving_obstacles:\n  - {position: [3, 0, 0]${more}}\n`);
  assert.deepEqual(outline(two(""), "robots.1"), []);
  assert.deepEqual(outline(two(", acceleration: [0, 0, 0.1]"), "moving_obstacles.0"), []);
  const [ring] = outline(two(""), "moving_obstacles.0");
  assert.ok(ring.length > 20 && ring.every(([x]) => x > 0.5), "the robot may stay");
});

test("braking paths end at rest, after as long a way as the limits ask for", () => {
  const simulation = steps(library.simulate(SCENES.helicopter), 120);
  const { position, velocity } = simulation.moment();
  const [own, ...others] = simulation.brakingPaths(0);
  assert.equal(own.of, "robots.0");
  assert.equal(others.at(-1).of, "moving_obstacles.0");
  for (const { of, points, radius } of [own, ...others.slice(0, -1)]) {
    const robot = Number(of.slice("robots.".length)), of3 = (from, k) => [...from.slice(3 * k, 3 * k + 3)];
    const way = minus3(of3(points, points.length / 3 - 1), of3(position, robot)), speed = norm3(of3(velocity, robot));
    assert.deepEqual([points.slice(0, 3), radius], [of3(position, robot), 0.4]);
    // the mean speed of each step: as in continuous time at 1 m/s², and a little more
    assert.ok(norm3(way) >= speed ** 2 / 2 - 1e-9 && norm3(way) <= speed ** 2 / 2 + 0.00126, `${of}: ${norm3(way)} from ${speed}`);
    assert.ok(dot3(way, of3(velocity, robot)) > (1 - 1e-9) * norm3(way) * speed);
  }
  assert.equal(others.at(-1).points.length, own.points.length);
  const flat = steps(library.simulate("version: 1\nspace: 3\nrobots:\n  - {position: [0, 0, 0], velocity: [0, 0, 1], goal: [0, 0, 9], vertical: 0.5}\n"), 0);
  assert.ok(Math.abs(flat.brakingPaths(0)[0].points.at(-1) - 1.0) < 1e-9, "1 m/s upwards, at 0.5 m/s²");
});

test("contacts: two balls, the air below a ball, a box", () => {
  const none = "certificate: none\nnavigation: false\n";
  const drive = (robots, more = "") => {
    const simulation = library.simulate(`version: 1\nspace: 3\n${none}time_horizon: 0.1\n${more}robots:\n${robots}`);
    for (let k = 0; k < 60 && simulation.contacts().length === 0; ++k) simulation.step();
    return simulation.contacts()[0];
  };
  const speeds = "velocity: [0, 0, 0], max_acceleration: 5";
  const head = drive(`  - {position: [-3, 0, 2], goal: [3, 0, 2], ${speeds}}\n  - {position: [3, 0, 2], goal: [-3, 0, 2], ${speeds}}\n`);
  assert.deepEqual([head.a, head.b, head.y, head.z], ["robots.0", "robots.1", 0, 2]);
  assert.ok(Math.abs(head.x) < 0.2 && head.depth > 0 && head.depth < 1, JSON.stringify(head));
  const under = drive(`  - {position: [0, 0, 3], goal: [0, 0, 3], downwash: 2}\n  - {position: [-3, 0, 1.5], goal: [3, 0, 1.5], ${speeds}}\n`);
  assert.deepEqual([under.a, under.b], ["robots.0", "robots.1"]);
  assert.ok(Math.abs(under.z - 1.5) < 1e-9, "at the height of the lower robot");
});

test("what space does not have is refused, and so is what is wrong", () => {
  const simulation = library.simulate(DRONES);
  const place = "space: found 3, must be 2 for this";
  for (const asked of [() => simulation.setGoal(0, 1, 1), () => simulation.admitted(0, [0, 0, 1, 1], 2, 2),
    () => simulation.outlines(0, [0, 0, 1, 1]), () => simulation.removeRobot(0)]) assert.equal(refused(asked), place);
  assert.match(refused(() => simulation.carriedInto(DRONES)), /space: found 3, must be 2 for a text that takes over/);
  assert.match(refused(() => library.simulate(DRONES.replace("space: 3", "space: 4"), { name: "a.yaml" })), /^a\.yaml:2:8: space: found 4, must be 2 or 3$/);
  assert.match(refused(() => library.simulate(DRONES.replace("jitter", "jiter"), { name: "a.yaml" })), /^a\.yaml:4:.*jiter/);
  assert.equal(simulation.steps, 0);
});
