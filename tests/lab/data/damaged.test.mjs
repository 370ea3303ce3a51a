// SPDX-License-Identifier: Apache-2.0
// HDF5 files that are cut off, damaged or of others: one line, or numbers that are some; never a crash or a long wait.
import assert from "node:assert/strict";
import { test } from "node:test";
import { allFrames, openRecording, randomNumbers, recorded, refusal } from "./native.mjs";

const whole = recorded("whole.h5", "positions-exchange", "--duration", "2");

/** Whether it was read; else it was refused in one line. */
async function isRead(bytes) {
  const read = openRecording("damaged.h5", bytes).then(allFrames);
  const frames = await read.catch(() => null);
  if (frames === null) {
    assert.match(await refusal(read), /^damaged\.h5: /);
    return false;
  }
  for (const { position, there } of frames)
    there.forEach((is, i) => assert.equal(Number.isFinite(position[2 * i]), is === 1));
  return true;
}

test("cut off at every byte", async () => {
  assert.ok(await isRead(whole));
  for (let size = 0; size < whole.length; ++size) assert.ok(!(await isRead(whole.subarray(0, size))), `${size}`);
});

test("other bits anywhere", async () => {
  const random = randomNumbers(5);
  let refused = 0;
  for (let k = 0; k < 3000; ++k) {
    const bytes = whole.slice();
    bytes[Math.floor(random() * bytes.length)] ^= 1 << Math.floor(random() * 8);
    if (!(await isRead(bytes))) ++refused;
  }
  assert.ok(refused > 300, `${refused}`);
});

test("other bytes in many places", async () => {
  const random = randomNumbers(6);
  for (let k = 0; k < 300; ++k) {
    const bytes = whole.slice();
    for (let n = 0; n < 40; ++n) bytes[Math.floor(random() * bytes.length)] = Math.floor(256 * random());
    await isRead(bytes);
  }
});

/** Where this text begins in the file, for the first time from `from` on. */
const placeOf = (text, from = 0) => Buffer.from(whole).indexOf(text, from);

test("a letter of the scene's text, and the place of a chunk", async () => {
  const letter = whole.slice();
  ++letter[placeOf("version: 1")];
  assert.equal(await refusal(openRecording("a.h5", letter)), "a.h5: found a damaged header of an object, must be whole");
  let node = placeOf("TREE");
  while (whole[node + 6] !== 4) node = placeOf("TREE", node + 1);  // of the table of states: four columns in one block
  const place = whole.slice();
  const ENTRY = 48, FIRST = 24, COLUMN = 24;
  [place[node + FIRST + COLUMN], place[node + FIRST + ENTRY + COLUMN]] = [1, 0];
  assert.equal(await refusal(openRecording("a.h5", place)), "a.h5: state: found a chunk out of its place, damaged");
  place[node + FIRST + COLUMN] = 0;
  place[node + 6] = 1;  // the others are not there
  assert.equal(await refusal(openRecording("a.h5", place)), "a.h5: state: found less than all of its rows, must be all");
});

test("what is no recording", async () => {
  const noise = Uint8Array.from({ length: 5000 }, (_, k) => (k * k) >> 3);
  for (const bytes of [new Uint8Array(), noise, whole.subarray(1)])
    assert.equal(await refusal(openRecording("x.h5", bytes)),
      "x.h5: found neither HDF5 nor a spool in it, cut off or damaged, must be one of them, whole");
  noise.set(whole.subarray(0, 8));
  assert.equal(await isRead(noise), false);
});
