// SPDX-License-Identifier: Apache-2.0
// Recordings in blocks of 64 times. Their chunks are shuffled and compressed by io/recording/recording_blocks.cpp.
// Shown data are uncompressed block by block, and the last blocks are kept. The module does not do this. The browser's
// own streams uncompress while the page goes on. The memory of a module, unlike that of the page, never shrinks after a
// large block.
import type { RecordingHeader } from "../../avo/avo.ts";
import { refuse } from "./bytes.ts";
import { uncompressed } from "./compression.ts";
import { ABSENT, emptyFrame, LARGEST, LARGEST_RANGE, MOST_ROBOTS, PLANE_COLUMNS, type RecordedFrame,
  SPACE_COLUMNS } from "./recording.ts";

export const BLOCK_TIMES = 64;
const MOST_ROBOTS_OF_CHUNK = 1024;
const MOST_PER_BYTE = 1032;         // the limit of deflate
const KEPT_BYTES = 96 * 2 ** 20;    // of blocks, but at least two blocks
const LAST_STATUS = 6;              // of PlanStatus

export interface BlockShape { robots: number; columns: readonly string[] }  // columns: of a robot's state

export const shapeOf = ({ robots, headings, dimensions }: RecordingHeader): BlockShape =>
  ({ robots, columns: dimensions === 3 ? SPACE_COLUMNS : PLANE_COLUMNS.slice(0, headings ? 6 : 4) });

/** Robots are split into parts of this number, each a chunk of its own. */
export const partsOf = ({ robots }: BlockShape) => Math.ceil(robots / MOST_ROBOTS_OF_CHUNK);
export const robotsOfChunk = (shape: BlockShape) => Math.ceil(shape.robots / partsOf(shape));

/** The number of chunks of all columns, of the status, and of the clearance. */
export const chunksOf = (shape: BlockShape) => (shape.columns.length + 2) * partsOf(shape);

export interface StoredBlocks {
  shape: BlockShape;
  times: Float64Array;
  /** Stored bytes: all parts of each column, then those of the status and of the clearance. */
  chunk(block: number, number: number): Uint8Array;
}

export interface OpenedBlocks { header: RecordingHeader; stored: StoredBlocks }

/** Tables [time, robot]. */
interface Block { columns: Float64Array[]; status: Uint8Array; clearance: Float32Array }

/** Refuses data that promise more than the stored bytes can hold, before memory is allocated for them. */
export function requireSize({ shape, times, chunk }: StoredBlocks): void {
  if (shape.robots > MOST_ROBOTS)
    refuse(`robots: found ${shape.robots}, must be ${MOST_ROBOTS} at most to be shown here`);
  const blocks = Math.ceil(times.length / BLOCK_TIMES);
  const bytes = BLOCK_TIMES * shape.robots * (8 * shape.columns.length + 5);
  for (let b = 0; b < blocks; ++b) {
    let stored = 0;
    for (let k = 0; k < chunksOf(shape); ++k) stored += chunk(b, k).length;
    if (stored * MOST_PER_BYTE < bytes) refuse("found less than all of its rows, must be all");
  }
}

/** Refuses times that no run records. */
export function requireTimes(times: Float64Array): void {
  let last = -Infinity;
  for (const time of times) {
    const must = !Number.isFinite(time) ? "a finite number" : time < 0 ? ">= 0 s"
      : time <= last ? `> ${last} s, the time before` : time > LARGEST ? "<= 1e+12 s" : null;
    if (must !== null) refuse(`time: found ${time} s, must be ${must}`);
    last = time;
  }
}

/** Unshuffles all first bytes of the values, then all second bytes, and so on, to the robots from `first` on of every
 * row. */
function unshuffle(bytes: Uint8Array, size: number, width: number, table: Uint8Array, robots: number, first: number) {
  const count = Math.min(width, robots - first);
  for (let b = 0; b < size; ++b)
    for (let k = 0; k < BLOCK_TIMES; ++k) {
      let from = (b * BLOCK_TIMES + k) * width;
      let to = (k * robots + first) * size + b;
      for (let i = 0; i < count; ++i, to += size) table[to] = bytes[from++];
    }
}

async function readBlock(stored: StoredBlocks, block: number): Promise<Block> {
  const { shape } = stored;
  const { robots } = shape;
  const parts = partsOf(shape);
  const width = robotsOfChunk(shape);
  const rows = BLOCK_TIMES * robots;
  const columns = shape.columns.map(() => new Float64Array(rows));
  const status = new Uint8Array(rows);
  const clearance = new Float32Array(rows);
  await Promise.all([...columns, status, clearance].map(async (table, t) => {
    const size = table.BYTES_PER_ELEMENT;
    const target = new Uint8Array(table.buffer);
    for (let part = 0; part < parts; ++part) {
      const whole = BLOCK_TIMES * width * size;
      const bytes = await uncompressed(stored.chunk(block, t * parts + part), "deflate", whole);
      if (bytes.length !== whole) refuse("found a damaged block, must be whole");
      unshuffle(bytes, size, width, target, robots, part * width);
    }
  }));
  return { columns, status, clearance };
}

/** Returns the robot's columns: those of its position and velocity, or all, with a heading. */
function columnsOf(names: readonly string[], { columns }: Block, at: number): readonly string[] {
  const lacksHeading = names[4] === "heading" && Number.isNaN(columns[4][at]) && Number.isNaN(columns[5][at]);
  return lacksHeading ? names.slice(0, 4) : names;
}

function requireNumbers(names: readonly string[], block: Block, at: number, time: number, robot: number): void {
  const where = `time ${time} s, robot ${robot}`;
  if (block.status[at] > LAST_STATUS)
    refuse(`${where}: status: found ${block.status[at]}, must be 0 to ${LAST_STATUS}, or ${ABSENT}, absent`);
  columnsOf(names, block, at).forEach((name, c) => {
    const value = block.columns[c][at];
    if (Math.abs(value) <= LARGEST) return;
    const must = Number.isFinite(value) ? LARGEST_RANGE : "a finite number";
    refuse(`${where}: ${name}: found ${value}, must be ${must}`);
  });
}

function frameOf({ shape, times }: StoredBlocks, block: Block, k: number): RecordedFrame {
  const dimensions = shape.columns === SPACE_COLUMNS ? 3 : 2;
  const frame = emptyFrame(times[k], shape.robots, dimensions);
  const { columns } = block;
  const [heading, speed] = dimensions === 2 ? columns.slice(4) : [];
  const first = (k % BLOCK_TIMES) * shape.robots;
  for (let i = 0; i < shape.robots; ++i) {
    const at = first + i;
    if (block.status[at] === ABSENT) continue;
    requireNumbers(shape.columns, block, at, times[k], i);
    frame.there[i] = 1;
    for (let axis = 0; axis < dimensions; ++axis) {
      frame.position[dimensions * i + axis] = columns[axis][at];
      frame.velocity[dimensions * i + axis] = columns[dimensions + axis][at];
    }
    if (heading !== undefined) frame.heading[i] = heading[at];
    if (speed !== undefined) frame.speed[i] = speed[at];
    frame.status[i] = block.status[at];
    frame.clearance[i] = block.clearance[at];
  }
  return frame;
}

/** Reads frames; the block after that of the frame is read ahead. */
export function frameReader(stored: StoredBlocks): (k: number) => Promise<RecordedFrame> {
  const blocks = Math.ceil(stored.times.length / BLOCK_TIMES);
  const bytes = BLOCK_TIMES * stored.shape.robots * (8 * stored.shape.columns.length + 5);
  const most = Math.max(2, Math.floor(KEPT_BYTES / bytes));
  const kept = new Map<number, Promise<Block>>();  // in order of use, the last one at the end
  const block = (b: number): Promise<Block> => {
    const found = kept.get(b) ?? readBlock(stored, b);
    kept.delete(b);
    kept.set(b, found);
    if (kept.size > most) kept.delete(kept.keys().next().value as number);
    return found;
  };
  return async (k) => {
    const b = Math.floor(k / BLOCK_TIMES);
    const read = await block(b);
    if (b + 1 < blocks) block(b + 1).catch(() => undefined);  // an error is reported when the block is needed
    return frameOf(stored, read, k);
  };
}
