// SPDX-License-Identifier: Apache-2.0
// Scenes in addresses: there and back, and what is damaged in one line.
import assert from "node:assert/strict";
import { test } from "node:test";
import { deflateSync, gunzipSync } from "node:zlib";
import { base64Of, bytesOfBase64, compressed } from "../../../lab/page/data/compression.ts";
import { decodeScene, encodeScene } from "../../../lab/page/data/share.ts";
import { randomNumbers, refusal } from "./native.mjs";

const SCENE = "version: 1\nname: Straße, 通り, 🚗\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n";
const DAMAGED = "found a link whose scene is damaged or cut off, must be copied whole";

test("there and back, in characters that need no escapes", async () => {
  const random = randomNumbers(3);
  const digits = Array.from({ length: 100_000 }, () => Math.floor(random() * 10)).join("");
  for (const text of ["", SCENE, "\ufeff" + SCENE, digits]) {
    const encoded = await encodeScene(text);
    assert.match(encoded, /^[A-Za-z0-9_-]*$/);
    assert.equal(await decodeScene(encoded), text);
  }
  assert.ok((await encodeScene(SCENE.repeat(50))).length < 2 * (await encodeScene(SCENE)).length);
});

test("cut off anywhere, or with another character anywhere", async () => {
  const encoded = await encodeScene(SCENE);
  for (let k = 0; k < encoded.length; ++k) {
    assert.equal(await refusal(decodeScene(encoded.slice(0, k))), DAMAGED);
    const other = encoded[k] === "Q" ? "h" : "Q";
    const text = await decodeScene(encoded.slice(0, k) + other + encoded.slice(k + 1)).catch(({ message }) => message);
    assert.ok(text === DAMAGED || text === SCENE, text);  // in the last one some bits mean nothing
  }
  for (const text of ["%", "a b", "AAAA", "🚗"]) assert.equal(await refusal(decodeScene(text)), DAMAGED);
});

test("what unpacks to more than a scene can be, and what is no text", async () => {
  const link = (bytes) => deflateSync(bytes).toString("base64url");
  assert.equal(await refusal(decodeScene(link(Buffer.alloc(64 << 20)))), DAMAGED);
  assert.equal(await refusal(decodeScene(link(Buffer.from([0xc3, 0x28])))), DAMAGED);
  assert.equal(await decodeScene(link(Buffer.from(SCENE))), SCENE);
  const large = "found a scene that is too large for a link, must be saved as a file instead";
  assert.equal(await refusal(encodeScene(" ".repeat(9_000_000))), large);
});

test("base64 and gzip are those of node", async () => {
  const bytes = Uint8Array.from({ length: 70_001 }, (_, k) => (k * k) >> 3);
  assert.equal(base64Of(bytes), Buffer.from(bytes).toString("base64"));
  assert.deepEqual(bytesOfBase64(base64Of(bytes)), bytes);
  assert.deepEqual(new Uint8Array(gunzipSync(await compressed(bytes, "gzip"))), bytes);
});
