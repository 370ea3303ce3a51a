// SPDX-License-Identifier: Apache-2.0
// What the package gives and takes. Names of data are those of scene files; SI units.

/** A file that a scene names, e.g. a map, by the path that the scene leads to. */
export interface SceneFile {
  path: string;
  text: string;
  builtin: boolean;
}

export interface SceneOptions {
  /** In front of messages; a scene without a name is called like it. */
  name?: string;
  /** "key=value" on keys of the scene, as `--set` takes them. */
  overrides?: string[];
  files?: SceneFile[];
  start_at_rest?: boolean;
  limit_speed?: boolean;
  /** Observes all steps, for Simulation.summary(); takes about a tenth of their time more. */
  metrics?: boolean;
}

export interface BuiltinScene {
  name: string;
  description: string;
  yaml: string;
}

/** A key of scene files that takes a plain value; `values` are all that are allowed, none of numbers. */
export interface Setting {
  key: string;
  values: string[];
}

/** One state: an entry, or x and y in turn, a robot that is there, by ascending number. Copies, to be kept. */
export interface Moment {
  time: number; // s
  steps: number;
  robot: Int32Array; // numbers as in the scene
  position: Float64Array; // m
  velocity: Float64Array; // m/s
  goal: Float64Array; // m
  heading: Float64Array; // rad; 0 of holonomic ones
  acceleration: Float64Array; // m/s^2, the largest |a| within the last step
  status: Uint8Array; // of the last decision, see STATUSES
  decided: Uint8Array; // in the last step
  arrived: Uint8Array; // is at its goal
  clearance: Float32Array; // m, to the nearest other disc; infinite where there is nobody
  moving_obstacles: Float64Array; // x, y, vx, vy of each
}

export interface RobotInfo {
  robot: number;
  radius: number;
  disc_radius: number; // of the disc that others sense
  disc_ahead: number; // of its position, along its heading
  max_speed: number;
  max_acceleration: number;
  preferred_speed: number;
  priority: number;
  parked: boolean;
  model: "holonomic" | "car" | "differential_drive" | "airplane";
}

export interface WallInfo {
  a: [number, number];
  b: [number, number];
  radius: number;
  obstacle: number; // number of the static obstacle
}

/** What does not change from step to step. */
export interface SceneInfo {
  name: string;
  duration: number;
  options: {
    method: string;
    certificate: string;
    motion: string;
    control_time: number;
    time_horizon: number;
    time_step: number;
    sensing_radius: number;
    arrival_distance: number;
    [key: string]: string | number | boolean | null;
  };
  robots: RobotInfo[];
  walls: WallInfo[];
  moving_obstacles: { radius: number }[];
  advice: string[]; // settings that do not fit the robots
  broken_assumptions: string[]; // of the certificate; empty: its promise holds
}

/** A robot to be added; what is left out is as in scene files. */
export interface RobotSetup {
  position: [number, number];
  goal: [number, number];
  radius?: number;
  max_speed?: number;
  max_acceleration?: number;
  preferred_speed?: number;
}

/** Two discs that overlap now, or a disc and a wall: "robots.3", "moving_obstacles.0", "obstacles.2". */
export interface Contact {
  a: string;
  b: string;
  x: number; // m, amid the overlap
  y: number;
  depth: number; // m
}

/** left, bottom, right, top */
export type Box = readonly [number, number, number, number];

/** Closed polygons around what the obstacle of `of` forbids. */
export interface Outline {
  of: string;
  rings: [number, number][][];
}

/** Centers of the disc while it brakes, x and y in turn, from step to step. */
export interface BrakingPath {
  of: string;
  points: number[]; // m
  radius: number; // m
}
