// SPDX-License-Identifier: Apache-2.0
// A small picture of a scene's start: robots in the colors of their directions, lines to their goals, walls and boxes.
import type { Moment, SceneInfo, Simulation } from "../../avo/avo.ts";
import { emptyBox, fit, include, toPixels, type Camera } from "./camera.ts";
import { cssOf, directionColor } from "./colors.ts";
import { robotsOf, vectorOf } from "./discs.ts";
import { ASIDE, ofThePlane, projectionOf } from "./orbit.ts";
import type { Vec3 } from "./vec3.ts";
import { stageOf } from "./stage.ts";

const MARGIN = { x: 10, top: 10, bottom: 10 };  // pixels
const MANY_WAYS = 120;                           // with more robots, these lines would hide everything

/** Returns the lines of walls, or of the edges of boxes. */
function linesOf(moment: Moment, info: SceneInfo): [Vec3, Vec3][] {
  if (info.dimensions === 3) return stageOf(moment, info).solids.flatMap(({ edges }) => edges.map(({ from, to }): [Vec3, Vec3] => [from, to]));
  return info.walls.map(({ a, b }) => [[...a, 0], [...b, 0]]);
}

export function drawStart(context: CanvasRenderingContext2D, simulation: Simulation, width: number, height: number,
                          theme: "light" | "dark", wall: string): void {
  const moment = simulation.moment(), info = simulation.info();
  const { dimensions } = info;
  const project = dimensions === 3 ? projectionOf({ ...ASIDE, pivot: [0, 0, 0] }) : ofThePlane;
  const shown = (place: Vec3): [number, number] => project(...place).slice(0, 2) as [number, number];
  const radii = robotsOf(moment, info).map((robot) => robot?.disc_radius ?? 0.5);
  const lines = linesOf(moment, info);
  const camera: Camera = { x: 0, y: 0, scale: 1, width, height };
  const box = emptyBox();
  moment.robot.forEach((_, i) => {
    include(box, ...shown(vectorOf(moment.position, dimensions, i)), radii[i]);
    include(box, ...shown(vectorOf(moment.goal, dimensions, i)));
  });
  for (const ends of lines) for (const end of ends) include(box, ...shown(end));
  fit(camera, box, MARGIN);
  const stroke = (color: string, wide: number, from: Vec3, to: Vec3): void => {
    context.strokeStyle = color;
    context.lineWidth = wide;
    context.beginPath(), context.moveTo(...toPixels(camera, ...shown(from))), context.lineTo(...toPixels(camera, ...shown(to))), context.stroke();
  };
  for (const [from, to] of lines) stroke(wall, dimensions === 3 ? 0.6 : 1.3, from, to);
  moment.robot.forEach((_, i) => {
    const [from, to] = [vectorOf(moment.position, dimensions, i), vectorOf(moment.goal, dimensions, i)];
    const color = cssOf(directionColor(Math.atan2(to[1] - from[1], to[0] - from[0]), theme));
    context.globalAlpha = 0.25;
    if (moment.robot.length <= MANY_WAYS) stroke(color, 0.8, from, to);
    context.globalAlpha = 1;
    context.fillStyle = color;
    context.beginPath();
    context.arc(...toPixels(camera, ...shown(from)), Math.max(1.1, radii[i]! * camera.scale), 0, 2 * Math.PI);
    context.fill();
  });
}
