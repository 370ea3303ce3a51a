// SPDX-License-Identifier: Apache-2.0
// Recordings as HDF5 files with avo's layout (docs/recordings.md).
import { refuse } from "./bytes.ts";
import { BLOCK_TIMES, type BlockShape, partsOf, robotsOfChunk, type StoredBlocks } from "./blocks.ts";
import { readAttributes } from "./hdf5_attributes.ts";
import { linksOf, type Message, readObject, readSuperblock } from "./hdf5_objects.ts";
import { ENUMERATION, FLOAT32, FLOAT64, readChunks, readList } from "./hdf5_tables.ts";
import { STATE_COLUMNS } from "./recording.ts";
import { headerOf, type OpenedBlocks, requireFormat, textField } from "./recording_fields.ts";
import { inQuotes } from "./words.ts";

function requireColumns(file: Uint8Array, state: Message[], columns: number): void {
  const found = textField(readAttributes(file, state), "columns");
  const must = STATE_COLUMNS.slice(0, columns).join(",");
  if (found !== must) refuse(`state: columns: found ${inQuotes(found)}, must be ${must}`);
}

/** Reads everything except the chunks. */
export function openHdf5(file: Uint8Array): OpenedBlocks {
  const root = readObject(file, readSuperblock(file));
  const fields = readAttributes(file, root);
  requireFormat(fields);
  const header = headerOf(fields);
  const links = linksOf(root);
  const table = (name: string) => readObject(file, links.get(name) ?? refuse(`found no table "${name}"`));
  const times = readList(file, table("time"), "time");
  const shape: BlockShape = { robots: header.robots, columns: header.headings ? 6 : 4 };
  const parts = partsOf(shape);
  const lengths = [times.length, shape.robots];
  const chunk = [BLOCK_TIMES, robotsOfChunk(shape)];
  const states = table("state");
  requireColumns(file, states, shape.columns);
  const state = readChunks(file, states, "state", FLOAT64, [...lengths, shape.columns], [...chunk, 1]);
  const status = readChunks(file, table("status"), "status", ENUMERATION, lengths, chunk);
  const clearance = readChunks(file, table("clearance"), "clearance", FLOAT32, lengths, chunk);
  const stored: StoredBlocks = {
    shape,
    times,
    chunk(block, number) {
      const part = number % parts;
      const column = Math.floor(number / parts);
      if (column < shape.columns) return state((block * parts + part) * shape.columns + column);
      return (column === shape.columns ? status : clearance)(block * parts + part);
    },
  };
  return { header, fields, stored };
}
