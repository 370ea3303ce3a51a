// SPDX-License-Identifier: Apache-2.0
// A plane through a velocity space of three dimensions: its ball becomes a disc and half-spaces become half-planes there.
// The plane is that of p and v of a pair (docs/space.md), through the robot's velocity, so it contains the normal of the
// pair's half-space.
import { cross3, dot3, minus3, norm3, times3, unit3, type Vec3 } from "../map/vec3.ts";
import type { Disc, HalfPlane, Source, Vec } from "./decision.ts";
import type { HalfSpace, SpaceDecision } from "./space_decision.ts";

/** All v with v·normal = offset; a place in it is v·along, v·across. The three vectors are of length 1, at right angles. */
export interface CutPlane {
  along: Vec3;
  across: Vec3;
  normal: Vec3;
  offset: number;  // m/s
}

const PARALLEL = 1e-9;  // of a length: less is none

/** Returns `a` without its part along the unit vector `b`. */
const without = (a: Vec3, b: Vec3): Vec3 => minus3(a, times3(dot3(a, b), b));

/** Returns the unit vector to the left of p, in the horizontal plane; the y axis if p is vertical. */
function leftOf(p: Vec3): Vec3 {
  const level = Math.hypot(p[0], p[1]);
  return level > 1e-6 * Math.abs(p[2]) ? [-p[1] / level, p[0] / level, 0] : [0, p[2] < 0 ? 1 : -1, 0];
}

/** Returns the plane of the pair with that neighbor: the first axis leads away from it. */
export function cutOfPair(decision: SpaceDecision, neighbor: Source): CutPlane | null {
  const other = decision.neighbors.find((sensed) => sensed.neighbor === neighbor);
  if (!other) return null;
  const p = minus3(decision.position, other.position), v = minus3(decision.velocity, other.velocity);
  if (norm3(p) === 0) return null;
  const own = decision.half_spaces.find((half) => half.neighbor === neighbor);
  // with downwash the pair is nearest elsewhere than at the middles: its normal tells where
  const first = own && Math.abs(dot3(own.normal, unit3(p))) < 1 - PARALLEL ? own.normal : unit3(p);
  const rest = without(v, first);
  const second = norm3(rest) > PARALLEL * norm3(v) ? rest : without(own && first !== own.normal ? leftOf(p) : p, first);
  const normal = unit3(cross3(first, norm3(second) > 0 ? second : leftOf(first)));
  const along = unit3(without(p, normal));
  const across = cross3(normal, along);
  const turned = dot3(v, across) < 0 ? -1 : 1;  // so that v leads upwards
  return { along, across: times3(turned, across), normal: times3(turned, normal), offset: turned * dot3(decision.velocity, normal) };
}

/** Returns the vertical plane through the velocity, or else through the preferred velocity: forwards and upwards. */
export function cutOfNobody({ velocity, preferred_velocity }: SpaceDecision): CutPlane {
  const ahead = [velocity, preferred_velocity].map(([x, y]): Vec3 => [x, y, 0]).find((level) => norm3(level) > 1e-6) ?? [1, 0, 0];
  const along = unit3(ahead), across: Vec3 = [0, 0, 1], normal = cross3(along, across);
  return { along, across, normal, offset: dot3(velocity, normal) };
}

export const inPlane = ({ along, across }: CutPlane, v: Vec3): Vec => [dot3(v, along), dot3(v, across)];

/** Returns m/s: the distance of v from the plane. */
export const besidePlane = ({ normal, offset }: CutPlane, v: Vec3): number => Math.abs(dot3(v, normal) - offset);

/** Returns null if the half-space contains the whole plane, or none of it. */
export function cutHalfSpace(plane: CutPlane, { normal, offset }: HalfSpace): HalfPlane | null {
  const [x, y] = inPlane(plane, normal);
  const length = Math.hypot(x, y);
  if (length < PARALLEL) return null;
  return { normal: [x / length, y / length], offset: (offset - dot3(normal, plane.normal) * plane.offset) / length };
}

/** Returns the cut through a ball with a vertical axis of `vertical` times its radius; null if the plane misses it. */
export function cutBall(plane: CutPlane, center: Vec3, radius: number, vertical: number): Disc | null {
  const own = ([x, y, z]: Vec3): Vec3 => [x, y, z / vertical];  // a ball there
  const [a, b] = [own(plane.along), own(plane.across)];
  const from = own(minus3(times3(plane.offset, plane.normal), center));
  // |from + x a + y b| <= radius: a quadratic form in (x, y), less its value at its middle
  const [aa, ab, bb, fa, fb] = [dot3(a, a), dot3(a, b), dot3(b, b), dot3(from, a), dot3(from, b)];
  const det = aa * bb - ab * ab;
  const [x, y] = [(ab * fb - bb * fa) / det, (ab * fa - aa * fb) / det];
  const left = radius * radius - dot3(from, from) - x * fa - y * fb;
  if (!(left > 0)) return null;
  const spread = Math.hypot((aa - bb) / 2, ab), mean = (aa + bb) / 2;
  const angle = 0.5 * Math.atan2(2 * ab, aa - bb);  // of the shorter axis
  const shorter = Math.sqrt(left / (mean + spread));
  if (spread < PARALLEL * mean) return { center: [x, y], radius: shorter };
  return { center: [x, y], radius: shorter, squeeze: { angle, ratio: Math.sqrt((mean + spread) / (mean - spread)) } };
}
