// SPDX-License-Identifier: Apache-2.0
// The discs of a moment's robots: their places, their clearances, and their overlaps.
import type { Moment, SceneInfo } from "../../avo/avo.ts";
import type { Touch } from "../run/contact_log.ts";

export type RobotInfo = SceneInfo["robots"][number];

const MANY = 1000;  // with more robots, one without another within `NEAR` counts as alone
const NEAR = 5;     // m

interface Disc { row: number; x: number; y: number; radius: number }

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

/** Returns the distance between two discs; negative if they overlap. */
const gap = (a: Disc, b: Disc) => Math.hypot(b.x - a.x, b.y - a.y) - a.radius - b.radius;

function discsByX(moment: Moment, info: SceneInfo): Disc[] {
  const robots = robotsOf(moment, info);
  const discs = Array.from(moment.robot, (_, row) => {
    const robot = robots[row];
    const { ahead, radius } = robot?.footprint ?? { ahead: [robot?.disc_ahead ?? 0], radius: robot?.disc_radius ?? 0 };
    return ahead.map((each) => ({
      row,
      x: moment.position[2 * row]! + each * Math.cos(moment.heading[row]!),
      y: moment.position[2 * row + 1]! + each * Math.sin(moment.heading[row]!),
      radius,
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
    const share = (a.radius - depth / 2) / (Math.hypot(b.x - a.x, b.y - a.y) || 1);
    const [x, y] = [a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)];
    touches.push({ a: `robots.${moment.robot[a.row]}`, b: `robots.${moment.robot[b.row]}`, x, y, depth });
  });
  return touches;
}
