// SPDX-License-Identifier: Apache-2.0
// The velocity space of one decision on a canvas: bright velocities are allowed, dark ones are forbidden (the paper's
// Figs. 4 to 6).
import type { Decision, Disc, Vec } from "./decision.ts";
import { along, norm, violation } from "./decision.ts";
import { Labels } from "./labels.ts";
import type { Palette } from "./palette.ts";
import { Pen, arrow, dotAt, forbiddenSide, lineEnd } from "./pen.ts";
import type { Box, View } from "./velocity_view.ts";
import { ticks, toScreen, toVelocity } from "./velocity_view.ts";
import type { Cut, Law, Why } from "./why.ts";

export interface Outline {
  of: string;  // "robots.7"
  rings: readonly (readonly Vec[])[];
}

/** The velocities that the certificate admits, at even steps over a box, bottom row first. */
export interface Admitted {
  box: Box;
  columns: number;
  rows: number;
  cells: Uint8Array;
}

/** The part of a decision that is drawn; of a cut through space, in the axes of the cut. */
export type DrawnDecision = Pick<Decision, "robot" | "target_by" | "velocity" | "preferred_velocity" | "new_velocity" | "max_acceleration" |
  "acceleration_disc" | "speed_disc">;

export interface VelocitySpace {
  decision: DrawnDecision;
  law: Law;
  why: Why;
  outlines: readonly Outline[];
  admitted: Admitted | null;
  axes?: [string, string];  // their names, to the right and up; of the plane if they are absent
}

const LABEL = 12, CHOSEN = 8;  // px; the size of text, the radius of the dot at the chosen next velocity

/** Whether the velocity after the step and v' are two points on the screen. */
function isApart({ decision, why }: VelocitySpace, view: View): boolean {
  return Math.hypot(why.next[0] - decision.new_velocity[0], why.next[1] - decision.new_velocity[1]) * view.scale > CHOSEN;
}

function drawRegions(pen: Pen, space: VelocitySpace): void {
  const { decision, why, outlines } = space;
  const { palette, view } = pen;
  const discs = [decision.acceleration_disc, decision.speed_disc];
  const union = decision.target_by === "union_of_obstacles";
  const page = (): void => pen.context.rect(0, 0, view.width, view.height);
  const rings = (): void => outlines.forEach((outline) => outline.rings.forEach((ring) => pen.polygon(ring)));
  pen.fill(palette.beyond, page);
  if (union) pen.fill(palette.forbidden_beyond, rings, "evenodd");
  pen.within(discs, () => {
    pen.fill(palette.chosen, page);
    if (union) {
      // one fill for each outline: overlapping outlines are not darker
      for (const outline of outlines)
        pen.fill(palette.forbidden, () => outline.rings.forEach((ring) => pen.polygon(ring)), "evenodd");
    }
    pen.fill(palette.forbidden, () => {
      for (const cut of why.cuts) if (cut.forbids) pen.polygon(forbiddenSide(cut, pen.box));
    });
  });
}

/** Soft area: grid nodes that the certificate admits, smoothed between them. */
function drawAdmitted(pen: Pen, admitted: Admitted): void {
  const { columns, rows, cells, box } = admitted;
  const picture = new OffscreenCanvas(columns, rows);
  const context = picture.getContext("2d")!;
  const image = context.createImageData(columns, rows);
  const [red, green, blue, part] = pen.palette.admitted;
  for (let row = 0; row < rows; ++row) {
    for (let column = 0; column < columns; ++column) {
      const at = 4 * ((rows - 1 - row) * columns + column);
      image.data[at] = red, image.data[at + 1] = green, image.data[at + 2] = blue;
      image.data[at + 3] = cells[row * columns + column] ? 255 * part : 0;
    }
  }
  context.putImageData(image, 0, 0);
  // nodes are at the middles of pixels
  const stepX = (box[2] - box[0]) / Math.max(columns - 1, 1), stepY = (box[3] - box[1]) / Math.max(rows - 1, 1);
  const [left, top] = toScreen(pen.view, [box[0] - 0.5 * stepX, box[3] + 0.5 * stepY]);
  const [right, bottom] = toScreen(pen.view, [box[2] + 0.5 * stepX, box[1] - 0.5 * stepY]);
  pen.context.imageSmoothingEnabled = true;
  pen.context.imageSmoothingQuality = "high";
  pen.context.drawImage(picture, left, top, right - left, bottom - top);
}

function drawOutlines(pen: Pen, space: VelocitySpace, highlighted: string | null): void {
  const union = space.decision.target_by === "union_of_obstacles";
  for (const outline of space.outlines) {
    const isHit = outline.of === highlighted;
    const path = (): void => outline.rings.forEach((ring) => pen.polygon(ring));
    if (isHit) {
      pen.context.globalAlpha = 0.16;
      pen.fill(pen.palette.highlight, path, "evenodd");
      pen.context.globalAlpha = 1;
    }
    pen.stroke(isHit ? pen.palette.highlight : pen.palette.soft, isHit ? 1.8 : 0.9, union ? [] : [2, 3], path);
  }
}

function drawCut(pen: Pen, cut: Cut, isHit: boolean): void {
  const side = forbiddenSide(cut, pen.box);
  if (isHit) {
    pen.context.globalAlpha = 0.14;
    pen.fill(pen.palette.highlight, () => pen.polygon(side));
    pen.context.globalAlpha = 1;
  }
  const color = isHit ? pen.palette.highlight : cut.binds ? pen.palette.ink : pen.palette.soft;
  const width = cut.binds ? 2.2 : isHit ? 2 : cut.forbids ? 1 : 0.8;
  pen.stroke(color, width, cut.forbids ? [] : [3, 3], () => pen.polygon([side[0], side[1]], false));
}

function drawDiscLabel(pen: Pen, labels: Labels, disc: Disc, formula: string): void {
  for (const degrees of [135, 45, 225, 315, 90, 270, 180, 0]) {
    const angle = degrees * Math.PI / 180;
    const rim = along(disc.center, [Math.cos(angle), Math.sin(angle)], disc.radius);
    const [x, y] = toScreen(pen.view, rim);
    if (x < 60 || y < 24 || x > pen.view.width - 60 || y > pen.view.height - 40) continue;
    labels.place(x, y, { formula, size: LABEL, color: pen.palette.soft, halo: pen.palette.halo, distance: 5, optional: true });
    return;
  }
}

function drawLabels(pen: Pen, space: VelocitySpace, highlighted: string | null): void {
  const { decision, why } = space;
  const { palette, view } = pen;
  const labels = new Labels(pen.context, { left: 30, top: 4, right: view.width - 4, bottom: view.height - 22 });
  const points: [Vec, string, string][] = [
    [decision.preferred_velocity, "*v*^{pref}", palette.preferred], [decision.new_velocity, "*v*′", palette.decided],
  ];
  if (isApart(space, view)) points.unshift([why.next, "*v*_{next}", palette.decided]);
  points.unshift([decision.velocity, "*v*", palette.ink]);
  for (const [v] of points) labels.keepFree(...toScreen(view, v) as [number, number], v === why.next ? CHOSEN : 5);
  for (const part of [0.25, 0.5, 0.75])
    labels.keepFree(...toScreen(view, along([0, 0], decision.velocity, part)) as [number, number], 4);
  for (const [v, formula, color] of points)
    labels.place(...toScreen(view, v) as [number, number], { formula, size: 16, color, halo: palette.halo, distance: 7 });
  for (const cut of why.cuts) {
    const end = lineEnd(cut, view);
    if (!end) continue;
    const isHit = cut.of === highlighted;
    const [x, y] = toScreen(view, along(end, cut.normal, -9 / view.scale));  // beside its line, on the forbidden side
    labels.place(x, y, {
      formula: cut.short, size: cut.binds || isHit ? LABEL + 2 : LABEL, halo: palette.halo, distance: 0,
      color: isHit ? palette.highlight : cut.binds ? palette.ink : palette.soft, optional: !cut.binds && !isHit,
    });
  }
  if (decision.acceleration_disc) drawDiscLabel(pen, labels, decision.acceleration_disc, "reach, D(*v*, δ *a*_{max})");
  if (decision.speed_disc) drawDiscLabel(pen, labels, decision.speed_disc, "D(0, *v*_{max})");
}

/** Returns the velocities that can be reached within `time` (s), as a cut of the same form as the reach. */
function reachIn({ acceleration_disc, max_acceleration }: DrawnDecision, time: number): Omit<Disc, "center"> {
  const squeeze = acceleration_disc?.squeeze;
  return { radius: time * max_acceleration, ...(squeeze ? { squeeze } : {}) };
}

function drawOrigin({ context, view, palette }: Pen): void {
  const [x, y] = toScreen(view, [0, 0]);
  context.strokeStyle = palette.frame;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(0, y), context.lineTo(view.width, y);
  context.moveTo(x, 0), context.lineTo(x, view.height);
  context.stroke();
}

function drawTicks(pen: Pen, [right, up]: [string, string]): void {
  const { context, view, palette, box } = pen;
  context.font = "11px system-ui, sans-serif";
  context.fillStyle = palette.soft;
  const mark = (text: string, x: number, y: number): void => {
    context.strokeStyle = palette.halo, context.lineWidth = 3;
    context.strokeText(text, x, y);
    context.fillText(text, x, y);
  };
  context.textAlign = "center", context.textBaseline = "bottom";
  for (const tick of ticks(box[0], box[2], view.width / 70)) {
    const x = toScreen(view, [tick.at, 0])[0];
    pen.stroke(palette.soft, 1, [], () => (context.moveTo(x, view.height), context.lineTo(x, view.height - 4)));
    if (x > 16 && x < view.width - 14 - context.measureText(right).width) mark(tick.text, x, view.height - 5);
  }
  context.textAlign = "left", context.textBaseline = "middle";
  for (const tick of ticks(box[1], box[3], view.height / 60)) {
    const y = toScreen(view, [0, tick.at])[1];
    pen.stroke(palette.soft, 1, [], () => (context.moveTo(0, y), context.lineTo(4, y)));
    if (y > 26 && y < view.height - 24) mark(tick.text, 7, y);
  }
  context.textAlign = "right", context.textBaseline = "bottom";
  mark(right, view.width - 5, view.height - 5);
  context.textAlign = "left", context.textBaseline = "top";
  mark(up, 7, 5);
}

/** Draws over the whole view; the context's unit is a pixel of CSS. */
export function drawVelocitySpace(context: CanvasRenderingContext2D, view: View, space: VelocitySpace, palette: Palette,
                                  highlighted: string | null): void {
  const { decision, law, why } = space;
  const pen = new Pen(context, view, palette);
  drawRegions(pen, space);
  if (space.admitted) drawAdmitted(pen, space.admitted);
  drawOrigin(pen);
  drawOutlines(pen, space, highlighted);
  for (const cut of why.cuts) if (cut.of !== highlighted) drawCut(pen, cut, false);
  for (const cut of why.cuts) if (cut.of === highlighted) drawCut(pen, cut, true);
  const { acceleration_disc, speed_disc } = decision;
  if (acceleration_disc) pen.stroke(palette.ink, 1.4, [], () => pen.disc(acceleration_disc));
  if (speed_disc) pen.stroke(palette.ink, 1.2, [5, 4], () => pen.disc(speed_disc));
  const step: Disc = { ...reachIn(decision, law.time_step), center: decision.velocity };
  if (law.method === "avo" && step.radius * view.scale > 6) pen.stroke(palette.soft, 1, [1, 2], () => pen.disc(step));
  arrow(pen, [0, 0], decision.velocity, palette.ink, 2);
  if (norm(decision.new_velocity) > 0) arrow(pen, decision.velocity, decision.new_velocity, palette.decided, 1.6);
  dotAt(pen, decision.preferred_velocity, 4.5, palette.preferred);
  dotAt(pen, why.next, CHOSEN, palette.decided);  // what the robot does; v' is what it aims at
  if (isApart(space, view)) dotAt(pen, decision.new_velocity, 4, palette.decided);
  drawLabels(pen, space, highlighted);
  drawTicks(pen, space.axes ?? ["vₓ in m/s", "vᵧ in m/s"]);
}

/** Returns the half-plane, or else the obstacle, with the line nearest to the pixel, within a few pixels. */
export function pick(space: VelocitySpace, view: View, x: number, y: number, reach = 9): string | null {
  const v = toVelocity(view, x, y);
  let best: string | null = null, distance = reach / view.scale;
  for (const cut of space.why.cuts) {
    const away = Math.abs(violation(cut, v));
    if (away < distance) best = cut.of, distance = away;
  }
  if (best) return best;
  distance = 0.7 * reach / view.scale;
  for (const outline of space.outlines) {
    for (const point of outline.rings.flat()) {
      const away = Math.hypot(point[0] - v[0], point[1] - v[1]);
      if (away < distance) best = outline.of, distance = away;
    }
  }
  return best;
}
