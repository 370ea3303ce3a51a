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
  if (!scene) return { info: unknownScene(recording), goals: new Map() };
  const simulation = library.simulate(scene.yaml, { ...liveOptions(recording), name: scene.name });
  const { robot, goal } = simulation.moment();
  const goals: Goals = new Map(Array.from(robot, (number, i) => [number, [goal[2 * i]!, goal[2 * i + 1]!]]));
  return { info: simulation.info(), goals };
}

/** Returns a scene for a table of positions alone, with the paper's constants, which are also the defaults of scenes. */
function unknownScene(recording: Recording): SceneInfo {
  const step = recording.times.length > 1 ? recording.times[1]! - recording.times[0]! : 0.1;
  return {
    name: recording.name,
    duration: recording.times[recording.times.length - 1] ?? 0,
    options: {
      method: "unknown", certificate: "none", motion: "held", control_time: 2, time_horizon: 3, time_step: step,
      sensing_radius: 15, arrival_distance: 0.5,
    },
    robots: Array.from({ length: recording.robots }, (_, robot) => ({
      robot, radius: 0.5, disc_radius: 0.5, disc_ahead: 0, max_speed: 2, max_acceleration: 1, preferred_speed: 2,
      priority: 1, parked: false, model: recording.headings ? "car" as const : "holonomic" as const,
    })),
    walls: [],
    moving_obstacles: [],
    advice: [],
    broken_assumptions: [],
  };
}
