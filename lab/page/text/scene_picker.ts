// SPDX-License-Identifier: Apache-2.0
// The built-in scenes and those of space, each with a picture of its start.
import type { BuiltinScene } from "../../avo/avo.ts";
import { closeFromBeside, crispContext, element } from "../frame/elements.ts";
import type { PageLab } from "../run/make_lab.ts";
import { SPACE_SCENES } from "./space_scenes.ts";
import { drawStart } from "../map/start_picture.ts";

const WIDTH = 208, HEIGHT = 118;  // pixels of a picture
const OF_ANY_NUMBER: Record<string, number[]> = { "circle-N": [20, 100, 1000], "uniform-N": [100, 1000] };

/** Returns a function that opens the picker. */
export function mountScenePicker(lab: PageLab, button: HTMLElement, place: HTMLElement): () => void {
  const open = (): void => {
    const find = element("input", { type: "search", placeholder: "find a scene", "aria-label": "find a scene" });
    const cards = scenesOf(lab).map((scene) => makeCard(lab, scene, () => dialog.close()));
    const dialog = element("dialog", { class: "card scenes", "aria-label": "scenes" },
      element("form", { method: "dialog", class: "card-head" }, element("h2", {}, "Scenes"), find,
        element("button", { class: "card-close", "aria-label": "close", formnovalidate: true }, "×")),
      element("div", { class: "scene-cards" }, ...cards.map(({ root }) => root)));
    find.addEventListener("input", () => {
      const words = find.value.toLowerCase().split(/\s+/);
      for (const { root, text } of cards) root.hidden = !words.every((word) => text.includes(word));
    });
    find.addEventListener("keydown", (event) => {
      if (event.key !== "Enter") return;
      event.preventDefault();
      cards.find(({ root }) => !root.hidden)?.root.click();
    });
    dialog.addEventListener("close", () => dialog.remove());
    closeFromBeside(dialog);
    place.append(dialog);
    dialog.showModal();
    drawWhenIdle(dialog, cards.map(({ draw }) => draw));
  };
  button.addEventListener("click", open);
  const refresh = (): void => {
    button.replaceChildren(element("b", {}, lab.info.name), " ▾");
    document.title = `${lab.info.name} · avo lab`;
  };
  lab.on("scene", refresh);
  refresh();
  return open;
}

function scenesOf(lab: PageLab): BuiltinScene[] {
  const plane = lab.library.builtinScenes().flatMap((scene) => {
    const numbers = OF_ANY_NUMBER[scene.name];
    return numbers ? numbers.map((n) => ({ ...scene, name: scene.name.replace("N", String(n)) })) : [scene];
  });
  return [...plane, ...SPACE_SCENES];
}

function makeCard(lab: PageLab, scene: BuiltinScene, done: () => void) {
  const canvas = element("canvas", { "aria-hidden": "true" });
  const description = described(scene.name, scene.description);
  const root = element("button", { type: "button", class: "scene-card" }, canvas, element("b", {}, scene.name), element("small", {}, description));
  const text = () => lab.library.builtinText(scene.name) ?? scene.yaml;
  root.addEventListener("click", () => {
    done();
    lab.openText(text(), scene.name, {});
  });
  const draw = (): void => {
    const wall = getComputedStyle(root).getPropertyValue("--wall");
    drawStart(crispContext(canvas, WIDTH, HEIGHT), lab.library.simulate(text(), { name: scene.name }), WIDTH, HEIGHT, lab.theme, wall);
  };
  return { root, draw, text: `${scene.name} ${description}`.toLowerCase() };
}

/** Returns "N robots ..." for circle-N, with the number in the name. */
export function described(name: string, description: string): string {
  return description.replace(/^N /, `${/\d+$/.exec(name)?.[0] ?? "N"} `);
}

/** Draws one picture per frame, so that the dialog stays responsive. */
function drawWhenIdle(dialog: HTMLDialogElement, draws: (() => void)[]): void {
  const next = draws.shift();
  if (!next || !dialog.open) return;
  requestAnimationFrame(() => {
    next();
    drawWhenIdle(dialog, draws);
  });
}
