// SPDX-License-Identifier: Apache-2.0
// Sliders for the paper's quantities, which work while the run continues; the scene's text follows.
import { digits, element } from "../frame/elements.ts";
import type { PageLab } from "../run/make_lab.ts";
import { withMethod } from "./method_text.ts";
import { robotsListed, valueAt } from "./scene_text.ts";

interface Knob {
  path: string;          // with * for all robots
  symbol: string;
  label: string;
  unit: string;
  least: number;
  most: number;
  step: number;
  value(lab: PageLab): number;
}

const isAvo = (lab: PageLab) => lab.info.options.method === "avo";
const ofRobot = (key: "radius" | "max_acceleration") => (lab: PageLab) =>
  (lab.info.robots.find(({ robot }) => robot === lab.selected) ?? lab.info.robots[0])?.[key] ?? NaN;

const KNOBS: Knob[] = [
  { path: "control_time", symbol: "δ", label: "control time", unit: "s", least: 0.2, most: 8, step: 0.1,
    value: (lab) => lab.info.options.control_time ?? (isAvo(lab) ? 2 : 4) },
  { path: "time_horizon", symbol: "τ", label: "time horizon", unit: "s", least: 0.5, most: 15, step: 0.1,
    value: (lab) => lab.info.options.time_horizon ?? (isAvo(lab) ? 3 : 10) },
  { path: "robots.*.max_acceleration", symbol: "a_max", label: "acceleration", unit: "m/s²", least: 0.1, most: 5, step: 0.05,
    value: ofRobot("max_acceleration") },
  { path: "robots.*.radius", symbol: "r", label: "radius", unit: "m", least: 0.1, most: 1.5, step: 0.01, value: ofRobot("radius") },
];
const CHOICES = [
  { path: "method", label: "Method" },
  { path: "certificate", label: "Certificate" },
];
const PACE = 120;  // ms between two edits while a slider is dragged

export function mountSliders(lab: PageLab, root: HTMLElement): void {
  let alone = false;  // whether radius and acceleration apply to the selected robot alone
  const scope = element("div", { class: "scope", role: "group", "aria-label": "whose radius and acceleration" });
  const all = element("button", { type: "button" }, "All robots");
  const one = element("button", { type: "button" });
  all.addEventListener("click", () => { alone = false; refresh(); });
  one.addEventListener("click", () => { alone = true; refresh(); });
  scope.append(all, one);
  const pathOf = (knob: Knob) => (alone ? knob.path.replace("*", String(lab.selected)) : knob.path);
  const rows = KNOBS.map((knob) => makeKnob(lab, knob, () => pathOf(knob)));
  const choices = CHOICES.map((choice) => makeChoice(lab, choice.path, choice.label));
  const notes = element("div", { class: "advice" });
  root.replaceChildren(...choices.map(({ row }) => row), rows[0]!.row, rows[1]!.row, scope, rows[2]!.row, rows[3]!.row, notes);

  function refresh(): void {
    const listed = lab.selected !== null && lab.text !== "" && lab.selected < robotsListed(lab.text);
    alone &&= listed;
    one.disabled = !listed;
    one.textContent = lab.selected === null ? "Selected one" : `Robot ${lab.selected}`;
    one.title = lab.selected === null ? "select a robot first" : listed ? "" : "its group's keys are those of all its robots";
    all.setAttribute("aria-pressed", String(!alone));
    one.setAttribute("aria-pressed", String(alone));
    for (const row of rows) row.refresh();
    for (const choice of choices) choice.refresh();
    const { broken_assumptions, advice } = lab.info;
    notes.replaceChildren(
      ...broken_assumptions.slice(0, 3).map((line) => element("p", { class: "bad" }, line)),
      ...advice.slice(0, 3).map((line) => element("p", {}, line)));
  }
  lab.on("scene", refresh);
  lab.on("text", refresh);
  lab.on("selection", refresh);
  refresh();
}

function makeKnob(lab: PageLab, knob: Knob, path: () => string) {
  const value = element("output", {});
  const range = element("input", { type: "range", min: knob.least, max: knob.most, step: knob.step, "aria-label": `${knob.label} in ${knob.unit}` });
  const [letter, below] = knob.symbol.split("_");
  const row = element("label", { class: "knob" },
    element("span", {}, element("i", {}, letter!), below ? element("sub", {}, below) : null, ` ${knob.label}`), value, range);
  const show = (now: number) => {
    value.textContent = `${digits(now, knob.step < 0.1 ? 2 : 1)} ${knob.unit}`;
    range.style.setProperty("--now", `${(100 * ((now || knob.least) - knob.least)) / (knob.most - knob.least)}%`);
    range.setAttribute("aria-valuetext", value.textContent);
  };
  let waiting: number | undefined;
  const apply = () => {
    waiting = undefined;
    lab.set(path(), Number(range.value));
  };
  const refresh = () => {
    if (waiting !== undefined) return;  // the slider is being dragged
    const now = knob.value(lab);
    range.disabled = lab.live === null || Number.isNaN(now);
    range.value = String(Number.isNaN(now) ? knob.least : now);
    show(now);
  };
  range.addEventListener("input", () => {
    show(Number(range.value));
    waiting ??= window.setTimeout(apply, PACE);
  });
  range.addEventListener("change", () => {
    clearTimeout(waiting);
    apply();
    refresh();
  });
  return { row, refresh };
}

function makeChoice(lab: PageLab, path: string, label: string) {
  const values = lab.library.settings().find(({ key }) => key === path)?.values ?? [];
  const unset = element("option", { value: "" });
  const select = element("select", { "aria-label": label }, unset, ...values.map((value) => element("option", { value }, value)));
  select.addEventListener("change", () => {
    const value = select.value || undefined;
    lab.carryOn(path === "method" ? withMethod(lab, value) : lab.textWith(path, value));
    refresh();
  });
  const refresh = () => {
    select.disabled = lab.live === null || (path === "method" && lab.info.dimensions === 3);  // which has one method
    const known = lab.text ? valueAt(lab.text, path) : undefined;
    const comesTo = known === undefined ? String(lab.info.options[path]) : "";
    unset.textContent = comesTo || "default";
    for (const option of select.options) option.hidden = option.value === comesTo;
    select.value = typeof known === "string" ? known : "";
  };
  return { row: element("label", { class: "choice" }, element("span", {}, label), select), refresh };
}
