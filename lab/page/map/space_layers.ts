// SPDX-License-Identifier: Apache-2.0
// What the picture of space has besides robots: a ground with a grid, and boxes of glass. It also has the air below
// robots, which others keep out of.
import { roundedUp } from "./camera.ts";
import type { Rgb } from "./colors.ts";
import type { Lab } from "../run/lab.ts";
import { vectorOf } from "./discs.ts";
import { axesOf, type Orbit } from "./orbit.ts";
import type { Shown } from "./shown.ts";
import { isHidden, type Face, type Stage } from "./stage.ts";
import { dot3, plus3, type Vec3 } from "./vec3.ts";
import { FORM, line, type BodyOf, type Layers, type Paint } from "./world_layers.ts";

const GRID_LINES = 14;    // along the longer side, at most
const BEHIND = 0.3;       // the opacity of a ball behind something
const NEAR_GLASS = 0.07, FAR_GLASS = 0.035;  // the opacity of faces
const DOWNWASH = 0.16;    // the opacity of the air below a robot

function edge(layers: Layers, { project }: Shown, from: Vec3, to: Vec3, color: Rgb, alpha: number, pixels: number): void {
  const [ax, ay] = project(...from), [bx, by] = project(...to);
  line(layers.ground, ax, ay, bx, by, color, alpha, 0, pixels);
}

export function drawGround(layers: Layers, { bounds: { min, max } }: Stage, shown: Shown, paint: Paint): void {
  const extent = Math.max(max[0] - min[0], max[1] - min[1]);
  const step = roundedUp(Math.max(extent / GRID_LINES, 1e-3));  // m, between lines
  for (const [axis, other] of [[0, 1], [1, 0]] as const) {
    for (let k = Math.ceil(min[axis] / step); k * step <= max[axis]; ++k) {
      const [from, to]: [Vec3, Vec3] = [[...min], [...min]];
      from[axis] = to[axis] = k * step;
      to[other] = max[other];
      edge(layers, shown, from, to, paint.grid, k % 5 === 0 ? 1 : 0.6, 0.5);
    }
  }
}

function drawFace(layers: Layers, { project }: Shown, { corner, a, b }: Face, color: Rgb, alpha: number): void {
  const [x, y] = project(...corner), [ax, ay] = project(...plus3(corner, a)), [bx, by] = project(...plus3(corner, b));
  layers.faces.push(x, y, ax - x, ay - y, color[0], color[1], color[2], alpha, bx - x, by - y, 0, 0);
}

/** Draws the far faces first. */
export function drawBoxes(layers: Layers, lab: Lab, { solids }: Stage, shown: Shown, orbit: Orbit, paint: Paint): void {
  const towards = axesOf(orbit)[2];
  const isNear = (normal: Vec3) => dot3(normal, towards) > 1e-9;
  for (const { obstacle, faces, edges } of solids) {
    const color = lab.highlighted === `obstacles.${obstacle}` ? paint.accent : paint.wall;
    for (const near of [false, true])
      for (const face of faces) if (isNear(face.normal) === near) drawFace(layers, shown, face, color, near ? NEAR_GLASS : FAR_GLASS);
    for (const { from, to, normals } of edges) {
      const seen = normals.some(isNear);
      edge(layers, shown, from, to, color, seen ? 0.7 : 0.25, seen ? 0.8 : 0.6);
    }
  }
}

/** Draws the part of each robot's body that is air. */
export function drawDownwash(layers: Layers, shown: Shown, colors: Rgb[]): void {
  shown.robots.forEach((robot, i) => {
    if (!robot?.downwash) return;
    const [x, y, z] = vectorOf(shown.world, 3, i);
    const [bx, by] = shown.project(x, y, z - robot.downwash);
    line(layers.heads, shown.x[i]!, shown.y[i]!, bx, by, colors[i]!, DOWNWASH, robot.radius, 0.5);
  });
}

/** Returns whether a moving obstacle is between the robot and the viewer. */
function isBehindMover({ x, y, near, movers }: Shown, row: number): boolean {
  return movers.some((mover) => mover.near > near[row]! && Math.hypot(mover.x - x[row]!, mover.y - y[row]!) < mover.radius);
}

/** Returns how robots are drawn: those behind a box or a moving obstacle are pale. */
export function bodiesOf({ boxes }: Stage, shown: Shown, orbit: Orbit): BodyOf {
  const towards = axesOf(orbit)[2];
  const hidden = (row: number) => isHidden(boxes, vectorOf(shown.world, 3, row), towards) || isBehindMover(shown, row);
  return (row) => ({ form: FORM.ball, alpha: hidden(row) ? BEHIND : 1 });
}
