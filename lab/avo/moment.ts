// SPDX-License-Identifier: Apache-2.0
// A state from the module's columns (lab/wasm/moment.cpp).
import type { Dimensions, Moment } from "./types.ts";

export function momentOf({ buffer }: Uint8Array, dimensions: Dimensions): Moment {
  const view = new DataView(buffer);
  const robots = view.getUint32(16, true), obstacles = view.getUint32(20, true);
  let at = 24;
  const doubles = (size: number) => new Float64Array(buffer, (at += 8 * size) - 8 * size, size);
  const bytes = (size: number) => new Uint8Array(buffer, (at += size) - size, size);
  return {
    dimensions,
    time: view.getFloat64(0, true),
    steps: view.getFloat64(8, true),
    position: doubles(dimensions * robots),
    velocity: doubles(dimensions * robots),
    goal: doubles(dimensions * robots),
    heading: doubles(robots),
    acceleration: doubles(robots),
    moving_obstacles: doubles(2 * dimensions * obstacles),
    clearance: new Float32Array(buffer, (at += 4 * robots) - 4 * robots, robots),
    robot: new Int32Array(buffer, (at += 4 * robots) - 4 * robots, robots),
    status: bytes(robots),
    decided: bytes(robots),
    arrived: bytes(robots),
  };
}
