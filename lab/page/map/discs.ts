// SPDX-License-Identifier: Apache-2.0
// The discs, or balls in space, of a moment's robots: their places, their clearances, and their overlaps. The module
// finds these in a run of its own. But a recording of another program may have no scene that a run could be made of.
import type { Dimensions, Moment, SceneInfo } from "../../avo/avo.ts";
import type { Touch } from "../run/contact_log.ts";

export type RobotInfo = SceneInfo["robots"][number];

const MANY = 1000;  // with more robots, one without another within `NEAR` counts as alone
const NEAR = 5;     // m

/** A body in m. In space it is a ball, to which the air down to `downwash` below it belongs. */
export interface Body { x: number; y: number; z: number; radius: number; downwash: number }
interface Disc extends Body { row: number }

/** Returns the constant facts about the robot of each row of `moment`; both are sorted by ascending numbers. */
export function robotsOf(moment: Moment, info: SceneInfo): (RobotInfo | undefined)[] {
  let at = 0;
  return Array.from(moment.robot, (robot) => {
    while (at < info.robots.length && info.robots[at]!.robot < robot) ++at;
    return info.robots[at]?.robot === robot ? info.robots[at] : undefined;
  });
}

export function rowOf(moment: Moment, robot: number): number {
  return moment.robot.indexOf(robot);
}

/** Returns the vector of row i of positions or velocities. */
export function vectorOf(from: ArrayLike<number>, dimensions: Dimensions, i: number): [number, number, number] {
  const at = dimensions * i;
  return [from[at]!, from[at + 1]!, dimensions === 3 ? from[at + 2]! : 0];
}

/** Returns m/s of row i, in the robot's own measure: a vertical speed counts by the limits along z. */
export function speedOf({ velocity, dimensions }: Moment, i: number, robot?: RobotInfo): number {
  const [x, y, z] = vectorOf(velocity, dimensions, i);
  return Math.hypot(x, y, z / (robot?.vertical ?? 1));
}

/** Returns how far below the middles of a and b the places are that are nearest to each other. */
function drops(a: Body, b: Body): [number, number] {
  return [Math.min(Math.max(a.z - b.z, 0), a.downwash), Math.min(Math.max(b.z - a.z, 0), b.downwash)];
}

/** Returns the distance between two bodies; negative if they overlap. */
export function gap(a: Body, b: Body): number {
  const [below_a, below_b] = drops(a, b);
  return Math.hypot(b.x - a.x, b.y - a.y, b.z - below_b - a.z + below_a) - a.radius - b.radius;
}

function discsByX(moment: Moment, info: SceneInfo): Disc[] {
  const robots = robotsOf(moment, info);
  const discs = Array.from(moment.robot, (_, row) => {
    const robot = robots[row];
    const [x, y, z] = vectorOf(moment.position, moment.dimensions, row);
    const { ahead, radius } = robot?.footprint ?? { ahead: [robot?.disc_ahead ?? 0], radius: robot?.disc_radius ?? 0 };
    return ahead.map((each) => ({
      row,
      x: x + each * Math.cos(moment.heading[row]!),
      y: y + each * Math.sin(moment.heading[row]!),
      z, radius, downwash: robot?.downwash ?? 0,
    }));
  }).flat();
  return discs.sort((a, b) => a.x - b.x);
}

/** Calls `visit` for all pairs of discs of two robots that are less than `reach` apart along x. */
function sweep(discs: Disc[], reach: number, visit: (a: Disc, b: Disc) => void): void {
  const widest = discs.reduce((most, disc) => Math.max(most, disc.radius), 0);
  discs.forEach((a, i) => {
    for (let j = i + 1; j < discs.length && discs[j]!.x - a.x < a.radius + widest + reach; ++j)
      if (discs[j]!.row !== a.row) visit(a, discs[j]!);
  });
}

/** Writes `moment.clearance` if a recording lacks it. */
export function fillClearance(moment: Moment, info: SceneInfo): void {
  const least = new Float64Array(moment.robot.length).fill(Infinity);
  const reach = moment.robot.length > MANY ? NEAR : Infinity;
  sweep(discsByX(moment, info), reach, (a, b) => {
    const distance = gap(a, b);
    if (distance < least[a.row]!) least[a.row] = distance;
    if (distance < least[b.row]!) least[b.row] = distance;
  });
  moment.clearance = Float32Array.from(least);
}

/** Returns pairs of discs that overlap, with the middle of the overlap. */
export function touchesIn(moment: Moment, info: SceneInfo): Touch[] {
  const touches: Touch[] = [];
  const discs = discsByX(moment, info).filter((disc) => moment.clearance[disc.row]! < 0);
  sweep(discs, 0, (first, second) => {
    const depth = -gap(first, second);
    if (depth <= 1e-9) return;
    const [a, b] = first.row < second.row ? [first, second] : [second, first];
    const [below_a, below_b] = drops(a, b);
    const line = [b.x - a.x, b.y - a.y, b.z - below_b - a.z + below_a] as const;
    const share = (a.radius - depth / 2) / (Math.hypot(...line) || 1);
    const [x, y] = [a.x + share * line[0], a.y + share * line[1]];
    const height = moment.dimensions === 3 ? { z: a.z - below_a + share * line[2] } : {};
    touches.push({ a: `robots.${moment.robot[a.row]}`, b: `robots.${moment.robot[b.row]}`, x, y, ...height, depth });
  });
  return touches;
}
