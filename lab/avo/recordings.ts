// SPDX-License-Identifier: Apache-2.0
// Recordings: headers of HDF5 and spools, and tables of states as CSV. Times of a table are lists of numbers: TABLE_TIME
// of a time, and then TABLE_ROW of each of its rows.
import { addText, emptyBytes, taken } from "./bytes.ts";
import { get, getText, put, type Instance } from "./instance.ts";
import type { Dimensions, RecordingHeader } from "./types.ts";

/** s, the steps from row to row, the number of rows. */
export const TABLE_TIME = 3;
/** The robot's number, x, y (m), vx, vy (m/s), heading (rad), speed along it (m/s). A heading that is NaN is none; where
 * a table is written, a speed that is NaN is that of the velocity. In space: the robot's number, x, y, z, vx, vy, vz. */
export const TABLE_ROW = 7;

/** `headings`: there are columns of headings and speeds. `every`: steps from row to row. `begins`: with the first line,
 * which names the columns. */
export interface TableForm {
  dimensions: Dimensions;
  headings: boolean;
  every: number;
  begins: boolean;
}

export function readHeader(instance: Instance, fields: Uint8Array): RecordingHeader {
  put(instance, fields);
  const bytes = get(instance, instance.functions["recording_header"]!());
  let at = bytes.indexOf("\n".charCodeAt(0)) + 1; // behind the line of JSON
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(0, at))) as RecordingHeader;
  header.scene.files = (header.scene.files as unknown as { path: string; builtin: boolean; size: number }[]).map(
    ({ path, builtin, size }) => ({ path, text: bytes.subarray(at, (at += size)), builtin }),
  );
  return header;
}

export function* readTable(instance: Instance, name: string, dimensions: Dimensions, mostRobots: number): Generator<Float64Array> {
  const bytes = emptyBytes();
  addText(bytes, name);
  put(instance, taken(bytes));
  instance.functions["open_table"]!(dimensions, mostRobots);
  for (let size; (size = instance.functions["read_table"]!()) > 0; ) yield new Float64Array(get(instance, size).buffer);
}

export function writeTable(instance: Instance, times: Float64Array, form: TableForm): string {
  const { dimensions, headings, every, begins } = form;
  put(instance, new Uint8Array(times.buffer, times.byteOffset, times.byteLength));
  return getText(instance, instance.functions["write_table"]!(dimensions, Number(headings), every, Number(begins)));
}
