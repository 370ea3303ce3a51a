// SPDX-License-Identifier: Apache-2.0
// Four numbers over the map that summarize the run.
import { digits, element } from "../frame/elements.ts";
import type { Lab } from "./lab.ts";

const AT_ENDS = "at the ends of steps; avo run --json also finds contacts within steps";

export function mountFigures(lab: Lab, root: HTMLElement): void {
  const refresh = (): void => root.replaceChildren(...figuresOf(lab));
  lab.on("moment", refresh);
  lab.on("scene", refresh);
  refresh();
}

function figuresOf(lab: Lab): HTMLElement[] {
  const { moment, contacts } = lab;
  const figure = (label: string, value: string, bad = false, title = "") =>
    element("span", { class: bad ? "figure figure-bad" : "figure", ...(title ? { title } : {}) }, element("b", {}, value), element("small", {}, label));
  const arrived = moment.arrived.reduce((sum, there) => sum + there, 0);
  const touched = contacts.filter((contact) => contact.time <= moment.time + 1e-9).length;
  const now = moment.clearance.reduce((least, clearance) => Math.min(least, clearance), Infinity);
  return [
    figure(moment.robot.length === 1 ? "robot" : "robots", String(moment.robot.length)),
    figure("arrived", String(arrived)),
    figure("contacts so far", String(touched), touched > 0, AT_ENDS),
    figure("robots' least gap", now === Infinity ? "–" : `${digits(now, now < 0.1 ? 3 : 2)} m`, now < -1e-9),
  ];
}
