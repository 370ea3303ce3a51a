// SPDX-License-Identifier: Apache-2.0
// The panel of the scene: its description, the quantities of the paper, its text.
import { mountEditor } from "./editor.ts";
import { element } from "../frame/elements.ts";
import type { PageLab } from "../run/make_lab.ts";
import { described } from "./scene_picker.ts";
import { SPACE_SCENES } from "./space_scenes.ts";
import { mountSliders } from "./sliders.ts";

export function mountScenePanel(lab: PageLab, root: HTMLElement): void {
  const name = element("h2", {});
  const says = element("p", { class: "scene-says" });
  const run = element("button", { type: "button", class: "tool-button", title: "simulate the scene of this recording anew" }, "Run its scene");
  const sliders = element("div", { class: "sliders" });
  const editor = element("div", { class: "editor" });
  root.replaceChildren(element("header", { class: "scene-head" }, name, says, run), sliders,
    element("details", { class: "fold editor-fold", open: true }, element("summary", {}, "Text of the scene"), editor));
  const descriptions = new Map([...lab.library.builtinScenes(), ...SPACE_SCENES].map((scene) => [scene.name, scene.description]));
  run.addEventListener("click", () => lab.openText(lab.text));
  const refresh = (): void => {
    name.textContent = lab.info.name;
    const recorded = lab.live ? null : lab.text ? "A recording." : "A recording of states alone: its scene is not in it, so radii and limits are the paper's.";
    const known = descriptions.get(lab.name) ?? descriptions.get(lab.name.replace(/-\d+$/, "-N")) ?? "";
    says.textContent = recorded ?? described(lab.name, known);
    says.hidden = says.textContent === "";
    run.hidden = lab.live !== null || lab.text === "";
  };
  lab.on("scene", refresh);
  lab.on("text", refresh);
  refresh();
  mountSliders(lab, sliders);
  mountEditor(lab, editor);
}
