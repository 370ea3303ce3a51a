// SPDX-License-Identifier: Apache-2.0
// Every edit of a scene in every form that its text may have: the library reads just that change, and the rest of the
// text is as it was.
import assert from "node:assert/strict";
import { test } from "node:test";
import { parse } from "yaml";
import { withEntry, withRobotKey, withValue } from "../../../lab/page/text/scene_text.ts";
import { library } from "../wasm/module.mjs";

const BLOCK = `version: 1   # the format
name: some
time_horizon: 3.0     # s
robots:
  # the first
  - {position: [-8, 0], goal: [8, 0]}    # goes right

  - position: [8, 0.3]   # goes left
    # to there
    goal: [-8, 0]
  - goal: [0, -9]
    position:   # m
      - 0
      - 9
obstacles:
  - {polyline: [[-3, 8], [3, 8], [3, 12]]}   # a corner
  - disc:
      center: [5, 5]
      radius: 1
  # no more
`;
const FLOW = `{version: 1, name: some, time_horizon: 3, robots: [{position: [-8, 0], goal: [8, 0]},
  {position: [8, 0.3], goal: [-8, 0], }, # goes left
  {position: [0, 9], goal: [0, -9]} # goes down
], obstacles: [{polyline: [[-3, 8], [3, 8]]}, disc: {center: [5, 5], radius: 1}, ] # no more
}
`;
const LINES = `# flow
{
  version: 1,   # the format
  time_horizon: 3,  # s
  robots: [
    # the first
    {position: [-8, 0], goal: [8, 0]},   # goes right
    {
      position: [8, 0.3],
      goal: [-8, 0]   # to there
    },
    {position: [0, 9], goal: [0, -9]}   # goes down
  ],
  obstacles: [
    {polyline: [[-3, 8], [3, 8]]},
  ]  # no more
}
`;
const COMMAS = `{ "version": 1
, "time_horizon": 3
, robots:
  [ {position: [-8, 0], goal: [8, 0]}
  , {position: [8, 0.3], goal: [-8, 0]} # goes left
  , {position: [0, 9], goal: [0, -9]}
  ]
, 'obstacles': [ {disc: {center: [5, 5], radius: 1}}
  ]
}`;
const DENSE = `"time_horizon": 3
'robots':
- position:
  - -8
  - 0
  goal: [8, 0]
-
  position: [8,
    0.3]
  goal: [-8, 0]   # to there
- goal: [0, -9]
  position: [0, 9]
# walls
obstacles:
- wkt: |
    LINESTRING (-3 8, 3 8)

- ? disc
  : center: [5, 5]
    radius: 1
? version
: 1`;
const PLAIN = parse(BLOCK);
const without = (scene, ...keys) => Object.fromEntries(Object.entries(scene).filter(([key]) => !keys.includes(key)));
const noWalls = BLOCK.slice(0, BLOCK.indexOf("obstacles"));

const SHAPES = {
  BLOCK, FLOW, LINES, COMMAS, DENSE,
  "no walls": noWalls,
  "no walls, an end": `%YAML 1.2\n---   # begins\n${noWalls}...\n# behind`,
  "no end of the last line": BLOCK.trimEnd().replace(/\n.*$/, ""),
  "an empty list": `${noWalls}obstacles: []   # none\n`,
  "an empty list, in the middle": `obstacles: [ # none\n  ]\n${noWalls}`,
  "indented": BLOCK.replace(/^(?=.)/gm, "   "),
  "indented, no walls": `\n${noWalls.replace(/^(?=.)/gm, "  ")}`,
  "CRLF": BLOCK.replace(/\n/g, "\r\n"),
  "CRLF in flow": LINES.replace(/\n/g, "\r\n"),
  "CR": BLOCK.replace(/\n/g, "\r"),
  "BOM": `\ufeff${BLOCK}`,
  "BOM and CRLF, no walls": `\ufeff${noWalls.replace(/\n/g, "\r\n")}`,
  "BOM in flow": `\ufeff${FLOW}`,
  "BOM and dense": `\ufeff${DENSE}`,
  "flow behind dashes": `--- ${FLOW}...\n`,
  "JSON": JSON.stringify(PLAIN),
  "JSON, no walls": JSON.stringify(without(PLAIN, "obstacles")),
  "pretty JSON": `${JSON.stringify(PLAIN, null, 2)}\n`,
  "pretty JSON, no walls": JSON.stringify(without(PLAIN, "obstacles"), null, "\t"),
};

const robot = { position: [20, 1], goal: [-20, 2], radius: 0.25 };
const wall = { polyline: [[-6, -7], [-5.5, -7]] };
const each = (scene, change) => ({ ...scene, robots: scene.robots.map(change) });
const at = (k, change) => (scene) => each(scene, (known, i) => (i === k ? change(known) : known));

/** The text, and what a scene comes to. */
const EDITS = {
  "another value": [(yaml) => withValue(yaml, "time_horizon", 5), (scene) => ({ ...scene, time_horizon: 5 })],
  "a new word": [(yaml) => withValue(yaml, "method", "orca_clamped"), (scene) => ({ ...scene, method: "orca_clamped" })],
  "no value": [(yaml) => withValue(yaml, "time_horizon", undefined), (scene) => without(scene, "time_horizon")],
  "no version": [(yaml) => withValue(yaml, "version", undefined), (scene) => without(scene, "version")],
  "new keys in each other": [(yaml) => withValue(yaml, "sensing.noise.position", 0.02), (scene) => ({ ...scene, sensing: { noise: { position: 0.02 } } })],
  "a robot, and not": [(yaml) => withValue(withEntry(yaml, "robots", robot), "robots.3", undefined), (scene) => scene],
  "a robot": [(yaml) => withEntry(yaml, "robots", robot), (scene) => ({ ...scene, robots: [...scene.robots, robot] })],
  "a wall": [(yaml) => withEntry(yaml, "obstacles", wall), (scene) => ({ ...scene, obstacles: [...scene.obstacles ?? [], wall] })],
  "two walls": [(yaml) => withEntry(withEntry(yaml, "obstacles", wall), "obstacles", wall), (scene) => ({ ...scene, obstacles: [...scene.obstacles ?? [], wall, wall] })],
  "no walls": [(yaml) => withValue(yaml, "obstacles", undefined), (scene) => without(scene, "obstacles")],
  "a radius of all": [(yaml) => withRobotKey(yaml, "radius", 0.4), (scene) => each(scene, (known) => ({ ...known, radius: 0.4 }))],
};
for (const k of [0, 1, 2]) {
  const robots = (scene) => ({ ...scene, robots: scene.robots.filter((_, i) => i !== k) });
  EDITS[`not robot ${k}`] = [(yaml) => withValue(yaml, `robots.${k}`, undefined), robots];
  EDITS[`robot ${k} elsewhere`] = [(yaml) => withValue(yaml, `robots.${k}.position`, [7.5, k]), at(k, (known) => ({ ...known, position: [7.5, k] }))];
  EDITS[`robot ${k} with a radius`] = [(yaml) => withValue(yaml, `robots.${k}.radius`, 0.3), at(k, (known) => ({ ...known, radius: 0.3 }))];
  for (const key of ["position", "goal"])
    EDITS[`no ${key} of robot ${k}`] = [(yaml) => withValue(yaml, `robots.${k}.${key}`, undefined), at(k, (known) => without(known, key))];
}
for (const k of [0, 1]) {
  const walls = (scene) => {
    const obstacles = scene.obstacles?.filter((_, i) => i !== k);
    return obstacles?.length ? { ...scene, obstacles } : without(scene, "obstacles");
  };
  EDITS[`not wall ${k}`] = [(yaml) => withValue(yaml, `obstacles.${k}`, undefined), walls];
}

/** What becomes of it, or why it is refused. */
function comesTo(yaml) {
  try {
    const simulation = library.simulate(yaml, { name: "scene" });
    for (let k = 0; k < 3; ++k) simulation.step();
    return [simulation.stateHash(), simulation.info()];
  } catch (error) {
    return error.message.replace(/^scene:\d+:\d+/, "scene");
  }
}

const plain = (yaml) => parse(yaml.replace(/\r(?!\n)/g, "\n"));
/** An empty list of walls is none. */
const shown = (scene) => (scene.obstacles?.length === 0 ? without(scene, "obstacles") : scene);

/** Lines of `before` that are not in `now`, in order. */
function lost(before, now) {
  let from = 0;
  return before.filter((line) => {
    const found = now.indexOf(line, from);
    if (found >= 0) from = found + 1;
    return found < 0;
  });
}

for (const [shape, yaml] of Object.entries(SHAPES)) {
  test(`${shape}: what the library reads is the change`, () => {
    assert.equal(typeof comesTo(yaml), "object", String(comesTo(yaml)));
    for (const [name, [change, meaning]] of Object.entries(EDITS)) {
      const text = change(yaml);
      const scene = meaning(plain(yaml));
      assert.deepEqual(shown(plain(text)), shown(scene), `${name}:\n${text}`);
      assert.deepEqual(comesTo(text), comesTo(JSON.stringify(scene)), `${name}:\n${text}`);
      if (shape.includes("JSON")) JSON.parse(text);
    }
  });

  test(`${shape}: the rest stays`, () => {
    const comments = (text) => text.split(/\r\n?|\n/).flatMap((line) => line.match(/#.*/) ?? []);
    const newlines = (text) => [...new Set(text.match(/\r\n?|\n/g))].join();
    for (const [name, [change]] of Object.entries(EDITS)) {
      const text = change(yaml);
      const gone = lost(comments(yaml), comments(text)).length;
      assert.ok(gone <= (/^(not|no) /.test(name) ? 2 : 0), `${name} loses ${gone} comments:\n${text}`);
      if (newlines(yaml)) assert.equal(newlines(text), newlines(yaml), name);
    }
  });
}
