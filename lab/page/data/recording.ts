// SPDX-License-Identifier: Apache-2.0
// What a recording is to those who show it, whatever file it comes from.

export interface SceneFile { path: string; text: string; builtin: boolean }

/** The scene that a recording has in itself, and how it was run. */
export interface RecordedScene {
  name: string;
  yaml: string;
  overrides: string[];
  files: SceneFile[];
  start_at_rest: boolean;
  limit_speed: boolean;
}

/** All robots at one time, each at its number; of those that are not there: NaN. */
export interface RecordedFrame {
  time: number;              // s
  there: Uint8Array;         // 1 or 0
  position: Float64Array;    // m, x and y of each
  velocity: Float64Array;    // m/s
  heading: Float64Array;     // rad; NaN of who has none
  speed: Float64Array;       // m/s along the heading; NaN of who has none
  status: Uint8Array;        // of the last decision by its number, 255 of who is not there; CSV does not tell: 0
  clearance: Float32Array;   // m, to the nearest other disc, +inf if nobody is there; CSV does not tell: NaN
}

export interface Recording {
  kind: "hdf5" | "spool" | "csv";
  name: string;
  times: Float64Array;       // s, ascending
  robots: number;            // their numbers are less
  headings: boolean;         // whether any robot may have one
  every: number;             // steps of the run from row to row
  scene: RecordedScene | null;
  attributes: Record<string, string | number | bigint>;  // whole numbers beyond 2^53 are bigint
  /** Of times[k]. Rejects with one line where the rows are damaged. */
  frame(k: number): Promise<RecordedFrame>;
}

/** In place of the status of who is not there. */
export const ABSENT = 255;
export const STATE_COLUMNS = ["x", "y", "vx", "vy", "heading", "speed"];
/** Of any number in a recording: m, m/s, rad, s. */
export const LARGEST = 1e12;
export const LARGEST_RANGE = "from -1e+12 to 1e+12";
/** A frame has memory for all of them. */
export const MOST_ROBOTS = 100_000;

/** Nobody is there. */
export function emptyFrame(time: number, robots: number): RecordedFrame {
  return {
    time,
    there: new Uint8Array(robots),
    position: new Float64Array(2 * robots).fill(NaN),
    velocity: new Float64Array(2 * robots).fill(NaN),
    heading: new Float64Array(robots).fill(NaN),
    speed: new Float64Array(robots).fill(NaN),
    status: new Uint8Array(robots).fill(ABSENT),
    clearance: new Float32Array(robots).fill(NaN),
  };
}
