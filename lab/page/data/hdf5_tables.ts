// SPDX-License-Identifier: Apache-2.0
// Tables of HDF5 as avo writes them (io/recording/hdf5_writer.cpp): the times in one piece, and all others in chunks. A
// B-tree (version 1) leads to the chunks.
import { ByteReader, refuse } from "./bytes.ts";
import { type Message, messageOf, requireBytes } from "./hdf5_objects.ts";

const DATASPACE = 0x01, DATATYPE = 0x03, DATA_LAYOUT = 0x08, FILTER_PIPELINE = 0x0b;

/** The bytes of a number, and what the messages of its type and filters begin with. */
export interface Kind { bytes: number; type: string; filters: string }

const DEFLATE = "01 00 01 00 01 00 01 00 00 00";
const shuffled = (bytes: number) => `02 02 02 00 01 00 01 00 0${bytes} 00 00 00 ${DEFLATE}`;
export const FLOAT64: Kind =
  { bytes: 8, type: "11 20 3f 00 08 00 00 00 00 00 40 00 34 0b 00 34 ff 03 00 00", filters: shuffled(8) };
export const FLOAT32: Kind =
  { bytes: 4, type: "11 20 1f 00 04 00 00 00 00 00 20 00 17 08 00 17 7f 00 00 00", filters: shuffled(4) };
export const ENUMERATION: Kind = { bytes: 1, type: "38 08 00 00 01 00 00 00", filters: `02 01 ${DEFLATE}` };

/** Returns the lengths of a table of that rank. */
function lengthsOf(messages: Message[], name: string, rank: number, { type }: Kind): number[] {
  messageOf(messages, DATATYPE, `type of ${name}`, type);
  const size = messageOf(messages, DATASPACE, `size of ${name}`, `02 0${rank} 01 01`);  // version, rank, it has a limit
  return Array.from({ length: rank }, () => size.u64());
}

/** Reads all numbers of a list in one piece. */
export function readList(file: Uint8Array, messages: Message[], name: string): Float64Array {
  const [length] = lengthsOf(messages, name, 1, FLOAT64);
  const layout = messageOf(messages, DATA_LAYOUT, `layout of ${name}`, "03 01");  // version, in one piece
  if (length === 0) refuse(`${name}: found no list, must be one of all times`);
  return new ByteReader(file, layout.u64(), `list "${name}"`).float64s(length);
}

/** The stored chunks by number, and for each dimension their length and their count. */
interface ChunkIndex { name: string; lengths: number[]; counts: number[]; chunks: { at: number; size: number }[] }

/** Adds the chunks below a node, all in order. A node of level 0 leads to chunks themselves. */
function addChunks(file: Uint8Array, address: number, level: number | null, index: ChunkIndex): void {
  const { name, lengths, counts, chunks } = index;
  const reader = new ByteReader(file, address, "B-tree of chunks");
  requireBytes(reader, "B-tree of chunks", "54 52 45 45 01");  // TREE, of chunks
  const [found, count] = [reader.u8(), reader.u16()];
  if ((level ?? found) !== found || count === 0) refuse(`${name}: found a damaged B-tree of chunks, must be whole`);
  reader.skip(16);  // siblings
  for (let k = 0; k < count; ++k) {
    const size = reader.u32();
    requireBytes(reader, "filters that a chunk lacks", "00 00 00 00");
    const number = lengths.reduce((before, length, d) => before * counts[d] + reader.u64() / length, 0);
    reader.skip(8);  // within an element
    const at = reader.u64();
    if (found > 0) addChunks(file, at, found - 1, index);
    else if (number !== chunks.length) refuse(`${name}: found a chunk out of its place, damaged`);
    else chunks.push({ at: new ByteReader(file, at, `chunk of ${name}`).skip(size), size });
  }
}

/** Returns a function that finds the stored bytes of a chunk by its number; the last dimension varies fastest. The
 * table must have these lengths, and all its chunks, which have this size. */
export function readChunks(file: Uint8Array, messages: Message[], name: string, kind: Kind, lengths: number[],
    chunk: number[]): (number: number) => Uint8Array {
  if (lengthsOf(messages, name, lengths.length, kind).join() !== lengths.join())
    refuse(`${name}: found another table, must be one of ${lengths.join(" x ")}`);
  messageOf(messages, FILTER_PIPELINE, `filters of ${name}`, kind.filters);
  const layout = messageOf(messages, DATA_LAYOUT, `layout of ${name}`, `03 02 0${lengths.length + 1}`);  // in chunks
  const address = layout.u64();
  const must = [...chunk, kind.bytes].join(" x "), found = [...chunk, kind.bytes].map(() => layout.u32()).join(" x ");
  if (found !== must) refuse(`chunks of ${name}: found ${found}, must be ${must}, as avo writes it`);
  const counts = lengths.map((length, d) => Math.ceil(length / chunk[d]));
  const chunks: ChunkIndex["chunks"] = [];
  addChunks(file, address, null, { name, lengths: chunk, counts, chunks });
  if (chunks.length !== counts.reduce((all, count) => all * count, 1))
    refuse(`${name}: found less than all of its rows, must be all`);
  return (number) => file.subarray(chunks[number].at, chunks[number].at + chunks[number].size);
}
