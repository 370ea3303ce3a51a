// SPDX-License-Identifier: Apache-2.0
// Files that are dropped: which of them is opened, and what it may read.
import assert from "node:assert/strict";
import { test } from "node:test";
import { makeOpener } from "../../../lab/page/run/files.ts";

const file = (name, text) => ({ name, bytes: new TextEncoder().encode(text) });
const SCENE = file("mine.yaml", "version: 1\nobstacles:\n  - {map: maps/small.map}\n  - {ros_map: ../hall.yaml}\n");
const MAP = file("small.map", "type octile\n");
const HALL = file("hall.yaml", "image: hall.pgm\nresolution: 0.1\n");

/** A Lab that refuses scenes as long as it lacks a file of `needed`. */
function labThatNeeds(...needed) {
  const lab = {
    error: null,
    opened: [],
    refuse(message) { lab.error = { message }; },
    async openFile(name, bytes, files = []) {
      lab.opened.push(name);
      const missing = needed.find((path) => !files.some((known) => known.path === path));
      lab.error = missing ? { message: `${missing}: found no such file` } : null;
    },
  };
  return lab;
}

test("a scene reads what is dropped with it, by the path that it has for it", async () => {
  const lab = labThatNeeds("maps/small.map", "../hall.yaml", "hall.pgm");
  await makeOpener(lab)([MAP, HALL, file("hall.pgm", "P2 1 1 255 0\n"), SCENE]);
  assert.equal(lab.error, null);
  assert.deepEqual(lab.opened, ["mine.yaml"]);
});

test("a scene that was refused is opened again with the file that was missing", async () => {
  const lab = labThatNeeds("maps/small.map");
  const open = makeOpener(lab);
  await open([SCENE]);
  assert.match(lab.error.message, /small\.map/);
  await open([MAP]);
  assert.equal(lab.error, null);
  assert.deepEqual(lab.opened, ["mine.yaml", "mine.yaml"]);
});

test("a map alone opens nothing, and is read by scenes that come later", async () => {
  const lab = labThatNeeds("maps/small.map");
  const open = makeOpener(lab);
  await open([MAP]);
  assert.match(lab.error.message, /small\.map is kept/);
  await open([SCENE]);
  assert.equal(lab.error, null);
  assert.deepEqual(lab.opened, ["mine.yaml"]);
});

test("a plan as GeoJSON is no scene, though it may have a name", async () => {
  const lab = labThatNeeds("plan.geojson");
  const open = makeOpener(lab);
  await open([file("plan.geojson", "{\n\"type\": \"FeatureCollection\",\n\"name\": \"plan\", \"features\": []}\n")]);
  assert.match(lab.error.message, /plan\.geojson is kept/);
  await open([file("mine.yaml", "version: 1\nobstacles:\n  - {geojson: plan.geojson}\n")]);
  assert.equal(lab.error, null);
});

test("a recording is opened as it is", async () => {
  const lab = labThatNeeds();
  await makeOpener(lab)([file("states.csv", "time,robot,x,y,vx,vy\n0,0,0,0,0,0\n")]);
  assert.deepEqual(lab.opened, ["states.csv"]);
});

test("of several scenes the first is opened, and the others are named", async () => {
  const lab = labThatNeeds("maps/small.map");
  await makeOpener(lab)([SCENE, file("other.yaml", "version: 1\n"), MAP, file("third.csv", "time,robot,x,y,vx,vy\n")]);
  assert.deepEqual(lab.opened, ["mine.yaml"]);
  assert.equal(lab.error.message, "mine.yaml is opened, and not other.yaml, third.csv: one scene or recording at a time");
});

test("where a name does not tell what a file is, its content does", async () => {
  for (const [name, text] of [["scene.txt", "# mine\nversion: 1\nrobots: []\n"], ["scene", "{name: short, groups: []}\n"],
    ["states.txt", "time,robot,x,y,vx,vy\n0,0,0,0,0,0\n"]]) {
    const lab = labThatNeeds();
    await makeOpener(lab)([file(name, text)]);
    assert.deepEqual(lab.opened, [name]);
  }
  const lab = labThatNeeds("hall.txt");
  const open = makeOpener(lab);
  await open([file("hall.txt", "POLYGON ((0 0, 1 0, 1 1, 0 0))\n")]);
  assert.match(lab.error.message, /hall\.txt is kept/);
  await open([file("mine.txt", "version: 1\nobstacles:\n  - {wkt_file: hall.txt}\n")]);
  assert.deepEqual([lab.opened, lab.error], [["mine.txt"], null]);
});
