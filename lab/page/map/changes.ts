// SPDX-License-Identifier: Apache-2.0
// Changes by the user on the map. At the start of a run they change the scene's text. Later they change the run, and
// also the text if it can express them.
import type { PageLab } from "../run/make_lab.ts";
import { hasMoreRobots, robotsListed, valueAt, withEntry, withValue } from "../text/scene_text.ts";
import { round, withoutWall, withWallMoved } from "../text/wall_text.ts";

type Point = [number, number];

const rounded = ([x, y]: Point): Point => [round(x), round(y)];
const isStart = (lab: PageLab) => lab.moment.steps === 0;
const isListed = (lab: PageLab, robot: number) => robot < robotsListed(lab.text);
const MAP = "this wall comes from a map or a file, and stays where that has it";

export function moveRobot(lab: PageLab, robot: number, to: Point): boolean {
  const [x, y] = rounded(to);
  if (isStart(lab) && isListed(lab, robot)) return lab.carryOn(withPosition(lab, robot, [x, y]));
  return lab.edit((simulation) => simulation.moveRobot(robot, x, y));
}

/** Moves a robot; a parked robot's goal moves with it. */
function withPosition(lab: PageLab, robot: number, to: Point): string {
  const text = withValue(lab.text, `robots.${robot}.position`, to);
  const parked = lab.info.robots.find((other) => other.robot === robot)?.parked;
  return parked && valueAt(text, `robots.${robot}.goal`) ? withValue(text, `robots.${robot}.goal`, to) : text;
}

export function moveGoal(lab: PageLab, robot: number, to: Point): boolean {
  const [x, y] = rounded(to);
  if (isStart(lab) && isListed(lab, robot)) return lab.carryOn(withValue(lab.text, `robots.${robot}.goal`, [x, y]));
  return lab.edit((simulation) => simulation.setGoal(robot, x, y));
}

/** Adds a robot like those of the scene, represented by its first robot. */
export function addRobot(lab: PageLab, at: Point, goal: Point): boolean {
  const like = lab.info.robots.find(({ model, parked }) => model === "holonomic" && !parked);
  const limits = like
    ? { radius: like.radius, max_speed: like.max_speed, max_acceleration: like.max_acceleration, preferred_speed: like.preferred_speed }
    : {};
  const setup = { position: rounded(at), goal: rounded(goal), ...limits };
  const text = withRobot(lab.text, setup);
  if (isStart(lab)) return lab.carryOn(text);
  let added = -1;
  if (!lab.edit((simulation) => { added = simulation.addRobot(setup); })) return false;
  const { robots } = lab.library.simulate(text, { ...lab.options, name: lab.name }).info();
  if (added === robots.length - 1) lab.noteText(text);  // the text gives it the same number
  return true;
}

/** Adds the robot as the last of all, so that all others keep their numbers: robots of groups come after those of the
 * list. */
function withRobot(yaml: string, setup: { position: Point; goal: Point }): string {
  if (!hasMoreRobots(yaml)) return withEntry(yaml, "robots", setup);
  const { position, goal, ...limits } = setup;
  return withEntry(yaml, "groups", {
    number: 1,
    ...limits,
    placement: { line: { from: position, to: position } },
    goals: { offset: { by: [round(goal[0] - position[0]), round(goal[1] - position[1])] } },
  });
}

export function removeRobot(lab: PageLab, robot: number): boolean {
  // otherwise the text would renumber other robots, which may have been edited
  const inText = isStart(lab) && !lab.run.handmade && isListed(lab, robot) && robotsListed(lab.text) + Number(hasMoreRobots(lab.text)) > 1;
  if (lab.selected === robot) lab.select(null);
  if (inText) return lab.carryOn(withValue(lab.text, `robots.${robot}`, undefined));
  return lab.edit((simulation) => simulation.removeRobot(robot));
}

export function addWall(lab: PageLab, from: Point, to: Point): boolean {
  return lab.carryOn(withEntry(lab.text, "obstacles", { polyline: [rounded(from), rounded(to)] }));
}

/** Moves `vertex` alone, or the whole obstacle, by (dx, dy) m. */
export function moveWall(lab: PageLab, wall: number, vertex: Point | null, dx: number, dy: number): boolean {
  return carryOrSay(lab, withWallMoved(lab.text, lab.info.walls[wall]!, vertex, dx, dy));
}

export function removeWall(lab: PageLab, wall: number): boolean {
  return carryOrSay(lab, withoutWall(lab.text, lab.info.walls[wall]!));
}

function carryOrSay(lab: PageLab, text: string | null): boolean {
  if (text !== null) return lab.carryOn(text);
  lab.refuse(MAP);
  return false;
}
