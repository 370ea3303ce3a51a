// SPDX-License-Identifier: Apache-2.0
// The inputs and outputs of the package. Data have the names of scene files, and SI units.

/** A file that a scene names, e.g. a map, by the path that follows from the scene. */
export interface SceneFile {
  path: string;
  text: string | Uint8Array; // verbatim, e.g. of a binary graymap
  builtin: boolean;
}

/** Vectors have so many numbers: of the plane, or of space. */
export type Dimensions = 2 | 3;

export interface SceneOptions {
  /** The name stands in front of messages; a scene without a name takes it. */
  name?: string;
  /** "key=value" for keys of the scene, as `--set` takes them. */
  overrides?: string[];
  files?: SceneFile[];
  start_at_rest?: boolean;
  limit_speed?: boolean;
  /** Whether the scene comes from a recording: what was removed from scenes is read as what replaces it. */
  recorded?: boolean;
  /** Whether all steps are observed, for Simulation.summary(); this costs about a tenth of their time. */
  metrics?: boolean;
}

/** The scene that a recording contains, and the options of its run. */
export interface RecordedScene {
  name: string;
  yaml: string;
  overrides: string[];
  files: SceneFile[];
  start_at_rest: boolean;
  limit_speed: boolean;
}

/** The facts that a recording stores about itself. */
export interface RecordingHeader {
  dimensions: Dimensions;
  robots: number; // upper bound of their numbers
  every: number; // steps of the run from row to row
  headings: boolean; // whether any robot may have a heading
  scene: RecordedScene;
}

export interface BuiltinScene {
  name: string;
  description: string;
  yaml: string;
}

/** A key of scene files that takes a plain value; `values` are all allowed values, and empty for numbers. */
export interface Setting {
  key: string;
  values: string[];
}

/** One state: an entry, or x and y (and z in space) in turn, for each present robot, by ascending number. The arrays are
 * copies, which the caller may keep. */
export interface Moment {
  dimensions: Dimensions;
  time: number; // s
  steps: number;
  robot: Int32Array; // numbers as in the scene
  position: Float64Array; // m
  velocity: Float64Array; // m/s
  goal: Float64Array; // m
  heading: Float64Array; // rad; 0 for holonomic robots
  acceleration: Float64Array; // m/s^2, the largest |a| within the last step
  status: Uint8Array; // of the last decision, see STATUSES
  decided: Uint8Array; // in the last step
  arrived: Uint8Array; // whether it is at its goal
  clearance: Float32Array; // m, to the nearest other disc, or ball and its downwash; infinite if there is none
  moving_obstacles: Float64Array; // position and velocity of each
}

/** Discs of one radius along the heading, at these distances ahead of the position. */
export interface Footprint {
  radius: number; // m
  ahead: number[]; // m
}

export interface RobotInfo {
  robot: number;
  radius: number;
  disc_radius: number; // of the disc that neighbors sense
  disc_ahead: number; // from its position to the disc's center, along its heading
  footprint: Footprint | null; // null if the robot is one disc
  max_speed: number;
  max_acceleration: number;
  preferred_speed: number;
  priority: number;
  parked: boolean;
  model: "holonomic" | "car" | "differential_drive" | "airplane";
  vertical?: number; // of robots of space: their limits along z, as a part of the horizontal ones
  downwash?: number; // m, of robots of space
}

export interface WallInfo {
  a: [number, number];
  b: [number, number];
  radius: number;
  obstacle: number; // number of the static obstacle
}

/** A static obstacle of space, turned about the vertical through the origin. A bound that is null is infinite. */
export interface BoxInfo {
  min: (number | null)[]; // m, in the frame of the box
  max: (number | null)[];
  heading: number; // rad
  radius: number; // m: everything so near to the box belongs to it
  obstacle: number; // number of the static obstacle
}

/** The facts that do not change from step to step. */
export interface SceneInfo {
  dimensions: Dimensions;
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
  boxes: BoxInfo[]; // of a scene of space
  moving_obstacles: MovingObstacleInfo[];
  advice: string[]; // settings that do not fit the robots
  broken_assumptions: string[]; // of the certificate; empty: its promise is valid
}

/** A moving obstacle. In a scene of space it is known where it is at any time, in m, m/s, m/s^2 and s. */
export interface MovingObstacleInfo {
  radius: number;
  position?: number[];
  velocity?: number[];
  acceleration?: number[];
  trajectory?: number[][];  // [time, x, y, z], by ascending times; empty: it keeps its acceleration
}

/** A robot to add; omitted values have the defaults of scene files. */
export interface RobotSetup {
  // scripts/fields: members of RobotSetup
  position: [number, number]; // m
  velocity?: [number, number]; // m/s
  goal: [number, number]; // m
  radius?: number; // m
  max_speed?: number; // m/s
  max_acceleration?: number; // m/s^2
  preferred_speed?: number; // m/s
  priority?: number;
  max_braking?: number; // m/s^2
  layers?: number[];
  avoids?: number[];
  behavior?: "decides" | "cooperates" | "moves_on" | "parked";
  time_step?: number; // s
  method?: string;
  time_horizon?: number; // s
  arrival_distance?: number; // m
  start_time?: number; // s
  // scripts/fields end
  parked?: boolean; // short for behavior: parked
  model?: RobotInfo["model"];
  heading?: number; // rad
  car?: Car;
  drive?: DifferentialDrive;
  airplane?: Airplane;
}

export interface Car {
  // scripts/fields: members of Car
  wheelbase?: number; // m
  max_curvature?: number; // 1/m
  reverse?: boolean;
  acceleration_set?: "incircle" | "exact";
  // scripts/fields end
  body?: CarBody;
}

/** The disc that covers a car; its offset is forward of the rear axle. */
export interface CarBody {
  // scripts/fields: members of its body
  offset?: number; // m
  radius: number; // m
  // scripts/fields end
}

export interface DifferentialDrive {
  // scripts/fields: members of DifferentialDrive
  track?: number; // m
  offset?: number; // m
  wheel_speed?: number; // m/s
  wheel_acceleration?: number; // m/s^2
  // scripts/fields end
}

export interface Airplane {
  // scripts/fields: members of Airplane
  min_speed?: number; // m/s
  lateral_acceleration?: number; // m/s^2
  after_goal?: "loiter" | "leave";
  // scripts/fields end
}

/** Two bodies that overlap now, or a body and a static obstacle: "robots.3", "moving_obstacles.0", "obstacles.2". */
export interface Contact {
  a: string;
  b: string;
  x: number; // m, in the middle of the overlap
  y: number;
  z?: number; // in space
  depth: number; // m
}

/** left, bottom, right, top */
export type Box = readonly [number, number, number, number];

/** A plane through the velocities of space: v = place + x along + y across, m/s. */
export interface VelocityCut {
  place: readonly [number, number, number];
  along: readonly [number, number, number];
  across: readonly [number, number, number];
}

/** Closed polygons around the velocities that the obstacle of `of` forbids. */
export interface Outline {
  of: string;
  rings: [number, number][][];
}

/** Centers of the disc or ball while it brakes, from step to step: x and y in turn, in space x, y and z. */
export interface BrakingPath {
  of: string;
  points: number[]; // m
  radius: number; // m
}
