// SPDX-License-Identifier: Apache-2.0
// Keys of the page; keys that are typed into a field are text.
import { zoomAt } from "../map/camera.ts";
import { removeRobot } from "../map/changes.ts";
import type { Tool } from "../map/dragging.ts";
import type { PageLab } from "../run/make_lab.ts";
import { SPEEDS } from "../run/transport.ts";
import { showNext, turnBy } from "../map/orbit.ts";
import { COLORINGS } from "../map/map_controls.ts";
import type { WorldView } from "../map/world_view.ts";

export interface Openers {
  scenes(): void;
  files(): void;
  help(): void;
  tool(tool: Tool): void;
}

const PAN = 60;   // pixels
const TURN = 25;  // pixels of a drag

export function mountKeys(lab: PageLab, view: WorldView, openers: Openers): void {
  const keys = { ...runKeys(lab), ...mapKeys(lab, view), ...robotKeys(lab), ...openerKeys(openers) };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || isTaken(event)) return;
    const name = event.shiftKey && event.key.startsWith("Arrow") ? `Shift${event.key}` : event.key;
    const action = keys[name];
    if (!action) return;
    event.preventDefault();
    action();
  });
  // A button that the pointer pressed returns the keys to the page. It does so before the button acts, because a dialog
  // that the button opens would return them to the button.
  document.addEventListener("click", (event) => {
    if (event.detail > 0 && document.activeElement instanceof HTMLButtonElement) document.activeElement.blur();
  }, { capture: true });
}

function isTaken(event: KeyboardEvent): boolean {
  if (document.querySelector("dialog[open]")) return true;
  const target = event.target as HTMLElement;
  if (target.matches("textarea, select, input:not([type=range])")) return true;
  if (target.matches("input[type=range]")) return event.key.startsWith("Arrow");
  return event.key === " " && target.matches("button, summary");
}

type Keys = Record<string, () => void>;

function runKeys(lab: PageLab): Keys {
  const faster = (): void => { lab.speed = SPEEDS.find((speed) => speed > lab.speed) ?? lab.speed; };
  const slower = (): void => { lab.speed = SPEEDS.filter((speed) => speed < lab.speed).pop() ?? lab.speed; };
  return {
    " ": () => (lab.playing ? lab.pause() : lab.play()),
    ArrowRight: () => lab.stepForward(),
    ArrowLeft: () => lab.stepBack(),
    ShiftArrowRight: () => lab.seek(Math.min(lab.end, lab.moment.time + 1)),
    ShiftArrowLeft: () => lab.seek(Math.max(0, lab.moment.time - 1)),
    ArrowUp: faster,
    ArrowDown: slower,
    r: () => lab.restart(),
  };
}

function mapKeys(lab: PageLab, view: WorldView): Keys {
  const { camera } = view;
  const pan = (x: number, y: number) => (): void => {
    camera.x += (x * PAN) / camera.scale;
    camera.y += (y * PAN) / camera.scale;
    view.touch();
  };
  const zoom = (factor: number) => (): void => {
    zoomAt(camera, camera.width / 2, camera.height / 2, factor);
    view.touch();
  };
  const turn = (x: number, y: number) => (): void => view.turn((orbit) => turnBy(orbit, -x * TURN, y * TURN));
  const recolor = (): void => {
    const k = COLORINGS.findIndex(({ coloring }) => coloring === lab.coloring);
    lab.coloring = COLORINGS[(k + 1) % COLORINGS.length]!.coloring;
    lab.say("coloring");
  };
  return {
    f: () => view.fit(), "+": zoom(1.25), "=": zoom(1.25), "-": zoom(0.8),
    v: () => view.turn(showNext),
    H: turn(-1, 0), J: turn(0, -1), K: turn(0, 1), L: turn(1, 0),
    h: pan(-1, 0), j: pan(0, -1), k: pan(0, 1), l: pan(1, 0), c: recolor,
  };
}

function robotKeys(lab: PageLab): Keys {
  const next = (by: number) => (): void => {
    const { robot } = lab.moment;
    const at = lab.selected === null ? (by > 0 ? -1 : 0) : robot.indexOf(lab.selected);
    if (robot.length) lab.select(robot[(at + by + robot.length) % robot.length]!);
  };
  const remove = (): void => {
    const robot = lab.selected;
    if (robot !== null && !removeRobot(lab, robot)) lab.select(robot);  // the robot stays, and so does the selection
  };
  return { n: next(1), p: next(-1), Delete: remove, Backspace: remove, Escape: () => lab.select(null) };
}

function openerKeys({ scenes, files, help, tool }: Openers): Keys {
  return {
    s: scenes, o: files, "?": help,
    "1": () => tool("move"), "2": () => tool("robot"), "3": () => tool("wall"), "4": () => tool("erase"),
  };
}
