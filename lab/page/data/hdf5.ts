// SPDX-License-Identifier: Apache-2.0
// Recordings as HDF5 files with avo's layout (docs/recordings.md).
import type { Library } from "../../avo/avo.ts";
import { refuse } from "./bytes.ts";
import { BLOCK_TIMES, type OpenedBlocks, partsOf, robotsOfChunk, shapeOf } from "./blocks.ts";
import { linksOf, readAttributes, readObject, readSuperblock } from "./hdf5_objects.ts";
import { ENUMERATION, FLOAT32, FLOAT64, readChunks, readList } from "./hdf5_tables.ts";
import { packed, requireText } from "./recording_fields.ts";

/** Reads everything except the chunks. */
export function openHdf5(library: Library, file: Uint8Array): OpenedBlocks {
  const root = readObject(file, readSuperblock(file));
  const fields = readAttributes(root);
  requireText(fields, "format", "avo recording 1");
  const header = library.readHeader(packed(fields));
  const links = linksOf(root);
  const table = (name: string) => readObject(file, links.get(name) ?? refuse(`found no table "${name}"`));
  const times = readList(file, table("time"), "time");
  const shape = shapeOf(header), { robots, columns } = shape;
  const parts = partsOf(shape), chunk = [BLOCK_TIMES, robotsOfChunk(shape)], lengths = [times.length, robots];
  const states = table("state");
  requireText(readAttributes(states), "columns", columns.join(","), "state: ");
  const state = readChunks(file, states, "state", FLOAT64, [...lengths, columns.length], [...chunk, 1]);
  const status = readChunks(file, table("status"), "status", ENUMERATION, lengths, chunk);
  const clearance = readChunks(file, table("clearance"), "clearance", FLOAT32, lengths, chunk);
  const stored = (block: number, number: number) => {
    const part = block * parts + number % parts, column = Math.floor(number / parts);
    if (column < columns.length) return state(part * columns.length + column);
    return (column === columns.length ? status : clearance)(part);
  };
  return { header, stored: { shape, times, chunk: stored } };
}
