// SPDX-License-Identifier: Apache-2.0
// CSV is read as the command line reads it, refused in its words, and written in its bytes.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { csvOf } from "../../../lab/page/data/csv_writer.ts";
import { formatOf } from "../../../lab/page/data/open.ts";
import { library } from "../wasm/module.mjs";
import { allFrames, avo, openRecording, recorded, refusal, sceneFile } from "./native.mjs";

/** The table of all these frames. */
const tableOf = (frames, { dimensions, headings, every }) =>
  frames.map((frame, k) => csvOf(library, frame, { dimensions, headings, every, begins: k === 0 })).join("");

const DRONES = sceneFile("drones.yaml", JSON.stringify({ version: 1, space: 3,
  groups: [{ count: 12, sphere: { radius: 5 }, goal: "antipodal", jitter: 0.2, downwash: 1 }], obstacles: [{ floor: -7 }] }));

const bytesOf = (text) => new TextEncoder().encode(text);

for (const [scene, ...options] of [["circle-10"], ["circle-10", "--every", "7"], ["planes-12", "--duration", "60"],
  ["mixed-yard", "--duration", "5"], ["cars-100", "--duration", "6"], [DRONES, "--duration", "3"], [DRONES, "--duration", "4", "--every", "3"]])
  test(`${[scene, ...options].join(" ")}: as HDF5 and as CSV`, async () => {
    const table = recorded("run.csv", scene, ...options);
    const csv = await openRecording("run.csv", table);
    const hdf5 = await openRecording("run.h5", recorded("run.h5", scene, ...options));
    for (const key of ["dimensions", "times", "robots", "headings", "every"]) assert.deepEqual(csv[key], hdf5[key], key);
    const frames = await allFrames(hdf5);
    const states = ({ status, clearance, ...state }) => state;
    assert.deepEqual((await allFrames(csv)).map(states), frames.map(states));
    assert.deepEqual(tableOf(frames, hdf5), new TextDecoder().decode(table));
    assert.deepEqual(tableOf(await allFrames(csv), csv), new TextDecoder().decode(table));
    const ofLive = frames.map(({ speed, ...frame }) => frame);  // whose speed is that of the velocity
    assert.deepEqual(tableOf(ofLive, hdf5), new TextDecoder().decode(table));
  });

test("robots of a run by their numbers; the speed of a velocity; the fewest digits", () => {
  const frame = { time: 0.1, robot: [3, 8], position: [1, -0, 1e-7, 2.5e21], velocity: [0, 2, 1e16, 1.5e-300],
    heading: [Math.PI / 2, NaN] };
  assert.equal(csvOf(library, frame, { dimensions: 2, headings: true, every: 1, begins: true }),
    "time,robot,x,y,vx,vy,heading,speed\n0.1,3,1,-0,0,2,1.5707963267948966,2\n0.1,8,1e-07,2.5e+21,1e+16,1.5e-300,,\n");
});

const HEAD = "time,robot,x,y,vx,vy\n";
const ROWS = "0,0,0,0,1,0\n0.1,0,0.1,0,1,0\n";

test("what is allowed", async () => {
  const table = '\ufeffvy, "vx" ,robot,time,x,y,note\r\n0,1,1.0,+0,.5,1.,any\r\n\r\n0,1,2,0,1e-999,2E0,"any"\r\n' +
    "0,1,2,1,3,4,\n-0,1,7,1,3,4,";
  const recording = await openRecording("odd.txt", bytesOf(table));
  const [first, second] = await allFrames(recording);
  assert.deepEqual([...recording.times, recording.robots, recording.kind], [0, 1, 8, "csv"]);
  assert.deepEqual([...first.there], [0, 1, 1, 0, 0, 0, 0, 0]);
  assert.deepEqual([...first.position.slice(2, 6)], [0.5, 1, 0, 2]);
  assert.ok(Object.is(second.velocity[15], -0) && Number.isNaN(second.heading[7]) && second.status[0] === 255);
  writeFileSync("odd.txt", table);
  const { stderr } = avo("check", "odd.txt", "--radius", "0.1", "--max-acceleration", "1", "--max-speed", "9");
  assert.doesNotMatch(stderr, /odd\.txt:\d/);
});

const REFUSED = {
  empty: "",
  "no header": ROWS,
  misspelled: "time,robto,x,y,vx,vy\n" + ROWS,
  abbreviated: "time,robot_number,x,y,vx,vy\n" + ROWS,
  "column twice": "time,robot,x,y,vx,vy,x\n",
  "heading twice": "time,robot,x,y,vx,vy,heading,speed,heading\n",
  "header alone": HEAD,
  "one time": HEAD + "0,0,0,0,1,0\n",
  "few columns": HEAD + "0,0,0,0\n",
  "many columns": HEAD + ROWS + "0.2,0,0,0,1,0,\n",
  "no number": HEAD + ROWS + "0.2,0,here,0,1,0\n",
  hexadecimal: HEAD + "0,0,0x10,0,1,0\n",
  "empty field": HEAD + "0,0,,0,1,0\n",
  blanks: HEAD + "0,0, ,0,1,0\n",
  "two signs": HEAD + "0,0,+-1,0,1,0\n",
  infinite: HEAD + "0,0,-inf,0,1,0\n",
  "not a number": HEAD + "0,0,nan,0,1,0\n",
  "too large": HEAD + "0,0,1e13,0,1,0\n",
  "beyond doubles": HEAD + "0,0,1e999,0,1,0\n",
  "negative robot": HEAD + "0,-1,0,0,1,0\n",
  "half a robot": HEAD + "0,0.5,0,0,1,0\n",
  "robot of letters": HEAD + "0,first,0,0,1,0\n",
  "robot again": HEAD + "0,0,0,0,1,0\n0,1,0,9,1,0\n0,0,3,0,1,0\n",
  "time descends": HEAD + ROWS + "0.05,0,0,0,1,0\n",
  "half a heading": "time,robot,x,y,vx,vy,heading,speed\n0,0,0,0,1,0,,1\n",
  "every 0": "time,robot,x,y,vx,vy,every\n0,0,0,0,1,0,0\n",
  "long field": HEAD + `0,0,${"long ".repeat(30)},0,1,0\n`,
  "control characters": HEAD + "0,0,a\u001b[31m\u200b\u2028é,0,1,0\n",
  "long line": HEAD + "0,0," + "1".repeat(70000) + ",0,1,0\n",
};
for (const [what, table] of Object.entries(REFUSED))
  test(`${what}: one line, that of the command line`, async () => {
    writeFileSync("bad.csv", table);
    const { status, stderr } = avo("check", "bad.csv", "--radius", "1", "--max-acceleration", "1", "--max-speed", "2");
    assert.equal(status, 3);
    assert.equal(await refusal(openRecording("bad.csv", bytesOf(table))), stderr.trimEnd());
  });

test("robots beyond what can be shown", async () => {
  const line = await refusal(openRecording("bad.csv", bytesOf(HEAD + "0,9000000000000000,0,0,1,0\n")));
  assert.equal(line, "bad.csv:2: robot: found 9000000000000000, must be less than 100000 to be shown here");
});

test("a table that was cut off at any byte", async () => {
  const whole = recorded("cut.csv", "positions-exchange", "--duration", "2");
  for (let size = 0; size < whole.length; ++size) {
    const opened = openRecording("cut.csv", whole.subarray(0, size));
    const recording = await opened.catch(() => null);
    if (recording === null) await refusal(opened);
    else for (const { position, there } of await allFrames(recording))
      there.forEach((is, i) => assert.equal(Number.isFinite(position[2 * i]), is === 1));
  }
});

test("scenes are told from tables, and both from what is neither", () => {
  const scene = readFileSync(`${process.env.AVO_LAB}../scenarios/circle-100.yaml`);
  assert.equal(formatOf("scene", scene), "yaml");
  assert.equal(formatOf("scene", bytesOf("version: 1\nname: time, robot\n")), "yaml");
  assert.equal(formatOf("scene", bytesOf("")), "yaml");
  assert.equal(formatOf("table", bytesOf(HEAD)), "csv");
  assert.equal(formatOf("table.csv", bytesOf("nothing")), "csv");
  assert.equal(formatOf("picture", Uint8Array.from([137, 80, 78, 71, 13, 10, 26, 10, 0, 0])), "unknown");
  assert.equal(formatOf("run.h5", bytesOf(HEAD)), "unknown");
});
