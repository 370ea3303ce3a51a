// SPDX-License-Identifier: Apache-2.0
// Actions that a press on the map begins: each shows a preview, and takes effect on release.
import { addRobot, addWall, moveGoal, moveRobot, moveWall, removeRobot, removeWall } from "./changes.ts";
import type { PageLab } from "../run/make_lab.ts";
import { pick, type Hit } from "./picking.ts";
import { disc, FORM, line, ring, type Layers, type Paint } from "./world_layers.ts";
import type { WorldView } from "./world_view.ts";

export type Tool = "move" | "robot" | "wall" | "erase";
type Point = [number, number];
const MOVER = "moving obstacles are erased in the text of the scene, under moving_obstacles";

export interface Gesture {
  /** The place of the pointer (m), and a preview. */
  show(layers: Layers, paint: Paint, to: Point): void;
  drop(to: Point): void;
}

/** Null: the press pans the map, or turns the view of space. `from` in m. */
export function begin(lab: PageLab, view: WorldView, tool: Tool, hit: Hit | null, from: Point): Gesture | null {
  if (view.orbit) return null;  // it turns the view
  if (!lab.live) return hit === null || hit.kind === "mover" ? null : stay(lab);
  if (tool === "robot") return placeRobot(lab, from);
  if (tool === "wall") return drawWall(lab, from);
  if (tool === "erase") return null;
  if (hit?.kind === "robot") return dragRobot(lab, view, hit.robot, from);
  if (hit?.kind === "goal") return dragGoal(lab, view, hit.robot);
  if (hit?.kind === "wall") return dragWall(lab, hit.wall, hit.end, from);
  return null;
}

/** Handles a press without motion: it selects, or erases. */
export function click(lab: PageLab, view: WorldView, tool: Tool, px: number, py: number, touch: boolean): void {
  const hit = pick(lab, view, px, py, touch);
  if (tool === "erase") {
    if (hit?.kind === "robot") removeRobot(lab, hit.robot);
    else if (hit?.kind === "wall") removeWall(lab, hit.wall);
    else if (hit?.kind === "mover") lab.refuse(MOVER);
  } else lab.select(hit?.kind === "robot" || hit?.kind === "goal" ? hit.robot : null);
}

/** In a recording nothing moves, and the Lab says why. */
function stay(lab: PageLab): Gesture {
  return { show: () => undefined, drop: () => { lab.edit(() => undefined); } };
}

function dragRobot(lab: PageLab, view: WorldView, robot: number, from: Point): Gesture {
  const row = view.shown.moment.robot.indexOf(robot);
  const { x, y, radius, heading, robots } = view.shown;
  const ahead = robots[row]?.disc_ahead ?? 0;  // the pointer drags the disc, and its robot's position follows
  const [dx, dy] = [x[row]! - from[0], y[row]! - from[1]];
  return {
    show(layers, paint, to) {
      disc(layers.above, to[0] + dx, to[1] + dy, radius[row]!, paint.accent, 0.45);
      line(layers.links, x[row]!, y[row]!, to[0] + dx, to[1] + dy, paint.accent, 0.8, 0, 0.8);
    },
    drop(to) {
      const back: Point = [ahead * Math.cos(heading[row]!), ahead * Math.sin(heading[row]!)];
      moveRobot(lab, robot, [to[0] + dx - back[0], to[1] + dy - back[1]]);
    },
  };
}

function dragGoal(lab: PageLab, view: WorldView, robot: number): Gesture {
  return {
    show(layers, paint, to) {
      const row = view.shown.moment.robot.indexOf(robot);
      linkToGoal(layers, paint, [view.shown.x[row]!, view.shown.y[row]!], to);
    },
    drop: (to) => { moveGoal(lab, robot, to); },
  };
}

function dragWall(lab: PageLab, wall: number, end: Point | null, from: Point): Gesture {
  const dragged = lab.info.walls[wall]!;
  const isEnd = (p: Point) => end !== null && Math.hypot(p[0] - end[0], p[1] - end[1]) < 1e-9;
  const walls = lab.info.walls.filter(({ a, b, obstacle }) =>
    obstacle === dragged.obstacle && (end === null || isEnd(a) || isEnd(b)));
  return {
    show(layers, paint, to) {
      const moved = (p: Point): Point => (end && !isEnd(p) ? p : [p[0] + to[0] - from[0], p[1] + to[1] - from[1]]);
      for (const { a, b, radius } of walls) {
        if (radius > 0) ring(layers, ...moved(a), radius, paint.accent, 2);
        else line(layers.links, ...moved(a), ...moved(b), paint.accent, 0.9, 0.04, 1.5);
      }
    },
    drop: (to) => { moveWall(lab, wall, end, to[0] - from[0], to[1] - from[1]); },
  };
}

/** Draws a link from the robot's place to its goal, and the goal. */
function linkToGoal(layers: Layers, paint: Paint, from: Point, to: Point): void {
  line(layers.links, ...from, ...to, paint.accent, 0.8, 0, 0.8);
  disc(layers.above, to[0], to[1], 0.3, paint.accent, 1, { form: FORM.diamond, outline: 2, least: 6 });
}

function placeRobot(lab: PageLab, from: Point): Gesture {
  const radius = lab.info.robots[0]?.radius ?? 0.5;
  return {
    show(layers, paint, to) {
      disc(layers.above, from[0], from[1], radius, paint.accent, 0.6);
      linkToGoal(layers, paint, from, to);
    },
    drop: (to) => { addRobot(lab, from, to); },
  };
}

function drawWall(lab: PageLab, from: Point): Gesture {
  return {
    show: (layers, paint, to) => line(layers.links, ...from, ...to, paint.accent, 1, 0.04, 1.5),
    drop(to) {
      if (Math.hypot(to[0] - from[0], to[1] - from[1]) > 0.05) addWall(lab, from, to);
    },
  };
}
