// SPDX-License-Identifier: Apache-2.0
// The decisions of the selected robot so far, as a strip over time. A worse status has a higher bar, so that the strip
// is readable without color. A click goes to that time.
import { STATUSES } from "../../avo/avo.ts";
import type { Lab } from "../run/lab.ts";
import { crispContext, digits, element, oncePerFrame } from "../frame/elements.ts";
import { STATUS_COLORS, paletteOf } from "./palette.ts";
import { NO_DECISION, alarmOf, worstByPixel } from "../run/thinned.ts";
import { ticks } from "./velocity_view.ts";

const HEIGHT = 58, AXIS = 16;  // px

export interface HistoryStrip {
  root: HTMLElement;
  redraw(): void;
}

export function makeHistoryStrip(lab: Lab): HistoryStrip {
  const canvas = element("canvas", { class: "insp-strip-canvas", role: "slider", tabindex: 0, "aria-label": "history of decisions, time in s" });
  const readout = element("span", { class: "insp-strip-readout" });
  const legend = element("div", { class: "insp-strip-legend" });
  const root = element("div", { class: "insp-strip" }, canvas, legend, readout);
  let hover: number | null = null;  // s
  let known = "";                   // of the legend, as last drawn

  const end = (): number => {
    const { past, moment } = lab;
    const so = Math.max(past.size > 0 ? past.times[past.size - 1]! : 0, moment.time);
    return Math.max(5, 5 * Math.ceil(so / 5));  // s; it grows in steps, so that the strip does not slide all the time
  };
  const redraw = oncePerFrame(() => {
    const width = canvas.clientWidth;
    if (width < 2 || lab.selected === null) return;
    const statuses = lab.past.statusOf(lab.selected);
    const context = crispContext(canvas, width, HEIGHT);
    draw(context, lab, statuses, end(), width, hover);
    known = tellLegend(legend, lab, statuses, known);
    canvas.setAttribute("aria-valuenow", lab.moment.time.toFixed(1));
    canvas.setAttribute("aria-valuemax", String(end()));
    readout.textContent = hover === null ? "" : hoverText(lab, statuses, hover);
  });
  canvas.addEventListener("pointermove", (event) => {
    hover = event.offsetX / canvas.clientWidth * end();
    redraw();
  });
  canvas.addEventListener("pointerleave", () => {
    hover = null;
    redraw();
  });
  canvas.addEventListener("click", (event) => lab.seek(event.offsetX / canvas.clientWidth * end()));
  canvas.addEventListener("keydown", (event) => {
    if (event.key !== "ArrowLeft" && event.key !== "ArrowRight") return;
    event.preventDefault();
    event.stopPropagation();
    if (event.key === "ArrowLeft") lab.stepBack();
    else lab.stepForward();
  });
  new ResizeObserver(redraw).observe(canvas);
  return { root, redraw };
}

function draw(context: CanvasRenderingContext2D, lab: Lab, statuses: Uint8Array, end: number, width: number, hover: number | null): void {
  const palette = paletteOf(lab.theme), base = HEIGHT - AXIS;
  context.fillStyle = palette.beyond;
  context.fillRect(0, 0, width, base);
  worstByPixel(statuses, lab.past.times, end, Math.round(width)).forEach((status, x) => {
    if (status < 0) return;
    const height = (alarmOf(status) + 1) / STATUSES.length * base;
    context.fillStyle = STATUS_COLORS[STATUSES[status]!]![lab.theme];
    context.fillRect(x, base - height, 1, height);
  });
  context.font = "11px system-ui, sans-serif";
  context.fillStyle = palette.soft;
  context.textBaseline = "bottom";
  for (const tick of ticks(0, end, width / 60)) {
    const x = Math.min(tick.at / end * width, width - 1);
    context.fillRect(x, base, 1, 3);
    context.textAlign = tick.at === 0 ? "left" : x > width - 20 ? "right" : "center";
    context.fillText(tick.at === 0 ? "0 s" : tick.text, x, HEIGHT);
  }
  const mark = (time: number, color: string, thick: number): void => {
    context.fillStyle = color;
    context.fillRect(Math.min(time / end * width, width - 1) - 0.5 * thick, 0, thick, base);
  };
  if (hover !== null) mark(hover, palette.soft, 1);
  mark(lab.moment.time, palette.ink, 2);
}

/** Returns the statuses that occur, with their number of decisions. */
function tellLegend(legend: HTMLElement, lab: Lab, statuses: Uint8Array, known: string): string {
  const counts = STATUSES.map((name, k) => [name, statuses.reduce((sum, status) => sum + (status === k ? 1 : 0), 0)] as const)
    .filter(([, count]) => count > 0);
  const now = JSON.stringify([counts, lab.theme]);
  if (now === known) return known;
  legend.replaceChildren(...counts.map(([name, count]) => {
    const { says, ...colors } = STATUS_COLORS[name]!;
    return element("span", { class: "insp-key", title: says },
      element("i", { style: `background:${colors[lab.theme]}` }), `${name} ${count}`);
  }));
  return now;
}

function hoverText(lab: Lab, statuses: Uint8Array, time: number): string {
  const { times, size } = lab.past;
  let k = 0;
  while (k < size && times[k]! < time) ++k;  // the step that led to times[k]
  const name = STATUSES[statuses[k] ?? NO_DECISION];
  const when = `${digits(time, 1)} s`;
  return name ? `${when}: ${name}, ${STATUS_COLORS[name]!.says}` : `${when}: no decision yet`;
}
