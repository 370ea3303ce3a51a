// SPDX-License-Identifier: Apache-2.0
// A notice over the map about a refused action and its reason. Faults of the text are also marked there.
import { element } from "./elements.ts";
import type { Lab } from "../run/lab.ts";

export function mountNotice(lab: Lab, root: HTMLElement): void {
  const text = element("p", {});
  const close = element("button", { type: "button", class: "notice-close", "aria-label": "close this message", onclick: () => (root.hidden = true) }, "×");
  root.replaceChildren(text, close);
  lab.on("error", () => {
    root.hidden = lab.error === null;
    text.textContent = lab.error?.message ?? "";
  });
}
