// SPDX-License-Identifier: Apache-2.0
// The surroundings in space: the bounds of a scene, and its boxes within them.
import type { BoxInfo, Moment, SceneInfo } from "../../avo/avo.ts";
import { robotsOf, vectorOf } from "./discs.ts";
import type { Vec3 } from "./vec3.ts";

export interface Bounds { min: Vec3; max: Vec3 }

/** A parallelogram with a corner and two sides; the normal points out of the solid. */
export interface Face { corner: Vec3; a: Vec3; b: Vec3; normal: Vec3 }

/** A box in the form that is drawn: without infinite sides. Edges are pairs of places, with the normals of their two
faces. */
export interface Solid {
  obstacle: number;
  faces: Face[];
  edges: { from: Vec3; to: Vec3; normals: [Vec3, Vec3] }[];
}

export interface Stage { bounds: Bounds; solids: Solid[]; boxes: BoxInfo[] }

export const middleOf = ({ min, max }: Bounds): Vec3 => min.map((low, k) => (low + max[k]!) / 2) as Vec3;
export const cornersOf = ({ min, max }: Bounds): Vec3[] =>
  Array.from({ length: 8 }, (_, k) => [k & 1 ? max[0] : min[0], k & 2 ? max[1] : min[1], k & 4 ? max[2] : min[2]]);

/** Turns about the vertical through the origin. */
export function turned([x, y, z]: Vec3, angle: number): Vec3 {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [c * x - s * y, s * x + c * y, z];
}

/** Returns the stage of a run that begins at this moment. */
export function stageOf(moment: Moment, info: SceneInfo): Stage {
  const bounds = boundsOf(moment, info);
  return { bounds, solids: info.boxes.map((box) => solidOf(box, bounds)), boxes: info.boxes };
}

/** Contains all robots, goals and finite sides of boxes. */
function boundsOf(moment: Moment, info: SceneInfo): Bounds {
  const bounds: Bounds = { min: [Infinity, Infinity, Infinity], max: [-Infinity, -Infinity, -Infinity] };
  const include = (place: (number | null)[], reach: number): void => place.forEach((value, k) => {
    if (value === null || !Number.isFinite(value)) return;
    bounds.min[k] = Math.min(bounds.min[k]!, value - reach);
    bounds.max[k] = Math.max(bounds.max[k]!, value + reach);
  });
  robotsOf(moment, info).forEach((robot, i) => {
    for (const of of [moment.position, moment.goal]) include(vectorOf(of, 3, i), robot?.radius ?? 0);
  });
  for (const { min, max, heading, radius } of info.boxes) {
    include([null, null, min[2]!], radius), include([null, null, max[2]!], radius);
    const [left, bottom, right, top] = [min[0], min[1], max[0], max[1]];
    if (left == null || bottom == null || right == null || top == null) continue;
    for (const x of [left, right]) for (const y of [bottom, top]) include([...turned([x, y, 0], heading).slice(0, 2), null], radius);
  }
  return bounds;
}

/** Returns the bounds in the frame of a box that is turned so far. */
function boundsIn(bounds: Bounds, heading: number): Bounds {
  const corners = cornersOf(bounds).map((corner) => turned(corner, -heading));
  const along = (k: number) => corners.map((corner) => corner[k]!);
  return {
    min: [0, 1, 2].map((k) => Math.min(...along(k))) as Vec3,
    max: [0, 1, 2].map((k) => Math.max(...along(k))) as Vec3,
  };
}

const AXES: Vec3[] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

export function solidOf({ min, max, heading, radius, obstacle }: BoxInfo, bounds: Bounds): Solid {
  const limits = boundsIn(bounds, heading);
  const side = (value: number | null, reach: number, limit: number) => (value === null ? limit : value + reach);
  const low = min.map((value, k) => side(value, -radius, Math.min(limits.min[k]!, max[k] ?? Infinity))) as Vec3;
  const high = max.map((value, k) => side(value, radius, Math.max(limits.max[k]!, min[k] ?? -Infinity))) as Vec3;
  const world = (place: Vec3) => turned(place, heading);
  const at = (k: number, upper: boolean, from: Vec3): Vec3 => from.map((value, axis) => (axis === k && upper ? high[k]! : value)) as Vec3;
  const faces: Face[] = [], edges: Solid["edges"] = [];
  for (let k = 0; k < 3; ++k) {
    const [i, j] = [(k + 1) % 3, (k + 2) % 3];
    const along = (axis: number): Vec3 => world(AXES[axis]!.map((one) => one * (high[axis]! - low[axis]!)) as Vec3);
    for (const upper of [false, true]) {
      const normal = world(AXES[k]!.map((one) => (upper ? one : -one)) as Vec3);
      faces.push({ corner: world(at(k, upper, low)), a: along(i), b: along(j), normal });
    }
    for (const upper_i of [false, true]) for (const upper_j of [false, true]) {
      const from = at(j, upper_j, at(i, upper_i, low));
      const normals = [[i, upper_i], [j, upper_j]].map(([axis, upper]) =>
        world(AXES[axis as number]!.map((one) => (upper ? one : -one)) as Vec3)) as [Vec3, Vec3];
      edges.push({ from: world(from), to: world(at(k, true, from)), normals });
    }
  }
  return { obstacle, faces, edges };
}

/** Returns the distance at which a ray leaves the box; null if the ray does not meet it. */
function exitOf({ min, max, heading, radius }: BoxInfo, place: Vec3, direction: Vec3): number | null {
  const [from, ray] = [turned(place, -heading), turned(direction, -heading)];
  let [enter, leave] = [0, Infinity];
  for (let k = 0; k < 3; ++k) {
    const [low, high] = [(min[k] ?? -Infinity) - radius, (max[k] ?? Infinity) + radius];
    if (Math.abs(ray[k]!) < 1e-12) {
      if (from[k]! < low || from[k]! > high) return null;
      continue;
    }
    const [a, b] = [(low - from[k]!) / ray[k]!, (high - from[k]!) / ray[k]!];
    enter = Math.max(enter, Math.min(a, b));
    leave = Math.min(leave, Math.max(a, b));
  }
  return enter < leave ? leave : null;
}

/** Returns whether a box is between the place and the viewer. A box that contains the viewer hides nothing: one looks
 * through the ceiling from above. */
export function isHidden(boxes: readonly BoxInfo[], place: Vec3, towards: Vec3): boolean {
  return boxes.some((box) => Number.isFinite(exitOf(box, place, towards) ?? Infinity));
}
