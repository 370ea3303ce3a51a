// SPDX-License-Identifier: Apache-2.0
// Every number and text of our recordings, as h5wasm (HDF5's own library) reads them.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { library, steps } from "../wasm/module.mjs";
import { allFrames, avo, openRecording, recorded, refusal, sceneFile } from "./native.mjs";

const h5wasm = await import(pathToFileURL(`${process.env.AVO_LAB}/node_modules/h5wasm/dist/node/hdf5_hl.js`));
await h5wasm.ready;

const ABSENT = 255;

/** The header is what the attributes say. */
function requireAttributes(file, { scene, robots, every, headings }) {
  const names = Object.keys(file.attrs);
  const own = { scene_name: scene.name, scene: scene.yaml, robots, every, headings: Number(headings),
    start_at_rest: Number(scene.start_at_rest), limit_speed: Number(scene.limit_speed) };
  scene.overrides.forEach((override, k) => { own[`override.${k}`] = override; });
  for (const { path, text, builtin } of scene.files)
    own[`${builtin ? "builtin_" : ""}file.${path}`] = new TextDecoder().decode(text);
  for (const [name, value] of Object.entries(own)) {
    const parts = names.filter((key) => key.startsWith("part.") && key.replace(/^part\.\d+\./, "") === name);
    const stored = parts.length > 0 ? parts.map((_, k) => file.attrs[`part.${k}.${name}`].value).join("")
      : file.attrs[name].value ?? "";
    assert.equal(typeof value === "string" ? stored : Number(stored), value, name);
  }
  const texts = names.filter((name) => /^(part\.0\.)?(override\.|file\.|builtin_file\.)/.test(name));
  assert.equal(scene.overrides.length + scene.files.length, texts.length);
}

/** `state`, `status` and `clearance` of one robot at one time. */
function requireRobot(tables, frame, at, robot) {
  const { state, columns, status, clearance } = tables;
  const c = (column) => (column < columns ? state[at * columns + column] : NaN);
  const expected = [c(0), c(1), c(2), c(3), c(4), c(5), status[at], clearance[at]];
  const { position: p, velocity: v } = frame;
  const own = [p[2 * robot], p[2 * robot + 1], v[2 * robot], v[2 * robot + 1], frame.heading[robot],
    frame.speed[robot], frame.status[robot], frame.clearance[robot]];
  if (status[at] === ABSENT) expected[7] = NaN;
  if (!own.every((value, k) => Object.is(value, expected[k])))
    assert.deepEqual(own, expected, `robot ${robot} at ${frame.time} s`);
  assert.equal(frame.there[robot], status[at] === ABSENT ? 0 : 1);
}

/** Returns the recording, all of whose contents are equal. */
async function requireEqual(path, bytes) {
  const recording = await openRecording(path, bytes);
  const file = new h5wasm.File(path, "r");
  requireAttributes(file, recording);
  const table = (name) => file.get(name).value;
  assert.deepEqual(recording.times, table("time"));
  const [times, robots, columns] = file.get("state").shape;
  assert.deepEqual([recording.times.length, recording.robots, recording.headings ? 6 : 4], [times, robots, columns]);
  const tables = { state: table("state"), status: table("status"), clearance: table("clearance"), columns };
  for (let k = 0; k < times; ++k) {
    const frame = await recording.frame(k);
    assert.equal(frame.time, recording.times[k]);
    for (let i = 0; i < robots; ++i) requireRobot(tables, frame, k * robots + i, i);
  }
  file.close();
  return recording;
}

test("circle-10", async () => {
  const recording = await requireEqual("circle.h5", recorded("circle.h5", "circle-10"));
  assert.equal(recording.scene.name, "circle-10");
  assert.equal(recording.every, 1);
  assert.deepEqual(recording.scene.overrides, []);
});

test("headings, and robots that leave", async () => {
  assert.ok((await requireEqual("cars.h5", recorded("cars.h5", "cars-100", "--duration", "15"))).headings);
  const planes = await requireEqual("planes.h5", recorded("planes.h5", "planes-12"));
  assert.ok((await planes.frame(planes.times.length - 1)).there.includes(0));
  const yard = await requireEqual("yard.h5", recorded("yard.h5", "mixed-yard", "--duration", "5"));
  const { heading } = await yard.frame(0);
  assert.ok(heading.some(Number.isNaN) && !heading.every(Number.isNaN));
});

test("files and options of the scene", async () => {
  const bytes = recorded("arena.h5", "arena", "--duration", "3", "--start-at-rest", "--limit-speed");
  const { scene } = await requireEqual("arena.h5", bytes);
  assert.deepEqual(scene.files.map(({ path, builtin }) => [path, builtin]),
    [["arena.map", true], ["arena.scen", true]]);
  assert.deepEqual([scene.overrides, scene.start_at_rest, scene.limit_speed], [["duration=3"], true, true]);
});

const ROOM = "version: 1\nrobots:\n  - {position: [2.5, 2.5], goal: [8, 2.5], radius: 0.3, max_speed: 1, " +
  "max_acceleration: 1}\n";

test("a raw graymap is read as it is", async () => {
  const values = Array.from({ length: 100 }, (_, k) => (k % 10 === 0 || k === 55 ? 0 : 200 + (k % 50)));
  const graymap = Buffer.concat([Buffer.from("P5\n# walls\n10 10\n255\n"), Buffer.from(values)]);
  writeFileSync("walls.pgm", graymap);
  writeFileSync("walls.yaml", "image: walls.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n" +
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const scene = sceneFile("walls-scene.yaml", `${ROOM}obstacles:\n  - ros_map: walls.yaml\n`);
  const recording = await openRecording("walls.h5", recorded("walls.h5", scene, "--duration", "2"));
  const { name, yaml, ...options } = recording.scene;
  assert.deepEqual(Buffer.from(options.files.find(({ path }) => path.endsWith("walls.pgm")).text), graymap);
  const simulation = library.simulate(yaml, { ...options, name });
  const { position } = steps(simulation, recording.times.length - 1).moment();
  assert.deepEqual(position, (await recording.frame(recording.times.length - 1)).position);
});

test("a scene of more than 64 KiB, and more than a hundred overrides", async () => {
  const posts = Array.from({ length: 3000 }, (_, k) => `  - disc: {center: [${k}, 20], radius: 0.25}\n`).join("");
  const file = sceneFile("posts.yaml", `${ROOM}obstacles:\n${posts}`);
  assert.ok(statSync(file).size > 2 ** 16);
  const overrides = Array.from({ length: 700 }, (_, k) => ["--set", `obstacles.${k}.disc.radius=0.${100 + k}`]);
  const bytes = recorded("posts.h5", file, "--duration", "1", ...overrides.flat());
  const { scene } = await requireEqual("posts.h5", bytes);
  assert.equal(scene.yaml, readFileSync(file, "utf8"));
  assert.deepEqual(scene.overrides, [...overrides.map(([, override]) => override), "duration=1"]);
});

test("as many attributes, and texts as long, as a header has no room for", async () => {
  const file = sceneFile("lines.yaml", `${ROOM}obstacles:\n  - wkt: "LINESTRING (0 20, 1 20)"\n`);
  const points = Array.from({ length: 390 }, (_, k) => `${100 + k} 20`).join(",");
  const lines = Array.from({ length: 200 }, (_, k) => `obstacles.0.wkt=LINESTRING (${k} 20,${points})`);
  lines.push(`obstacles.0.wkt=LINESTRING (0 20,${Array.from({ length: 9000 }, (_, k) => `${k + 1} ${20 + k % 2}`)})`);
  const bytes = recorded("lines.h5", file, "--duration", "1", ...lines.flatMap((line) => ["--set", line]));
  assert.ok(bytes.length > 600_000);
  const { scene } = await requireEqual("lines.h5", bytes);
  assert.deepEqual(scene.overrides, [...lines, "duration=1"]);
});

test("attributes in a heap, of an older build: one line that says what to do", async () => {
  const old = readFileSync(`${process.env.AVO_LAB}../tests/recordings/attributes_in_heap.h5`);
  assert.equal(await refusal(openRecording("old.h5", new Uint8Array(old))),
    "old.h5: found attributes in a heap, as older builds of avo wrote them, must be in the header: " +
    "avo lab FILE makes a page of it");
  writeFileSync("old.h5", old);
  const { status, stdout, stderr } = avo("lab", "old.h5", "--out", "-");
  assert.equal(status, 0, stderr);
  const [, base64] = /"base64":"([^"]*)"/.exec(stdout);
  assert.equal((await openRecording("new.h5", new Uint8Array(Buffer.from(base64, "base64")))).times.length, 4);
});

test("every 7th step", async () => {
  const recording = await requireEqual("thin.h5", recorded("thin.h5", "circle-10", "--every", "7"));
  assert.equal(recording.every, 7);
});

test("clocks of their own", async () => {
  await requireEqual("free.h5", recorded("free.h5", "circle-10", "--set", "clock=free", "--duration", "8"));
});

test("chunks for parts of the robots", async () => {
  await requireEqual("many.h5", recorded("many.h5", "uniform-2500", "--duration", "1"));
});

test("a run that was ended early", async () => {
  for (const file of ["early.h5", "early.h5.part"]) rmSync(file, { force: true });
  const run = spawn(process.env.AVO_BINARY, ["run", "circle-100", "-q", "--record", "early.h5", "--threads", "1"]);
  const ended = new Promise((resolve) => run.on("exit", resolve));
  while (!existsSync("early.h5.part") || statSync("early.h5.part").size < 100_000)
    await new Promise((resolve) => setTimeout(resolve, 2));
  run.kill("SIGINT");
  await ended;
  const recording = await requireEqual("early.h5", new Uint8Array(readFileSync("early.h5")));
  assert.ok(recording.times.at(-1) < 300);
});

test("frames come in any order, and again", async () => {
  const recording = await openRecording("circle.h5", recorded("circle.h5", "circle-10"));
  const frames = await allFrames(recording);
  const order = frames.map((_, k) => (k * 389) % frames.length);
  const again = await Promise.all(order.map((k) => recording.frame(k)));
  assert.deepEqual(again, order.map((k) => frames[k]));
});
