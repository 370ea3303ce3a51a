// SPDX-License-Identifier: Apache-2.0
// Tables of HDF5 as avo writes them (io/recording/hdf5_writer.cpp): the times in one piece, and all others in chunks. A
// B-tree (version 1) leads to the chunks.
import { ByteReader, hexOf, refuse } from "./bytes.ts";
import { DATA_LAYOUT, DATASPACE, DATATYPE, FILTER_PIPELINE, type Message, messageOf, readExtent, refuseForeign,
  requireSignature, requireVersion } from "./hdf5_objects.ts";

/** Datatype messages; for the enumeration only the class, because its size is checked as well. */
export const FLOAT64 = "11 20 3f 00 08 00 00 00 00 00 40 00 34 0b 00 34 ff 03 00 00";
export const FLOAT32 = "11 20 1f 00 04 00 00 00 00 00 20 00 17 08 00 17 7f 00 00 00";
export const ENUMERATION = "enumeration of one byte";
const BYTES: Record<string, number> = { [FLOAT64]: 8, [FLOAT32]: 4, [ENUMERATION]: 1 };

const SHUFFLE = 2, DEFLATE = 1;
const MOST_LEVEL = 8;

const product = (lengths: number[]) => lengths.reduce((all, length) => all * length, 1);

function requireType(messages: Message[], name: string, type: string): void {
  const reader = messageOf(messages, DATATYPE, `type of ${name}`);
  const bytes = reader.bytes;
  const found = bytes.length >= 8 && (bytes[0] & 0x0f) === 8 && hexOf(bytes.subarray(4, 8)) === "01 00 00 00"
    ? ENUMERATION : hexOf(bytes.subarray(0, 20));
  if (found !== type) refuseForeign(`type of ${name}`, found, type);
}

/** Returns the lengths of the table. */
function lengthsOf(messages: Message[], name: string): number[] {
  return readExtent(messageOf(messages, DATASPACE, `size of ${name}`)) ?? refuse(`${name}: found nothing in it`);
}

/** Returns a reader behind the layout's version and class; the class must be the given one. */
function layoutOf(messages: Message[], name: string, kind: number): ByteReader {
  const reader = messageOf(messages, DATA_LAYOUT, `layout of ${name}`);
  requireVersion(reader, `layout of ${name}`, 3);
  const found = reader.u8();
  if (found !== kind) refuseForeign(`class of the layout of ${name}`, found, kind);
  return reader;
}

/** Reads all numbers of a list in one piece. */
export function readList(file: Uint8Array, messages: Message[], name: string): Float64Array {
  const lengths = lengthsOf(messages, name);
  requireType(messages, name, FLOAT64);
  const layout = layoutOf(messages, name, 1);
  const [address, size] = [layout.u64(), layout.u64()];
  if (lengths.length !== 1 || lengths[0] === 0 || size !== 8 * lengths[0])
    refuse(`${name}: found no list, must be one of all times`);
  return new ByteReader(file, address, `list "${name}"`).float64s(lengths[0]);
}

function requireFilters(messages: Message[], name: string, type: string): void {
  const must = BYTES[type] > 1 ? [SHUFFLE, DEFLATE] : [DEFLATE];
  const reader = messageOf(messages, FILTER_PIPELINE, `filters of ${name}`);
  requireVersion(reader, `filters of ${name}`, 2);
  const count = reader.u8();
  const found: number[] = [];
  for (let k = 0; k < count; ++k) {
    const id = reader.u16();
    if (id >= 256) refuseForeign(`filters of ${name}`, id, must.join(", "));
    reader.skip(2);
    reader.skip(4 * reader.u16());
    found.push(id);
  }
  if (found.join() !== must.join()) refuseForeign(`filters of ${name}`, found.join(", "), must.join(", "));
}

interface ChunkIndex { name: string; lengths: number[]; chunk: number[]; begin: Float64Array; size: Float64Array }

/** The entry of a leaf or of an inner node; the place of the latter is that of the first chunk below it. */
interface Entry { size: number; place: number[]; address: number }

function readEntries(reader: ByteReader, count: number, index: ChunkIndex): Entry[] {
  return Array.from({ length: count }, () => {
    const size = reader.u32();
    if (reader.u32() !== 0) refuseForeign(`filters of a chunk of ${index.name}`, "some that were left out", "all");
    const place = index.lengths.map(() => reader.u64());
    reader.skip(8);  // within an element
    return { size, place, address: reader.u64() };
  });
}

function addChunk(file: Uint8Array, entry: Entry, index: ChunkIndex): void {
  let number = 0;
  for (let d = 0; d < index.chunk.length; ++d) {
    const part = entry.place[d] / index.chunk[d];
    if (!Number.isInteger(part) || entry.place[d] >= index.lengths[d])
      refuse(`${index.name}: found a chunk out of its place, damaged`);
    number = number * Math.ceil(index.lengths[d] / index.chunk[d]) + part;
  }
  if (index.size[number] !== 0 || entry.size === 0) refuse(`${index.name}: found a chunk twice or empty, damaged`);
  new ByteReader(file, entry.address, `chunk of ${index.name}`).skip(entry.size);
  index.begin[number] = entry.address;
  index.size[number] = entry.size;
}

function readNode(file: Uint8Array, address: number, level: number | null, index: ChunkIndex, seen: Set<number>): void {
  const reader = new ByteReader(file, address, "B-tree of chunks");
  requireSignature(reader, "TREE");
  const type = reader.u8();
  const found = reader.u8();
  if (type !== 1 || found > MOST_LEVEL || (level !== null && found !== level) || seen.has(address))
    refuse(`${index.name}: found a damaged B-tree of chunks, must be whole`);
  seen.add(address);
  const count = reader.u16();
  reader.skip(16);  // siblings
  for (const entry of readEntries(reader, count, index))
    if (found === 0) addChunk(file, entry, index);
    else readNode(file, entry.address, found - 1, index, seen);
}

/** Returns the stored bytes of the chunk with that number; the last dimension varies fastest. */
export type Chunks = (number: number) => Uint8Array;

/** Reads a table of these lengths in chunks of this size; all chunks must be there. */
export function readChunks(file: Uint8Array, messages: Message[], name: string, type: string, lengths: number[],
    chunk: number[]): Chunks {
  const found = lengthsOf(messages, name);
  if (found.join() !== lengths.join())
    refuse(`${name}: found another table, must be one of ${lengths.join(" x ")}`);
  requireType(messages, name, type);
  requireFilters(messages, name, type);
  const layout = layoutOf(messages, name, 2);
  const rank = layout.u8();
  const address = layout.u64();
  const size = Array.from({ length: rank }, () => layout.u32());
  if (size.join() !== [...chunk, BYTES[type]].join())
    refuseForeign(`chunks of ${name}`, size.slice(0, -1).join(" x "), chunk.join(" x "));
  const count = product(lengths.map((length, d) => Math.ceil(length / chunk[d])));
  const ENTRY = 16 + 8 * rank;
  if (count * ENTRY > file.length) refuse(`${name}: found less than all of its rows, must be all`);
  const index: ChunkIndex = { name, lengths, chunk, begin: new Float64Array(count), size: new Float64Array(count) };
  readNode(file, address, null, index, new Set());
  if (index.size.includes(0)) refuse(`${name}: found less than all of its rows, must be all`);
  return (number) => file.subarray(index.begin[number], index.begin[number] + index.size[number]);
}
