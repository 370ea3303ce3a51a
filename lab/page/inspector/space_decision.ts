// SPDX-License-Identifier: Apache-2.0
// One decision of a robot in space and all its inputs, as `avo explain --json` gives them (docs/space.md), in SI units.
import type { Vec3 } from "../map/vec3.ts";

export interface SensedInSpace {
  neighbor: number;
  position: Vec3;
  velocity: Vec3;
  radius: number;
  max_acceleration: number;
  priority: number;
  vertical: number;
  downwash: number;
}

/** normal·v' >= offset, m/s; the normal has length 1. */
export interface HalfSpace {
  normal: Vec3;
  offset: number;
}

/** I for robots.I, or "obstacles.K". */
export type Cause = number | string;

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
  boxes: number[];
  half_spaces: ({ neighbor: number } & HalfSpace)[];
  preferred_velocity: Vec3;
  binding: Cause[];
  heeded: Cause[];
  proposal: Vec3;
  refusing: Cause[];
  new_velocity: Vec3;
  next_velocity: Vec3;
  acceleration: Vec3;
  status: string;
  violation: number;
  state: string;
  sentence: string;
}
