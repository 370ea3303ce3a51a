// SPDX-License-Identifier: Apache-2.0
// Explains why a robot decides as it does: the half-planes that its choice rests on, and the decision in one sentence.
import type { SceneInfo } from "../../avo/avo.ts";
import type { Decision, HalfPlane, Vec } from "./decision.ts";
import { along, avoidsUnion, cross, dot, isCertified, labelOf, minus, nameOf, norm, sceneWall, violation } from "./decision.ts";
import { nearestPoint } from "./nearest.ts";

/** A half-plane of the decision, and its effect on the choice. */
export interface Cut extends HalfPlane {
  of: string;        // "robots.7", "walls.4" of the scene
  forbids: boolean;  // false: it is drawn as an explanation, and does not affect the choice
  binds: boolean;    // the choice lies on its line
  refuses: number;   // m/s, by how much v^pref violates it; 0 if it does not
}

/** The settings that are needed to interpret a decision. */
export interface Law {
  method: string;
  motion: string;
  time_step: number;     // s
  control_time: number;  // s
  holonomic: boolean;    // false: the robot approximates the decision by its wheels or wings
}

export interface Why {
  cuts: Cut[];
  /** The velocity after this step; null if the robot's wheels or wings decide how v' is followed. */
  next: Vec | null;
  /** The velocity by which the choice is judged: v', or for method avo the target that it approaches as fast as it may. */
  choice: Vec;
  /** Whether the rules for arriving (docs/arrival.md) have changed the wanted velocity v^pref. */
  wish_changed: boolean;
}

const ON_LINE = 1e-3;  // m/s; programs have tolerances
const SAME = 1e-6;     // m/s

export function lawOf(info: SceneInfo, robot: number): Law {
  const { method, motion, time_step, control_time } = info.options;
  const model = info.robots.find((other) => other.robot === robot)?.model;
  return { method, motion, time_step, control_time, holonomic: (model ?? "holonomic") === "holonomic" };
}

/** Returns v + Δt a if the acceleration is held, and Eq. (8) if it decays. */
export function nextVelocity(decision: Decision, law: Law): Vec {
  if (law.motion !== "exponential") return along(decision.velocity, decision.acceleration, law.time_step);
  const part = -Math.expm1(-law.time_step / law.control_time);
  return along(decision.velocity, minus(decision.new_velocity, decision.velocity), part);
}

/** Returns the target of v' or, within one step, of v1, as far as it follows from the output of explain(). */
function aimOf(decision: Decision, law: Law, cuts: Cut[]): { choice: Vec; wish_changed: boolean } {
  if (law.method !== "avo" || avoidsUnion(decision, law.method) || !law.holonomic)
    return { choice: decision.new_velocity, wish_changed: false };
  const next = nextVelocity(decision, law);
  if (decision.status !== "optimal") return { choice: next, wish_changed: false };
  const discs = [decision.acceleration_disc, decision.speed_disc].filter((disc) => disc !== null);
  const forbidding = cuts.filter((cut) => cut.forbids);
  const step = minus(next, decision.velocity);
  for (const aim of aimsOf(decision)) {
    const target = nearestPoint(forbidding, discs, aim);
    if (!target) return { choice: next, wish_changed: false };
    const way = minus(target, decision.velocity);
    const isAhead = Math.abs(cross(way, step)) <= SAME * Math.max(norm(step), SAME) && dot(way, step) >= 0 &&
      norm(way) >= norm(step) - SAME;
    if (isAhead) return { choice: target, wish_changed: false };
  }
  return { choice: next, wish_changed: true };
}

/** Returns what the program may have been asked for: v^pref, or half of the difference to it (docs/smoothness.md). */
function aimsOf({ velocity, preferred_velocity, response_time }: Decision): Vec[] {
  const halfWay = along(velocity, minus(preferred_velocity, velocity), 0.5);
  return response_time ? [halfWay, preferred_velocity] : [preferred_velocity];
}

function cutsOf(decision: Decision, law: Law, info: Pick<SceneInfo, "walls">): Cut[] {
  const union = avoidsUnion(decision, law.method);
  const wish = decision.preferred_velocity;
  const cut = (of: string, { normal, offset }: HalfPlane, forbids: boolean): Cut => ({
    of, normal, offset, forbids, binds: false,
    refuses: forbids ? Math.max(violation({ normal, offset }, wish), 0) : 0,
  });
  return [
    ...decision.half_planes.map((plane) => cut(nameOf(plane.neighbor), plane, true)),
    ...decision.wall_half_planes.map((plane) => cut(`walls.${sceneWall(decision, plane.wall, info.walls)}`, plane,
      plane.kind === "speed" ? !union : law.method !== "avo")),
  ];
}

export function why(decision: Decision, law: Law, info: Pick<SceneInfo, "walls">): Why {
  const cuts = cutsOf(decision, law, info);
  const { choice, wish_changed } = aimOf(decision, law, cuts);
  for (const cut of cuts) cut.binds = cut.forbids && Math.abs(violation(cut, choice)) < ON_LINE;
  return { cuts, next: law.holonomic ? nextVelocity(decision, law) : null, choice, wish_changed };
}

const number = (value: number, digits = 2): string => value.toFixed(digits).replace(/^-(0\.?0*)$/, "$1");

/** Returns e.g. "robots 2, 4 and wall 7". */
export function listOf(names: string[], most = 4): string {
  const whose = [...new Set(names)];
  const rest = whose.length - most;
  const shown = rest > 1 ? whose.slice(0, most) : whose;
  const areRobots = shown.length > 1 && shown.every((name) => name.startsWith("robots."));
  const words = areRobots ? shown.map((name) => name.slice("robots.".length)) : shown.map(labelOf);
  if (rest > 1) words.push(`${rest} others`);
  const list = words.length < 2 ? words.join("") : `${words.slice(0, -1).join(", ")} and ${words.at(-1)}`;
  return areRobots ? `robots ${list}` : list;
}

/** Returns e.g. "turns 12° right and slows down", for v' against v. */
export function actionOf(decision: Decision): string {
  const { velocity, new_velocity, max_speed } = decision;
  const slow = 0.01 * max_speed;
  if (norm(velocity) < slow && norm(new_velocity) < slow) return "stays at rest";
  if (norm(new_velocity) < slow) return "brakes to rest";
  if (norm(velocity) < slow) return `starts, towards ${number(headingOf(new_velocity), 0)}°`;
  const angle = Math.atan2(cross(velocity, new_velocity), dot(velocity, new_velocity)) * 180 / Math.PI;
  const gain = dot(decision.acceleration, velocity) / norm(velocity);  // m/s^2
  const little = 0.02 * decision.max_acceleration;
  const turn = Math.abs(angle) < 0.5 ? "" : `turns ${number(Math.abs(angle), 0)}° ${angle > 0 ? "left" : "right"}`;
  const pace = Math.abs(gain) < little ? "" : gain > 0 ? "speeds up" : "slows down";
  return [turn, pace].filter(Boolean).join(" and ") || "keeps its velocity";
}

/** Returns the angle counter-clockwise from +x, in degrees. */
export function headingOf(v: Vec): number {
  return Math.atan2(v[1], v[0]) * 180 / Math.PI;
}

const half = (names: string[]): string =>
  new Set(names).size > 1 ? `the half-planes of ${listOf(names)}` : `the half-plane of ${listOf(names)}`;

/** Returns the reason for an optimal decision. */
function reasonOf(decision: Decision, law: Law, found: Why): string {
  const binding = found.cuts.filter((cut) => cut.binds).map((cut) => cut.of);
  const refusing = found.cuts.filter((cut) => cut.refuses > ON_LINE).map((cut) => cut.of);
  if (avoidsUnion(decision, law.method)) {
    return norm(minus(decision.new_velocity, decision.preferred_velocity)) < ON_LINE
      ? "what it prefers lies outside of all obstacles"
      : `what it prefers is forbidden, so it takes ${law.method === "avo" ? "the way to " : ""}the nearest velocity outside of the union of all obstacles`;
  }
  if (found.wish_changed) {
    const rules = "the rules for arriving (keep right, give way) turn its wish away from the preferred velocity";
    return binding.length > 0 ? `${rules}, and ${half(binding)} ${new Set(binding).size > 1 ? "bind" : "binds"}` : rules;
  }
  if (binding.length > 0) {
    const whose = half(binding);
    return `${whose} ${new Set(binding).size > 1 ? "bind" : "binds"}${refusing.length > 0 ? "" : ", though what it prefers is free"}`;
  }
  if (law.method === "buffered_voronoi") return "it stays within its Voronoi cell";
  if (refusing.length > 0) return `${half(refusing)} ${new Set(refusing).size > 1 ? "refuse" : "refuses"} what it prefers`;
  return norm(minus(decision.velocity, decision.preferred_velocity)) < ON_LINE
    ? "it has the velocity that it prefers, and nothing refuses it"
    : "nothing refuses the velocity that it prefers";
}

const STATUS_REASONS: Record<string, (decision: Decision, law: Law) => string> = {
  least_unsafe: (decision, law) => (avoidsUnion(decision, law.method)
    ? "no velocity lies outside of all obstacles, and this is the least unsafe one"
    : `no velocity satisfies all half-planes, and this one misses them by the least that is possible, ${number(decision.violation)} m/s`) +
    (isCertified(decision) ? "; the certificate holds" : ""),
  candidate: (decision) => decision.detour
    ? `the way is blocked, so it takes what the certificate admits on a detour of ${number(decision.detour * 180 / Math.PI, 0)}° to the right`
    : "the certificate refuses what the half-planes propose, or the way is blocked, and this is the nearest that it admits",
  braking: () => "nothing but braking is admitted",
  overlapping: (decision) => {
    const whom = decision.contact_with === null ? "" : ` with ${labelOf(nameOf(decision.contact_with))}`;
    return `it is in contact${whom} already, or braking no longer avoids it: it separates if it can`;
  },
  invalid_input: () => "a number that it knows or senses is not finite or out of range: it brakes",
};

/** Returns the neighbor that a decision evades, for people. */
export function evadedOf(decision: Decision): string {
  const whom = decision.evading?.neighbor ?? null;
  return whom === null ? "those who come" : labelOf(nameOf(whom));
}

/** Returns the reason for a decision that was replaced. */
function evasionReason(decision: Decision): string {
  const whom = evadedOf(decision);
  return decision.evading && norm(decision.evading.velocity) > 0
    ? `what it would have chosen leaves no way out from ${whom}, so it makes room`
    : `what it would have chosen leaves no way out from ${whom}, so it brakes`;
}

export function stateSentence(decision: Decision): string {
  if (decision.state === "safe")
    return decision.loiter ? "Its circle keeps clear of all who decide, and it can evade the others (safe)." : "Braking keeps clear of all others (safe).";
  if (decision.state === "unknown") return "Neither safe nor doomed is proved (unknown).";
  const whom = decision.doomed_by === null ? "something" : labelOf(nameOf(decision.doomed_by));
  if (decision.contact_within === 0) return `It is in contact with ${whom} (doomed).`;
  return `Contact with ${whom} within ${number(decision.contact_within ?? 0)} s is inevitable, whatever it does (doomed).`;
}

/** Returns e.g. "Robot 3 turns 12° right: the half-plane of robot 7 binds. Braking keeps clear of all others (safe)." */
export function sentence(decision: Decision, law: Law, found: Why): string {
  const reason = decision.evading && decision.status !== "overlapping" ? evasionReason(decision)
    : STATUS_REASONS[decision.status]?.(decision, law) ?? reasonOf(decision, law, found);
  return `Robot ${decision.robot} ${actionOf(decision)}: ${reason}. ${stateSentence(decision)}`;
}
