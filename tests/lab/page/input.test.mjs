// SPDX-License-Identifier: Apache-2.0
// What `avo lab` puts into a page is what opens there: the same scenes to the bit, and the same recordings.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { first, openInput } from "../../../lab/page/run/input.ts";
import { avo, recorded } from "../data/native.mjs";
import { hex, library } from "../wasm/module.mjs";

const folder = mkdtempSync(join(tmpdir(), "avo-input-"));
process.chdir(folder);
after(() => rmSync(folder, { recursive: true }));

const MARK = '<script id="avo-input" type="application/json">';

/** The Lab of the page that the command line makes of these words. */
async function opened(...words) {
  const { status, stdout, stderr } = avo("lab", ...words, "--out", "-");
  assert.equal(status, 0, stderr);
  const from = stdout.indexOf(MARK) + MARK.length;
  const input = JSON.parse(stdout.slice(from, stdout.indexOf("</script>", from)));
  const lab = first(library);
  await openInput(lab, input);
  assert.equal(lab.error, null);
  return lab;
}

async function comesToTheSameState(...words) {
  const lab = await opened(...words);
  recorded("run.h5", ...words);
  const { times, state_hash } = JSON.parse(avo("replay", "run.h5", "--json").stdout);
  for (let k = 1; k < times; ++k) lab.live.step();
  assert.equal(hex(lab.live.stateHash()), state_hash);
}

test("a scene with what the command line changes of it", () =>
  comesToTheSameState("circle-8", "--set", "groups.0.radius=0.6", "--seed", "7", "--set", "duration=5", "--start-at-rest"));

test("a scene that reads a built-in map", () => comesToTheSameState("arena", "--set", "duration=2"));

test("a scene with a raw graymap, which is no text", async () => {
  const cells = Uint8Array.from({ length: 200 * 100 }, (_, k) => (k < 30 * 200 && k % 97 === 0 ? 0 : 254));
  writeFileSync("map.pgm", Buffer.concat([Buffer.from("P5\n# by a robot\n200 100\n255\n"), cells]));
  writeFileSync("map.yaml", "image: map.pgm\nresolution: 0.1\norigin: [-10, -5, 0]\nnegate: 0\n" +
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  writeFileSync("scene.yaml", "version: 1\nduration: 5\nrobots:\n  - {position: [-6, 0], goal: [6, 1]}\n" +
    "  - {position: [6, 0], goal: [-6, 0]}\nobstacles:\n  - {ros_map: map.yaml}\n");
  assert.ok((await opened("scene.yaml")).info.walls.length > 50);
  await comesToTheSameState("scene.yaml");
});

test("a recording, as HDF5 with its scene and as CSV with one beside it", async () => {
  for (const file of ["run.h5", "run.csv"]) recorded(file, "circle-4", "--set", "duration=3");
  for (const words of [["run.h5"], ["run.csv", "--scene", "circle-4"]]) {
    const lab = await opened(...words);
    assert.equal(lab.live, null);
    assert.equal(lab.end, 3);
    assert.equal(lab.info.robots.length, 4);
    assert.equal(lab.info.options.method, "avo");
    assert.ok(lab.text.includes("groups:"));
    if (words.length === 1) assert.ok(lab.text.includes("duration: 3"), "what it was run with");
    assert.ok(lab.moment.goal.every(Number.isFinite));
  }
});
