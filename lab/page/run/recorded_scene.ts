// SPDX-License-Identifier: Apache-2.0
// The facts about its scene that a recording gives: radii, limits, walls and goals.
import type { Library, SceneInfo, SceneOptions } from "../../avo/avo.ts";
import type { Recording } from "../data/recording.ts";
import type { Goals } from "./recorded_run.ts";

/** The options for simulating its scene again. */
export function liveOptions(recording: Recording): SceneOptions {
  const scene = recording.scene;
  if (!scene) return {};
  const { overrides, files, start_at_rest, limit_speed } = scene;
  return { overrides, files, start_at_rest, limit_speed, recorded: true };
}

export function infoOf(recording: Recording, library: Library): { info: SceneInfo; goals: Goals } {
  const { scene } = recording;
  if (!scene) return { info: unknownScene(recording, library), goals: new Map() };
  const simulation = library.simulate(scene.yaml, { ...liveOptions(recording), name: scene.name });
  const { robot, goal } = simulation.moment();
  const { dimensions } = simulation;
  const goals: Goals = new Map(Array.from(robot, (number, i) => [number, [...goal.subarray(dimensions * i, dimensions * (i + 1))]]));
  return { info: simulation.info(), goals };
}

/** The paper's constants, and the library's defaults. */
const UNKNOWN = "version: 1\ncontrol_time: 2\ntime_horizon: 3\nsensing_radius: 15\n" +
  "robots: [{position: [0, 0], goal: [1, 0]}]\n";
const UNKNOWN_IN_SPACE = "version: 1\nspace: 3\nrobots: [{position: [0, 0, 0], goal: [1, 0, 0]}]\n";

/** Returns a scene for a table of positions alone. */
function unknownScene(recording: Recording, library: Library): SceneInfo {
  const { name, times, robots, headings, dimensions } = recording;
  const info = library.simulate(dimensions === 3 ? UNKNOWN_IN_SPACE : UNKNOWN).info();
  const known = { ...info.robots[0]!, model: headings ? "car" as const : "holonomic" as const };
  return {
    ...info, name, duration: times[times.length - 1]!,
    options: { ...info.options, method: "unknown", certificate: "none", time_step: times[1]! - times[0]! },
    robots: Array.from({ length: robots }, (_, robot) => ({ ...known, robot })),
  };
}
