// SPDX-License-Identifier: Apache-2.0
// All keys and gestures on one card.
import { closeFromBeside, element } from "../frame/elements.ts";

const KEYS: [string, [string, string][]][] = [
  ["The run", [
    ["Space", "play, pause"], ["→  ←", "one step on, one step back"], ["Shift →  ←", "a second on, a second back"],
    ["r", "restart"], ["↑  ↓", "faster, slower"],
  ]],
  ["Robots", [
    ["n  p", "select the next, the previous one"], ["Delete", "remove the selected one"], ["Escape", "give up what is being drawn; select nobody"],
  ]],
  ["The map", [
    ["f", "fit all"], ["+  −", "zoom"], ["h  j  k  l", "pan"], ["c", "color by goal, status, speed"],
    ["v", "in space: from aside, plan, elevation"], ["H  J  K  L", "in space: turn"],
  ]],
  ["What a press does", [
    ["1", "look and move: click selects, drag moves"], ["2", "add a robot: drag from its start to its goal"],
    ["3", "add a wall: drag from end to end"], ["4", "erase robots and walls"],
  ]],
  ["The page", [["s", "choose a scene"], ["o", "open a file"], ["?", "this card"]]],
];

const GESTURES = "Drag the ground to pan, turn the wheel or pinch to zoom, press twice to fit all. In space a drag turns the view, and with Shift, the " +
  "right button or two fingers it pans. Drop files anywhere: scenes " +
  "(YAML) with their maps, recordings of avo run --record (HDF5), tables of states (CSV).";

const SHAPES: [string, string][] = [
  ["filled", "goes its way"], ["hollow", "nothing but braking is admitted"],
  ["dashed", "no velocity satisfies all half-planes"],
  ["heavy rim", "in contact"], ["dot", "at its goal"], ["cross", "a contact happened here"],
];

export function mountHelp(button: HTMLElement, place: HTMLElement): () => void {
  const open = (): void => {
    const dialog = element("dialog", { class: "card help", "aria-label": "keys and gestures" },
      element("form", { method: "dialog", class: "card-head" }, element("h2", {}, "Keys and gestures"),
        element("button", { class: "card-close", "aria-label": "close" }, "×")),
      element("div", { class: "help-columns" }, ...KEYS.map(([title, keys]) => list(title, keys, "kbd")), list("Robots are drawn", SHAPES, "b")),
      element("p", {}, GESTURES));
    dialog.addEventListener("close", () => dialog.remove());
    closeFromBeside(dialog);
    place.append(dialog);
    dialog.showModal();
  };
  button.addEventListener("click", open);
  return open;
}

function list(title: string, rows: [string, string][], mark: "kbd" | "b"): HTMLElement {
  return element("section", {}, element("h3", {}, title),
    element("dl", {}, ...rows.flatMap(([key, says]) => [element("dt", {}, element(mark, {}, key)), element("dd", {}, says)])));
}
