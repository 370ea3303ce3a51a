// SPDX-License-Identifier: Apache-2.0
// One decision of a robot and all its inputs, as `avo explain --json` gives them (docs/command_line.md), in SI units.

/** x, y */
export type Vec = readonly [number, number];

export interface Disc {
  center: Vec;
  radius: number;
  /** An ellipse: the radius is the half of its axis in this direction (rad), and the other axis is so many times as long. */
  squeeze?: { angle: number; ratio: number };
}

/** normal·v' >= offset, m/s; the normal has length 1. */
export interface HalfPlane {
  normal: Vec;
  offset: number;
}

/** I for robots.I, or "moving_obstacles.K". */
export type Source = number | string;

export interface Sensed {
  neighbor: Source;
  position: Vec;
  velocity: Vec;
  acceleration: Vec;
  radius: number;
  max_acceleration: number;     // 0 for a neighbor that moves on
  priority: number | null;      // null for a neighbor that moves on
  behavior: "decides" | "moves_on" | "cooperates";
  share: number;                // the part of the robot that decides here in the evasion of the two
  max_braking?: number;
  age?: number;                 // steps since it was measured, if it is extrapolated
  risk?: number;
  loiter?: Disc;
  max_deviation?: number;
  max_speed?: number | null;
}

/** A part of a static obstacle, or the disc of a parked robot: it has the id of one of the two. */
export interface SensedWall {
  a: Vec;
  b: Vec;
  radius: number;
  obstacle?: number;
  robot?: number;
}

/** The neighbor that a robot evades, the velocity that its evasion approaches (0: it brakes), and the time at which the
 * evasion brakes, or circles. */
export interface Evasion<Vector = Vec> {
  neighbor: Source | null;
  velocity: Vector;
  until: number;                // s, of the run
}

/** The stages of a decision, in the plane or in space. A null among causes is the robot's own motion; "walls.K" is of
 * `walls` below. */
export interface Trace<Vector = Vec> {
  guide: "route" | "lane" | "passage" | "back" | "mover" | "place" | "host";
  wish: Vector;
  rule: "none" | "steers" | "keeps_right" | "yields" | "settles" | "leaves_wall" | "in_cell";
  heeded: Source | null;
  aim: Vector;
  target: Vector;
  binding: (Source | null)[];
  proposal: Vector;
  refusing: (Source | null)[];
  detour: Vector | null;
  refusing_detour: (Source | null)[];
}

export interface Decision {
  scene: string;
  robot: number;
  time: number;
  position: Vec;
  velocity: Vec;
  goal: Vec;
  radius: number;
  max_speed: number;
  max_acceleration: number;
  max_braking: number;
  priority: number;
  neighbors: Sensed[];
  target_by: "half_planes" | "union_of_obstacles";
  half_planes: ({ neighbor: Source } & HalfPlane)[];
  walls: SensedWall[];
  wall_half_planes: ({ wall: number; kind: "speed" | "obstacle" } & HalfPlane)[];
  certificate_kind?: string;
  certificate?: { neighbor: Source; interval: number; normal: Vec; offset: number }[];
  wall_certificate?: { wall: number; held: number; distance: number; normal: Vec }[];
  detour_angle?: number;        // rad, to the right
  response_time?: number;       // s, with which the robot approaches v'; 0: at once
  loiter?: Disc;
  risk?: number;
  acceleration_disc: Disc | null;
  speed_disc: Disc | null;
  preferred_velocity: Vec;
  new_velocity: Vec;
  next_velocity: Vec;           // after the step
  acceleration: Vec;
  trace: Trace;
  sentence: string;             // the decision in words
  evading: Evasion | null;      // its usual choice was replaced by an evasion (docs/movers.md)
  waits: { passage: Vec; for: number; inside: boolean; between: [Vec, Vec] } | null;  // the passage, and the robot for which it waits (docs/arrival.md)
  state: "safe" | "doomed" | "unknown";
  doomed_by: Source | null;     // may also be "walls.K", of `walls` above
  contact_within: number | null;
  status: string;
  contact_with: Source | null;  // what it touches, or cannot help touching, when it is overlapping; also "walls.K"
  contact_depth: number | null; // m
  violation: number;
}

export function parseDecision(text: string): Decision {
  return JSON.parse(text) as Decision;
}

/** Returns the name in the Lab: "robots.3", "moving_obstacles.0". */
export function nameOf(source: Source): string {
  return typeof source === "number" ? `robots.${source}` : source;
}

const KINDS: Record<string, string> = {
  robots: "robot", moving_obstacles: "moving obstacle", walls: "wall", obstacles: "obstacle",
};

/** Returns the name for people: "robot 3". The name of a wall is that of its obstacle or parked robot; `walls` has it. */
export function labelOf(name: string, walls: readonly Pick<SensedWall, "obstacle" | "robot">[] = []): string {
  const [kind, number] = name.split(".");
  if (kind === "walls") {
    const { obstacle, robot } = walls[Number(number)] ?? {};
    return robot !== undefined ? `robot ${robot}` : obstacle !== undefined ? `obstacle ${obstacle}` : "a wall";
  }
  return `${KINDS[kind!] ?? kind} ${number}`;
}

/** Returns a short name beside a line: "3", "o0" for a moving obstacle, as in the figures. */
export function shortLabelOf(name: string): string {
  const [kind, number] = name.split(".");
  return `${kind === "robots" ? "" : "o"}${number}`;
}

export const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1];
export const cross = (a: Vec, b: Vec): number => a[0] * b[1] - a[1] * b[0];
export const norm = (a: Vec): number => Math.hypot(a[0], a[1]);
export const minus = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1]];
export const along = (a: Vec, b: Vec, t: number): Vec => [a[0] + t * b[0], a[1] + t * b[1]];

/** Returns by how much `v` violates the half-plane, m/s; <= 0 inside. */
export function violation(plane: HalfPlane, v: Vec): number {
  return plane.offset - dot(plane.normal, v);
}

/** Returns the distance from the surface of the robot to that of the neighbor, m; negative if they overlap. */
export function clearanceOf(decision: Decision, other: Sensed): number {
  return norm(minus(decision.position, other.position)) - decision.radius - other.radius;
}

export function isCertified({ certificate_kind }: Decision): boolean {
  return certificate_kind !== undefined && certificate_kind !== "none";
}

/** Returns the name in the Lab of the decision's wall: "walls.4" of the scene, or "robots.3" for a parked robot. It is
 * "obstacles.2" where no wall of the scene is just there, e.g. for a robot that does not know its own place exactly. */
export function wallName(decision: Decision, index: number, walls: readonly { a: Vec; b: Vec; radius: number }[]): string {
  const wall = decision.walls[index]!;
  if (wall.robot !== undefined) return `robots.${wall.robot}`;
  const same = (p: Vec, q: Vec): boolean => p[0] === q[0] && p[1] === q[1];
  const found = walls.findIndex((other) => other.radius === wall.radius &&
    ((same(other.a, wall.a) && same(other.b, wall.b)) || (same(other.a, wall.b) && same(other.b, wall.a))));
  return found < 0 ? `obstacles.${wall.obstacle}` : `walls.${found}`;
}
