// SPDX-License-Identifier: Apache-2.0
// A small picture of a scene's start: robots in the colors of their directions, lines to their goals, and walls.
import type { Simulation } from "../../avo/avo.ts";
import { emptyBox, fit, include, toPixels, type Camera } from "./camera.ts";
import { cssOf, directionColor } from "./colors.ts";
import { robotsOf } from "./discs.ts";

const MARGIN = { x: 10, top: 10, bottom: 10 };  // pixels
const MANY_WAYS = 120;                           // with more robots, these lines would hide everything

export function drawStart(context: CanvasRenderingContext2D, simulation: Simulation, width: number, height: number,
                          theme: "light" | "dark", wall: string): void {
  const moment = simulation.moment();
  const { walls } = simulation.info();
  const radii = robotsOf(moment, simulation.info()).map((robot) => robot?.disc_radius ?? 0.5);
  const camera: Camera = { x: 0, y: 0, scale: 1, width, height };
  const box = emptyBox();
  moment.robot.forEach((_, i) => {
    include(box, moment.position[2 * i]!, moment.position[2 * i + 1]!, radii[i]);
    include(box, moment.goal[2 * i]!, moment.goal[2 * i + 1]!);
  });
  for (const { a, b } of walls) include(box, ...a), include(box, ...b);
  fit(camera, box, MARGIN);
  const stroke = (color: string, wide: number, from: readonly number[], to: readonly number[]): void => {
    context.strokeStyle = color;
    context.lineWidth = wide;
    context.beginPath(), context.moveTo(from[0]!, from[1]!), context.lineTo(to[0]!, to[1]!), context.stroke();
  };
  for (const { a, b } of walls) stroke(wall, 1.3, toPixels(camera, ...a), toPixels(camera, ...b));
  moment.robot.forEach((_, i) => {
    const [x, y, gx, gy] = [moment.position[2 * i]!, moment.position[2 * i + 1]!, moment.goal[2 * i]!, moment.goal[2 * i + 1]!];
    const color = cssOf(directionColor(Math.atan2(gy - y, gx - x), theme));
    const at = toPixels(camera, x, y);
    context.globalAlpha = 0.25;
    if (moment.robot.length <= MANY_WAYS) stroke(color, 0.8, at, toPixels(camera, gx, gy));
    context.globalAlpha = 1;
    context.fillStyle = color;
    context.beginPath();
    context.arc(...at, Math.max(1.1, radii[i]! * camera.scale), 0, 2 * Math.PI);
    context.fill();
  });
}
