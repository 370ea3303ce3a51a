// SPDX-License-Identifier: Apache-2.0
// What the tests of readers and writers share: recordings by the command line, and numbers that are the same each time.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { openRecording as open } from "../../../lab/page/data/open.ts";
import { library } from "../wasm/module.mjs";

export const openRecording = (name, bytes) => open(library, name, bytes);

export function avo(...args) {
  const { status, stdout, stderr } = spawnSync(process.env.AVO_BINARY, args, { encoding: "utf8", maxBuffer: 1 << 30 });
  return { status, stdout, stderr };
}

/** The bytes of a recording of that run, and its file. */
export function recorded(file, scene, ...args) {
  for (const path of [file, `${file}.part`]) rmSync(path, { force: true });
  const { status, stderr } = avo("run", scene, "-q", "--record", file, ...args);
  assert.equal(status, 0, stderr);
  return new Uint8Array(readFileSync(file));
}

/** The name of a file with this scene. */
export function sceneFile(file, yaml) {
  writeFileSync(file, yaml);
  return file;
}

/** Mulberry32. */
export function randomNumbers(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

export async function allFrames(recording) {
  const frames = [];
  for (let k = 0; k < recording.times.length; ++k) frames.push(await recording.frame(k));
  return frames;
}

/** The one line in which it was refused; fails where it was not, or in anything else. */
export async function refusal(promise) {
  try {
    await promise;
  } catch (error) {
    assert.equal(error.constructor, Error, error.stack);
    assert.match(error.message, /^[^\n]{1,400}$/);
    return error.message;
  }
  return assert.fail("it was not refused");
}
