// SPDX-License-Identifier: Apache-2.0
// Controls beside the map: the action of a press, zoom, the meaning of colors, and the length of a meter.
import { roundLength, zoomAt } from "./camera.ts";
import { shareColor, cssOf, directionColor } from "./colors.ts";
import type { Tool } from "./dragging.ts";
import { showNext } from "./orbit.ts";
import { digits, element } from "../frame/elements.ts";
import { icon } from "../frame/icons.ts";
import type { PageLab } from "../run/make_lab.ts";
import { STATUS_COLORS } from "../inspector/palette.ts";
import type { Hand } from "./pointer.ts";
import type { Coloring } from "./world_layers.ts";
import type { WorldView } from "./world_view.ts";

const TOOLS: { tool: Tool; picture: string; says: string }[] = [
  { tool: "move", picture: "move", says: "look and move: click selects, drag moves (1)" },
  { tool: "robot", picture: "robot", says: "add a robot: drag from its start to its goal (2)" },
  { tool: "wall", picture: "wall", says: "add a wall: drag from end to end (3)" },
  { tool: "erase", picture: "erase", says: "erase robots and walls (4)" },
];
export const COLORINGS: { coloring: Coloring; label: string }[] = [
  { coloring: "goal", label: "direction to the goal" },
  { coloring: "status", label: "status of the decision" },
  { coloring: "speed", label: "speed" },
];
const SCALE_BAR = 70;  // pixels at least, on a map with room for 9 of them

/** Returns a function that selects a tool. */
export function mountMapControls(lab: PageLab, view: WorldView, hand: Hand,
                                 { palette, zoom, legend }: Record<"palette" | "zoom" | "legend", HTMLElement>): (tool: Tool) => void {
  const button = (picture: string, says: string, action: () => void) =>
    element("button", { type: "button", class: "icon-button", title: says, "aria-label": says, onclick: action }, icon(picture));
  const tools = TOOLS.map(({ tool, picture, says }) => button(picture, says, () => choose(tool)));
  const choose = (tool: Tool): void => {
    const edits = lab.live !== null && lab.info.dimensions === 2;
    if (!edits && tool !== "move") lab.edit(() => undefined);  // shows the reason
    hand.tool = edits ? tool : "move";
    tools.forEach((shown, k) => shown.setAttribute("aria-pressed", String(TOOLS[k]!.tool === hand.tool)));
  };
  palette.replaceChildren(...tools);
  lab.on("scene", () => {
    palette.hidden = lab.live === null || lab.info.dimensions === 3;
    turn.hidden = lab.info.dimensions === 2;
    if (palette.hidden) choose("move");
  });
  const turn = button("orbit", "from aside, plan, elevation (v)", () => view.turn(showNext));
  turn.hidden = lab.info.dimensions === 2;
  choose("move");

  const zoomBy = (factor: number) => (): void => {
    zoomAt(view.camera, view.camera.width / 2, view.camera.height / 2, factor);
    view.touch();
  };
  zoom.replaceChildren(button("plus", "zoom in (+)", zoomBy(1.5)), button("minus", "zoom out (−)", zoomBy(1 / 1.5)),
    button("fit", "show all (f)", () => view.fit()), turn);
  mountLegend(lab, view, legend);
  return choose;
}

function mountLegend(lab: PageLab, view: WorldView, root: HTMLElement): void {
  const select = element("select", { "aria-label": "what the robots' colors mean" },
    ...COLORINGS.map(({ coloring, label }) => element("option", { value: coloring }, label)));
  const keys = element("span", { class: "legend-keys" });
  const bar = element("i", { class: "scale-bar" });
  const length = element("span", {});
  root.replaceChildren(element("span", { class: "scale" }, bar, length), element("label", {}, "color: ", select), keys);
  select.addEventListener("change", () => {
    lab.coloring = select.value as Coloring;
    lab.say("coloring");
  });
  const fill = (): void => {
    select.value = lab.coloring;
    keys.replaceChildren(...keysOf(lab.coloring, lab.theme));
  };
  lab.on("coloring", fill);
  lab.on("theme", fill);
  let scale = 0;
  view.whenDrawn.add(() => {
    if (view.camera.scale === scale) return;
    scale = view.camera.scale;
    const meters = roundLength(view.camera, Math.min(SCALE_BAR, view.camera.width / 9));
    bar.style.width = `${meters * scale}px`;
    length.textContent = `${digits(meters, meters < 1 ? 2 : 0)} m`;
  });
  fill();
}

function keysOf(coloring: Coloring, theme: "light" | "dark"): HTMLElement[] {
  const swatch = (style: string, label: string, title = "") =>
    element("span", { class: "legend-key", title }, element("i", { style }), label);
  if (coloring === "status") {
    return Object.entries(STATUS_COLORS).map(([status, colors]) => swatch(`background:${colors[theme]}`, status.replace("_", " "), colors.says));
  }
  if (coloring === "speed") {
    const ramp = [0, 0.25, 0.5, 0.75, 1].map((share) => cssOf(shareColor(share))).join(", ");
    return [swatch(`width:70px;background:linear-gradient(90deg, ${ramp})`, "0 to vₘₐₓ")];
  }
  const circle = Array.from({ length: 13 }, (_, k) => cssOf(directionColor(-(k / 12) * 2 * Math.PI + Math.PI / 2, theme))).join(", ");
  return [swatch(`border-radius:50%;background:conic-gradient(${circle})`, "as on a compass")];
}
