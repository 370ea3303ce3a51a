// SPDX-License-Identifier: Apache-2.0
// Reads an export as MCAP with other people's programs, by its index and from begin to end, decodes the messages
// by the schema in the file, and compares them with the CSV of the same run, whose robots are all holonomic.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import protobuf from "protobufjs";
import descriptor from "protobufjs/ext/descriptor/index.js";

const [mcapPath, csvPath, walls] = process.argv.slice(2);
const bytes = readFileSync(mcapPath);

function rowsByTime(csv) {
  const times = new Map();
  for (const line of csv.trim().split("\n").slice(1)) {
    const [time, robot, x, y, vx, vy] = line.split(",").map(Number);
    const nanoseconds = BigInt(Math.round(time * 1e9));
    if (!times.has(nanoseconds)) times.set(nanoseconds, []);
    times.get(nanoseconds).push({ robot, x, y, vx, vy });
  }
  return times;
}

function decoderOf(schema) {
  assert.equal(schema.encoding, "protobuf");
  const set = descriptor.FileDescriptorSet.decode(schema.data);
  const type = protobuf.Root.fromDescriptor(set).lookupType(schema.name);
  return (data) => type.toObject(type.decode(data), { longs: Number, enums: String, defaults: true });
}

async function messagesByIndex() {
  const reader = await McapIndexedReader.Initialize({
    readable: {
      size: async () => BigInt(bytes.length),
      read: async (offset, size) => bytes.subarray(Number(offset), Number(offset + size)),
    },
  });
  const decoders = new Map([...reader.schemasById].map(([id, schema]) => [id, decoderOf(schema)]));
  const messages = [];
  for await (const message of reader.readMessages()) {
    const channel = reader.channelsById.get(message.channelId);
    assert.equal(channel.messageEncoding, "protobuf");
    messages.push({ topic: channel.topic, time: message.logTime,
      value: decoders.get(channel.schemaId)(message.data) });
  }
  assert.equal(reader.statistics.messageCount, BigInt(messages.length));
  assert.equal(reader.statistics.chunkCount, reader.chunkIndexes.length);
  return messages;
}

function countInStream() {
  const reader = new McapStreamReader({ validateCrcs: true });
  reader.append(bytes);
  let count = 0;
  for (let record; (record = reader.nextRecord()) != undefined;) if (record.type === "Message") ++count;
  assert.ok(reader.done());
  return count;
}

function check(messages, times) {
  const of = (topic) => messages.filter((message) => message.topic === topic);
  assert.equal(of("/walls").length, 1);
  assert.equal(of("/walls")[0].value.entities.length, Number(walls));
  assert.deepEqual(of("/robots").map((message) => message.time), [...times.keys()]);
  for (const { time, value } of of("/robots")) {
    const rows = times.get(time);
    assert.deepEqual(value.entities.map((entity) => Number(entity.id)), rows.map((row) => row.robot));
    value.entities.forEach((entity, k) => {
      const { position } = entity.cylinders[0].pose;
      assert.deepEqual([position.x, position.y], [rows[k].x, rows[k].y]);
      const { seconds, nanos } = entity.timestamp;
      assert.equal(BigInt(seconds) * 1_000_000_000n + BigInt(nanos), time);
      assert.equal(entity.arrows.length, Math.hypot(rows[k].vx, rows[k].vy) > 1e-12 ? 1 : 0);
      assert.deepEqual([entity.frame_id, entity.models, entity.lines], ["world", [], []]);
    });
  }
  assert.equal(of("/poses").length, times.size);
  for (const { time, value } of of("/poses"))
    assert.deepEqual(value.poses.map((pose) => pose.position.x), times.get(time).map((row) => row.x));
}

const messages = await messagesByIndex();
assert.equal(countInStream(), messages.length);
check(messages, rowsByTime(readFileSync(csvPath, "utf8")));
console.log(`${messages.length} messages`);
