// SPDX-License-Identifier: Apache-2.0
// The first hint for a new user, before anything is done.
import { element } from "../frame/elements.ts";
import type { Lab } from "../run/lab.ts";

export function mountHint(lab: Lab, root: HTMLElement): void {
  if (document.body.classList.contains("embedded")) return;
  const play = element("button", { type: "button", class: "hint-play", onclick: () => lab.play() }, "Play");
  const says = element("p", {}, "Each robot wants to get to its goal. ", element("b", {}, "Click one"),
    " to see why it moves as it does, ", element("b", {}, "drag"), " one to make trouble.");
  root.replaceChildren(play, says);
  root.hidden = false;
  const stops = (["playing", "selection", "moment", "scene"] as const).map((event) => lab.on(event, () => {
    root.hidden = true;
    stops.forEach((stop) => stop());
  }));
}
