// SPDX-License-Identifier: Apache-2.0
// Edits of a simulation, what an inspector asks of it, and that a call that throws changes nothing.
import assert from "node:assert/strict";
import { test } from "node:test";
import { builtin, library, refused, steps } from "./module.mjs";

const at = (moment, number) => {
  const k = moment.robot.indexOf(number);
  return [moment.position[2 * k], moment.position[2 * k + 1]];
};
const TWO = `version: 1
robots:
  - {position: [-8, 0], goal: [8, 0]}
  - {position: [8, 0.5], goal: [-8, 0]}
obstacles:
  - {polyline: [[-3, 8], [3, 8]]}
`;
const two = () => library.simulate(TWO, { name: "two" });

test("a moment has the numbers that were asked for", () => {
  const moment = steps(builtin("office"), 20).moment();
  const robots = moment.robot.length;
  assert.deepEqual([...moment.robot], Array.from({ length: robots }, (_, k) => k));
  for (const [name, each] of Object.entries({ position: 2, velocity: 2, goal: 2, heading: 1, acceleration: 1, status: 1, decided: 1, arrived: 1, clearance: 1 }))
    assert.equal(moment[name].length, each * robots, name);
  assert.equal(moment.steps, 20);
  assert.ok(Math.abs(moment.time - 2) < 1e-9);
  let least = Infinity; // two discs, by hand
  for (let i = 0; i < robots; ++i)
    for (let j = 0; j < i; ++j)
      least = Math.min(least, Math.hypot(moment.position[2 * i] - moment.position[2 * j], moment.position[2 * i + 1] - moment.position[2 * j + 1]));
  const radius = builtin("office").info().robots[0].radius;
  assert.ok(Math.abs(Math.min(...moment.clearance) - (least - 2 * radius)) < 1e-5);
  assert.ok(Math.max(...moment.acceleration) <= 1 + 1e-9 && Math.max(...moment.acceleration) > 0.5);
});

test("robots are added, moved and removed, and goals set", () => {
  const simulation = steps(two(), 10);
  const added = simulation.addRobot({ position: [0, -5], goal: [0, 5], radius: 0.3 });
  assert.equal(added, 2);
  simulation.moveRobot(1, 6, 3);
  simulation.setGoal(0, 4, -4);
  const moment = simulation.moment();
  assert.deepEqual(at(moment, 1), [6, 3]);
  assert.deepEqual([...moment.goal.subarray(0, 2)], [4, -4]);
  assert.equal(simulation.info().robots[2].radius, 0.3);
  steps(simulation, 200);
  const later = simulation.moment();
  for (const [number, goal] of [[0, [4, -4]], [1, [-8, 0]], [2, [0, 5]]])
    assert.ok(Math.hypot(...at(later, number).map((x, k) => x - goal[k])) < 0.5, `robot ${number} is at ${at(later, number)}`);
  simulation.removeRobot(1);
  assert.deepEqual([...simulation.moment().robot], [0, 2]);
});

test("obstacles come and go", () => {
  const simulation = steps(two(), 5);
  const wall = simulation.addObstacle("{polyline: [[0, -20], [0, 7.9]]}");
  assert.equal(wall, 1);
  assert.equal(simulation.info().walls.at(-1).obstacle, 1);
  steps(simulation, 60);
  assert.ok(at(simulation.moment(), 0)[0] < 0, "it is in the way");
  simulation.removeObstacle(wall);
  steps(simulation, 250);
  assert.ok(Math.hypot(at(simulation.moment(), 0)[0] - 8, at(simulation.moment(), 0)[1]) < 0.5, "no more");
});

test("a bad edit says what, and changes nothing", () => {
  const simulation = steps(two(), 12);
  const hash = simulation.stateHash();
  for (const [edit, says] of [
    [() => simulation.addRobot({ position: [0, 0], goal: [1, 1], radius: -1 }), /robots\.0\.radius: found -1/],
    [() => simulation.addRobot({ position: [0, 0], goal: [1, 1], speed: 1 }), /unknown key "speed"/],
    [() => simulation.removeRobot(9), /robot 9/],
    [() => simulation.setGoal(0, NaN, 0), /goal/],
    [() => simulation.moveRobot(9, 0, 0), /robot 9/],
    [() => simulation.moveRobot(0, Infinity, 0), /position/],
    [() => simulation.addObstacle("{disc: 1"), /obstacle:/],
    [() => simulation.addObstacle("{polyline: [[-7.6, 0], [-7, 0]]}"), /obstacle 1/],
    [() => simulation.removeObstacle(4), /obstacle 4/],
    [() => simulation.explain(7), /robot 7/],
    [() => simulation.outlines(7, [-2, -2, 2, 2]), /robot 7/],
  ]) {
    let message;
    assert.doesNotThrow(() => { message = refused(edit); }, String(edit));
    assert.match(message, says);
    assert.equal(simulation.stateHash(), hash);
  }
  assert.equal(steps(simulation, 30).stateHash(), steps(two(), 42).stateHash());
});

test("edits, back and forth lead to the same bits", () => {
  const simulation = steps(builtin("doorway"), 20);
  simulation.moveRobot(3, 5, 5);
  simulation.addRobot({ position: [-6, -6], goal: [6, 6] });
  simulation.removeRobot(1);
  const saved = simulation.save(), hash = simulation.stateHash();
  const there = steps(simulation, 40).stateHash();
  simulation.restore(saved);
  assert.equal(simulation.stateHash(), hash);
  assert.equal(steps(simulation, 40).stateHash(), there);
});

test("another scene's text takes over where everybody is", () => {
  const simulation = steps(builtin("circle-20"), 60);
  simulation.removeRobot(4);
  const text = library.builtinText("circle-20");
  const other = simulation.carriedInto(`${text}\nmethod: orca\n`, { name: "other" });
  const [before, after] = [simulation.moment(), other.moment()];
  assert.equal(other.info().options.method, "orca");
  assert.deepEqual([after.robot, after.position, after.velocity, after.goal], [before.robot, before.position, before.velocity, before.goal]);
  assert.match(refused(() => simulation.carriedInto("version: 2\n", { name: "bad" })), /^bad:1:/);
  for (const name of ["cars-100", "planes-12", "drives-100"]) {
    const moving = steps(builtin(name), 30);
    const carried = moving.carriedInto(library.builtinText(name), { name }).moment();
    assert.deepEqual(carried.position, moving.moment().position, name);
    if (name !== "drives-100") // whose discs swing about their axles
      carried.velocity.forEach((v, k) => assert.ok(Math.abs(v - moving.moment().velocity[k]) < 1e-9, `${name} ${k}`));
  }
});

test("the same text goes on with the same bits", () => {
  const names = library.builtinScenes().map(({ name }) => name).filter((name) => library.builtinText(name) && !/-1000/.test(name));
  const scenes = [...names, "circle-30"].map((name) => [name, library.builtinText(name)]);
  const free = "version: 1\nclock: free\ngroups:\n  - {number: 12, placement: {circle: {min_radius: 9}}, goals: antipodal}\n";
  const late = "version: 1\nsensing: {delay: 2, noise: {position: 0.01, velocity: 0.01}}\ngroups:\n  - {number: 12, placement: {circle: {min_radius: 9}}, goals: antipodal}\n";
  assert.ok(scenes.length > 12, `${scenes.length}`);
  for (const [name, text] of [...scenes, ["free", free], ["late", late]]) {
    const simulation = steps(library.simulate(text, { name }), 60);
    const other = simulation.carriedInto(text, { name });
    assert.equal(other.stateHash(), simulation.stateHash(), name);
    assert.equal(other.time, simulation.time, name);
    assert.equal(steps(other, 20).stateHash(), steps(simulation, 20).stateHash(), `${name}, later`);
  }
});

const MOVERS = `version: 1
robots:
  - {position: [-8, 0], goal: [8, 0]}
  - {position: [8, 6], goal: [-8, 6]}
moving_obstacles:
  - {position: [10, 1], velocity: [-1, 0], acceleration: [0.1, 0], radius: 0.4}
  - {position: [0, -6], velocity: [0, 0], radius: 0.3, max_speed: 1.3, max_deviation: 2, path: [[0, -5], [5, -5], [5, 5]]}
`;
const everything = ({ robot, position, velocity, goal, moving_obstacles }) => ({ robot, position, velocity, goal, moving_obstacles });

test("a changed text takes over moving obstacles, their ways, and goals that were set", () => {
  const name = "movers";
  const simulation = steps(library.simulate(MOVERS, { name }), 80);
  simulation.setGoal(0, 5, 5);
  let other = simulation.carriedInto(`${MOVERS}time_horizon: 4\n`, { name });
  assert.deepEqual(everything(other.moment()), everything(simulation.moment()));
  const [late, alone] = [steps(library.simulate(MOVERS, { name }), 300), steps(other, 220)];
  assert.deepEqual(alone.moment().moving_obstacles, late.moment().moving_obstacles, "they go on to the same points");
  other = steps(other.carriedInto(`${MOVERS}time_horizon: 5\n`, { name }), 100);
  assert.deepEqual(other.moment().moving_obstacles, steps(late, 100).moment().moving_obstacles, "also when taken over twice");
  // what the text says anew holds
  const elsewhere = MOVERS.replace("goal: [8, 0]", "goal: [7, 0]").replace("goal: [-8, 6]", "goal: [-7, 6]");
  assert.deepEqual([...simulation.carriedInto(elsewhere, { name }).moment().goal], [7, 0, -7, 6]);
  const turned = simulation.carriedInto(MOVERS.replace("[5, -5], [5, 5]", "[-5, -5]"), { name });
  assert.deepEqual(turned.moment().moving_obstacles, simulation.moment().moving_obstacles);
  assert.ok(steps(turned, 100).moment().moving_obstacles[4] < 0, "by its new path");
});

test("a changed text takes over who came and left", () => {
  const name = "two";
  const simulation = steps(two(), 10);
  simulation.removeRobot(1);
  simulation.addRobot({ position: [0, -5], goal: [0, 5], radius: 0.3 });
  simulation.removeRobot(simulation.addRobot({ position: [4, -5], goal: [4, 5] }));
  simulation.addRobot({ position: [-4, -5], goal: [-4, 5] });
  const other = simulation.carriedInto(`${TWO}time_horizon: 4\n`, { name });
  assert.deepEqual(everything(other.moment()), everything(simulation.moment()));
  assert.deepEqual(other.info().robots, simulation.info().robots);
  assert.equal(other.addRobot({ position: [0, 20], goal: [0, 20] }), 5, "numbers are not given twice");
  const more = TWO.replace("obstacles:", "  - {position: [1, 20], goal: [1, 21]}\nobstacles:");
  assert.deepEqual([...steps(two(), 10).carriedInto(more, { name }).moment().robot], [0, 1, 2]);
  const fewer = TWO.replace("  - {position: [8, 0.5], goal: [-8, 0]}\n", "");
  assert.deepEqual([...steps(two(), 10).carriedInto(fewer, { name }).moment().robot], [0]);
});

test("at the start a changed text has other starts, and leaves those that were moved by hand", () => {
  const name = "two";
  const simulation = two();
  simulation.moveRobot(1, 8, 3);
  simulation.setGoal(1, -8, 3);
  const other = simulation.carriedInto(TWO.replace("[-8, 0], goal", "[-9, 1], goal"), { name });
  const { position, goal } = other.moment();
  assert.deepEqual([[...position], [...goal]], [[-9, 1, 8, 3], [8, 0, -8, 3]]);
});

test("contacts are those of the clearances, and of walls and movers", () => {
  const crowd = library.simulate(`version: 1
method: velocity_obstacle
groups:
  - {number: 30, placement: {circle: {min_radius: 8}}, goals: antipodal}
`, { name: "crowd" });
  let contacts = 0;
  for (let k = 0; k < 100; ++k) {
    crowd.step();
    const found = crowd.contacts(), moment = crowd.moment();
    const touching = new Set(found.flatMap(({ a, b }) => [a, b]));
    moment.clearance.forEach((clearance, i) => {
      if (Math.abs(clearance) > 1e-6) assert.equal(touching.has(`robots.${moment.robot[i]}`), clearance < 0, `robot ${i}: ${clearance}`);
    });
    for (const { a, b, depth, x, y } of found) {
      const [p, q] = [a, b].map((name) => at(moment, Number(name.split(".")[1])));
      assert.ok(Math.abs(1 - Math.hypot(p[0] - q[0], p[1] - q[1]) - depth) < 1e-9);
      assert.ok(Math.hypot(x - (p[0] + q[0]) / 2, y - (p[1] + q[1]) / 2) < 1e-9);
    }
    contacts += found.length;
  }
  assert.ok(contacts > 10, `${contacts}`);
  const touching = library.simulate(`version: 1
robots:
  - {position: [0, 0], goal: [5, 0]}
obstacles:
  - {polyline: [[-2, 0.3], [2, 0.3]]}
moving_obstacles:
  - {position: [-0.6, 0], velocity: [0, 0], radius: 0.5}
`, { name: "touching" });
  assert.deepEqual(touching.contacts().map(({ a, b, depth }) => [a, b, Number(depth.toFixed(6))]),
    [["robots.0", "moving_obstacles.0", 0.4], ["robots.0", "obstacles.0", 0.2]]);
});

test("an inspector is told obstacles, what is admitted, and braking paths", () => {
  const simulation = steps(builtin("circle-20"), 70);
  const box = [-2.2, -2.2, 2.2, 2.2];
  let rings = 0, admitted = 0, refusedNodes = 0;
  for (let robot = 0; robot < 20; ++robot) {
    const decision = JSON.parse(simulation.explain(robot));
    const outlines = simulation.outlines(robot, box);
    const planes = new Set(decision.half_planes.map(({ neighbor }) => `robots.${neighbor}`));
    assert.deepEqual(new Set(outlines.map(({ of }) => of)), planes);
    rings += outlines.flatMap((outline) => outline.rings).length;
    const grid = simulation.admitted(robot, box, 45, 45);
    grid.forEach((is, k) => {
      const v = [-2.2 + 0.1 * (k % 45), -2.2 + 0.1 * Math.floor(k / 45)];
      if (is) assert.ok(Math.hypot(v[0], v[1]) <= 2 + 1e-9 && Math.hypot(v[0] - decision.velocity[0], v[1] - decision.velocity[1]) <= 0.1 + 1e-9);
    });
    const near = simulation.admitted(robot, [decision.velocity[0] - 0.1, decision.velocity[1] - 0.1, decision.velocity[0] + 0.1, decision.velocity[1] + 0.1], 21, 21);
    admitted += near.filter((is) => is === 1).length;
    refusedNodes += near.filter((is) => is === 0).length;
    const [own, ...others] = simulation.brakingPaths(robot);
    assert.equal(own.of, `robots.${robot}`);
    assert.deepEqual(own.points.slice(0, 2), decision.position);
    const speed = Math.hypot(...decision.velocity), length = Math.hypot(own.points.at(-2) - own.points[0], own.points.at(-1) - own.points[1]);
    assert.ok(Math.abs(length - speed * speed / 2) < 0.02, `${length} m from ${speed} m/s`);
    assert.equal(others.length, decision.neighbors.length);
    // where the invariant holds, all who brake now keep clear of this one
    for (const other of others.filter(({ of }) => planes.has(of))) {
      for (let k = 0; k < Math.max(own.points.length, other.points.length); k += 2) {
        const [p, q] = [own.points, other.points].map((points) => points.slice(Math.min(k, points.length - 2)).slice(0, 2));
        assert.ok(Math.hypot(p[0] - q[0], p[1] - q[1]) >= own.radius + other.radius - 1e-6, `${own.of} and ${other.of}`);
      }
    }
  }
  assert.ok(rings > 20 && admitted > 100 && refusedNodes > 100, `${rings} rings, ${admitted} admitted, ${refusedNodes} refused`);
  const plane = steps(builtin("planes-12"), 20);
  assert.equal(plane.brakingPaths(0)[0].points.length, 98, "a circle");
});

test("the summary is that of avo run --json", () => {
  const simulation = builtin("circle-20", { metrics: true });
  steps(simulation, 100);
  const summary = JSON.parse(simulation.summary());
  assert.equal(summary.steps, 100);
  assert.ok(summary.min_clearance > 0);
  assert.equal(builtin("circle-20").summary(), "null");
});
