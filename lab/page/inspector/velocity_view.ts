// SPDX-License-Identifier: Apache-2.0
// The visible part of a robot's velocity space: converts m/s to pixels and back, and has axes with units.
import type { Vec } from "./decision.ts";
import type { DrawnDecision } from "./velocity_space.ts";

export interface View {
  center: Vec;    // m/s
  scale: number;  // pixels of CSS per m/s
  width: number;  // pixels of CSS
  height: number;
}

export type Box = [xmin: number, ymin: number, xmax: number, ymax: number];  // m/s

export function toScreen(view: View, v: Vec): Vec {
  return [0.5 * view.width + (v[0] - view.center[0]) * view.scale, 0.5 * view.height - (v[1] - view.center[1]) * view.scale];
}

export function toVelocity(view: View, x: number, y: number): Vec {
  return [view.center[0] + (x - 0.5 * view.width) / view.scale, view.center[1] - (y - 0.5 * view.height) / view.scale];
}

export function boxOf(view: View): Box {
  const x = 0.5 * view.width / view.scale, y = 0.5 * view.height / view.scale;
  return [view.center[0] - x, view.center[1] - y, view.center[0] + x, view.center[1] + y];
}

/** Zooms about the velocity under the pixel x, y, between 1 and 100 000 pixels per m/s. */
export function zoomed(view: View, factor: number, x: number, y: number): View {
  const scale = Math.min(Math.max(view.scale * factor, 1), 1e5);
  const kept = toVelocity(view, x, y);
  return { ...view, scale, center: [kept[0] - (x - 0.5 * view.width) / scale, kept[1] + (y - 0.5 * view.height) / scale] };
}

export function panned(view: View, dx: number, dy: number): View {
  return { ...view, center: [view.center[0] - dx / view.scale, view.center[1] + dy / view.scale] };
}

function around(box: Box, width: number, height: number): View {
  const x = box[2] - box[0], y = box[3] - box[1];
  return {
    center: [0.5 * (box[0] + box[2]), 0.5 * (box[1] + box[3])],
    scale: Math.min(width / x, height / y), width, height,
  };
}

/** Returns a view of all velocities that the robot may choose, which lie in the disc of its speed, and of v'. Two sizes
 * are enough, so that the axes stay the same from decision to decision. */
export function fitted(decision: DrawnDecision, width: number, height: number): View {
  const points = [decision.velocity, decision.new_velocity, decision.preferred_velocity];
  const farthest = Math.max(...points.map((v) => Math.max(Math.abs(v[0]), Math.abs(v[1]))));
  const speed = decision.speed_disc?.radius ?? Math.max(farthest, 1e-3);
  const half = farthest > 1.1 * speed ? 1.7 * speed : 1.12 * speed;
  return around([-half, -half, half, half], width, height);
}

/** Returns a view of the results of one step, `u` m/s around the velocity. */
export function fittedToStep(decision: DrawnDecision, u: number, width: number, height: number): View {
  const [x, y] = decision.velocity;
  const radius = 1.25 * u;
  return around([x - radius, y - radius, x + radius, y + radius], width, height);
}

/** Returns numbers at even steps of 1, 2 or 5 times a power of ten, about `most` of them. */
export function ticks(from: number, to: number, most: number): { at: number; text: string }[] {
  const rough = (to - from) / Math.max(most, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((digit) => digit * power).find((candidate) => candidate >= rough * 0.999) ?? rough;
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const found = [];
  for (let k = Math.ceil(from / step); k * step <= to; ++k)
    found.push({ at: k * step, text: (k * step + 0).toFixed(digits).replace("-", "−") });
  return found;
}
