// SPDX-License-Identifier: Apache-2.0
// What a run leaves that was killed: all whole blocks, as `avo recover` makes a recording of them.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { allFrames, avo, openRecording, randomNumbers, refusal } from "./native.mjs";

/** Of a run that was killed once its spool had that many bytes. */
async function killed(file, scene, size) {
  for (const path of [file, `${file}.part`]) rmSync(path, { force: true });
  const run = spawn(process.env.AVO_BINARY, ["run", scene, "-q", "--record", file, "--threads", "1"]);
  const ended = new Promise((resolve) => run.on("exit", resolve));
  while (!existsSync(`${file}.part`) || statSync(`${file}.part`).size < size)
    await new Promise((resolve) => setTimeout(resolve, 1));
  run.kill("SIGKILL");
  await ended;
  return new Uint8Array(readFileSync(`${file}.part`));
}

const spool = await killed("killed.h5", "circle-100", 200_000);

test("equal to the recording that is recovered", async () => {
  const own = await openRecording("killed.h5.part", spool);
  assert.equal(avo("recover", "killed.h5.part").status, 7);
  const recovered = await openRecording("killed.h5", new Uint8Array(readFileSync("killed.h5")));
  assert.deepEqual([own.kind, recovered.kind], ["spool", "hdf5"]);
  assert.deepEqual(own.times, recovered.times);
  assert.deepEqual(own.scene, recovered.scene);
  assert.deepEqual([own.robots, own.every, own.headings], [recovered.robots, recovered.every, recovered.headings]);
  assert.deepEqual(await allFrames(own), await allFrames(recovered));
});

function crc32(bytes) {
  let value = -1;
  for (const byte of bytes) {
    value ^= byte;
    for (let bit = 0; bit < 8; ++bit) value = (value >>> 1) ^ (value & 1 ? 0xedb88320 : 0);
  }
  return ~value >>> 0;
}

test("another number in its header, with its checksums: the line of the command line", async () => {
  const BEGIN = 12, HEAD = 20;  // bytes of the first line, and of the head of a record
  for (const [name, number] of [["robots", 0], ["robots", 2_000_000], ["headings", 2], ["limit_speed", 7]]) {
    const bytes = Buffer.from(spool);
    const at = bytes.indexOf(name) + name.length;
    assert.equal(bytes.readBigUInt64LE(at), 0n, "a number follows");
    bytes.writeBigUInt64LE(BigInt(number), at + 8);
    const length = Number(bytes.readBigUInt64LE(BEGIN + 8));
    bytes.writeUInt32LE(crc32(bytes.subarray(BEGIN + HEAD, BEGIN + HEAD + length)), BEGIN + 4);
    bytes.writeUInt32LE(crc32(bytes.subarray(BEGIN, BEGIN + 16)), BEGIN + 16);
    writeFileSync("changed.h5.part", bytes);
    const line = await refusal(openRecording("changed.h5.part", new Uint8Array(bytes)));
    assert.equal(`${line}\n`, avo("check", "changed.h5.part").stderr);
    assert.match(line, new RegExp(`${name}: found ${number}, must be`));
  }
});

test("cut off anywhere: whole blocks or one line", async () => {
  const { times } = await openRecording("killed.h5.part", spool);
  const seen = new Set();
  for (let size = 0; size < spool.length; size += size < 3000 ? 1 : 97) {
    const opened = openRecording("killed.h5.part", spool.subarray(0, size));
    const recording = await opened.catch(() => null);
    if (recording === null) await refusal(opened);
    else assert.deepEqual(recording.times, times.subarray(0, recording.times.length));
    seen.add(recording === null ? 0 : recording.times.length);
  }
  assert.ok(seen.has(0) && seen.has(64));
});

test("other bits anywhere: blocks before them or one line", async () => {
  const random = randomNumbers(4);
  const { times } = await openRecording("killed.h5.part", spool);
  for (let k = 0; k < 300; ++k) {
    const bytes = spool.slice();
    bytes[Math.floor(random() * (k < 150 ? 3000 : bytes.length))] ^= 1 << Math.floor(random() * 8);
    const opened = openRecording("killed.h5.part", bytes);
    const recording = await opened.catch(() => null);
    if (recording === null) await refusal(opened);
    else assert.deepEqual(recording.times, times.subarray(0, recording.times.length));
  }
});
