// SPDX-License-Identifier: Apache-2.0
// The tour: a card beside the lab, which stays usable all the time. Arrows turn pages, Escape leaves.
import { digits, element } from "../frame/elements.ts";
import type { Lab } from "../run/lab.ts";
import { TOUR, type Try } from "./tour_steps.ts";

/** Shows the tour in `place`; a tour that is open already begins again. */
export function openTour(lab: Lab, place: HTMLElement, step = 0): void {
  place.querySelector(".tour")?.remove();
  const card = element("section", { class: "tour", role: "dialog", "aria-label": "a tour of the paper", tabindex: -1 });
  const from = document.activeElement as HTMLElement | null;
  const leave = (): void => {
    card.remove();
    from?.focus();
  };
  let at = step;
  const go = (next: number): void => {
    if (next < 0) return;
    if (next >= TOUR.length) return leave();
    at = next;
    begin(lab, at);
    card.replaceChildren(...pageOf(lab, at, go, leave));
    card.focus();
  };
  card.addEventListener("keydown", (event) => {
    if (event.target instanceof HTMLInputElement) return;
    if (event.key === "Escape") leave();
    else if (event.key === "ArrowRight" || event.key === "PageDown") go(Math.min(at + 1, TOUR.length - 1));
    else if (event.key === "ArrowLeft" || event.key === "PageUp") go(at - 1);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  place.append(card);
  go(at);
}

/** Shows the scene, the robot and the moment of the step. */
function begin(lab: Lab, at: number): void {
  const step = TOUR[at]!;
  const text = step.scene(lab.library);
  lab.openText(text, /^name: (.*)$/m.exec(text)?.[1] ?? step.title, {});
  lab.speed = step.speed;
  lab.select(step.robot);
  lab.seek(step.time);
}

function pageOf(lab: Lab, at: number, go: (step: number) => void, leave: () => void): Node[] {
  const step = TOUR[at]!;
  const button = (label: string, act: () => void, disabled = false): HTMLElement =>
    element("button", { type: "button", onclick: act, disabled }, label);
  const dots = TOUR.map(({ title }, k) =>
    element("button", { type: "button", class: "tour-dot", title, "aria-label": `step ${k + 1}: ${title}`, "aria-current": k === at ? "step" : "false", onclick: () => go(k) }, String(k + 1)));
  const isLast = at === TOUR.length - 1;
  return [
    element("header", { class: "tour-head" }, element("nav", { class: "tour-dots" }, ...dots),
      element("button", { type: "button", class: "insp-close", "aria-label": "leave the tour", onclick: leave }, "×")),
    element("h2", {}, step.title),
    ...step.paragraphs.map((text) => element("p", {}, text)),
    element("h3", {}, "Look"), element("ul", {}, ...step.look.map((text) => element("li", {}, text))),
    element("h3", {}, "Try"), ...step.tries.map((what) => control(lab, what)),
    element("p", { class: "tour-reference" }, step.reference),
    element("footer", { class: "tour-foot" },
      button("Back", () => go(at - 1), at === 0), button("Play", () => lab.play()), button("Again", () => go(at)),
      isLast ? button("To the lab", leave) : button(`Next: ${TOUR[at + 1]!.title}`, () => go(at + 1))),
  ];
}

function control(lab: Lab, what: Try): HTMLElement {
  if (what.words) {
    const buttons = what.words.map((word) => {
      const button = element("button", { type: "button" }, word.replaceAll("_", " "));
      button.addEventListener("click", () => {
        lab.set(what.path, word);
        press();
      });
      return button;
    });
    const press = (): void => buttons.forEach((button, k) =>
      button.setAttribute("aria-pressed", String(lab.info.options[what.path] === what.words![k])));
    press();
    return element("div", { class: "tour-try" }, element("span", {}, what.label), ...buttons);
  }
  const { least, most, step, unit, start } = what.range!;
  const value = element("output", {}, `${digits(start)} ${unit}`);
  const slider = element("input", { type: "range", min: least, max: most, step, value: start });
  slider.addEventListener("input", () => {
    value.textContent = `${digits(Number(slider.value))} ${unit}`;
    lab.set(what.path, Number(slider.value));
  });
  return element("label", { class: "tour-try" }, element("span", {}, what.label), slider, value);
}
