// SPDX-License-Identifier: Apache-2.0
// States as a table of text: the same bytes that `avo run --record FILE.csv` would write.
import { shortest } from "./words.ts";

/** Robots at one time: those of a recording, where `there` tells which are present, or those of a run, by their
 * numbers. */
export interface CsvFrame {
  time: number;             // s
  robot?: ArrayLike<number>;  // ascending; without it, each robot's number is its index
  there?: ArrayLike<number>;
  position: ArrayLike<number>;
  velocity: ArrayLike<number>;
  heading?: ArrayLike<number>;  // NaN for a robot without a heading
  speed?: ArrayLike<number>;    // along the heading; without it, the speed follows from the velocity
}

/** Returns m/s, the velocity's component along the heading (rad): Library.speedAlong. */
export type SpeedAlong = (heading: number, vx: number, vy: number) => number;

/** `headings`: write headings and speeds of robots with wheels or wings. `every`: steps from row to row. */
export interface CsvOptions { headings?: boolean; every?: number; speedAlong?: SpeedAlong }

export function csvHeader({ headings = false, every = 1 }: CsvOptions = {}): string {
  return `time,robot,x,y,vx,vy${headings ? ",heading,speed" : ""}${every > 1 ? ",every" : ""}\n`;
}

function headingColumns(frame: CsvFrame, k: number, speedAlong?: SpeedAlong): string {
  const heading = frame.heading?.[k] ?? NaN;
  if (Number.isNaN(heading)) return ",,";
  const speed = frame.speed?.[k] ?? speedAlong!(heading, frame.velocity[2 * k]!, frame.velocity[2 * k + 1]!);
  return `,${shortest(heading)},${shortest(speed)}`;
}

export function csvRows(frame: CsvFrame, { headings = false, every = 1, speedAlong }: CsvOptions = {}): string {
  const time = shortest(frame.time);
  const { position: p, velocity: v } = frame;
  const last = every > 1 ? `,${every}\n` : "\n";
  let rows = "";
  for (let k = 0; 2 * k < p.length; ++k) {
    if (frame.there !== undefined && frame.there[k] === 0) continue;
    const state = [p[2 * k], p[2 * k + 1], v[2 * k], v[2 * k + 1]].map(shortest).join(",");
    rows += `${time},${frame.robot?.[k] ?? k},${state}${headings ? headingColumns(frame, k, speedAlong) : ""}${last}`;
  }
  return rows;
}

export function csvOf(frames: Iterable<CsvFrame>, options: CsvOptions = {}): string {
  let text = csvHeader(options);
  for (const frame of frames) text += csvRows(frame, options);
  return text;
}
