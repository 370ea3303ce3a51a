// SPDX-License-Identifier: Apache-2.0
// One decision of a robot in space and all its inputs, as `avo explain --json` gives them (docs/space.md), in SI units.
import type { Vec3 } from "../map/vec3.ts";
import type { Evasion, Source, Trace } from "./decision.ts";

export interface SensedInSpace {
  neighbor: Source;
  position: Vec3;
  velocity: Vec3;
  radius: number;
  max_acceleration: number;     // 0 for a moving obstacle
  priority: number | null;      // null for a moving obstacle
  vertical: number;
  downwash: number;
  behavior: "decides" | "moves_on";
  acceleration?: Vec3;          // of a moving obstacle, as what follows
  max_deviation?: number;
  max_speed?: number | null;
  age?: number;                 // steps since it was measured, if it is extrapolated
}

/** normal·v' >= offset, m/s; the normal has length 1. */
export interface HalfSpace {
  normal: Vec3;
  offset: number;
}

/** I for robots.I, "obstacles.K" or "moving_obstacles.K"; null: the robot's own limits. */
export type Cause = Source | null;

export interface SpaceDecision {
  scene: string;
  robot: number;
  time: number;
  position: Vec3;
  velocity: Vec3;
  goal: Vec3;
  radius: number;
  max_speed: number;
  max_acceleration: number;
  priority: number;
  neighbors: SensedInSpace[];
  obstacles: number[];          // static ones, in range
  half_spaces: ({ neighbor: Source } & HalfSpace)[];
  obstacle_half_spaces: ({ obstacle: string } & HalfSpace)[];
  detour_angle: number;         // rad, to the right
  preferred_velocity: Vec3;
  new_velocity: Vec3;
  next_velocity: Vec3;
  acceleration: Vec3;
  trace: Trace<Vec3>;
  sentence: string;
  evading: Evasion<Vec3> | null;
  waits: { passage: Vec3; for: number; inside: boolean } | null;
  state: string;
  status: string;
  contact_with: Cause;
  contact_depth: number | null; // m
  violation: number;
}
