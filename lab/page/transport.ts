// SPDX-License-Identifier: Apache-2.0
// Play, step, go back, and where in time the run is; beside that, how it goes.
import { digits, element } from "./elements.ts";
import { icon } from "./icons.ts";
import type { PageLab } from "./make_lab.ts";

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
  speed.addEventListener("change", () => { lab.speed = Number(speed.value); });
  const figures = element("div", { class: "figures" });
  root.replaceChildren(
    element("div", { class: "buttons" }, button("restart (r)", "restart", () => lab.restart()), back, play,
      button("one step (→)", "forward", () => lab.stepForward())),
    time, slider, speed, figures);

  const refresh = () => {
    const { moment, past, end } = lab;
    slider.max = String(end);
    slider.value = String(moment.time);
    const done = (t: number) => `${(100 * Math.min(1, t / (end || 1))).toFixed(2)}%`;
    slider.style.setProperty("--now", done(moment.time));
    slider.style.setProperty("--known", done(past.times[past.size - 1] ?? 0));
    slider.setAttribute("aria-valuetext", `${digits(moment.time, 1)} seconds`);
    time.replaceChildren(element("b", {}, digits(moment.time, 1)), ` / ${digits(end, 0)} s`);
    back.disabled = moment.steps === 0;
    figures.replaceChildren(...figuresOf(lab));
  };
  const playing = () => {
    const name = lab.playing ? "pause (space)" : "play (space)";
    play.replaceChildren(icon(lab.playing ? "pause" : "play"));
    play.title = play.ariaLabel = name;
    speed.value = String(lab.speed);
  };
  lab.on("moment", refresh);
  lab.on("scene", refresh);
  lab.on("playing", playing);
  refresh();
  playing();
}

/** Arrivals, contacts and the least clearance so far, with units. */
function figuresOf(lab: PageLab): HTMLElement[] {
  const { moment, past, contacts } = lab;
  const figure = (label: string, value: string, bad = false) =>
    element("span", { class: bad ? "figure figure-bad" : "figure" }, element("small", {}, label), element("b", {}, value));
  const arrived = moment.arrived.reduce((sum, there) => sum + there, 0);
  const touched = contacts.filter((contact) => contact.time <= moment.time + 1e-9).length;
  const now = past.clearance[Math.min(moment.steps, past.size - 1)] ?? Infinity;
  return [
    figure("robots", String(moment.robot.length)),
    figure("arrived", String(arrived)),
    figure("contacts", String(touched), touched > 0),
    figure("least gap", `${digits(now)} m`, now < -1e-9),
  ];
}
