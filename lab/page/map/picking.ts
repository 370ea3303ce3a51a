// SPDX-License-Identifier: Apache-2.0
// Finds the thing under a pixel of the map.
import { toMeters } from "./camera.ts";
import type { PageLab } from "../run/make_lab.ts";
import type { Shown } from "./shown.ts";
import { hasGoalShown } from "./world_layers.ts";
import type { WorldView } from "./world_view.ts";

export type Hit =
  | { kind: "robot"; robot: number }
  | { kind: "goal"; robot: number }
  | { kind: "mover"; mover: number }
  | { kind: "wall"; wall: number; end: [number, number] | null };  // end: one of its two ends, or null: the whole wall

const FINGER = 14;  // pixels, the error of a finger
const MOUSE = 5;

/** Robots and goals come before moving obstacles, and these before walls; of a robot and a goal, the one with the
 * nearer middle is taken. */
export function pick(lab: PageLab, view: WorldView, px: number, py: number, touch: boolean): Hit | null {
  const [x, y] = toMeters(view.camera, px, py);
  const slack = (touch ? FINGER : MOUSE) / view.camera.scale;
  const { shown } = view;
  const { moment } = shown;
  const toRobot = (i: number) => Math.hypot(shown.x[i]! - x, shown.y[i]! - y);
  const toGoal = (i: number) => Math.hypot(shown.goal[2 * i]! - x, shown.goal[2 * i + 1]! - y);
  const robot = inFront(shown, toRobot) ?? nearest(moment.robot.length, slack, (i) => toRobot(i) - shown.radius[i]!);
  const goal = nearest(moment.robot.length, slack + 3 / view.camera.scale, (i) => (hasGoalShown(lab, shown, i) ? toGoal(i) : Infinity));
  const isGoal = goal >= 0 && (robot < 0 || toGoal(goal) < toRobot(robot) - 2 / view.camera.scale);
  if (isGoal) return { kind: "goal", robot: moment.robot[goal]! };
  if (robot >= 0) return { kind: "robot", robot: moment.robot[robot]! };
  const mover = nearest(shown.movers.length, slack, (k) => Math.hypot(shown.movers[k]!.x - x, shown.movers[k]!.y - y) - shown.movers[k]!.radius);
  if (mover >= 0) return { kind: "mover", mover };
  return pickWall(lab, x, y, slack);
}

/** In space, returns the row of the nearest ball to the viewer over that place of the picture. */
export function inFront({ order, radius }: Pick<Shown, "order" | "radius">, toRobot: (row: number) => number): number | undefined {
  for (let k = (order?.length ?? 0) - 1; k >= 0; --k) if (toRobot(order![k]!) <= radius[order![k]!]!) return order![k];
  return undefined;
}

function pickWall(lab: PageLab, x: number, y: number, slack: number): Hit | null {
  const { walls } = lab.info;
  const wall = nearest(walls.length, slack, (k) => distanceToWall(walls[k]!.a, walls[k]!.b, x, y) - walls[k]!.radius);
  if (wall < 0) return null;
  const { a, b, radius } = walls[wall]!;
  const ends = radius > 0 ? [] : [a, b].filter((end) => Math.hypot(end[0] - x, end[1] - y) < 1.6 * slack);
  return { kind: "wall", wall, end: ends[0] ?? null };
}

/** Returns the index with the least distance (m), if that is at most `most`; otherwise -1. */
function nearest(count: number, most: number, distance: (index: number) => number): number {
  let best = -1;
  for (let i = 0, least = most; i < count; ++i) {
    const from = distance(i);
    if (from > least) continue;
    least = from;
    best = i;
  }
  return best;
}

function distanceToWall(a: [number, number], b: [number, number], x: number, y: number): number {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const length2 = dx * dx + dy * dy;
  const share = length2 > 0 ? Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / length2)) : 0;
  return Math.hypot(a[0] + share * dx - x, a[1] + share * dy - y);
}

/** Returns its name for highlighting. */
export function nameOf(hit: Hit | null): string | null {
  if (!hit) return null;
  if (hit.kind === "mover") return `moving_obstacles.${hit.mover}`;
  return hit.kind === "wall" ? `walls.${hit.wall}` : `robots.${hit.robot}`;
}
