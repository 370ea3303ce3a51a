// SPDX-License-Identifier: Apache-2.0
// The places of all robots in the picture; they lie between two steps while the run plays.
import type { Moment, SceneInfo } from "../../avo/avo.ts";
import { robotsOf, vectorOf, type RobotInfo } from "./discs.ts";
import { ofThePlane, type Projection } from "./orbit.ts";
import type { Run } from "../run/run.ts";

/** Row i is row i of the moment. Vectors are x and y in turn. */
export interface Shown {
  moment: Moment;
  robots: (RobotInfo | undefined)[];
  project: Projection;     // from the world to the picture
  world: Float64Array;     // m, x, y and z of the disc's center; z is 0 in the plane
  x: Float64Array;         // m, of the disc's center in the picture
  y: Float64Array;
  near: Float64Array;      // m, towards the viewer; 0 in the plane
  order: number[] | null;  // of the rows, from the farthest to the nearest; null in the plane: as they are
  goal: Float64Array;      // m, in the picture
  velocity: Float64Array;  // m/s, in the picture
  radius: Float64Array;    // m
  heading: Float64Array;   // rad
  movers: { x: number; y: number; near: number; vx: number; vy: number; radius: number }[];
}

/** `share`, 0 to 1: the position between the run's `before` and its `moment`. */
export function shownOf(run: Run, share: number, project: Projection = ofThePlane): Shown {
  const { moment, before, info } = run;
  const robots = robotsOf(moment, info);
  const from = share < 1 && before ? before : null;
  const { world, heading } = placesOf(moment, from, share, robots);
  const inSpace = moment.dimensions === 3;
  return {
    moment, robots, project, world, heading, ...pictured(world, inSpace ? project : null),
    goal: inSpace ? projected(moment.goal, project) : moment.goal,
    velocity: inSpace ? directed(moment.velocity, project) : moment.velocity,
    radius: Float64Array.from(robots, (robot) => robot?.disc_radius ?? 0.5),
    movers: moversOf(moment, from, share, info, project),
  };
}

function placesOf(moment: Moment, from: Moment | null, share: number, robots: Shown["robots"]): Pick<Shown, "world" | "heading"> {
  const count = moment.robot.length;
  const world = new Float64Array(3 * count);
  const heading = new Float64Array(count);
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
    const [begin, end] = [vectorOf(was.position, was.dimensions, j), vectorOf(moment.position, moment.dimensions, i)];
    world[3 * i] = mix(begin[0], end[0], part) + ahead * Math.cos(heading[i]!);
    world[3 * i + 1] = mix(begin[1], end[1], part) + ahead * Math.sin(heading[i]!);
    world[3 * i + 2] = mix(begin[2], end[2], part);
  }
  return { world, heading };
}

/** Returns places in the picture and their order; `project` is null in the plane. */
function pictured(world: Float64Array, project: Projection | null): Pick<Shown, "x" | "y" | "near" | "order"> {
  const count = world.length / 3;
  const [x, y, near] = [new Float64Array(count), new Float64Array(count), new Float64Array(count)];
  for (let i = 0; i < count; ++i) {
    const place = vectorOf(world, 3, i);
    [x[i], y[i], near[i]] = project ? project(...place) : place;
  }
  return { x, y, near, order: project && Array.from(near.keys()).sort((a, b) => near[a]! - near[b]!) };
}

/** Returns places of space in the picture. */
function projected(places: Float64Array, project: Projection): Float64Array {
  const found = new Float64Array(places.length / 3 * 2);
  for (let i = 0; i < places.length / 3; ++i) {
    const [x, y] = project(...vectorOf(places, 3, i));
    found[2 * i] = x;
    found[2 * i + 1] = y;
  }
  return found;
}

/** Returns vectors of space without a place in the picture. */
function directed(vectors: Float64Array, project: Projection): Float64Array {
  const [x, y] = project(0, 0, 0);
  return projected(vectors, project).map((value, k) => value - (k % 2 === 0 ? x : y));
}

function moversOf(moment: Moment, before: Moment | null, share: number, info: SceneInfo, project: Projection): Shown["movers"] {
  const { dimensions, moving_obstacles: now } = moment;
  const was = before && before.moving_obstacles.length === now.length ? before.moving_obstacles : now;
  const [ox, oy] = project(0, 0, 0);
  return info.moving_obstacles.slice(0, now.length / (2 * dimensions)).map(({ radius }, k) => {
    const [begin, end] = [vectorOf(was, dimensions, 2 * k), vectorOf(now, dimensions, 2 * k)];
    const [x, y, near] = project(mix(begin[0], end[0], share), mix(begin[1], end[1], share), mix(begin[2], end[2], share));
    const [vx, vy] = project(...vectorOf(now, dimensions, 2 * k + 1));
    return { x, y, near, vx: vx - ox, vy: vy - oy, radius };
  });
}

const mix = (from: number, to: number, share: number) => from + share * (to - from);
