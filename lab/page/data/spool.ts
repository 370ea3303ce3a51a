// SPDX-License-Identifier: Apache-2.0
// Spools (io/recording/spool.h), which a killed run leaves: records with checksums. Everything behind the last whole
// block is lost. The module reads the header; the blocks stay parts of the file until blocks.ts needs one of them.
import type { Library } from "../../avo/avo.ts";
import { beginsWith, ByteReader, RecordingError, refuse } from "./bytes.ts";
import { BLOCK_TIMES, type BlockShape, chunksOf, type OpenedBlocks, shapeOf } from "./blocks.ts";
import { MOST_ROBOTS } from "./recording.ts";

const BEGIN = "avo spool 1\n";
const HEADER = 1, BLOCK = 2;
const HEAD_SIZE = 20;  // type, checksum of the payload, its length, checksum of these

export const isSpool = (bytes: Uint8Array) => beginsWith(bytes, BEGIN);

const CRC_TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
  let value = byte;
  for (let bit = 0; bit < 8; ++bit) value = (value >>> 1) ^ ((value & 1) !== 0 ? 0xedb88320 : 0);
  return value;
});

function crc32(bytes: Uint8Array): number {
  let value = -1;
  for (let k = 0; k < bytes.length; ++k) value = CRC_TABLE[(value ^ bytes[k]) & 0xff] ^ (value >>> 8);
  return ~value >>> 0;
}

interface Record { type: number; payload: Uint8Array }

/** Returns null if there is no whole record. */
function readRecord(reader: ByteReader): Record | null {
  if (reader.left < HEAD_SIZE) return null;
  const begin = reader.offset;
  const [type, checksum, length] = [reader.u32(), reader.u32(), reader.u64()];
  if (reader.u32() !== crc32(reader.bytes.subarray(begin, begin + 16)) || length > reader.left) return null;
  const payload = reader.take(length);
  return crc32(payload) === checksum ? { type, payload } : null;
}

interface SpoolBlock { times: Float64Array; chunks: Uint8Array[] }

/** Returns null if it is not a block of that shape. */
function blockOf(payload: Uint8Array, shape: BlockShape): SpoolBlock | null {
  try {
    const reader = new ByteReader(payload);
    const count = reader.u64();
    if (count === 0 || count > BLOCK_TIMES) return null;
    const times = reader.float64s(count);
    const chunks = Array.from({ length: chunksOf(shape) }, () => reader.take(reader.u64()));
    return reader.left === 0 ? { times, chunks } : null;
  } catch (error) {
    if (error instanceof RecordingError) return null;
    throw error;
  }
}

/** Returns all whole blocks. */
export function openSpool(library: Library, file: Uint8Array): OpenedBlocks {
  const reader = new ByteReader(file, BEGIN.length);
  const first = readRecord(reader);
  if (first === null || first.type !== HEADER)
    refuse("found no whole header, cut off or damaged, must be a spool of avo");
  const header = library.readHeader(first.payload);
  const shape = shapeOf(header);
  if (shape.robots > MOST_ROBOTS)
    refuse(`robots: found ${shape.robots}, must be ${MOST_ROBOTS} at most to be shown here`);
  const blocks: SpoolBlock[] = [];
  let record = readRecord(reader);
  for (; record?.type === BLOCK; record = readRecord(reader)) {
    const block = blockOf(record.payload, shape);
    if (block === null) break;
    blocks.push(block);
    if (block.times.length < BLOCK_TIMES) break;
  }
  if (blocks.length === 0) refuse("found no whole block, must be one or more");
  const times = Float64Array.from(blocks.flatMap((block) => Array.from(block.times)));
  return { header, stored: { shape, times, chunk: (block, number) => blocks[block].chunks[number] } };
}
