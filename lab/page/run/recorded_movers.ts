// SPDX-License-Identifier: Apache-2.0
// Where the moving obstacles of a recording of space are: recordings have no rows of them, but their scene tells.
import type { MovingObstacleInfo, SceneInfo } from "../../avo/avo.ts";

/** Returns position and velocity of each at a time, s; none where the scene does not tell. */
export function moversAt(info: SceneInfo, time: number): Float64Array {
  return Float64Array.from(info.moving_obstacles.flatMap((obstacle) => stateAt(obstacle, time)));
}

function stateAt(obstacle: MovingObstacleInfo, time: number): number[] {
  const { position, velocity, acceleration, trajectory } = obstacle;
  if (!position || !velocity || !acceleration || !trajectory) return [];
  if (trajectory.length > 0) return onTrajectory(trajectory, time);
  const now = velocity.map((v, k) => v + time * acceleration[k]!);
  return [...position.map((p, k) => p + 0.5 * time * (velocity[k]! + now[k]!)), ...now];
}

/** It rests before the first place and behind the last one, and goes straight and evenly from each to the next. */
function onTrajectory(trajectory: number[][], time: number): number[] {
  const next = trajectory.findIndex(([at]) => at! > time);
  const rest = next === 0 ? trajectory[0]! : next < 0 ? trajectory[trajectory.length - 1]! : null;
  if (rest) return [...rest.slice(1), 0, 0, 0];
  const [from, to] = [trajectory[next - 1]!, trajectory[next]!];
  const velocity = [1, 2, 3].map((k) => (to[k]! - from[k]!) / (to[0]! - from[0]!));
  return [...velocity.map((v, k) => from[k + 1]! + (time - from[0]!) * v), ...velocity];
}
