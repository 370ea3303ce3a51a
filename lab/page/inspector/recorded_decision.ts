// SPDX-License-Identifier: Apache-2.0
// A recording holds states, but no decisions. Its scene, started from the state of one row, decides again.
import type { Simulation } from "../../avo/avo.ts";
import type { Lab } from "../run/lab.ts";

/** Returns "robots.3.position=[1,2]" and so on: overrides that start each robot with the row's position, velocity and
 * heading. */
export function startsOf({ moment, info }: Pick<Lab, "moment" | "info">): string[] {
  const models = new Map(info.robots.map((robot) => [robot.robot, robot]));
  const starts: string[] = [];
  moment.robot.forEach((robot, i) => {
    const { dimensions } = moment;
    const vector = (from: Float64Array): string => `[${from.subarray(dimensions * i, dimensions * (i + 1)).join(",")}]`;
    const setup = models.get(robot);
    if (!setup || setup.parked) return;
    starts.push(`robots.${robot}.position=${vector(moment.position)}`, `robots.${robot}.velocity=${vector(moment.velocity)}`);
    if (setup.model !== "holonomic") starts.push(`robots.${robot}.heading=${moment.heading[i]}`);
  });
  return starts;
}

/** Uses the recording's scene, or another text of it. Throws one line that says why the row cannot be explained. */
export function simulationOfRow(lab: Lab, text = lab.text): Simulation {
  if (!text) throw new Error("This recording does not hold its scene: radii, limits and goals are unknown, so there is nothing to explain.");
  if (lab.info.moving_obstacles.length > 0)
    throw new Error("A recording does not tell where moving obstacles are, so this scene's decisions cannot be explained from its rows.");
  const overrides = [...(lab.options.overrides ?? []), ...startsOf(lab)];
  const simulation = lab.library.simulate(text, { ...lab.options, name: lab.name, overrides });
  const present = new Set(lab.moment.robot);
  for (const { robot } of lab.info.robots) if (!present.has(robot)) simulation.removeRobot(robot);
  return simulation;
}
