// SPDX-License-Identifier: Apache-2.0
// Mouse, pen and fingers on the map: they pan, zoom, pinch, hover, select and drag.
import { toMeters, zoomAt } from "./camera.ts";
import { speedOf } from "./discs.ts";
import { begin, click, type Gesture, type Tool } from "./dragging.ts";
import { digits } from "../frame/elements.ts";
import { STATUSES } from "../../avo/avo.ts";
import type { PageLab } from "../run/make_lab.ts";
import { nameOf, pick, type Hit } from "./picking.ts";
import { turnBy } from "./orbit.ts";
import type { WorldView } from "./world_view.ts";

const CLICK = 4;  // pixels that a click may move

export interface Hand { tool: Tool }

type Pixel = [number, number];  // of the canvas

/** `pans`: in space, a drag that does not turn the view. */
interface Press { px: number; py: number; moved: boolean; gesture: Gesture | null; isFinger: boolean; pans: boolean }

/** The present actions of fingers, the mouse or a pen. */
interface Grip {
  lab: PageLab;
  view: WorldView;
  hand: Hand;
  tip: HTMLElement;
  fingers: Map<number, Pixel>;  // that are down, by pointer
  press: Press | null;          // of the first of them
}

export function mountPointer(lab: PageLab, view: WorldView, hand: Hand, tip: HTMLElement): void {
  const { canvas } = view;
  const grip: Grip = { lab, view, hand, tip, fingers: new Map(), press: null };
  canvas.addEventListener("pointerdown", (event) => down(grip, event));
  canvas.addEventListener("pointermove", (event) => move(grip, event));
  canvas.addEventListener("pointerup", (event) => up(grip, event));
  canvas.addEventListener("pointercancel", (event) => {
    grip.fingers.delete(event.pointerId);
    letGo(grip);
  });
  canvas.addEventListener("pointerleave", () => {
    lab.highlight(null);
    tip.hidden = true;
  });
  canvas.addEventListener("dblclick", () => {
    if (hand.tool === "move" && lab.selected === null) view.fit();
  });
  canvas.addEventListener("contextmenu", (event) => { if (view.orbit) event.preventDefault(); });  // that button pans
  mountEscape(grip);
  mountWheel(view);
}

function down(grip: Grip, event: PointerEvent): void {
  const { lab, view, hand, tip, fingers } = grip;
  view.canvas.setPointerCapture(event.pointerId);
  const [px, py] = pixelOf(view.canvas, event);
  fingers.set(event.pointerId, [px, py]);
  tip.hidden = true;
  if (fingers.size > 1) return letGo(grip);  // a pinch does not drag
  const isFinger = event.pointerType === "touch";
  const hit = pick(lab, view, px, py, isFinger);
  const gesture = event.button === 0 ? begin(lab, view, hand.tool, hit, toMeters(view.camera, px, py)) : null;
  grip.press = { px, py, moved: false, gesture, isFinger, pans: event.shiftKey || event.button !== 0 };
}

function move({ lab, view, hand, tip, fingers, press }: Grip, event: PointerEvent): void {
  const { camera } = view;
  const now = pixelOf(view.canvas, event);
  const before = fingers.get(event.pointerId);
  if (!before) return look(lab, view, hand, tip, now);
  fingers.set(event.pointerId, now);
  if (fingers.size === 2) {
    const other = [...fingers].find(([finger]) => finger !== event.pointerId)![1];
    return pinch(view, other, before, now);
  }
  if (!press) return;
  press.moved ||= Math.hypot(now[0] - press.px, now[1] - press.py) > CLICK;
  if (!press.moved) return;
  const { gesture } = press;
  if (gesture) {
    view.preview = (layers, paint) => gesture.show(layers, paint, toMeters(camera, ...now));
  } else if (view.orbit && !press.pans) {
    view.turn((orbit) => turnBy(orbit, now[0] - before[0], now[1] - before[1]));
  } else {
    camera.x -= (now[0] - before[0]) / camera.scale;
    camera.y += (now[1] - before[1]) / camera.scale;
  }
  view.touch();
}

function up(grip: Grip, event: PointerEvent): void {
  const { lab, view, hand, fingers, press } = grip;
  fingers.delete(event.pointerId);
  if (!press) return;
  const [px, py] = pixelOf(view.canvas, event);
  letGo(grip);
  const places = hand.tool === "robot" || hand.tool === "wall";
  if (press.gesture && (press.moved || places)) press.gesture.drop(toMeters(view.camera, px, py));
  else if (!press.moved) click(lab, view, hand.tool, px, py, press.isFinger);
}

/** Ends drawing and dragging. */
function letGo(grip: Grip): void {
  grip.press = null;
  grip.view.preview = null;
  grip.view.touch();
}

/** While something is drawn or dragged, Escape cancels that and does nothing else. */
function mountEscape(grip: Grip): void {
  document.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !grip.press?.gesture) return;
    event.stopPropagation();
    letGo(grip);
  }, { capture: true });
}

function pixelOf(canvas: HTMLElement, event: MouseEvent): Pixel {
  const box = canvas.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

function mountWheel(view: WorldView): void {
  view.canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const pixels = event.deltaMode === 1 ? 16 * event.deltaY : event.deltaY;
    zoomAt(view.camera, ...pixelOf(view.canvas, event), Math.exp(-Math.max(-200, Math.min(200, pixels)) / 400));
    view.touch();
  }, { passive: false });
}

/** One finger moves while the other rests. */
function pinch(view: WorldView, other: Pixel, before: Pixel, now: Pixel): void {
  const { camera } = view;
  const [was, is] = [before, now].map((p) => Math.hypot(p[0] - other[0], p[1] - other[1]));
  camera.x -= (now[0] - before[0]) / 2 / camera.scale;
  camera.y += (now[1] - before[1]) / 2 / camera.scale;
  if (was! > 1) zoomAt(camera, (now[0] + other[0]) / 2, (now[1] + other[1]) / 2, is! / was!);
  view.touch();
}

/** The pointer hovers without a press. */
function look(lab: PageLab, view: WorldView, hand: Hand, tip: HTMLElement, now: Pixel): void {
  const hit = pick(lab, view, ...now, false);
  lab.highlight(nameOf(hit));
  view.canvas.style.cursor = cursorOf(hand.tool, hit, lab.live !== null);
  tip.hidden = hit === null || hit.kind === "wall";
  if (tip.hidden) return;
  tip.textContent = saysOf(lab, hit!);
  tip.style.left = `${Math.min(now[0] + 14, view.camera.width - 190)}px`;
  tip.style.top = `${Math.min(now[1] + 14, view.camera.height - 40)}px`;
}

function cursorOf(tool: Tool, hit: Hit | null, live: boolean): string {
  if (live && (tool === "robot" || tool === "wall")) return "crosshair";
  if (!hit) return "grab";
  return tool === "erase" || hit.kind !== "wall" ? "pointer" : "move";
}

function saysOf(lab: PageLab, hit: Hit): string {
  if (hit.kind === "goal") return `goal of robot ${hit.robot}`;
  if (hit.kind === "mover") return `moving obstacle ${hit.mover}`;
  if (hit.kind === "wall") return "wall";
  const { moment } = lab;
  const row = moment.robot.indexOf(hit.robot);
  const speed = speedOf(moment, row);
  const how = moment.arrived[row] ? "at its goal" : moment.decided[row] ? STATUSES[moment.status[row]!]!.replace("_", " ") : "";
  return [`robot ${hit.robot}`, `${digits(speed)} m/s`, how].filter(Boolean).join(" · ");
}
