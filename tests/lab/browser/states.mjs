// SPDX-License-Identifier: Apache-2.0
// Eleven states of the page that a person has looked at, and how to get to each of them.
import { readFileSync } from "node:fs";
import { frames, openText, steps } from "./browser.mjs";

const builtin = (name, seconds) => async (page) => {
  const text = await page.evaluate((scene) => window.avoLab.library.builtinText(scene), name);
  await openText(page, text, name);
  await steps(page, Math.round(seconds * 10));
};
const then = (...parts) => async (page) => {
  for (const part of parts) await part(page);
};
const select = (robot) => (page) => page.evaluate((number) => window.avoLab.select(number), robot);

const CROWD = `version: 1
name: a crowd by another method
method: velocity_obstacle
groups:
  - number: 40
    placement: {circle: {min_radius: 12}}
    goals: antipodal
    jitter: 0.3
`;

const WINDOW = readFileSync(new URL("../../../examples/space/window.yaml", import.meta.url), "utf8");

/** name, what open() takes, and what leads there from the first picture. */
export const STATES = [
  { name: "first", go: async () => {} },
  { name: "circle-100-dark", context: { colorScheme: "dark" }, go: builtin("circle-100", 18) },
  { name: "inspector", go: then(builtin("circle-10", 8), select(3)) },
  { name: "doorway-inspector-dark", context: { colorScheme: "dark" }, go: then(builtin("doorway", 10), select(4)) },
  { name: "office", go: builtin("office", 12) },
  { name: "mixed-yard", go: builtin("mixed-yard", 15) },
  { name: "planes-12", go: then(builtin("planes-12", 14), select(0)) },
  { name: "space", go: then((page) => openText(page, WINDOW, "window"), (page) => steps(page, 80), select(3)) },
  { name: "collisions", go: then((page) => openText(page, CROWD, "crowd"), (page) => steps(page, 90)) },
  { name: "error", go: (page) => openText(page, "version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], radius: -1}\n", "bad") },
  { name: "phone", width: 390, height: 844, context: { hasTouch: true, isMobile: true }, go: then(builtin("circle-20", 6), select(2)) },
];

export async function picture(page, state) {
  await state.go(page);
  await page.evaluate(() => document.fonts.ready);
  await frames(page, 20); // until what moves on its own has come to rest
  return page.screenshot({ animations: "disabled", caret: "hide" });
}
