// SPDX-License-Identifier: Apache-2.0
// The window into a decision: it explains why the selected robot chooses its velocity.
import type { Simulation } from "../../avo/avo.ts";
import { openComparison } from "./comparison.ts";
import { markNeighbor } from "./decision_tables.ts";
import { closeFromBeside, digits, element, oncePerFrame } from "../frame/elements.ts";
import type { Explained } from "./explained.ts";
import { explained } from "./explained.ts";
import { explainedInSpace } from "./explained_in_space.ts";
import { makeHistoryStrip, type HistoryStrip } from "./history_strip.ts";
import type { Lab } from "../run/lab.ts";
import { simulationOfRow } from "./recorded_decision.ts";
import { makeSpaceCanvas, sharedAxes, type SpaceCanvas } from "./space_canvas.ts";

const LEAST_PAUSE = 60;  // ms between two decisions while it plays
const REST = 4;          // other work gets this multiple of a decision's time

/** The parts of the panel. */
interface Panel {
  root: HTMLElement;
  title: HTMLElement;
  when: HTMLElement;
  says: HTMLElement;
  note: HTMLElement;
  cut: HTMLElement;
  space: SpaceCanvas;
  strip: HistoryStrip;
  numbers: HTMLElement;
  neighbors: HTMLElement;
  shown: Explained | null;  // the present content
  pointed: string | null;   // in space: the neighbor for which the velocity space is cut
}

export function mountInspector(lab: Lab, root: HTMLElement): void {
  const panel = makePanel(lab);
  const nobody = empty(lab);
  root.replaceChildren(nobody, panel.root);
  let last = 0, cost = 0, late = 0;
  const refresh = (): void => {
    nobody.hidden = lab.selected !== null;
    panel.root.hidden = lab.selected === null;
    if (lab.selected === null) return;
    const begun = performance.now();
    show(lab, panel, lab.selected);
    cost = performance.now() - begun, last = performance.now();
  };
  const refreshSoon = oncePerFrame(() => {
    const rest = Math.max(LEAST_PAUSE, REST * cost) - (performance.now() - last);
    clearTimeout(late);
    if (!lab.playing || rest <= 0) refresh();
    else late = window.setTimeout(refresh, rest);
  });
  panel.root.addEventListener("neighbor", (event) => lab.select((event as CustomEvent<number>).detail));
  for (const event of ["moment", "scene", "playing"] as const) lab.on(event, refreshSoon);
  lab.on("past", () => panel.strip.redraw());
  lab.on("selection", refresh);
  lab.on("theme", refresh);
  lab.on("highlight", () => {
    markNeighbor(panel.neighbors, lab.highlighted);
    if (!turnCut(lab, panel)) panel.space.redraw();
  });
  refresh();
}

function makePanel(lab: Lab): Panel {
  const title = element("h2", { class: "insp-title" }), when = element("span", { class: "insp-when" });
  const says = element("p", { class: "insp-sentence", role: "status" });
  const note = element("p", { class: "insp-note", hidden: true }), cut = element("p", { class: "insp-note", hidden: true });
  const space = makeSpaceCanvas(lab, sharedAxes());
  const strip = makeHistoryStrip(lab);
  const numbers = element("div"), neighbors = element("div", { class: "insp-scroll" });
  const close = element("button", { type: "button", class: "insp-close", "aria-label": "close the inspector", onclick: () => lab.select(null) }, "×");
  const compare = element("button", { type: "button", class: "of-the-plane", onclick: () => openComparison(lab) }, "Compare methods");
  const copy = element("button", { type: "button", title: "the very text of avo explain --json" }, "Copy JSON");
  copy.addEventListener("click", () => void copyText(panel.shown?.text ?? "", copy));
  const root = element("div", { class: "insp", hidden: true },
    element("header", { class: "insp-head" }, title, when, close),
    says, note, space.root, cut, tools(space), legend(),
    element("h3", {}, "History"), strip.root,
    element("div", { class: "insp-actions" }, compare, copy),
    element("h3", {}, "Numbers"), numbers,
    element("h3", {}, "Neighbors"), neighbors);
  const panel: Panel = { root, title, when, says, note, cut, space, strip, numbers, neighbors, shown: null, pointed: null };
  return panel;
}

function show(lab: Lab, panel: Panel, robot: number): void {
  panel.strip.redraw();
  panel.note.hidden = lab.live !== null;
  panel.note.textContent = lab.live ? "" : ROW_NOTE;
  try {
    const simulation = simulationFor(lab);
    fill(lab, panel, lab.info.dimensions === 3 ? explainedInSpace(simulation, lab.info, robot, lab.playing) : explained(simulation, lab.info, robot, lab.playing));
  } catch (error) {
    silence(lab, panel, robot, error);
  }
}

function fill(lab: Lab, panel: Panel, now: Explained): void {
  const { numbers, neighbors } = panel;
  if (panel.shown?.robot !== now.robot) panel.pointed = null;
  panel.shown = now;
  panel.title.textContent = `Robot ${now.robot}`;
  panel.when.textContent = `at ${digits(lab.moment.time)} s · ${now.method}`;
  panel.says.textContent = now.sentence;
  panel.root.dataset["dimensions"] = String(lab.info.dimensions);
  showSpace(panel, now);
  numbers.replaceChildren(now.numbers());
  const scrolled = neighbors.scrollTop;
  neighbors.replaceChildren(now.neighbors(lab));
  neighbors.scrollTop = scrolled;
  markNeighbor(neighbors, lab.highlighted);
  panel.root.classList.remove("insp-silent");
}

function showSpace(panel: Panel, shown: Explained): void {
  const { source, note } = shown.drawnFor(panel.pointed);
  panel.space.show(source);
  panel.cut.textContent = note;
  panel.cut.hidden = note === "";
}

/** In space, cuts the velocity space for the robot that is pointed at elsewhere; returns whether it did. */
function turnCut({ highlighted, info }: Lab, panel: Panel): boolean {
  const { shown, space } = panel;
  const robot = highlighted?.startsWith("robots.") ? highlighted : null;
  if (!shown || info.dimensions === 2 || robot === null || robot === panel.pointed || robot === `robots.${shown.robot}` || space.root.matches(":hover"))
    return false;
  panel.pointed = robot;
  showSpace(panel, shown);
  return true;
}

function silence(lab: Lab, panel: Panel, robot: number, error: unknown): void {
  panel.shown = null;
  panel.title.textContent = `Robot ${robot}`;
  panel.when.textContent = `at ${digits(lab.moment.time)} s`;
  panel.says.textContent = error instanceof Error ? error.message : String(error);
  panel.root.classList.add("insp-silent");
  panel.space.show(null);
  panel.cut.hidden = true;
}

const ROW_NOTE = "From the row of the recording: what robots remember (their detours) and how fast drives turn is not recorded, so the decision is " +
  "that of robots which begin here.";

let rowOf: { moment: unknown; simulation: Simulation } | null = null;  // the last row is needed more than once

export function simulationFor(lab: Lab): Simulation {
  if (lab.live) return lab.live;
  if (rowOf?.moment !== lab.moment) rowOf = { moment: lab.moment, simulation: simulationOfRow(lab) };
  return rowOf.simulation;
}

function tools(space: SpaceCanvas): HTMLElement {
  const button = (label: string, title: string, act: () => void): HTMLElement =>
    element("button", { type: "button", title, onclick: act }, label);
  const layer = (key: "obstacles" | "certificate", label: string, title: string): HTMLElement => {
    const toggle = element("button", { type: "button", title, "aria-pressed": "true" }, label);
    toggle.addEventListener("click", () => {
      space.layers[key] = !space.layers[key];
      toggle.setAttribute("aria-pressed", String(space.layers[key]));
      space.refresh();
    });
    return toggle;
  };
  return element("div", { class: "insp-tools", role: "toolbar", "aria-label": "velocity space" },
    button("+", "zoom in (+)", () => space.zoom(1.5)), button("−", "zoom out (−)", () => space.zoom(1 / 1.5)),
    button("All", "all that it may choose (0)", () => space.fit()),
    button("Step", "what one step reaches", () => space.fitToStep()),
    layer("obstacles", "Obstacles", "the exact boundary of each obstacle, Eq. (29)"),
    layer("certificate", "Certificate", "velocities that the certificate admits for the next step"));
}

function legend(): HTMLElement {
  const entry = (kind: string, label: string, of = ""): HTMLElement =>
    element("span", { class: `insp-key ${of}` }, element("i", { class: `insp-swatch insp-${kind}` }), label);
  return element("div", { class: "insp-legend" }, entry("chosen", "may be chosen"), entry("forbidden", "forbidden"),
    entry("admitted", "certificate admits"),
    entry("binding", "binding half-plane", "of-the-plane"), entry("binding", "binding half-space", "of-space"), entry("outline", "obstacle, Eq. (29)"));
}

/** Returns the robot with the nearest neighbor: its decision is interesting. */
function busiest({ moment }: Lab): number | null {
  let best = 0;
  moment.clearance.forEach((clearance, i) => { if (clearance < moment.clearance[best]!) best = i; });
  return moment.robot[best] ?? null;
}

function empty(lab: Lab): HTMLElement {
  return element("div", { class: "insp-empty" },
    element("h2", {}, "Why did it choose that velocity?"),
    element("p", {}, "Click a robot, or tap it. Here you then look into its decision:"),
    element("ol", {},
      element("li", {}, "the velocities that it can reach, and those that its neighbors forbid,"),
      element("li", {}, "the one that it prefers, vᵖʳᵉᶠ, the one that it aims at, v′, the one that it has after this step, large, and why,"),
      element("li", {}, "what the certificate admits, so that all can always brake,"),
      element("li", {}, "how it has decided so far, and how another method would decide now.")),
    element("button", { type: "button", onclick: () => lab.select(busiest(lab)) }, "Look into one"));
}

async function copyText(text: string, button: HTMLElement): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    return showText(text);
  }
  button.textContent = "Copied";
  setTimeout(() => (button.textContent = "Copy JSON"), 1200);
}

/** Shows the text for copying by hand, if the browser does not let a page copy. */
function showText(text: string): void {
  const area = element("textarea", { class: "insp-text", readonly: true, rows: 16, "aria-label": "the text to copy" }, text);
  const dialog = element("dialog", { class: "card", "aria-label": "the text to copy" },
    element("form", { method: "dialog", class: "card-head" }, element("h2", {}, "The browser refuses to copy: do it here"),
      element("button", { class: "card-close", "aria-label": "close" }, "×")),
    area);
  dialog.addEventListener("close", () => dialog.remove());
  closeFromBeside(dialog);
  document.body.append(dialog);
  dialog.showModal();
  area.focus();
  area.select();
}
