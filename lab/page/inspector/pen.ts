// SPDX-License-Identifier: Apache-2.0
// Draws shapes that are given in m/s on a canvas, and the sides of half-planes, which have no end.
import type { Disc, HalfPlane, Vec } from "./decision.ts";
import { along, violation } from "./decision.ts";
import type { Palette } from "./palette.ts";
import type { Box, View } from "./velocity_view.ts";
import { boxOf, toScreen } from "./velocity_view.ts";

/** Returns two points of the line and two on its forbidden side, beyond any view. */
export function forbiddenSide(plane: HalfPlane, box: Box): [Vec, Vec, Vec, Vec] {
  const middle: Vec = [0.5 * (box[0] + box[2]), 0.5 * (box[1] + box[3])];
  const miss = violation(plane, middle);
  const reach = 2 * Math.hypot(box[2] - box[0], box[3] - box[1]) + Math.abs(miss);
  const foot = along(middle, plane.normal, miss);
  const side: Vec = [-plane.normal[1], plane.normal[0]];
  const from = along(foot, side, -reach), to = along(foot, side, reach);
  return [from, to, along(to, plane.normal, -reach), along(from, plane.normal, -reach)];
}

export class Pen {
  readonly box: Box;
  constructor(readonly context: CanvasRenderingContext2D, readonly view: View, readonly palette: Palette) {
    this.box = boxOf(view);
  }
  polygon(points: readonly Vec[], closed = true): void {
    points.forEach((point, k) => {
      const [x, y] = toScreen(this.view, point);
      if (k === 0) this.context.moveTo(x, y);
      else this.context.lineTo(x, y);
    });
    if (closed) this.context.closePath();
  }
  disc(disc: Disc): void {
    const [x, y] = toScreen(this.view, disc.center);
    const radius = disc.radius * this.view.scale;
    const { angle, ratio } = disc.squeeze ?? { angle: 0, ratio: 1 };
    this.context.moveTo(x + radius * Math.cos(angle), y - radius * Math.sin(angle));
    this.context.ellipse(x, y, radius, radius * ratio, -angle, 0, 2 * Math.PI);
  }
  fill(color: string, path: () => void, rule: CanvasFillRule = "nonzero"): void {
    this.context.beginPath();
    path();
    this.context.fillStyle = color;
    this.context.fill(rule);
  }
  stroke(color: string, width: number, dashes: number[], path: () => void): void {
    this.context.beginPath();
    path();
    this.context.strokeStyle = color;
    this.context.lineWidth = width;
    this.context.setLineDash(dashes);
    this.context.stroke();
    this.context.setLineDash([]);
  }
  within(discs: readonly (Disc | null)[], draw: () => void): void {
    this.context.save();
    for (const disc of discs) {
      if (!disc) continue;
      this.context.beginPath();
      this.disc(disc);
      this.context.clip();
    }
    draw();
    this.context.restore();
  }
}

/** Returns where the line leaves the view, a little inside it. */
export function lineEnd(cut: HalfPlane, view: View): Vec | null {
  const inset = 30 / view.scale;
  const box = boxOf(view);
  const [from, to] = forbiddenSide(cut, box);
  let enter = 0, leave = 1;
  for (const axis of [0, 1] as const) {
    const line = to[axis] - from[axis];
    const lower = box[axis] + inset, upper = box[axis + 2]! - inset;
    if (line === 0) {
      if (from[axis] < lower || from[axis] > upper) return null;
      continue;
    }
    const a = (lower - from[axis]) / line, b = (upper - from[axis]) / line;
    enter = Math.max(enter, Math.min(a, b)), leave = Math.min(leave, Math.max(a, b));
  }
  return enter > leave ? null : [from[0] + leave * (to[0] - from[0]), from[1] + leave * (to[1] - from[1])];
}

export function arrow(pen: Pen, from: Vec, to: Vec, color: string, width: number): void {
  const [x0, y0] = toScreen(pen.view, from), [x1, y1] = toScreen(pen.view, to);
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (length < 2) return;
  const head = Math.min(10, 0.5 * length);
  const x = (x1 - x0) / length, y = (y1 - y0) / length;
  const context = pen.context;
  context.lineCap = "butt";
  context.strokeStyle = context.fillStyle = color;
  context.lineWidth = width;
  context.beginPath();
  context.moveTo(x0, y0);
  context.lineTo(x1 - 0.8 * head * x, y1 - 0.8 * head * y);
  context.stroke();
  context.beginPath();
  context.moveTo(x1, y1);
  context.lineTo(x1 - head * x - 0.4 * head * y, y1 - head * y + 0.4 * head * x);
  context.lineTo(x1 - 0.75 * head * x, y1 - 0.75 * head * y);
  context.lineTo(x1 - head * x + 0.4 * head * y, y1 - head * y - 0.4 * head * x);
  context.fill();
}

export function dotAt(pen: Pen, v: Vec, radius: number, color: string): void {
  const [x, y] = toScreen(pen.view, v);
  const path = (): void => pen.context.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fill(color, path);
  pen.stroke(pen.palette.halo, 1.2, [], path);
}
