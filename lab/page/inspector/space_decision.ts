// SPDX-License-Identifier: Apache-2.0
// One decision of a robot in space and all its inputs, as `avo explain --json` gives them (docs/space.md), in SI units.
import type { Vec3 } from "../map/orbit.ts";

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

export const dot3 = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross3 = (a: Vec3, b: Vec3): Vec3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const minus3 = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times3 = (factor: number, a: Vec3): Vec3 => [factor * a[0], factor * a[1], factor * a[2]];
export const norm3 = (a: Vec3): number => Math.hypot(...a);
export const unit3 = (a: Vec3): Vec3 => times3(1 / norm3(a), a);
