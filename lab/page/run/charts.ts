// SPDX-License-Identifier: Apache-2.0
// Live charts of the run so far against its limits: clearance, speed, acceleration, arrivals. The time under the
// pointer is the same in all charts; a click goes there.
import uPlot from "uplot";
import type { Lab } from "./lab.ts";
import { digits, element } from "../frame/elements.ts";
import { paletteOf } from "../inspector/palette.ts";
import { thinned } from "./thinned.ts";

/** The contents of one chart. */
interface Measure {
  title: string;
  unit: string;
  says: string;
  limit: (lab: Lab) => number | null;      // drawn as a line
  limit_label: string;
  values: (lab: Lab) => ArrayLike<number>;
  scale: number;                            // from the values to the unit
  places: number;
  floor: number;                            // the axis begins here or lower
  ceiling: (lab: Lab) => number;            // the axis ends here or higher
}

const MEASURES: Measure[] = [
  { title: "clearance", unit: "m between robots", says: "the least of all pairs of robots, surface to surface, at the ends of steps; triangles are contacts, of a live run with walls too", limit: () => 0, limit_label: "contact",
    values: (lab) => lab.past.clearance, scale: 1, places: 3, floor: -0.1, ceiling: () => 0.5 },
  { title: "speed", unit: "% of vₘₐₓ", says: "the robot that comes nearest to its limit, or exceeds it most", limit: () => 100, limit_label: "vₘₐₓ",
    values: (lab) => lab.past.speed_ratio, scale: 100, places: 0, floor: 0, ceiling: () => 115 },
  { title: "acceleration", unit: "% of aₘₐₓ", says: "the robot that comes nearest to its limit, or exceeds it most", limit: () => 100, limit_label: "aₘₐₓ",
    values: (lab) => lab.past.acceleration_ratio, scale: 100, places: 0, floor: 0, ceiling: () => 115 },
  { title: "arrived", unit: "robots", says: "at their goals now", limit: (lab) => lab.moment.robot.length, limit_label: "all",
    values: (lab) => lab.past.arrived, scale: 1, places: 0, floor: 0, ceiling: (lab) => 1.12 * Math.max(1, lab.moment.robot.length) },
];

const HEIGHT = 118, MOST_POINTS = 1500, LEAST_PAUSE = 90;  // px, -, ms

interface Chart {
  measure: Measure;
  value: HTMLElement;
  holder: HTMLElement;
  plot: uPlot | null;
}

export function mountCharts(lab: Lab, root: HTMLElement): void {
  const charts = MEASURES.map((measure): Chart => {
    const value = element("output", { class: "chart-value" }), holder = element("div", { class: "chart-plot" });
    return { measure, value, holder, plot: null };
  });
  root.classList.add("charts");
  root.replaceChildren(...charts.map(({ measure, value, holder }) =>
    element("figure", { class: "chart", title: measure.says },
      element("figcaption", {}, element("b", {}, measure.title), element("span", { class: "chart-unit" }, measure.unit), value), holder)));
  const rebuild = (): void => charts.forEach((chart) => {
    chart.plot?.destroy();
    chart.plot = makePlot(lab, chart);
  });
  let last = 0, timer = 0;
  const refresh = (): void => {
    last = performance.now();
    if (root.clientWidth > 0) charts.forEach((chart) => fill(lab, chart));
  };
  const soon = (): void => {
    clearTimeout(timer);
    const rest = LEAST_PAUSE - (performance.now() - last);
    if (rest <= 0) refresh();
    else timer = window.setTimeout(refresh, rest);
  };
  lab.on("moment", soon);
  lab.on("past", soon);
  lab.on("scene", soon);
  lab.on("theme", () => {
    rebuild();
    refresh();
  });
  rebuild();
  new ResizeObserver(() => {
    charts.forEach(({ plot, holder }) => plot?.setSize({ width: Math.max(holder.clientWidth, 80), height: HEIGHT }));
    refresh();
  }).observe(root);
  refresh();
}

function fill(lab: Lab, chart: Chart): void {
  const { measure, plot } = chart;
  const [times, values] = thinned(lab.past.times, measure.values(lab), MOST_POINTS, measure.title === "clearance");
  plot?.setData([times, values.map((value) => (value === null ? null : value * measure.scale))]);
  tell(lab, chart);
}

/** The value under the pointer, or the present value. */
function tell(lab: Lab, { measure, plot, value }: Chart): void {
  const hovered = plot?.cursor.idx;
  const [times, values] = plot?.data ?? [[], []];
  const time = hovered != null ? times![hovered] : undefined;
  const row = time !== undefined ? hovered! : nearestRow(times as number[], lab.moment.time);
  const shown = values?.[row];
  value.textContent = shown == null ? "–" : `${digits(shown, measure.places)}${time !== undefined ? ` at ${digits(time, 1)} s` : ""}`;
  const limit = measure.limit(lab);
  const isBroken = shown != null && limit !== null && (measure.title === "clearance" ? shown < 0 : measure.title !== "arrived" && shown > limit * (1 + 1e-6));
  value.classList.toggle("chart-broken", isBroken);
}

function nearestRow(times: number[], time: number): number {
  let row = times.length - 1;
  while (row > 0 && times[row]! > time + 1e-9) --row;
  return row;
}

function makePlot(lab: Lab, chart: Chart): uPlot {
  const { measure, holder } = chart;
  const palette = paletteOf(lab.theme);
  const axis = { stroke: palette.soft, font: "11px system-ui, sans-serif", ticks: { stroke: palette.frame, size: 3 }, grid: { show: false } };
  const plot = new uPlot({
    width: Math.max(holder.clientWidth, 80), height: HEIGHT, legend: { show: false }, padding: [6, 10, 0, 0],
    scales: {
      x: { time: false, range: (_, __, most) => [0, Math.max(5, 5 * Math.ceil((most ?? 0) / 5))] },
      y: { range: (_, least, most) => [Math.min(measure.floor, (least ?? 0) * 1.05), Math.max(measure.ceiling(lab), (most ?? 0) * 1.05)] },
    },
    axes: [
      { ...axis, size: 22, space: 50, values: (_, all) => all.map((value, k) => (k === 0 ? `${value} s` : String(value))) },
      { ...axis, size: 40, space: 24, values: (_, all) => all.map((value) => digits(value, Math.max(...all) < 2 ? 1 : 0)) },
    ],
    series: [{}, { stroke: palette.preferred, width: 1.5, points: { show: false }, spanGaps: false }],
    cursor: { sync: { key: "lab" }, drag: { x: false, y: false }, y: false, points: { size: 6 } },
    hooks: {
      draw: [(drawn) => drawMarks(drawn, lab, measure)],
      setCursor: [() => tell(lab, chart)],
    },
  }, [[], []], holder);
  plot.over.addEventListener("click", () => lab.seek(plot.posToVal(plot.cursor.left ?? 0, "x")));
  return plot;
}

/** Draws the limit as a line with its name, contacts as ticks below, and the present time. */
function drawMarks(plot: uPlot, lab: Lab, measure: Measure): void {
  const { ctx, bbox } = plot;
  const palette = paletteOf(lab.theme), unit = devicePixelRatio || 1;
  const bad = lab.theme === "dark" ? "#ff7a6b" : "#b3261e";
  ctx.save();
  const limit = measure.limit(lab);
  if (limit !== null) {
    const y = plot.valToPos(limit, "y", true);
    ctx.strokeStyle = ctx.fillStyle = bad;
    ctx.lineWidth = unit;
    ctx.setLineDash([4 * unit, 3 * unit]);
    ctx.beginPath(), ctx.moveTo(bbox.left, y), ctx.lineTo(bbox.left + bbox.width, y), ctx.stroke();
    ctx.setLineDash([]);
    ctx.font = `${10 * unit}px system-ui, sans-serif`;
    ctx.textAlign = "right", ctx.textBaseline = "bottom";
    ctx.fillText(measure.limit_label, bbox.left + bbox.width, y - unit);
  }
  if (measure.title === "clearance") {
    ctx.fillStyle = bad;
    for (const contact of lab.contacts) {
      const x = plot.valToPos(contact.time, "x", true);
      ctx.beginPath();
      ctx.moveTo(x, bbox.top + bbox.height - 6 * unit), ctx.lineTo(x - 3.5 * unit, bbox.top + bbox.height), ctx.lineTo(x + 3.5 * unit, bbox.top + bbox.height);
      ctx.fill();
    }
  }
  ctx.fillStyle = palette.ink;
  ctx.globalAlpha = 0.7;
  ctx.fillRect(plot.valToPos(lab.moment.time, "x", true) - 0.5 * unit, bbox.top, unit, bbox.height);
  ctx.restore();
}
