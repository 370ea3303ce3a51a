// SPDX-License-Identifier: Apache-2.0
// Recordings as CSV (docs/check.md), which the library reads.
import { type Dimensions, type Library, TABLE_ROW, TABLE_TIME } from "../../avo/avo.ts";
import { emptyFrame, MOST_ROBOTS, type Recording, type RecordedFrame } from "./recording.ts";

const COLUMNS = ["time", "robot", "x", "y", "vx", "vy"];

/** Returns the fields of the first line. */
function headOf(bytes: Uint8Array): string[] {
  const [line] = new TextDecoder().decode(bytes.subarray(0, 4096)).split("\n", 1);
  return line.split(",").map((field) => field.replace(/^[ \t]*"?|"?[ \t\r]*$/g, ""));
}

/** Returns whether the first line names columns of a recording; otherwise it begins a scene. */
export function looksLikeCsv(bytes: Uint8Array): boolean {
  const fields = headOf(bytes);
  return COLUMNS.filter((name) => fields.includes(name)).length >= 2;
}

/** `numbers`: of that time and those after it. */
function frameOf(numbers: Float64Array, robots: number, dimensions: Dimensions): RecordedFrame {
  const [time, , rows] = numbers;
  const frame = emptyFrame(time, robots, dimensions);
  for (let at = TABLE_TIME; at < TABLE_TIME + TABLE_ROW * rows; at += TABLE_ROW) {
    const robot = numbers[at];
    frame.there[robot] = 1;
    const middle = at + 1 + dimensions;
    frame.position.set(numbers.subarray(at + 1, middle), dimensions * robot);
    frame.velocity.set(numbers.subarray(middle, middle + dimensions), dimensions * robot);
    frame.status[robot] = 0;
    if (dimensions === 3) continue;
    frame.heading[robot] = numbers[at + 5];
    frame.speed[robot] = numbers[at + 6];
  }
  return frame;
}

/** Throws AvoError. */
export function openCsv(library: Library, name: string, bytes: Uint8Array): Recording {
  const times: number[] = [], places: { part: Float64Array; at: number }[] = [];
  const dimensions = headOf(bytes).includes("z") ? 3 : 2;
  let [robots, every, headings] = [0, 1, false];
  for (const part of library.readTable(name, bytes, dimensions, MOST_ROBOTS))
    for (let at = 0; at < part.length; ) {
      times.push(part[at]);
      places.push({ part, at });
      every = Math.max(every, part[at + 1]);
      const end = at + TABLE_TIME + TABLE_ROW * part[at + 2];
      for (at += TABLE_TIME; at < end; at += TABLE_ROW) {
        robots = Math.max(robots, part[at] + 1);
        headings ||= dimensions === 2 && !Number.isNaN(part[at + 5]);
      }
    }
  return { kind: "csv", name, dimensions, times: Float64Array.from(times), robots, headings, every, scene: null,
    frame: async (k) => frameOf(places[k].part.subarray(places[k].at), robots, dimensions) };
}
