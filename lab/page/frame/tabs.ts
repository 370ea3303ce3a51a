// SPDX-License-Identifier: Apache-2.0
// Without room for all panels, one of them is shown at a time.
import { element } from "./elements.ts";
import type { Lab } from "../run/lab.ts";

const PANELS = ["scene", "inspector", "charts"] as const;
type Panel = (typeof PANELS)[number];
const NAMES: Record<Panel, string> = { scene: "Scene", inspector: "Inspector", charts: "Charts" };

/** The style sheet shows the panel that <body data-panel> names. */
export function mountTabs(lab: Lab, root: HTMLElement): void {
  const tabs = PANELS.map((panel) => element("button", { type: "button", "aria-controls": panel, onclick: () => show(panel) }, NAMES[panel]));
  const show = (panel: Panel): void => {
    document.body.dataset["panel"] = panel;
    tabs.forEach((tab, k) => tab.setAttribute("aria-pressed", String(PANELS[k] === panel)));
  };
  root.replaceChildren(...tabs);
  lab.on("selection", () => { if (lab.selected !== null) show("inspector"); });
  show(document.body.classList.contains("embedded") ? "inspector" : "scene");
}
