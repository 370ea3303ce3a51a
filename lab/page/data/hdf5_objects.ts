// SPDX-License-Identifier: Apache-2.0
// HDF5 as avo writes it (io/recording/hdf5_output.cpp): superblock 2, and objects, whose headers are lists of messages.
// Names and numbers are those of the HDF5 File Format Specification.
import { beginsWith, ByteReader, hexOf, refuse } from "./bytes.ts";
import { requireChecksum } from "./hdf5_checksum.ts";

const SIGNATURE = "\x89HDF\r\n\x1a\n";

export const DATASPACE = 0x01, DATATYPE = 0x03, LINK = 0x06, DATA_LAYOUT = 0x08, FILTER_PIPELINE = 0x0b,
  ATTRIBUTE = 0x0c, CONTINUATION = 0x10, ATTRIBUTE_INFO = 0x15;

export interface Message { type: number; body: Uint8Array }

export const isHdf5 = (bytes: Uint8Array) => beginsWith(bytes, SIGNATURE);

/** Refuses part of the file, which must come from another writer. */
export function refuseForeign(what: string, found: unknown, must: unknown): never {
  refuse(`${what}: found ${found}, must be ${must}, as avo writes it`);
}

export function requireSignature(reader: ByteReader, signature: string): void {
  if (!beginsWith(reader.take(signature.length), signature))
    refuse(`found no ${signature} where it must be, damaged or not of avo`);
}

export function requireVersion(reader: ByteReader, of: string, version: number): void {
  const found = reader.u8();
  if (found !== version) refuseForeign(`version of the ${of}`, found, version);
}

/** Returns the address of the root group's header. */
export function readSuperblock(file: Uint8Array): number {
  const reader = new ByteReader(file, SIGNATURE.length);
  const version = reader.u8();
  if (version !== 2 && version !== 3) refuseForeign("version of the superblock", version, 2);
  const sizes = hexOf(reader.take(2));
  if (sizes !== "08 08") refuseForeign("sizes of addresses and lengths", sizes, "08 08");
  reader.skip(1);
  const base = reader.u64();
  if (base !== 0) refuseForeign("base address", base, 0);
  reader.skip(8);
  const end = reader.u64();
  const root = reader.u64();
  requireChecksum(reader, 0, "superblock");
  if (end > file.length) refuse(`found ${file.length} bytes, must be ${end}: the file is cut off`);
  return root;
}

/** Reads the messages from the reader's place to `end`, where the block's checksum stands. */
function readBlock(reader: ByteReader, begin: number, end: number, ordered: boolean): Message[] {
  const messages: Message[] = [];
  const head = ordered ? 6 : 4;
  while (end - reader.offset >= head) {
    const type = reader.u8();
    const size = reader.u16();
    const flags = reader.u8();
    if (ordered) reader.skip(2);
    if (size > end - reader.offset) refuse("found a damaged header of an object, must be whole");
    if ((flags & 2) !== 0) refuseForeign(`message ${type} of an object`, "one that is shared", "in its header");
    messages.push({ type, body: reader.take(size) });
  }
  reader.skip(end - reader.offset);
  requireChecksum(reader, begin, "header of an object");
  return messages;
}

/** Reads the first block of the header of the object at `address`, and whether its messages have an order of creation. */
function readFirstBlock(file: Uint8Array, address: number): { messages: Message[]; ordered: boolean } {
  const reader = new ByteReader(file, address);
  requireSignature(reader, "OHDR");
  requireVersion(reader, "header of an object", 2);
  const flags = reader.u8();
  if ((flags & 0x20) !== 0) reader.skip(16);  // times of day
  if ((flags & 0x10) !== 0) reader.skip(4);   // limits beyond which attributes move to a heap
  const size = reader.uint(1 << (flags & 3));
  const ordered = (flags & 4) !== 0;
  return { messages: readBlock(reader, address, reader.offset + size, ordered), ordered };
}

/** Returns all messages of the object whose header is at `address`. */
export function readObject(file: Uint8Array, address: number): Message[] {
  const { messages, ordered } = readFirstBlock(file, address);
  const seen = new Set<number>();
  for (let k = 0; k < messages.length; ++k) {
    if (messages[k].type !== CONTINUATION) continue;
    const link = new ByteReader(messages[k].body);
    const begin = link.u64();
    const end = begin + link.u64() - 4;
    if (seen.has(begin)) refuse("found a header of an object that goes on in itself");
    seen.add(begin);
    const reader = new ByteReader(file, begin);
    requireSignature(reader, "OCHK");
    messages.push(...readBlock(reader, begin, end, ordered));
  }
  return messages;
}

export function messageOf(messages: Message[], type: number, what: string): ByteReader {
  const found = messages.find((message) => message.type === type);
  return new ByteReader(found?.body ?? refuse(`found no ${what}, must be there`), 0, what);
}

/** Returns the addresses of the objects in a group, by name. */
export function linksOf(messages: Message[]): Map<string, number> {
  const links = new Map<string, number>();
  for (const { type, body } of messages) {
    if (type !== LINK) continue;
    const reader = new ByteReader(body, 0, "link");
    requireVersion(reader, "link", 1);
    const flags = reader.u8();
    const kind = (flags & 8) !== 0 ? reader.u8() : 0;
    if ((flags & 4) !== 0) reader.skip(8);   // order of creation
    if ((flags & 16) !== 0) reader.skip(1);  // character set
    const name = new TextDecoder().decode(reader.take(reader.uint(1 << (flags & 3))));
    if (kind === 0) links.set(name, reader.u64());
  }
  return links;
}

/** Returns the lengths of a table, an empty list for a single value, and null for an empty dataset. */
export function readExtent(reader: ByteReader): number[] | null {
  requireVersion(reader, "size of a table", 2);
  const rank = reader.u8();
  reader.skip(1);
  const kind = reader.u8();
  if (kind === 2) return null;
  return Array.from({ length: rank }, () => reader.u64());
}
