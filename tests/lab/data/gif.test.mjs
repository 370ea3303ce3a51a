// SPDX-License-Identifier: Apache-2.0
// Animated GIFs, decoded by ffmpeg: every pixel of every frame, and when it is shown.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { test } from "node:test";
import { GifEncoder, paletteOf } from "../../../lab/page/data/gif.ts";
import { randomNumbers } from "./native.mjs";

/** The frames, each as a picture of colors; the file's own times of a frame are kept. */
function decoded(file, width, height) {
  const { stdout, stderr } = spawnSync("ffmpeg", ["-v", "error", "-i", file, "-fps_mode", "passthrough", "-f", "rawvideo",
    "-pix_fmt", "rgba", "-"], { maxBuffer: 2 ** 30 });
  assert.equal(stderr.toString(), "");
  const size = 4 * width * height;
  return Array.from({ length: stdout.length / size }, (_, k) => colorsOf(stdout.subarray(k * size, (k + 1) * size)));
}

function colorsOf(rgba) {
  return Array.from({ length: rgba.length / 4 }, (_, k) => (rgba[4 * k] << 16) | (rgba[4 * k + 1] << 8) | rgba[4 * k + 2]);
}

function picture(colors) {
  return Uint8ClampedArray.from(colors.flatMap((color) => [color >> 16, (color >> 8) & 255, color & 255, 255]));
}

const PALETTE = Array.from({ length: 255 }, (_, k) => (k * 65793 * 7) & 0xffffff);

function requireSame(file, width, height, pictures, options) {
  const encoder = new GifEncoder(width, height, options);
  for (const colors of pictures) encoder.add(picture(colors));
  writeFileSync(file, encoder.finish());
  const frames = decoded(file, width, height);
  assert.equal(frames.length, pictures.length);
  frames.forEach((frame, k) => assert.deepEqual(frame, pictures[k], `frame ${k}`));
}

test("noise of all colors, so that all widths of codes come and codes begin anew", () => {
  const random = randomNumbers(1);
  for (const [width, height] of [[1, 1], [3, 1], [127, 131], [300, 200]]) {
    const pictures = Array.from({ length: 3 }, () =>
      Array.from({ length: width * height }, () => PALETTE[Math.floor(random() * 255)]));
    requireSame("noise.gif", width, height, pictures, { palette: PALETTE, delay: 0.1 });
  }
});

test("lengths of codes at every end of a picture", () => {
  const random = randomNumbers(2);
  const colors = Array.from({ length: 1200 }, () => PALETTE[Math.floor(random() * 255)]);
  for (let size = 240; size < 1200; size += 61)
    requireSame("ends.gif", size, 1, [colors.slice(0, size)], { palette: PALETTE, delay: 0.1 });
});

test("what moves, what stays, and a frame like the one before", () => {
  const still = Array.from({ length: 64 * 48 }, (_, k) => PALETTE[k % 5]);
  const pictures = Array.from({ length: 12 }, (_, f) => still.map((color, k) => (k % 64 === 5 * f ? PALETTE[200] : color)));
  requireSame("moves.gif", 64, 48, [...pictures, pictures[11], still], { palette: PALETTE, delay: 0.04 });
});

test("delays add up to the time", () => {
  const encoder = new GifEncoder(2, 2, { delay: 1 / 30, palette: PALETTE });
  for (let k = 0; k < 60; ++k) encoder.add(picture([0, 1, 2, 3].map((n) => PALETTE[n + k])));
  writeFileSync("delays.gif", encoder.finish());
  const { stdout } = spawnSync("ffprobe", ["-v", "error", "-count_frames", "-show_entries",
    "stream=nb_read_frames,duration", "-of", "csv=p=0", "delays.gif"], { encoding: "utf8" });
  assert.deepEqual(stdout.trim().split(",").map(Number), [2, 60]);
});

test("a palette of the picture's own colors, and near ones for all others", () => {
  const own = [0xffffff, 0x0072b2, 0xe69f00, 0x123456];
  const palette = paletteOf(picture(own));
  assert.deepEqual([...new Set(palette)].length, palette.length);
  assert.ok(palette.length <= 255 && own.every((color) => palette.includes(color)));
  const encoder = new GifEncoder(4, 1, { delay: 0.1 });
  encoder.add(picture(own));
  encoder.add(picture([0x804030, 0x00ff10, 0xfefefe, 0x123456]));
  writeFileSync("near.gif", encoder.finish());
  const [first, second] = decoded("near.gif", 4, 1);
  assert.deepEqual(first, own);
  assert.deepEqual(second, [0x804040, 0x00ff00, 0xffffff, 0x123456]);
});

test("what is no animation", () => {
  assert.throws(() => new GifEncoder(0, 5, { delay: 0.1 }), /^Error: found a picture of 0 x 5, must be 1 to 65535$/);
  assert.throws(() => new GifEncoder(5, 5, { delay: 0.001 }), /^Error: delay: found 0.001 s/);
  assert.throws(() => new GifEncoder(5, 5, { delay: 0.1 }).finish(), /^Error: found no frame/);
  assert.throws(() => new GifEncoder(5, 5, { delay: 0.1 }).add(new Uint8ClampedArray(8)), /^Error: found 8 bytes/);
});
