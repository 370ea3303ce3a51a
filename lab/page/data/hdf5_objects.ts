// SPDX-License-Identifier: Apache-2.0
// HDF5 as avo writes it (io/recording/hdf5_writer.cpp): superblock 2, and objects. Their headers are lists of messages.
// Names and numbers are those of the HDF5 File Format Specification.
import { beginsWith, ByteReader, hexOf, refuse } from "./bytes.ts";
import type { Fields } from "./recording_fields.ts";

const SIGNATURE = "\x89HDF\r\n\x1a\n";
const LINK = 0x06, ATTRIBUTE = 0x0c, CONTINUATION = 0x10, ATTRIBUTE_INFO = 0x15;
const UNSIGNED_64 = "10 00 00 00 08 00 00 00 00 00 40 00", ONE_VALUE = "02 00 00 00";
const NO_HEAP = `00 00${" ff".repeat(16)}`;

export interface Message { type: number; body: Uint8Array }

export const isHdf5 = (bytes: Uint8Array) => beginsWith(bytes, SIGNATURE);

/** Reads these bytes, in the form of hexOf(); refuses others, which must come from another writer. */
export function requireBytes(reader: ByteReader, what: string, must: string): void {
  const found = hexOf(reader.take((must.length + 1) / 3));
  if (found !== must) refuse(`${what}: found ${found}, must be ${must}, as avo writes it`);
}

const rotated = (x: number, by: number) => (x << by) | (x >>> (32 - by));

/** Returns the checksum of one byte or more: Jenkins' lookup3, hashlittle(), with initial value 0. */
function lookup3(bytes: Uint8Array): number {
  const state = new Int32Array(3).fill(0xdeadbeef + bytes.length);  // its numbers wrap around
  const add = (begin: number) => {
    for (let k = 0; k < 12; ++k) state[k >> 2] += (bytes[begin + k] ?? 0) << (8 * (k & 3));
  };
  let at = 0;
  for (; bytes.length - at > 12; at += 12) {
    add(at);
    [4, 6, 8, 16, 19, 4].forEach((by, k) => {
      const [x, last, next] = [k % 3, (k + 2) % 3, (k + 1) % 3];
      state[x] = (state[x] - state[last]) ^ rotated(state[last], by);
      state[last] += state[next];
    });
  }
  add(at);
  [14, 11, 25, 16, 4, 14, 24].forEach((by, k) => {
    const [x, last] = [(k + 2) % 3, (k + 1) % 3];
    state[x] = (state[x] ^ state[last]) - rotated(state[last], by);
  });
  return state[2] >>> 0;
}

/** The reader must stand behind `what`, which began at `begin`, and in front of its checksum. */
function requireChecksum(reader: ByteReader, begin: number, what: string): void {
  const covered = reader.bytes.subarray(begin, reader.offset);
  if (reader.u32() !== lookup3(covered)) refuse(`found a damaged ${what}, must be whole`);
}

/** Returns the address of the root group's header. */
export function readSuperblock(file: Uint8Array): number {
  const reader = new ByteReader(file, SIGNATURE.length);
  requireBytes(reader, "superblock", `02 08 08 00${" 00".repeat(8)}`);  // version, sizes of numbers, address 0
  const [, end, root] = [reader.u64(), reader.u64(), reader.u64()];
  requireChecksum(reader, 0, "superblock");
  if (end > file.length) refuse(`found ${file.length} bytes, must be ${end}: the file is cut off`);
  return root;
}

/** Reads the messages from the reader's place to `end`, where the block's checksum stands. */
function readBlock(reader: ByteReader, begin: number, end: number): Message[] {
  const messages: Message[] = [];
  while (end - reader.offset >= 4) {
    const [type, size, flags] = [reader.u8(), reader.u16(), reader.u8()];
    if (size > end - reader.offset || (flags & 2) !== 0)  // 2: the body is elsewhere
      refuse("found a damaged header of an object, must be whole");
    messages.push({ type, body: reader.take(size) });
  }
  reader.skip(end - reader.offset);
  requireChecksum(reader, begin, "header of an object");
  return messages;
}

/** Returns all messages of the object with the header at `address`. */
export function readObject(file: Uint8Array, address: number): Message[] {
  const reader = new ByteReader(file, address);
  requireBytes(reader, "header of an object", "4f 48 44 52 02");  // OHDR, version
  const flags = reader.u8();
  if ((flags & ~0x13) !== 0) refuse(`found flags ${flags} of an object, must be 0 to 3 or 16 to 19, as avo writes it`);
  if ((flags & 0x10) !== 0) reader.skip(4);  // limits beyond which attributes move to a heap
  const size = reader.uint(1 << (flags & 3));
  const messages = readBlock(reader, address, reader.offset + size);
  const seen = new Set<number>();
  for (const { type, body } of messages) {  // which become more
    if (type !== CONTINUATION) continue;
    const link = new ByteReader(body);
    const [begin, length] = [link.u64(), link.u64()];
    if (seen.has(begin)) refuse("found a header of an object that goes on in itself");
    seen.add(begin);
    const block = new ByteReader(file, begin);
    requireBytes(block, "header of an object", "4f 43 48 4b");  // OCHK
    messages.push(...readBlock(block, begin, begin + length - 4));
  }
  return messages;
}

/** Returns a reader of the first message of that type, behind the bytes that it must begin with. */
export function messageOf(messages: Message[], type: number, what: string, beginning: string): ByteReader {
  const found = messages.find((message) => message.type === type);
  const reader = new ByteReader(found?.body ?? refuse(`found no ${what}, must be there`), 0, what);
  requireBytes(reader, what, beginning);
  return reader;
}

/** Returns the addresses of the objects in a group, by name. */
export function linksOf(messages: Message[]): Map<string, number> {
  const links = new Map<string, number>();
  for (const { type, body } of messages) {
    if (type !== LINK || hexOf(body.subarray(0, 2)) !== "01 00") continue;  // version, and flags of another kind
    const reader = new ByteReader(body, 2, "link");
    links.set(new TextDecoder().decode(reader.take(reader.u8())), reader.u64());
  }
  return links;
}

function addAttribute(message: Uint8Array, fields: Fields): void {
  const reader = new ByteReader(message, 0, "attribute");
  requireBytes(reader, "attribute", "03 00");  // version, and a type of its own
  const [nameSize, typeSize, extentSize] = [reader.u16(), reader.u16(), reader.u16()];
  reader.skip(1);  // character set
  const name = new TextDecoder().decode(reader.take(nameSize)).replace(/\0.*$/s, "");
  const type = new ByteReader(reader.take(typeSize), 0, "attribute");
  const isOne = hexOf(reader.take(extentSize)) === ONE_VALUE;
  if (isOne && hexOf(type.bytes) === UNSIGNED_64) fields.set(name, reader.exact64());
  if ((type.u32() & 0x0f) === 3) fields.set(name, isOne ? reader.take(type.u32()) : new Uint8Array());  // 3: text
}

/** Returns the attributes of an object that are whole numbers, or texts of fixed length. */
export function readAttributes(messages: Message[]): Fields {
  const fields: Fields = new Map();
  for (const { type, body } of messages) {
    if (type === ATTRIBUTE_INFO && hexOf(body) !== NO_HEAP)
      refuse("found attributes in a heap, as older builds of avo wrote them, must be in the header: " +
        "avo lab FILE makes a page of it");
    if (type === ATTRIBUTE) addAttribute(body, fields);
  }
  return fields;
}
