// SPDX-License-Identifier: Apache-2.0
// A run that can be shown: simulated now, or recorded.
import type { Moment, SceneInfo, Simulation } from "../../avo/avo.ts";
import type { Contact } from "./lab.ts";
import type { PastColumns } from "./past.ts";

export interface Run {
  readonly live: Simulation | null;
  readonly info: SceneInfo;
  readonly text: string;            // of the scene, at this moment; "" if unknown
  readonly moment: Moment;
  readonly before: Moment | null;   // one step earlier, if known: the picture moves from there to `moment`
  readonly past: PastColumns;
  readonly contacts: readonly Contact[];
  readonly start: number;           // s
  readonly end: number;             // s
  readonly handmade: boolean;       // whether it was changed before this moment by edits that its text does not contain
  canStep(): boolean;
  step(): boolean;                  // false: the next step has not been read yet
  stepBack(): Promise<void> | void;
  /** Goes to the last step at or before `time`; a live run that has not been there yet keeps its place. */
  goTo(time: number): Promise<void> | void;
}

/** Returns the index of the last of ascending `times` that is at most `time`, with a tolerance for rounding; at least
 * 0. */
export function lastAt(times: ArrayLike<number>, time: number): number {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle]! <= time + 1e-9) low = middle + 1;
    else high = middle;
  }
  return Math.max(0, low - 1);
}
