// SPDX-License-Identifier: Apache-2.0
// The content of the world view, from the bottom up, as rows of discs and lines.
import { STATUSES } from "../../avo/avo.ts";
import { roundLength, toMeters, type Camera } from "./camera.ts";
import { directionColor, rgbOf, shareColor, type Rgb } from "./colors.ts";
import type { Contact, Lab } from "../run/lab.ts";
import { speedOf } from "./discs.ts";
import { STATUS_COLORS } from "../inspector/palette.ts";
import type { Shown } from "./shown.ts";
import { forHeads, forTrails, type Trails } from "./trails.ts";
import { Rows } from "./webgl.ts";

export type Coloring = "goal" | "status" | "speed";
export const FORM = { disc: 0, ring: 1, dashed: 2, diamond: 3, cross: 4, ball: 5 };
export const MARK = { none: 0, wedge: 1, dart: 2, dot: 3, bar: 4 };

const LEAST_RADIUS = 1;      // pixels, so that a disc never vanishes
const LEAST_OF_FEW = 3.5;    // the same for few robots, so that they are visible
const LEAST_AIRPLANE = 6;    // so that its direction of flight is visible
const FEW = 50;              // robots
const MANY_GOALS = 250;      // with more robots, only the goals of selected or highlighted robots are drawn
const BRAKING = STATUSES.indexOf("braking");
const OVERLAPPING = STATUSES.indexOf("overlapping");
const LEAST_UNSAFE = STATUSES.indexOf("least_unsafe");
const INVALID = STATUSES.indexOf("invalid_input");

/** Returns the theme's colors from the page's style sheet. */
export interface Paint { world: Rgb; grid: Rgb; ink: Rgb; wall: Rgb; mover: Rgb; accent: Rgb; danger: Rgb }

export function themePaint(): Paint {
  const style = getComputedStyle(document.documentElement);
  const of = (name: string) => rgbOf(style.getPropertyValue(`--${name}`));
  return {
    world: of("world"), grid: of("grid"), ink: of("ink"), wall: of("wall"), mover: of("mover"), accent: of("accent"),
    danger: of("danger"),
  };
}

/** Rows that are filled again for each picture; `under` is drawn first, and `trail` changes only with the steps. */
export class Layers {
  faces = new Rows();  // of boxes in space
  ground = new Rows();
  trail = new Rows();
  heads = new Rows();
  below = new Rows();
  links = new Rows();
  discs = new Rows();
  above = new Rows();
  clear(): void {
    for (const rows of [this.faces, this.ground, this.heads, this.below, this.links, this.discs, this.above]) rows.clear();
  }
}

export function line(rows: Rows, ax: number, ay: number, bx: number, by: number, color: Rgb, alpha: number,
                     half: number, pixels: number, fade = 1, flat = false): void {
  rows.push(ax, ay, bx, by, color[0], color[1], color[2], alpha, half, pixels, fade, Number(flat));
}

export interface DiscLook { form?: number; mark?: number; outline?: number; least?: number; heading?: number }

export function disc(rows: Rows, x: number, y: number, radius: number, color: Rgb, alpha: number,
                     { form = FORM.disc, mark = MARK.none, outline = 0, least = 0, heading = 0 }: DiscLook = {}): void {
  rows.push(x, y, radius, heading, color[0], color[1], color[2], alpha, form, mark, outline, least);
}

/** Returns the color of each row of the moment. */
export function robotColors(lab: Lab, shown: Shown, coloring: Coloring, homes: Map<number, Rgb>): Rgb[] {
  const { moment, robots } = shown;
  const statuses = STATUSES.map((status) => rgbOf(STATUS_COLORS[status]![lab.theme]));
  return Array.from(moment.robot, (robot, i) => {
    if (coloring === "status") return (moment.decided[i] && statuses[moment.status[i]!]) || rgbOf("#8a8a8a");
    if (coloring === "goal") return homes.get(robot) ?? directionColor(robot * 2.4, lab.theme);
    return shareColor(speedOf(moment, i, robots[i]) / (robots[i]?.max_speed ?? 2));
  });
}

/** Returns for each robot the direction from its place to its goal, rad. */
export function homeAngles(shown: Shown): Map<number, number> {
  const { moment, goal } = shown;
  return new Map(Array.from(moment.robot, (robot, i) => {
    const angle = Math.atan2(goal[2 * i + 1]! - shown.y[i]!, goal[2 * i]! - shown.x[i]!);
    return [robot, Number.isFinite(angle) ? angle : robot * 2.4];
  }));
}

export function homeColors(angles: Map<number, number>, theme: Lab["theme"]): Map<number, Rgb> {
  return new Map([...angles].map(([robot, angle]) => [robot, directionColor(angle, theme)]));
}

export function drawGrid(layers: Layers, camera: Camera, paint: Paint): void {
  const step = roundLength(camera, 40);
  const [left, top] = toMeters(camera, 0, 0);
  const [right, bottom] = toMeters(camera, camera.width, camera.height);
  const draw = (k: number, ax: number, ay: number, bx: number, by: number) =>
    line(layers.ground, ax, ay, bx, by, paint.grid, k % 5 === 0 ? 1 : 0.45, 0, 0.5);
  for (let k = Math.ceil(left / step); k * step <= right; ++k) draw(k, k * step, bottom, k * step, top);
  for (let k = Math.ceil(bottom / step); k * step <= top; ++k) draw(k, left, k * step, right, k * step);
}

export function drawWalls(layers: Layers, lab: Lab, paint: Paint): void {
  lab.info.walls.forEach(({ a, b, radius }, k) => {
    const looked = lab.highlighted === `walls.${k}`;
    const color = looked ? paint.accent : paint.wall;
    if (radius > 0) {
      disc(layers.below, a[0], a[1], radius, color, 0.35, { least: LEAST_RADIUS });
      disc(layers.below, a[0], a[1], radius, color, 1, { form: FORM.ring, outline: 2, least: LEAST_RADIUS });
    } else line(layers.ground, a[0], a[1], b[0], b[1], color, 1, 0.04, looked ? 2.2 : 1.5);
  });
}

/** Draws the lines from the robots to their goals, at the start of a run. */
export function drawGoalLines(layers: Layers, shown: Shown, colors: Rgb[]): void {
  const { moment, goal } = shown;
  if (moment.steps > 0 || moment.robot.length > MANY_GOALS) return;
  const alpha = Math.min(0.45, 6 / moment.robot.length);
  moment.robot.forEach((_, i) => {
    const [x, y] = [goal[2 * i]!, goal[2 * i + 1]!];
    if (Number.isFinite(x)) line(layers.ground, shown.x[i]!, shown.y[i]!, x, y, colors[i]!, alpha, 0, 0.6, 0.3);
  });
}

/** Draws the pieces of the trails between past steps. */
export function drawTrails(layers: Layers, trails: Trails, shown: Shown, colors: Rgb[]): void {
  layers.trail.clear();
  forTrails(trails, shown, (row, ax, ay, bx, by, young) =>
    line(layers.trail, ax, ay, bx, by, colors[row]!, 0.5 * Math.max(0, young), 0.04, 0.8, 1, true));
}

export function drawHeads(layers: Layers, trails: Trails, shown: Shown, colors: Rgb[]): void {
  forHeads(trails, shown, (row, ax, ay, bx, by) => line(layers.heads, ax, ay, bx, by, colors[row]!, 0.5, 0.04, 0.8, 1, true));
}

const isLookedAt = (lab: Lab, robot: number) => robot === lab.selected || lab.highlighted === `robots.${robot}`;

/** Returns whether to draw the goal of row i: with many robots, and for arrived robots, only if it is selected or
 * highlighted. */
export function hasGoalShown(lab: Lab, { moment, goal }: Shown, i: number): boolean {
  if (!Number.isFinite(goal[2 * i]!)) return false;
  return isLookedAt(lab, moment.robot[i]!) || (moment.robot.length <= MANY_GOALS && !moment.arrived[i]);
}

/** Returns whether a robot stands at that very place: a press there means the robot, see pick(). */
function isTaken({ x, y }: Shown, px: number, py: number, slack: number): boolean {
  for (let i = 0; i < x.length; ++i) if (Math.abs(x[i]! - px) <= slack && Math.abs(y[i]! - py) <= slack) return true;
  return false;
}

/** Draws above the robots, except if one stands in the same place; `pixel` in m. */
export function drawGoals(layers: Layers, lab: Lab, shown: Shown, colors: Rgb[], pixel: number): void {
  const { moment } = shown;
  moment.robot.forEach((robot, i) => {
    if (!hasGoalShown(lab, shown, i)) return;
    const looked = isLookedAt(lab, robot);
    const [x, y] = [shown.goal[2 * i]!, shown.goal[2 * i + 1]!];
    const rows = looked || !isTaken(shown, x, y, 2 * pixel) ? layers.above : layers.below;
    disc(rows, x, y, 0.22, colors[i]!, looked ? 1 : 0.6, { form: FORM.diamond, outline: looked ? 2 : 1.4, least: 3 });
    if (looked) line(layers.links, shown.x[i]!, shown.y[i]!, x, y, colors[i]!, 0.6, 0, 0.7);
  });
}

export function drawMovers(layers: Layers, lab: Lab, shown: Shown, paint: Paint): void {
  shown.movers.forEach(({ x, y, vx, vy, radius }, k) => {
    line(layers.links, x, y, x + vx, y + vy, paint.mover, 1, 0, 1.2);
    disc(layers.below, x, y, radius, paint.mover, 0.85, { form: shown.order ? FORM.ball : FORM.disc, least: LEAST_RADIUS });
    if (lab.highlighted === `moving_obstacles.${k}`) ring(layers, x, y, radius, paint.ink, 1.5);
  });
}

/** Returns the centers of the discs of a robot: of its footprint, or of its one disc. */
function centersOf(shown: Shown, row: number): [number, number][] {
  const robot = shown.robots[row];
  const [x, y, heading] = [shown.x[row]!, shown.y[row]!, shown.heading[row]!];
  if (!robot?.footprint) return [[x, y]];
  return robot.footprint.ahead.map((ahead) => {
    const from = ahead - robot.disc_ahead;
    return [x + from * Math.cos(heading), y + from * Math.sin(heading)];
  });
}

/** The form of a robot that moves as usual, and its opacity. */
export type BodyOf = (row: number) => { form: number; alpha: number };
const FLAT = { form: FORM.disc, alpha: 1 };

/** Filled: the robot decides as usual. Hollow: it brakes. Dashed: no velocity satisfies all half-planes, or a number is
 * not valid. A heavy rim: it touches another disc. A dot: it has arrived. */
export function drawRobots(layers: Layers, shown: Shown, colors: Rgb[], paint: Paint, bodyOf: BodyOf = () => FLAT): void {
  const { moment, robots, order } = shown;
  const few = moment.robot.length <= FEW;
  for (let k = 0; k < moment.robot.length; ++k) {
    const i = order?.[k] ?? k;
    const body = bodyOf(i);
    const [color, heading] = [colors[i]!, shown.heading[i]!];
    const robot = robots[i];
    const r = robot?.footprint?.radius ?? shown.radius[i]!;
    const least = !few ? LEAST_RADIUS : robot?.model === "airplane" ? LEAST_AIRPLANE : LEAST_OF_FEW;
    const status = moment.decided[i] ? moment.status[i] : -1;
    const draw = (paintOfDisc: Rgb, alpha: number, look: DiscLook) => {
      for (const [x, y] of centersOf(shown, i)) disc(layers.discs, x, y, r, paintOfDisc, body.alpha * alpha, look);
    };
    if (robot?.parked) {
      draw(paint.mover, 0.9, { mark: MARK.bar, least });
      continue;
    }
    const model = robot?.model ?? "holonomic";
    const headed = model === "airplane" ? MARK.dart : model === "holonomic" ? MARK.none : MARK.wedge;
    const mark = headed || (moment.arrived[i] ? MARK.dot : MARK.none);
    const touches = status === OVERLAPPING || moment.clearance[i]! < -1e-9;
    const hollow = !touches && !moment.arrived[i] && (status === BRAKING || status === LEAST_UNSAFE || status === INVALID);
    draw(color, hollow ? 0.28 : moment.arrived[i] ? 0.55 : 1, { form: body.form, mark, least, heading });
    if (hollow) draw(color, 1, { form: status === BRAKING ? FORM.ring : FORM.dashed, outline: 2, least });
    if (touches) draw(paint.danger, 1, { form: FORM.ring, outline: 3, least: least + 1 });
  }
}

export function ring(layers: Layers, x: number, y: number, radius: number, color: Rgb, outline: number, form = FORM.ring): void {
  disc(layers.above, x, y, radius, color, 1, { form, outline, least: 4 });
}

const FEW_TOUCHES = 12;  // with more contacts at once, the crosses have no rings

/** Draws crosses where discs have touched so far; present contacts are larger. */
export function drawContacts(layers: Layers, contacts: readonly Contact[], time: number, { project }: Shown, paint: Paint): void {
  const begun = contacts.filter((contact) => contact.time <= time + 1e-9);
  const isNow = ({ last }: Contact) => last >= time - 1e-9;
  const few = begun.filter(isNow).length <= FEW_TOUCHES;
  for (const contact of begun) {
    const [x, y] = project(contact.x, contact.y, contact.z ?? 0);
    const now = isNow(contact);
    disc(layers.above, x, y, now ? 0.35 : 0.2, paint.danger, now ? 1 : 0.7, { form: FORM.cross, outline: now ? 2.2 : 1.5, least: now ? 4 : 3 });
    if (now && few) disc(layers.above, x, y, 0, paint.danger, 0.9, { form: FORM.ring, outline: 1.5, least: 12 });
  }
}
