// SPDX-License-Identifier: Apache-2.0
// The selection: the selected robot, its neighbors, and where they would come to rest if they braked now.
import type { BrakingPath, Moment, Simulation } from "../../avo/avo.ts";
import type { Rgb } from "./colors.ts";
import { simulationFor } from "../inspector/inspector.ts";
import type { PageLab } from "../run/make_lab.ts";
import { vectorOf } from "./discs.ts";
import type { Shown } from "./shown.ts";
import { disc, FORM, line, ring, type Layers, type Paint } from "./world_layers.ts";

interface Known { live: Simulation | null; moment: Moment; robot: number; paths: BrakingPath[] }
let known: Known | null = null;  // for the last requested moment

/** Returns the path of the selected robot first, then those of its neighbors; an empty list for a robot that does not
 * decide. */
function brakingPaths(lab: PageLab, robot: number): BrakingPath[] {
  const { live, moment } = lab;
  if (known && known.live === live && known.moment === moment && known.robot === robot) return known.paths;
  if (!live && lab.playing) return [];  // each row of a recording would need a simulation
  let paths: BrakingPath[] = [];
  try {
    paths = simulationFor(lab).brakingPaths(robot);
  } catch {
    // parked, gone or unknown: nothing to show
  }
  known = { live, moment, robot, paths };
  return paths;
}

export function drawSelection(layers: Layers, lab: PageLab, shown: Shown, paint: Paint): void {
  const { moment } = shown;
  const row = lab.selected === null ? -1 : moment.robot.indexOf(lab.selected);
  if (row >= 0) drawSelected(layers, lab, shown, row, paint);
  if (lab.highlighted?.startsWith("robots.")) {
    const at = moment.robot.indexOf(Number(lab.highlighted.slice("robots.".length)));
    if (at >= 0) ring(layers, shown.x[at]!, shown.y[at]!, shown.radius[at]! + 0.1, paint.ink, 2);
  }
}

function drawSelected(layers: Layers, lab: PageLab, shown: Shown, row: number, paint: Paint): void {
  const { moment } = shown;
  const [x, y] = [shown.x[row]!, shown.y[row]!];
  disc(layers.above, x, y, lab.info.options.sensing_radius, paint.accent, 0.4, { form: FORM.dashed, outline: 1 });
  ring(layers, x, y, shown.radius[row]! + 0.12, paint.accent, 2.5);
  const [vx, vy] = [shown.velocity[2 * row]!, shown.velocity[2 * row + 1]!];
  line(layers.links, x, y, x + vx, y + vy, paint.ink, 1, 0, 1.2);
  brakingPaths(lab, moment.robot[row]!).forEach(({ of, points, radius }, k) => {
    if (k > 0 && moment.dimensions === 3 && of !== lab.highlighted) return;  // in space, many are in line
    drawBraking(layers, inPicture(points, shown), radius, k === 0 ? paint.accent : paint.mover, k === 0);
    const at = k > 0 && of.startsWith("robots.") ? moment.robot.indexOf(Number(of.slice("robots.".length))) : -1;
    if (at < 0) return;
    line(layers.links, x, y, shown.x[at]!, shown.y[at]!, paint.accent, 0.22, 0, 0.6);
    disc(layers.above, shown.x[at]!, shown.y[at]!, shown.radius[at]! + 0.1, paint.accent, 0.6, { form: FORM.ring, outline: 1, least: 4 });
  });
}

/** Returns x and y in turn of places in the picture. */
function inPicture(points: number[], { moment, project }: Shown): number[] {
  if (moment.dimensions === 2) return points;
  return Array.from({ length: points.length / 3 }, (_, k) => project(...vectorOf(points, 3, k)).slice(0, 2)).flat();
}

/** Draws the path to rest, and the disc there. */
function drawBraking(layers: Layers, points: number[], radius: number, color: Rgb, own: boolean): void {
  for (let k = 2; k + 1 < points.length; k += 2) {
    line(layers.links, points[k - 2]!, points[k - 1]!, points[k]!, points[k + 1]!, color, own ? 1 : 0.7, 0, own ? 1.4 : 0.8);
  }
  const [x, y] = [points[points.length - 2], points[points.length - 1]];
  if (x !== undefined && y !== undefined) ring(layers, x, y, radius, color, own ? 1.6 : 1, FORM.dashed);
}
