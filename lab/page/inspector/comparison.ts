// SPDX-License-Identifier: Apache-2.0
// Compares two methods on the same state: what would the robot do if all robots decided by another method?
import type { Lab } from "../run/lab.ts";
import type { Decision } from "./decision.ts";
import { cross, dot, minus, norm } from "./decision.ts";
import { closeFromBeside, digits, element, oncePerFrame } from "../frame/elements.ts";
import type { ExplainedInPlane } from "./explained.ts";
import { explained } from "./explained.ts";
import { simulationFor } from "./inspector.ts";
import { withMethod } from "../text/method_text.ts";
import { simulationOfRow } from "./recorded_decision.ts";
import { makeSpaceCanvas, sharedAxes, type SpaceCanvas } from "./space_canvas.ts";

interface Side {
  root: HTMLElement;
  title: HTMLElement;
  says: HTMLElement;
  space: SpaceCanvas;
}

/** Opens over the page; Escape and a press beside it close it. */
export function openComparison(lab: Lab): void {
  if (lab.selected === null) return;
  const axes = sharedAxes();
  const sides = [makeSide(lab, axes), makeSide(lab, axes)] as const;
  const method = methodChoice(lab);
  const differences = element("div", { class: "insp-differences" });
  const dialog = element("dialog", { class: "insp-compare", "aria-label": "two methods on the same state" },
    element("form", { method: "dialog", class: "insp-head" }, element("h2", {}, "Two methods, one state"),
      element("label", {}, "compare with ", method), element("button", { class: "insp-close", "aria-label": "close" }, "×")),
    element("div", { class: "insp-sides" }, sides[0].root, sides[1].root), differences);
  const refresh = oncePerFrame(() => {
    if (lab.selected === null) return dialog.close();
    const own = attempt(() => explained(simulationFor(lab), lab.info, lab.selected!, lab.playing));
    const other = attempt(() => {
      const text = withMethod(lab, method.value);
      const simulation = lab.live?.carriedInto(text, { ...lab.options, name: lab.name }) ?? simulationOfRow(lab, text);
      return explained(simulation, simulation.info(), lab.selected!, lab.playing);
    });
    fillSide(sides[0], lab.info.options.method, own);
    fillSide(sides[1], method.value, other);
    differences.replaceChildren(own instanceof Error || other instanceof Error ? "" : differencesTable(own, other));
  });
  method.addEventListener("change", refresh);
  const stops = (["moment", "scene", "selection", "theme"] as const).map((event) => lab.on(event, refresh));
  stops.push(lab.on("highlight", () => sides.forEach((side) => side.space.redraw())));
  dialog.addEventListener("neighbor", (event) => lab.select((event as CustomEvent<number>).detail));
  dialog.addEventListener("close", () => {
    stops.forEach((stop) => stop());
    dialog.remove();
  });
  closeFromBeside(dialog);
  document.body.append(dialog);
  dialog.showModal();
  method.focus();
  refresh();
}

function methodChoice(lab: Lab): HTMLSelectElement {
  const methods = lab.library.settings().find((setting) => setting.key === "method")?.values ?? [];
  // an external method cannot be asked here
  const others = methods.filter((name) => name !== lab.info.options.method && !name.startsWith("external"));
  return element("select", {}, ...others.map((name) => element("option", { value: name, selected: name === "orca" || name === "avo" }, name)));
}

function makeSide(lab: Lab, axes: ReturnType<typeof sharedAxes>): Side {
  const title = element("h3"), says = element("p", { class: "insp-sentence" });
  const space = makeSpaceCanvas(lab, axes);
  return { root: element("section", { class: "insp-side" }, title, space.root, says), title, says, space };
}

function attempt(work: () => ExplainedInPlane): ExplainedInPlane | Error {
  try {
    return work();
  } catch (error) {
    return error instanceof Error ? error : new Error(String(error));
  }
}

function fillSide(side: Side, method: string, result: ExplainedInPlane | Error): void {
  side.title.textContent = method;
  side.says.textContent = result instanceof Error ? result.message : result.sentence;
  side.space.show(result instanceof Error ? null : result.drawnFor(null).source);
}

const angle = (a: Decision, b: Decision): number =>
  Math.atan2(cross(a.new_velocity, b.new_velocity), dot(a.new_velocity, b.new_velocity)) * 180 / Math.PI;

function differencesTable(own: ExplainedInPlane, other: ExplainedInPlane): HTMLElement {
  const [a, b] = [own.decision, other.decision];
  const turn = norm(a.new_velocity) > 0 && norm(b.new_velocity) > 0 ? `, ${digits(Math.abs(angle(a, b)), 1)}° ${angle(a, b) < 0 ? "right" : "left"}` : "";
  const needed = (explained: ExplainedInPlane): number => norm(explained.decision.acceleration) / explained.decision.max_acceleration;
  const row = (label: string, unit: string, left: string, right: string, difference = ""): HTMLElement =>
    element("tr", {}, element("th", { scope: "row" }, label, unit ? element("small", {}, ` ${unit}`) : null),
      element("td", {}, left), element("td", {}, right), element("td", {}, difference));
  const plain = (label: string, unit: string, of: (decision: Decision) => number, places = 2): HTMLElement =>
    row(label, unit, digits(of(a), places), digits(of(b), places), digits(of(b) - of(a), places));
  return element("table", { class: "insp-numbers" },
    element("thead", {}, element("tr", {}, ...["", own.law.method, other.law.method, "difference"].map((head) => element("th", { scope: "col" }, head)))),
    element("tbody", {},
      row("v′", "m/s", `(${digits(a.new_velocity[0])}, ${digits(a.new_velocity[1])})`, `(${digits(b.new_velocity[0])}, ${digits(b.new_velocity[1])})`,
        `${digits(norm(minus(b.new_velocity, a.new_velocity)))}${turn}`),
      plain("speed |v′|", "m/s", (decision) => norm(decision.new_velocity)),
      plain("acceleration |a|", "m/s²", (decision) => norm(decision.acceleration)),
      row("|a| of aₘₐₓ", "%", digits(100 * needed(own), 0), digits(100 * needed(other), 0), digits(100 * (needed(other) - needed(own)), 0)),
      plain("distance from vᵖʳᵉᶠ", "m/s", (decision) => norm(minus(decision.new_velocity, decision.preferred_velocity))),
      plain("violation", "m/s", (decision) => decision.violation, 3),
      plain("sensed", "neighbors", (decision) => decision.neighbors.length, 0),
      plain("half-planes", "that cut", (decision) => decision.half_planes.length + decision.wall_half_planes.length, 0),
      row("status", "", a.status, b.status), row("state", "", a.state, b.state)));
}
