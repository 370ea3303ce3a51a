// SPDX-License-Identifier: Apache-2.0
// Edits of a scene's text: what they are about changes, and every other byte stays.
import assert from "node:assert/strict";
import { test } from "node:test";
import { parse } from "yaml";
import { flow, hasMoreRobots, robotsListed, valueAt, withEntry, withRobotKey, withValue } from "../../../lab/page/text/scene_text.ts";
import { withoutWall, withWallMoved } from "../../../lab/page/text/wall_text.ts";
import { library } from "../wasm/module.mjs";

const SCENE = `# a scene
version: 1
name: two   # of them
time_horizon: 3.0     # s
robots:
  - {position: [-8, 0], goal: [8, 0]}    # the first
  # in between
  - position: [8, 0.3]
    goal: [-8, 0]
obstacles:
  - {polyline: [[-3, 8], [3, 8], [3, 12]]}   # a corner
  - wkt: "LINESTRING (0 1, 2 3)"
  - {disc: {center: [5, 5], radius: 1}}
groups:
  - number: 3
    placement: {line: {from: [0, 0], to: [9, 0]}}
    goals: antipodal
`;

/** The lines that differ, as "-old" and "+new". */
function changes(before, after) {
  const [old, now] = [before.split("\n"), after.split("\n")];
  return [...old.filter((line) => !now.includes(line)).map((line) => `-${line}`),
    ...now.filter((line) => !old.includes(line)).map((line) => `+${line}`)];
}

test("a value that is there is replaced, and its comment stays", () => {
  assert.deepEqual(changes(SCENE, withValue(SCENE, "time_horizon", 5)), ["-time_horizon: 3.0     # s", "+time_horizon: 5     # s"]);
  assert.deepEqual(changes(SCENE, withValue(SCENE, "robots.0.position", [1, 2])),
    ["-  - {position: [-8, 0], goal: [8, 0]}    # the first", "+  - {position: [1, 2], goal: [8, 0]}    # the first"]);
});

test("a new key stands among those of its kind", () => {
  assert.deepEqual(changes(SCENE, withValue(SCENE, "method", "orca")), ["+method: orca"]);
  assert.deepEqual(changes(SCENE, withValue(SCENE, "robots.1.radius", 0.4)), ["+    radius: 0.4"]);
  assert.equal(valueAt(withValue(SCENE, "robots.0.radius", 0.4), "robots.0.radius"), 0.4);
});

test("undefined takes a key, an entry or the last entry's list out", () => {
  assert.deepEqual(changes(SCENE, withValue(SCENE, "time_horizon", undefined)), ["-time_horizon: 3.0     # s"]);
  assert.equal(withValue(SCENE, "method", undefined), SCENE);
  assert.equal(withValue("version: 1  # alone\n", "version", undefined), "");
  assert.equal(withValue("car:\n  reverse: true\n", "car.reverse", undefined), "car: {}\n");
  const one = withValue(SCENE, "robots.0", undefined);
  assert.deepEqual(parse(one).robots, [parse(SCENE).robots[1]]);
  assert.equal(parse(withValue(one, "robots.0", undefined)).robots, undefined);
});

test("entries are added to lists in either form, and to lists that are not there", () => {
  const robot = { position: [1, 2], goal: [3, 4] };
  assert.deepEqual(changes(SCENE, withEntry(SCENE, "robots", robot)), ["+  - {position: [1, 2], goal: [3, 4]}"]);
  assert.deepEqual(parse(withEntry(SCENE, "robots", robot)).robots[2], robot);
  assert.deepEqual(parse(withEntry("a: [1, 2]\n", "a", 3)).a, [1, 2, 3]);
  assert.deepEqual(parse(withEntry("version: 1", "obstacles", { polyline: [[0, 0], [1, 0]] })), { version: 1, obstacles: [{ polyline: [[0, 0], [1, 0]] }] });
  assert.deepEqual(parse(withEntry("a: []\nb: 2\n", "a", 1)), { a: [1], b: 2 });
});

test("a key of all robots comes to those of the list and of the groups", () => {
  const { robots, groups } = parse(withRobotKey(SCENE, "radius", 0.4));
  assert.deepEqual([...robots, ...groups].map(({ radius }) => radius), [0.4, 0.4, 0.4]);
  assert.equal(robotsListed(SCENE), 2);
  assert.ok(hasMoreRobots(SCENE));
});

test("a key of ten thousand robots", () => {  // how soon it comes, scripts/lab-check tells
  const yaml = `version: 1\nrobots:\n${"  - {position: [-8, 0], goal: [8, 0]}\n".repeat(10000)}`;
  assert.equal(withRobotKey(yaml, "radius", 0.4), yaml.replaceAll("}", ", radius: 0.4}"));
});

test("a word that ends with a space, and JSON", () => {
  assert.equal(withValue("{\"version\": 1}", "method", "orca"), '{"version": 1, "method": "orca"}');
  assert.equal(withValue("version: 1\n", "name", "a "), 'version: 1\nname: "a "\n');
});

test("the next entry of a list in lines has a line of its own", () => {
  const list = "obstacles: [\n  {disc: {center: [0, 0], radius: 1}}   # one\n]\n";
  assert.equal(withEntry(list, "obstacles", { wkt: "x" }), "obstacles: [\n  {disc: {center: [0, 0], radius: 1}},   # one\n  {wkt: x}\n]\n");
  assert.equal(withValue(withEntry(list, "obstacles", 1), "obstacles.1", undefined), list);
});

test("a value in lines of its own comes to its key", () => {
  const robot = "robots:\n  - position:   # m\n    - 1\n    - 2\n    goal: [0, 0]\n";
  assert.equal(withValue(robot, "robots.0.position", [3, 4]), "robots:\n  - position: [3, 4]   # m\n    goal: [0, 0]\n");
});

test("keys without a value get one", () => {
  assert.equal(withEntry("version: 1\nobstacles:   # none\nname: a\n", "obstacles", 1), "version: 1\nobstacles:   [1] # none\nname: a\n");
  assert.equal(withValue("sensing:\nversion: 1\n", "sensing.noise.position", 0.1), "sensing: {noise: {position: 0.1}}\nversion: 1\n");
  assert.throws(() => withValue("version: 1", "robots.0.position", [1, 2]), { message: "the scene has nothing at robots.0" });
});

test("numbers have no noise, and words that YAML would take for something else are quoted", () => {
  assert.equal(flow({ a: 0.1 + 0.2, b: ["no", "a word", "1: 2", true] }), '{a: 0.3, b: ["no", a word, "1: 2", true]}');
  for (const text of ["true", "null", "1", "- x", "#", "", "a: b"]) assert.equal(parse(flow(text)), text);
});

const wall = (a, b, radius = 0) => ({ a, b, radius, obstacle: 0 });

test("walls are moved, whole or by one end, whatever they are written as", () => {
  const corner = wall([-3, 8], [3, 8]);
  assert.deepEqual(parse(withWallMoved(SCENE, corner, null, 1, -2)).obstacles[0].polyline, [[-2, 6], [4, 6], [4, 10]]);
  assert.deepEqual(parse(withWallMoved(SCENE, corner, [3, 8], 1, 0.5)).obstacles[0].polyline, [[-3, 8], [4, 8.5], [3, 12]]);
  assert.equal(parse(withWallMoved(SCENE, wall([0, 1], [2, 3]), [2, 3], 1, 1)).obstacles[1].wkt, "LINESTRING (0 1, 3 4)");
  assert.deepEqual(parse(withWallMoved(SCENE, wall([5, 5], [5, 5], 1), null, 1, 1)).obstacles[2].disc.center, [6, 6]);
  assert.equal(withWallMoved(SCENE, wall([50, 50], [60, 60]), null, 1, 1), null, "a wall of a map");
  assert.equal(parse(withoutWall(SCENE, corner)).obstacles.length, 2);
});

test("a wall is that of its number and its thickness, where others have the same points", () => {
  const scene = `version: 1
robots:
  - {position: [-8, 0], goal: [8, 0]}
obstacles:
  - {polyline: [[0, 5], [3, 5]]}
  - {disc: {center: [0, 5], radius: 1}}
  - {disc: {center: [0, 5], radius: 0.25}}
  - {wkt: "LINESTRING (0 5, +3 5)"}
`;
  const { walls } = library.simulate(scene).info();
  for (const one of walls) {
    const kept = parse(scene).obstacles.filter((_, k) => k !== one.obstacle);
    assert.deepEqual(parse(withoutWall(scene, one)).obstacles, kept);
    const moved = library.simulate(withWallMoved(scene, one, null, 0, 1)).info().walls;
    assert.deepEqual(moved, walls.map((each) => (each === one ? { ...each, a: [each.a[0], 6], b: [each.b[0], 6] } : each)));
  }
  const text = withoutWall(scene, walls[0]);  // and the run goes back to when it was there
  assert.deepEqual(parse(withoutWall(text, walls[2])).obstacles.map((each) => Object.keys(each)[0]), ["disc", "wkt"]);
  assert.equal(parse(withoutWall(text, walls[2])).obstacles[0].disc.radius, 1);
});

test("an error says first what was probably meant", () => {
  const refused = (from, to) => {
    try {
      library.simulate(SCENE.replace(from, to), { name: "s" });
    } catch (error) {
      return error.message;
    }
    return "nothing was refused";
  };
  assert.match(refused("time_horizon:", "time_horzon:"),
    /found the unknown key "time_horzon", did you mean "time_horizon"\? Allowed are version, .*, \w+$/);
  assert.match(refused("goals: antipodal", "goals: antipodl"), /found "antipodl", did you mean "antipodal"\? Must be one of /);
  assert.match(refused("number: 3", "number: -3"), /^s:\d+:\d+: groups.0.number: found -3, must be /);
});
