// SPDX-License-Identifier: Apache-2.0
// From space to the picture: the world is turned about a point, and seen from infinitely far away. A ball is a disc of its
// own radius then, so that the picture of space is drawn and picked as the map is.
import type { Vec3 } from "./vec3.ts";

/** The direction of the view. */
export interface Orbit {
  turn: number;   // rad, of the viewer about the vertical; 0: x goes to the right
  tilt: number;   // rad, of the viewer above the horizontal plane, -pi/2 to pi/2
  pivot: Vec3;    // m, in the middle of the picture's coordinates
}

/** From m of the world to m of the picture: to the right, up, towards the viewer. */
export type Projection = (x: number, y: number, z: number) => Vec3;

export const PLAN = { turn: 0, tilt: Math.PI / 2 };
export const ELEVATION = { turn: 0, tilt: 0 };
export const ASIDE = { turn: -0.6, tilt: 0.42 };
const VIEWS = [ASIDE, PLAN, ELEVATION];

const A_PIXEL = 0.008;  // rad that a drag by one pixel turns

export const ofThePlane: Projection = (x, y) => [x, y, 0];

/** Returns the axes of the picture in the world: to the right, up, towards the viewer. */
export function axesOf({ turn, tilt }: Pick<Orbit, "turn" | "tilt">): [Vec3, Vec3, Vec3] {
  const [c, s, ct, st] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
  return [[c, s, 0], [-s * st, c * st, ct], [s * ct, -c * ct, st]];
}

export function projectionOf(orbit: Orbit): Projection {
  const [right, up, near] = axesOf(orbit);
  const [px, py, pz] = orbit.pivot;
  const along = (axis: Vec3, x: number, y: number, z: number) => axis[0] * (x - px) + axis[1] * (y - py) + axis[2] * (z - pz);
  return (x, y, z) => [along(right, x, y, z), along(up, x, y, z), along(near, x, y, z)];
}

/** Turns as if the pointer dragged the near side of a globe. */
export function turnBy(orbit: Orbit, pixelsX: number, pixelsY: number): void {
  orbit.turn = (orbit.turn - A_PIXEL * pixelsX) % (2 * Math.PI);
  orbit.tilt = Math.min(PLAN.tilt, Math.max(-PLAN.tilt, orbit.tilt + A_PIXEL * pixelsY));
}

/** Shows the next view: from aside, the plan, the elevation. */
export function showNext(orbit: Orbit): void {
  const k = VIEWS.findIndex(({ turn, tilt }) => turn === orbit.turn && tilt === orbit.tilt);
  Object.assign(orbit, VIEWS[(k + 1) % VIEWS.length]);
}
