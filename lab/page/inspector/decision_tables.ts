// SPDX-License-Identifier: Apache-2.0
// A decision in numbers with units, and the neighbors that the robot senses, nearest first.
import type { Lab } from "../run/lab.ts";
import type { Decision, Sensed, Vec } from "./decision.ts";
import { clearanceOf, labelOf, nameOf, norm } from "./decision.ts";
import { digits, element } from "../frame/elements.ts";
import { STATUS_COLORS } from "./palette.ts";
import type { Law, Why } from "./why.ts";
import { evadedOf, headingOf } from "./why.ts";

export interface Row {
  name: string;     // for the key of `avo explain --json`, or for a derived value
  label: Node | string;
  value: string;
  exact: unknown;   // the value in the JSON
  title?: string;
}

/** Returns "*v*^{pref}" of math_text.ts as elements. */
export function symbol(letter: string, raised = ""): HTMLElement {
  return element("span", { class: "insp-symbol" }, element("b", {}, element("i", {}, letter)), raised ? element("sup", {}, raised) : null);
}

const pair = (v: Vec): string => `(${digits(v[0], 3)}, ${digits(v[1], 3)})`;
const polar = (v: Vec): string => (norm(v) > 0 ? `, ${digits(norm(v))} m/s at ${digits(headingOf(v), 0)}°` : "");

function motionRows(decision: Decision): Row[] {
  const { velocity, preferred_velocity, new_velocity, acceleration, max_acceleration, position, goal } = decision;
  const share = max_acceleration > 0 ? `, ${digits(100 * norm(acceleration) / max_acceleration, 0)} % of aₘₐₓ` : "";
  return [
    { name: "position", label: "position", value: `${pair(position)} m`, exact: position },
    { name: "goal", label: "goal", value: `${pair(goal)} m`, exact: goal },
    { name: "velocity", label: symbol("v"), value: `${pair(velocity)} m/s${polar(velocity)}`, exact: velocity, title: "velocity" },
    { name: "preferred_velocity", label: symbol("v", "pref"), value: `${pair(preferred_velocity)} m/s${polar(preferred_velocity)}`, exact: preferred_velocity, title: "preferred velocity" },
    { name: "new_velocity", label: symbol("v′"), value: `${pair(new_velocity)} m/s${polar(new_velocity)}`, exact: new_velocity, title: "target v′" },
    { name: "acceleration", label: symbol("a"), value: `${pair(acceleration)} m/s²${share}`, exact: acceleration, title: "acceleration: what follows from the target, Eq. (7)" },
  ];
}

function verdictRows(decision: Decision): Row[] {
  const rows: Row[] = [
    { name: "status", label: "status", value: decision.status, exact: decision.status, title: STATUS_COLORS[decision.status]?.says ?? "" },
    ...contactRows(decision),
    ...evasionRows(decision),
    ...waitRows(decision),
    { name: "violation", label: "violation", value: `${digits(decision.violation, 3)} m/s`, exact: decision.violation, title: "by how much v′ misses CA_A" },
    { name: "state", label: "state", value: stateText(decision), exact: decision.state, title: "what is proved before anything is decided (docs/states.md)" },
    { name: "target_by", label: "target by", value: decision.target_by.replaceAll("_", " "), exact: decision.target_by },
  ];
  if (decision.certificate_kind !== undefined) {
    const constraints = decision.certificate ?? [];
    const whose = new Set(constraints.map((constraint) => constraint.neighbor)).size;
    rows.push(
      { name: "detour_angle", label: "detour", value: `${digits((decision.detour_angle ?? 0) * 180 / Math.PI, 1)}° to the right`, exact: decision.detour_angle },
      { name: "response_time", label: "response time", value: decision.response_time ? `${digits(decision.response_time)} s` : "0: at once", exact: decision.response_time, title: "time constant with which it approaches v′" },
      { name: "certificate", label: "certificate", value: `${decision.certificate_kind.replaceAll("_", " ")}: ${constraints.length} constraints of ${whose} neighbors`, exact: constraints.length });
  }
  if (decision.risk !== undefined)
    rows.push({ name: "risk", label: "risk", value: decision.risk.toPrecision(2), exact: decision.risk, title: "that noise hides a broken half-plane, at most" });
  return rows;
}

function contactRows(decision: Decision): Row[] {
  if (decision.contact_with === null || decision.contact_depth === null) return [];
  const whom = labelOf(nameOf(decision.contact_with), decision.walls);
  return [{ name: "contact", label: "contact", value: `${whom}, ${decision.contact_depth.toPrecision(3)} m deep`, exact: decision.contact_depth, title: "whom it touches, or comes to touch in spite of braking, and how deep" }];
}

function evasionRows(decision: Decision): Row[] {
  if (!decision.evading) return [];
  const { velocity, until } = decision.evading;
  const maneuver = norm(velocity) > 0 ? `towards ${pair(velocity)} m/s until ${digits(until)} s` : "brakes";
  return [{ name: "evading", label: "evades", value: `${evadedOf(decision)}: ${maneuver}`, exact: decision.evading, title: "the mover that it evades, and by which evasive maneuver (docs/movers.md)" }];
}

function waitRows(decision: Decision): Row[] {
  if (!decision.waits) return [];
  const whom = labelOf(nameOf(decision.waits.for));
  return [{ name: "waits", label: "waits", value: `for ${whom}, at the passage at ${pair(decision.waits.passage)} m`, exact: decision.waits, title: "the right of way at the passage (docs/arrival.md)" }];
}

function stateText(decision: Decision): string {
  if (decision.state !== "doomed") return decision.state;
  const whom = decision.doomed_by === null ? "" : ` by ${labelOf(nameOf(decision.doomed_by), decision.walls)}`;
  if (decision.contact_within === 0) return `doomed${whom}: in contact`;
  return `doomed${whom} within ${digits(decision.contact_within ?? 0)} s`;
}

export function numbersTable(decision: Decision): HTMLElement {
  return tableOf([...motionRows(decision), ...verdictRows(decision)]);
}

export function tableOf(rows: Row[]): HTMLElement {
  return element("table", { class: "insp-numbers" }, element("tbody", {}, ...rows.map((row) =>
    element("tr", { "data-key": row.name, ...(row.title ? { title: row.title } : {}) },
      element("th", { scope: "row" }, row.label),
      element("td", { "data-value": JSON.stringify(row.exact) ?? "" }, row.value)))));
}

function behaviorOf(sensed: Sensed): string {
  const age = sensed.age ? `, ${sensed.age} steps old` : "";
  if (sensed.behavior === "decides") return `decides${age}`;
  const what = sensed.behavior.replaceAll("_", " ");
  return `${sensed.max_deviation ? `${what}, within ${digits(sensed.max_deviation)} m/s²` : what}${age}`;
}

/** Returns a link that selects the robot. */
export function neighborLink(lab: Lab, robot: number): HTMLElement {
  const name = `robots.${robot}`;
  return element("button", {
    type: "button", class: "insp-link", onclick: () => lab.select(robot), onfocus: () => lab.highlight(name), onblur: () => lab.highlight(null),
  }, labelOf(name));
}

const ROWS = 40;  // more rows would not be read

/** Returns the table of the neighbors that are nearest, with these heads and their units. */
export function neighborsOf<T>(heads: [string, string][], sorted: T[], rowOf: (each: T) => HTMLElement): HTMLElement {
  const rest = sorted.length - ROWS;
  return element("table", { class: "insp-neighbors" },
    element("thead", {}, element("tr", {}, ...heads.map(([head, unit]) =>
      element("th", { scope: "col" }, head, unit ? element("small", {}, ` ${unit}`) : null)))),
    element("tbody", {}, ...sorted.slice(0, ROWS).map(rowOf)),
    rest > 0 ? element("caption", {}, `and ${rest} farther away`) : null);
}

export function neighborTable(lab: Lab, decision: Decision, found: Why, law: Law): HTMLElement {
  const sorted = decision.neighbors.map((sensed) => ({ sensed, name: nameOf(sensed.neighbor), clearance: clearanceOf(decision, sensed) }))
    .sort((a, b) => a.clearance - b.clearance);
  return neighborsOf([["neighbor", ""], ["clearance", "m"], ["share", "%"], ["behavior", ""], ["half-plane", ""]], sorted, ({ sensed, name, clearance }) => {
    const cut = found.cuts.find((other) => other.of === name);
    const role = !cut ? (law.method === "buffered_voronoi" || decision.target_by !== "half_planes" ? "" : "does not cut")
      : cut.binds ? "binds" : cut.refuses > 1e-3 ? "refuses vᵖʳᵉᶠ" : "cuts";
    const label = typeof sensed.neighbor === "number" ? neighborLink(lab, sensed.neighbor) : labelOf(name);
    return element("tr", { "data-name": name, onpointerenter: () => lab.highlight(name), onpointerleave: () => lab.highlight(null) },
      element("th", { scope: "row" }, label),
      element("td", { class: clearance < 0 ? "insp-bad" : "" }, digits(clearance)),
      element("td", {}, digits(100 * sensed.share, 0)),
      element("td", {}, behaviorOf(sensed)),
      element("td", { class: cut?.binds ? "insp-binds" : "" }, role));
  });
}

/** Marks the row of the item that is highlighted in any view. */
export function markNeighbor(table: ParentNode, highlighted: string | null): void {
  for (const row of table.querySelectorAll<HTMLElement>("tr[data-name]")) row.classList.toggle("insp-hit", row.dataset.name === highlighted);
}
