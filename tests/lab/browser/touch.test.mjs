// SPDX-License-Identifier: Apache-2.0
// The page on a phone: what one finger and two of them do.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { close, frames, launch, open, openText, pixelsOf, steps } from "./browser.mjs";

const SCENE = `version: 1
robots:
  - {position: [-4, 0], goal: [4, 0]}
  - {position: [4, 1.5], goal: [-4, 1.5]}
`;

let browser, lab, fingers;
before(async () => {
  browser = await launch();
  lab = await open(browser, { width: 390, height: 844, hasTouch: true, isMobile: true });
  fingers = await lab.page.context().newCDPSession(lab.page); // Playwright itself only taps
});
after(async () => {
  await close(lab);
  await browser.close();
});

const selected = () => lab.page.evaluate(() => window.avoLab.selected);
const touch = (type, ...points) => fingers.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });

/** One path of each finger, from its first point to its last one. */
async function swipe(...paths) {
  const at = (share) => paths.map(([from, to]) => from.map((x, k) => x + share * (to[k] - x)));
  await touch("touchStart", ...at(0));
  for (const share of [0.25, 0.5, 0.75, 1]) await touch("touchMove", ...at(share));
  await touch("touchEnd");
  await frames(lab.page, 2);
}

test("a tap selects, a drag moves a robot, a pinch zooms", async () => {
  await openText(lab.page, SCENE, "touched");
  await frames(lab.page, 2);
  await lab.page.touchscreen.tap(...(await pixelsOf(lab.page, [-4, 0])));
  assert.equal(await selected(), 0);

  const [from, to] = [await pixelsOf(lab.page, [4, 1.5]), await pixelsOf(lab.page, [2, -2])];
  await swipe([from, to]);
  const place = await lab.page.evaluate(() => [...window.avoLab.moment.position.slice(2)]);
  assert.ok(Math.hypot(place[0] - 2, place[1] + 2) < 0.2, `robot 1 is at (${place})`);
  assert.match(await lab.page.evaluate(() => window.avoLab.text), /\[ ?2, -2 ?\]/);

  const meter = async () => (await pixelsOf(lab.page, [1, 0]))[0] - (await pixelsOf(lab.page, [0, 0]))[0];
  const [before, middle] = [await meter(), await pixelsOf(lab.page, [0, 0])];
  const beside = (x) => [middle[0] + x, middle[1]];
  await swipe([beside(-30), beside(-90)], [beside(30), beside(90)]);
  assert.ok(Math.abs((await meter()) / before - 3) < 0.1, "three times as large");
  assert.deepEqual(await lab.page.evaluate(() => [...window.avoLab.moment.position.slice(2)]), place, "and nothing is dragged");
});

test("the comparison fits, and a tap beside it closes it", async () => {
  await steps(lab.page, 10);
  await lab.page.locator("#tabs button", { hasText: /inspect/i }).tap();
  await lab.page.getByRole("button", { name: "Compare methods" }).tap();
  const dialog = lab.page.locator("dialog.insp-compare");
  assert.ok(await dialog.evaluate((shown) => shown.scrollWidth <= shown.clientWidth), "nothing is cut off at its right");
  const { x, y, width } = await dialog.boundingBox();
  await lab.page.touchscreen.tap(x + width / 2, y / 2);
  await dialog.waitFor({ state: "detached" });
  assert.equal(await selected(), 0);
});
