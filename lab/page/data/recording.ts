// SPDX-License-Identifier: Apache-2.0
// A recording in the form that views use, whatever its file format.
import type { Dimensions, RecordedScene, RecordingHeader } from "../../avo/avo.ts";

/** All robots at one time, each at its number; absent robots have NaN. */
export interface RecordedFrame {
  time: number;              // s
  there: Uint8Array;         // 1 or 0
  position: Float64Array;    // m, x and y (and z in space) of each
  velocity: Float64Array;    // m/s
  heading: Float64Array;     // rad; NaN for a robot without a heading
  speed: Float64Array;       // m/s along the heading; NaN for a robot without a heading
  status: Uint8Array;        // of the last decision by its number, 255 for an absent robot; in CSV unknown: 0
  clearance: Float32Array;   // m, to the nearest other disc, +inf if there is none; in CSV unknown: NaN
}

export interface Recording extends Omit<RecordingHeader, "scene"> {
  kind: "hdf5" | "spool" | "csv";
  name: string;
  times: Float64Array;       // s, ascending
  scene: RecordedScene | null;
  /** Reads the frame at times[k]. Rejects with one line if the rows are damaged. */
  frame(k: number): Promise<RecordedFrame>;
}

/** Stands in place of an absent robot's status. */
export const ABSENT = 255;
export const PLANE_COLUMNS = ["x", "y", "vx", "vy", "heading", "speed"];
export const SPACE_COLUMNS = ["x", "y", "z", "vx", "vy", "vz"];
/** The limit of any number in a recording: m, m/s, rad, s. */
export const LARGEST = 1e12;
export const LARGEST_RANGE = "from -1e+12 to 1e+12";
/** The limit of robots: a frame has memory for all of them. */
export const MOST_ROBOTS = 100_000;

/** Returns a frame without robots. */
export function emptyFrame(time: number, robots: number, dimensions: Dimensions): RecordedFrame {
  return {
    time,
    there: new Uint8Array(robots),
    position: new Float64Array(dimensions * robots).fill(NaN),
    velocity: new Float64Array(dimensions * robots).fill(NaN),
    heading: new Float64Array(robots).fill(NaN),
    speed: new Float64Array(robots).fill(NaN),
    status: new Uint8Array(robots).fill(ABSENT),
    clearance: new Float32Array(robots).fill(NaN),
  };
}
