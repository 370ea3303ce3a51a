// SPDX-License-Identifier: Apache-2.0
// The places of all robots in the picture; they lie between two steps while the run plays.
import type { Moment, SceneInfo } from "../../avo/avo.ts";
import { robotsOf, type RobotInfo } from "./discs.ts";
import type { Run } from "../run/run.ts";

/** Row i is row i of the moment. */
export interface Shown {
  moment: Moment;
  robots: (RobotInfo | undefined)[];
  x: Float64Array;         // m, of the disc's center
  y: Float64Array;
  radius: Float64Array;    // m
  heading: Float64Array;   // rad
  movers: { x: number; y: number; vx: number; vy: number; radius: number }[];
}

/** `share`, 0 to 1: the position between the run's `before` and its `moment`. */
export function shownOf(run: Run, share: number): Shown {
  const { moment, before, info } = run;
  const robots = robotsOf(moment, info);
  const count = moment.robot.length;
  const x = new Float64Array(count);
  const y = new Float64Array(count);
  const heading = new Float64Array(count);
  const from = share < 1 && before ? before : null;
  let at = 0;  // both are sorted by ascending numbers
  for (let i = 0; i < count; ++i) {
    while (from && at < from.robot.length && from.robot[at]! < moment.robot[i]!) ++at;
    const known = from && from.robot[at] === moment.robot[i] ? from : null;
    const part = known ? share : 1;
    const was = known ?? moment;
    const j = known ? at : i;
    const turn = moment.heading[i]! - was.heading[j]!;
    heading[i] = was.heading[j]! + part * (turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI)));
    const ahead = robots[i]?.disc_ahead ?? 0;
    x[i] = mix(was.position[2 * j]!, moment.position[2 * i]!, part) + ahead * Math.cos(heading[i]!);
    y[i] = mix(was.position[2 * j + 1]!, moment.position[2 * i + 1]!, part) + ahead * Math.sin(heading[i]!);
  }
  const radius = Float64Array.from(robots, (robot) => robot?.disc_radius ?? 0.5);
  return { moment, robots, x, y, radius, heading, movers: moversOf(moment, from, share, info) };
}

function moversOf(moment: Moment, before: Moment | null, share: number, info: SceneInfo): Shown["movers"] {
  const now = moment.moving_obstacles;
  const was = before && before.moving_obstacles.length === now.length ? before.moving_obstacles : now;
  return info.moving_obstacles.slice(0, now.length / 4).map(({ radius }, k) => ({
    x: mix(was[4 * k]!, now[4 * k]!, share),
    y: mix(was[4 * k + 1]!, now[4 * k + 1]!, share),
    vx: now[4 * k + 2]!,
    vy: now[4 * k + 3]!,
    radius,
  }));
}

const mix = (from: number, to: number, share: number) => from + share * (to - from);
