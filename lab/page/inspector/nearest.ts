// SPDX-License-Identifier: Apache-2.0
// The point of a set of safe velocities that is nearest to a wanted velocity (Eq. 23), found by trying all candidates.
// The robot's decision itself comes from explain(); this code only finds the limits that its choice rests on.
import type { Disc, HalfPlane, Vec } from "./decision.ts";
import { along, dot, minus, norm, violation } from "./decision.ts";

const ROUNDING = 1e-9;  // m/s

/** Returns where the line of the half-plane meets the circle. */
function onCircle(plane: HalfPlane, disc: Disc): Vec[] {
  const foot = violation(plane, disc.center);
  const half = disc.radius ** 2 - foot ** 2;
  if (half < 0) return [];
  const middle = along(disc.center, plane.normal, foot);
  const direction: Vec = [-plane.normal[1], plane.normal[0]];
  return [along(middle, direction, Math.sqrt(half)), along(middle, direction, -Math.sqrt(half))];
}

function ofTwoLines(a: HalfPlane, b: HalfPlane): Vec[] {
  const determinant = a.normal[0] * b.normal[1] - a.normal[1] * b.normal[0];
  if (Math.abs(determinant) < 1e-12) return [];
  return [[(a.offset * b.normal[1] - b.offset * a.normal[1]) / determinant,
    (a.normal[0] * b.offset - b.normal[0] * a.offset) / determinant]];
}

function ofTwoCircles(a: Disc, b: Disc): Vec[] {
  const between = minus(b.center, a.center);
  const distance = norm(between);
  if (distance === 0) return [];
  const ahead = (distance ** 2 + a.radius ** 2 - b.radius ** 2) / (2 * distance);
  const axis: HalfPlane = { normal: [between[0] / distance, between[1] / distance], offset: 0 };
  return onCircle({ normal: axis.normal, offset: dot(axis.normal, a.center) + ahead }, a);
}

/** Returns the nearest point of the disc's rim. */
function onto(disc: Disc, wish: Vec): Vec[] {
  const from = minus(wish, disc.center);
  const length = norm(from);
  return length === 0 ? [] : [along(disc.center, from, disc.radius / length)];
}

function candidates(planes: readonly HalfPlane[], discs: readonly Disc[], wish: Vec): Vec[] {
  const found: Vec[] = [wish, ...discs.flatMap((disc) => onto(disc, wish))];
  planes.forEach((plane, i) => {
    found.push(along(wish, plane.normal, violation(plane, wish)));
    for (let j = 0; j < i; ++j) found.push(...ofTwoLines(plane, planes[j]!));
    for (const disc of discs) found.push(...onCircle(plane, disc));
  });
  for (let i = 1; i < discs.length; ++i) found.push(...ofTwoCircles(discs[i - 1]!, discs[i]!));
  return found;
}

/** Returns null if no velocity lies in all of them. */
export function nearestPoint(planes: readonly HalfPlane[], discs: readonly Disc[], wish: Vec): Vec | null {
  let best: Vec | null = null;
  for (const point of candidates(planes, discs, wish)) {
    if (best && norm(minus(point, wish)) >= norm(minus(best, wish))) continue;
    const isInside = planes.every((plane) => violation(plane, point) <= ROUNDING) &&
      discs.every((disc) => norm(minus(point, disc.center)) <= disc.radius + ROUNDING);
    if (isInside) best = point;
  }
  return best;
}
