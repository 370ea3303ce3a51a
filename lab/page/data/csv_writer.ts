// SPDX-License-Identifier: Apache-2.0
// States as a table of text: the same bytes that `avo run --record FILE.csv` would write.
import { type Library, TABLE_ROW, TABLE_TIME, type TableForm } from "../../avo/avo.ts";

/** Robots at one time: those of a recording, where `there` tells which are present, or those of a run, by their
 * numbers. */
export interface CsvFrame {
  time: number;             // s
  robot?: ArrayLike<number>;  // ascending; without it, each robot's number is its index
  there?: ArrayLike<number>;
  position: ArrayLike<number>;
  velocity: ArrayLike<number>;
  heading: ArrayLike<number>;  // NaN for a robot without a heading
  speed?: ArrayLike<number>;   // along the heading; without it, the speed follows from the velocity
}

/** Returns the lines of one time. */
export function csvOf(library: Library, { time, robot, there, position, velocity, heading, speed }: CsvFrame,
    form: TableForm): string {
  const numbers = new Float64Array(TABLE_TIME + TABLE_ROW * heading.length);
  let rows = 0;
  for (let k = 0; k < heading.length; ++k) {
    if (there?.[k] === 0) continue;
    const vectors = [position, velocity].flatMap((of) => Array.from({ length: form.dimensions }, (_, axis) => of[form.dimensions * k + axis]!));
    const row = [robot?.[k] ?? k, ...vectors, ...(form.dimensions === 3 ? [] : [heading[k]!, speed?.[k] ?? NaN])];
    numbers.set(row, TABLE_TIME + TABLE_ROW * rows++);
  }
  numbers.set([time, form.every, rows]);
  return library.writeTable(numbers.subarray(0, TABLE_TIME + TABLE_ROW * rows), form);
}
