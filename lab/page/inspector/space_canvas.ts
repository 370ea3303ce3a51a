// SPDX-License-Identifier: Apache-2.0
// The canvas of a velocity space: at the resolution of the screen, with wheel, drag, pinch and keys, and with a reading
// under the pointer.
import type { Lab } from "../run/lab.ts";
import { crispContext, digits, element, oncePerFrame } from "../frame/elements.ts";
import { labelOf, norm, violation } from "./decision.ts";
import { paletteOf } from "./palette.ts";
import type { Admitted, Outline, VelocitySpace } from "./velocity_space.ts";
import { drawVelocitySpace, pick } from "./velocity_space.ts";
import type { Box, View } from "./velocity_view.ts";
import { boxOf, fitted, fittedToStep, panned, toVelocity, zoomed } from "./velocity_view.ts";
import { headingOf } from "./why.ts";

/** The content of the canvas, and functions for the sets that depend on the visible part. */
export interface SpaceSource {
  space: Omit<VelocitySpace, "outlines" | "admitted">;
  outlines(box: Box): Outline[];
  admitted(box: Box): Admitted | null;
}

/** Axes that several canvases share; null: each view shows all velocities that may be chosen. */
export interface SharedAxes {
  axes: Pick<View, "center" | "scale"> | null;
  changed: Set<() => void>;
}

export interface SpaceCanvas {
  root: HTMLElement;
  show(source: SpaceSource | null): void;
  redraw(): void;
  refresh(): void;  // other layers
  fit(): void;
  fitToStep(): void;
  zoom(factor: number): void;
  layers: { obstacles: boolean; certificate: boolean };
}

export function sharedAxes(): SharedAxes {
  return { axes: null, changed: new Set() };
}

export function makeSpaceCanvas(lab: Lab, shared: SharedAxes): SpaceCanvas {
  const canvas = element("canvas", { class: "insp-canvas", tabindex: 0, role: "img", "aria-label": "velocity space" });
  const readout = element("div", { class: "insp-readout", "aria-hidden": "true" });
  const root = element("div", { class: "insp-space" }, canvas, readout);
  let source: SpaceSource | null = null;
  let space: VelocitySpace | null = null;
  let box: Box | null = null;  // of the present layers of `space`
  const layers = { obstacles: true, certificate: true };

  const view = (): View => {
    const width = canvas.clientWidth || 1, height = canvas.clientHeight || 1;
    if (shared.axes) return { ...shared.axes, width, height };
    return source ? fitted(source.space.decision, width, height) : { center: [0, 0], scale: 100, width, height };
  };
  const collect = (): void => {
    if (!source) return;
    box = boxOf(view());
    space = {
      ...source.space, outlines: layers.obstacles ? source.outlines(box) : [],
      admitted: layers.certificate ? source.admitted(box) : null,
    };
  };
  const redraw = oncePerFrame(() => {
    const now = view();
    const context = crispContext(canvas, now.width, now.height);
    if (!source || now.width < 2) return;
    const wanted = boxOf(now);
    if (!space || !box || wanted.some((side, k) => Math.abs(side - box![k]!) * now.scale > 0.01)) collect();
    drawVelocitySpace(context, now, space!, paletteOf(lab.theme), lab.highlighted);
  });
  const setAxes = (next: View | null): void => {
    shared.axes = next && { center: next.center, scale: next.scale };
    for (const listener of shared.changed) listener();
  };
  shared.changed.add(redraw);
  listen(lab, canvas, readout, view, setAxes, () => space);
  new ResizeObserver(redraw).observe(canvas);

  return {
    root, layers, redraw,
    refresh() {
      space = null;
      redraw();
    },
    show(next) {
      source = next, space = null;
      if (next) canvas.setAttribute("aria-label", `velocity space of robot ${next.space.decision.robot}`);
      redraw();
    },
    fit: () => setAxes(null),
    fitToStep() {
      if (!source) return;
      const { decision, law } = source.space;
      setAxes(fittedToStep(decision, law.time_step * decision.max_acceleration, canvas.clientWidth, canvas.clientHeight));
    },
    zoom: (factor) => setAxes(zoomed(view(), factor, 0.5 * canvas.clientWidth, 0.5 * canvas.clientHeight)),
  };
}

type SetAxes = (next: View | null) => void;

function listen(lab: Lab, canvas: HTMLCanvasElement, readout: HTMLElement, view: () => View, setAxes: SetAxes,
                space: () => VelocitySpace | null): void {
  const pointers = new Map<number, [number, number]>();
  const place = (event: MouseEvent): [number, number] => [event.offsetX, event.offsetY];
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    setAxes(zoomed(view(), Math.exp(-0.0016 * event.deltaY), ...place(event)));
  }, { passive: false });
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, place(event));
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (before) drag(pointers, event.pointerId, before, place(event), view, setAxes);
    const shown = space();
    if (!shown) return;
    lab.highlight(pick(shown, view(), ...place(event)));
    readout.textContent = readoutOf(shown, view(), place(event), lab.highlighted);
  });
  for (const end of ["pointerup", "pointercancel"] as const)
    canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  canvas.addEventListener("pointerleave", () => {
    lab.highlight(null);
    readout.textContent = "";
  });
  canvas.addEventListener("dblclick", () => setAxes(null));
  canvas.addEventListener("click", () => {
    const robot = /^robots\.(\d+)$/.exec(lab.highlighted ?? "");
    if (robot && space()?.decision.robot !== Number(robot[1])) canvas.dispatchEvent(new CustomEvent("neighbor", { bubbles: true, detail: Number(robot[1]) }));
  });
  canvas.addEventListener("keydown", (event) => useKey(event, view, setAxes));
}

/** One finger pans, and two fingers also zoom. */
function drag(pointers: Map<number, [number, number]>, id: number, before: [number, number], now: [number, number],
              view: () => View, setAxes: SetAxes): void {
  const other = [...pointers].find(([key]) => key !== id)?.[1];
  pointers.set(id, now);
  if (other) {
    const span = (at: [number, number]): number => Math.max(8, Math.hypot(at[0] - other[0], at[1] - other[1]));
    setAxes(zoomed(view(), span(now) / span(before), 0.5 * (now[0] + other[0]), 0.5 * (now[1] + other[1])));
  }
  const part = other ? 0.5 : 1;
  if (now[0] !== before[0] || now[1] !== before[1])
    setAxes(panned(view(), part * (now[0] - before[0]), part * (now[1] - before[1])));
}

function useKey(event: KeyboardEvent, view: () => View, setAxes: SetAxes): void {
  const now = view();
  const middle = [0.5 * now.width, 0.5 * now.height] as const;
  const moves: Record<string, () => View | null> = {
    "+": () => zoomed(now, 1.25, ...middle), "=": () => zoomed(now, 1.25, ...middle), "-": () => zoomed(now, 0.8, ...middle),
    "0": () => null, ArrowLeft: () => panned(now, 40, 0), ArrowRight: () => panned(now, -40, 0),
    ArrowUp: () => panned(now, 0, 40), ArrowDown: () => panned(now, 0, -40),
  };
  const move = moves[event.key];
  if (!move || event.ctrlKey || event.metaKey) return;
  event.preventDefault();
  event.stopPropagation();  // the page has its own keys
  setAxes(move());
}

/** Shows the velocity under the pointer, and the meaning of the line under it. */
function readoutOf(space: VelocitySpace, view: View, at: [number, number], highlighted: string | null): string {
  const v = toVelocity(view, ...at);
  const cut = space.why.cuts.find((other) => other.of === highlighted);
  const heading = space.axes ? "" : ` · ${digits(norm(v))} m/s at ${digits(headingOf(v), 0)}°`;
  const where = `(${digits(v[0])}, ${digits(v[1])}) m/s${heading}`;
  if (!cut) return highlighted ? `${where} · ${labelOf(highlighted)}: its obstacle` : where;
  const miss = violation(cut, v);
  return `${where} · ${cut.label}: ${miss > 0 ? `refused by ${digits(miss)} m/s` : `${digits(-miss)} m/s to spare`}`;
}
