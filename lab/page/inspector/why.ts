// SPDX-License-Identifier: Apache-2.0
// The half-planes of a decision as the inspector draws them, and the choice that rests on them. The decision's own trace
// tells which of them bind.
import type { SceneInfo } from "../../avo/avo.ts";
import type { Decision, HalfPlane, SensedWall, Vec } from "./decision.ts";
import { labelOf, nameOf, shortLabelOf, violation, wallName } from "./decision.ts";

/** A half-plane of the decision, and its effect on the choice. */
export interface Cut extends HalfPlane {
  of: string;        // "robots.7", "walls.4" of the scene, "obstacles.2"
  label: string;     // "obstacle 2" for a wall of it
  short: string;     // "w2"
  forbids: boolean;  // false: it is drawn as an explanation, and does not affect the choice
  binds: boolean;    // the target lies on its line
  refuses: number;   // m/s, by how much v^pref violates it; 0 if it does not
}

/** The settings that are needed to interpret a decision. */
export interface Law {
  method: string;
  time_step: number;  // s
}

export interface Why {
  cuts: Cut[];
  /** The velocity after this step. */
  next: Vec;
}

export function lawOf(info: SceneInfo): Law {
  const { method, time_step } = info.options;
  return { method, time_step };
}

export function why(decision: Decision, law: Law, info: Pick<SceneInfo, "walls">): Why {
  const union = decision.target_by === "union_of_obstacles";
  const wish = decision.preferred_velocity;
  const binding = union ? [] : decision.trace.binding.map((source) => (source === null ? "" : nameOf(source)));
  const cut = (name: string, { normal, offset }: HalfPlane, forbids: boolean): Cut => ({
    of: name, label: labelOf(name), short: shortLabelOf(name), normal, offset, forbids,
    binds: forbids && binding.includes(name),
    refuses: forbids ? Math.max(violation({ normal, offset }, wish), 0) : 0,
  });
  const cutOfWall = (name: string, of: string, { obstacle, robot }: SensedWall, half: HalfPlane, forbids: boolean): Cut => ({
    ...cut(name, half, forbids), of, label: labelOf(name, decision.walls), short: `w${obstacle ?? robot}`,
  });
  const cuts = [
    ...decision.half_planes.map((plane) => cut(nameOf(plane.neighbor), plane, true)),
    ...decision.wall_half_planes.map((plane) => cutOfWall(`walls.${plane.wall}`, wallName(decision, plane.wall, info.walls),
      decision.walls[plane.wall]!, plane, plane.kind === "speed" ? !union : law.method !== "avo")),
  ];
  return { cuts, next: decision.next_velocity };
}

/** Returns the angle counter-clockwise from +x, in degrees. */
export function headingOf(v: Vec): number {
  return Math.atan2(v[1], v[0]) * 180 / Math.PI;
}

/** Returns the neighbor that a decision evades, for people. */
export function evadedOf(decision: Decision): string {
  const whom = decision.evading?.neighbor ?? null;
  return whom === null ? "the moving obstacles around it" : labelOf(nameOf(whom));
}
