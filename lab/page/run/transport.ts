// SPDX-License-Identifier: Apache-2.0
// Play, step, go back, and the present time of the run.
import { digits, element } from "../frame/elements.ts";
import { icon } from "../frame/icons.ts";
import type { PageLab } from "./make_lab.ts";

const FIRST_SPAN = 60;  // s, of the slider
export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 8, 16, 64];

export function mountTransport(lab: PageLab, root: HTMLElement): void {
  const button = (name: string, picture: string, action: () => void) =>
    element("button", { type: "button", class: "icon-button", title: name, "aria-label": name, onclick: action }, icon(picture));
  const play = button("play (space)", "play", () => (lab.playing ? lab.pause() : lab.play()));
  play.classList.add("play");
  const back = button("one step back (←)", "back", () => lab.stepBack());
  const slider = element("input", { type: "range", min: 0, max: 1, step: "any", value: 0, class: "timeline", "aria-label": "time in s" });
  slider.addEventListener("input", () => lab.seek(Number(slider.value)));
  const time = element("output", { class: "time" });
  const speed = element("select", { class: "speed", "aria-label": "speed: simulated seconds a second", title: "simulated seconds a second" },
    ...SPEEDS.map((value) => element("option", { value }, `${value}×`)));
  const between = element("option", {});  // for a speed that is not in the list
  speed.addEventListener("change", () => { lab.speed = Number(speed.value); });
  root.replaceChildren(
    element("div", { class: "buttons" }, button("restart (r)", "restart", () => lab.restart()), back, play,
      button("one step (→)", "forward", () => lab.stepForward())),
    time, slider, speed);

  const refresh = () => {
    const { moment, past } = lab;
    const end = shownEnd(lab);
    slider.max = String(end);
    slider.value = String(moment.time);
    const done = (t: number) => `${(100 * Math.min(1, t / (end || 1))).toFixed(2)}%`;
    slider.style.setProperty("--now", done(moment.time));
    slider.style.setProperty("--known", done(past.times[past.size - 1] ?? 0));
    slider.setAttribute("aria-valuetext", `${digits(moment.time, 1)} seconds`);
    time.replaceChildren(element("b", {}, digits(moment.time, 1)), " s");
    back.disabled = moment.steps === 0;
  };
  const playing = () => {
    const name = lab.playing ? "pause (space)" : "play (space)";
    play.replaceChildren(icon(lab.playing ? "pause" : "play"));
    play.title = name;
    play.setAttribute("aria-label", name);
    between.remove();
    if (!SPEEDS.includes(lab.speed)) {
      between.value = String(lab.speed);
      between.textContent = `${lab.speed}×`;
      speed.prepend(between);
    }
    speed.value = String(lab.speed);
  };
  lab.on("moment", refresh);
  lab.on("past", refresh);
  lab.on("scene", refresh);
  lab.on("playing", playing);
  refresh();
  playing();
}

/** s: a recording's whole duration, or for a run the known part and some more. It grows in steps, so that the slider
 * does not slide all the time. */
function shownEnd({ live, past, end }: PageLab): number {
  if (!live) return end;
  const known = past.times[past.size - 1] ?? 0;
  return Math.min(end, FIRST_SPAN * 2 ** Math.max(0, Math.ceil(Math.log2(known / (0.9 * FIRST_SPAN)))));
}
