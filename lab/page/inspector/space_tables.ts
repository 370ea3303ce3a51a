// SPDX-License-Identifier: Apache-2.0
// A decision in space in numbers with units, and the neighbors that the robot senses, nearest first.
import { gap, type Body } from "../map/discs.ts";
import { norm3, type Vec3 } from "../map/vec3.ts";
import { digits, element } from "../frame/elements.ts";
import type { Lab } from "../run/lab.ts";
import { labelOf, nameOf, type Source } from "./decision.ts";
import { neighborLink, neighborsOf, symbol, tableOf, type Row } from "./decision_tables.ts";
import { STATUS_COLORS } from "./palette.ts";
import type { Cause, SpaceDecision } from "./space_decision.ts";

const triple = (v: Vec3): string => `(${v.map((value) => digits(value, 3)).join(", ")})`;
const speed = (v: Vec3): string => (norm3(v) > 0 ? `, ${digits(norm3(v))} m/s` : "");
const names = (causes: Cause[]): string =>
  causes.map((cause) => (cause === null ? "its own limits" : labelOf(nameOf(cause)))).join(", ") || "nobody";

export function numbersTableInSpace(decision: SpaceDecision): HTMLElement {
  const { position, goal, velocity, preferred_velocity, new_velocity, next_velocity, acceleration, max_acceleration, trace } = decision;
  const velocities = (name: string, label: Node, v: Vec3, title: string): Row =>
    ({ name, label, value: `${triple(v)} m/s${speed(v)}`, exact: v, title });
  const causes = (name: string, label: string, all: Cause[], title: string): Row => ({ name, label, value: names(all), exact: all, title });
  return tableOf([
    { name: "position", label: "position", value: `${triple(position)} m`, exact: position },
    { name: "goal", label: "goal", value: `${triple(goal)} m`, exact: goal },
    velocities("velocity", symbol("v"), velocity, "velocity"),
    velocities("preferred_velocity", symbol("v", "pref"), preferred_velocity, "preferred velocity"),
    velocities("new_velocity", symbol("v′"), new_velocity, "target v′"),
    velocities("next_velocity", symbol("v", "next"), next_velocity, "velocity after this step"),
    { name: "acceleration", label: symbol("a"), value: `${triple(acceleration)} m/s², ${digits(100 * norm3(acceleration) / max_acceleration, 0)} % of aₘₐₓ`, exact: acceleration, title: "acceleration: what follows from the target, Eq. (7)" },
    { name: "status", label: "status", value: decision.status, exact: decision.status, title: STATUS_COLORS[decision.status]?.says ?? "" },
    causes("binding", "binding", trace.binding, "whose half-spaces bind"),
    causes("heeded", "heeded", trace.heeded === null ? [] : [trace.heeded], "the neighbor that a rule for arriving heeds"),
    causes("refusing", "refusing", [...new Set([...trace.refusing, ...trace.refusing_detour])], "for whom the certificate refuses a velocity"),
    { name: "violation", label: "violation", value: `${digits(decision.violation, 3)} m/s`, exact: decision.violation, title: "by how much v′ misses CA_A" },
    { name: "state", label: "state", value: decision.state, exact: decision.state, title: "what is proved before anything is decided (docs/states.md)" },
  ]);
}

const bodyOf = ([x, y, z]: Vec3, radius: number, downwash: number): Body => ({ x, y, z, radius, downwash });

export function neighborTableInSpace(lab: Lab, decision: SpaceDecision): HTMLElement {
  const downwash = lab.info.robots.find(({ robot }) => robot === decision.robot)?.downwash ?? 0;
  const own = bodyOf(decision.position, decision.radius, downwash);
  const sorted = decision.neighbors.map((sensed) => ({ sensed, clearance: gap(own, bodyOf(sensed.position, sensed.radius, sensed.downwash)) }))
    .sort((a, b) => a.clearance - b.clearance);
  const { binding, refusing, refusing_detour, heeded } = decision.trace;
  const roleOf = (neighbor: Source): string =>
    ([["binds", binding], ["refuses", [...refusing, ...refusing_detour]], ["heeded", [heeded]]] as [string, Cause[]][])
      .filter(([, all]) => all.includes(neighbor)).map(([role]) => role).join(", ");
  return neighborsOf([["neighbor", ""], ["clearance", "m"], ["height", "m"], ["role", ""]], sorted, ({ sensed, clearance }) => {
    const name = nameOf(sensed.neighbor), role = roleOf(sensed.neighbor);
    const height = sensed.position[2] - decision.position[2];
    return element("tr", { "data-name": name, onpointerenter: () => lab.highlight(name), onpointerleave: () => lab.highlight(null) },
      element("th", { scope: "row" }, typeof sensed.neighbor === "number" ? neighborLink(lab, sensed.neighbor) : labelOf(name)),
      element("td", { class: clearance < 0 ? "insp-bad" : "" }, digits(clearance)),
      element("td", {}, `${height > 0 ? "+" : ""}${digits(height, 1)}`),
      element("td", { class: role ? "insp-binds" : "" }, role));
  });
}
