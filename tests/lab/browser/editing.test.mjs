// SPDX-License-Identifier: Apache-2.0
// What a user does with the mouse and the keys, and that going back and forth leads to the same bits.
import assert from "node:assert/strict";
import { after, afterEach, before, beforeEach, test } from "node:test";
import { close, frames, launch, open, openText, pixelsOf, stateHash, steps } from "./browser.mjs";

const SCENE = `version: 1
name: editing
duration: 60
robots:
  - {position: [-8, 0], goal: [8, 0]}    # this comment stays
  - {position: [8, 0.3], goal: [-8, 0]}
  - {position: [0, -6], goal: [0, 6]}
obstacles:
  - {polyline: [[-3, 8], [3, 8]]}
`;

let browser, lab;
before(async () => { browser = await launch(); });
after(() => browser.close());
beforeEach(async () => {
  lab = await open(browser);
  await openText(lab.page, SCENE, "editing");
});
afterEach(() => close(lab));

const pixels = (at) => pixelsOf(lab.page, at);
const placeOf = (robot) => lab.page.evaluate((number) => {
  const { moment } = window.avoLab;
  const k = moment.robot.indexOf(number);
  return [moment.position[2 * k], moment.position[2 * k + 1]];
}, robot);
const textOf = () => lab.page.evaluate(() => window.avoLab.text);

async function drag(from, to) {
  const [a, b] = [await pixels(from), await pixels(to)];
  await lab.page.mouse.move(...a);
  await lab.page.mouse.down();
  await lab.page.mouse.move((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, { steps: 4 });
  await lab.page.mouse.move(...b, { steps: 4 });
  await lab.page.mouse.up();
  await frames(lab.page, 2);
}

const near = (found, wanted, what) =>
  assert.ok(Math.hypot(found[0] - wanted[0], found[1] - wanted[1]) < 0.2, `${what}: [${found}], must be near [${wanted}]`);

async function backAndForth(count) {
  const hash = await stateHash(lab.page);
  await lab.page.evaluate((n) => { for (let k = 0; k < n; ++k) window.avoLab.stepBack(); }, count);
  assert.notEqual(await stateHash(lab.page), hash);
  await steps(lab.page, count);
  assert.equal(await stateHash(lab.page), hash);
}

test("back and forth leads to the same bits", async () => {
  await steps(lab.page, 70);
  await backAndForth(1);
  await backAndForth(45);
  const there = await stateHash(lab.page);
  await lab.page.evaluate(() => { window.avoLab.seek(2); window.avoLab.seek(7); });
  assert.equal(await stateHash(lab.page), there);
});

test("a robot dragged at the start starts there, in the text too, whose comments stay", async () => {
  await drag([-8, 0], [-6, 3]);
  near(await placeOf(0), [-6, 3], "robot 0");
  const text = await textOf();
  assert.match(text, /this comment stays/);
  const [, x, y] = text.match(/position: \[ ?(-?[\d.]+), (-?[\d.]+) ?\], goal: \[ ?8, 0/);
  near([Number(x), Number(y)], [-6, 3], "the text's position");
  await openText(lab.page, text, "again"); // what the text says is what runs
  near(await placeOf(0), [-6, 3], "robot 0 of the text");
});

test("a robot dragged in a run goes on from there, and back and forth over that leads to the same bits", async () => {
  await steps(lab.page, 20);
  const from = await placeOf(2);
  await drag(from, [5, -5]);
  near(await placeOf(2), [5, -5], "robot 2");
  await steps(lab.page, 30);
  assert.ok(Math.hypot(...(await placeOf(2)).map((x, k) => x - [5, -5][k])) > 0.5, "it moves on");
  await backAndForth(10); // not yet over the edit
  const hash = await stateHash(lab.page);
  await lab.page.evaluate(() => { window.avoLab.seek(1); window.avoLab.seek(5); });
  assert.equal(await stateHash(lab.page), hash, "over the edit");
});

test("a goal dragged is where the robot goes", async () => {
  await drag([8, 0], [6, 5]);
  assert.match(await textOf(), /position: \[ ?-8, 0 ?\], goal: \[ ?(5\.9|6)\d*[\d.]*, (4\.9|5)/);
  await steps(lab.page, 250);
  near(await placeOf(0), [6, 5], "robot 0 at its goal");
});

const robotsOf = () => lab.page.evaluate(() => [...window.avoLab.moment.robot]);
const wallsOf = () => lab.page.evaluate(() => window.avoLab.info.walls.map(({ a, b }) => [...a, ...b].map(Math.round)));

/** With the tool of that key. */
async function draw(key, from, to) {
  await lab.page.keyboard.press(key);
  await drag(from, to);
}

async function erase(at) {
  await lab.page.keyboard.press("4");
  await lab.page.mouse.click(...(await pixels(at)));
  await frames(lab.page, 2);
}

test("what is added and removed by hand takes part", async () => {
  await draw("2", [-6, -5], [6, -5]);
  assert.deepEqual(await robotsOf(), [0, 1, 2, 3]);
  await draw("3", [-2, -3], [2, -3]);
  assert.deepEqual(await wallsOf(), [[-3, 8, 3, 8], [-2, -3, 2, -3]]);
  await draw("1", [2, -3], [4, -2]);
  assert.deepEqual(await wallsOf(), [[-3, 8, 3, 8], [-2, -3, 4, -2]], "the end alone was dragged");
  const text = await textOf();
  assert.match(text, /this comment stays/);
  await openText(lab.page, text, "again"); // the text has it all
  assert.deepEqual([await robotsOf(), (await wallsOf()).length], [[0, 1, 2, 3], 2]);
  await steps(lab.page, 40);
  assert.ok((await placeOf(3))[0] > -2, "the robot that was added goes its way");
  assert.ok((await placeOf(2))[0] < -2, "robot 2 goes around the wall");

  await erase([1, -2.5]);
  assert.deepEqual(await wallsOf(), [[-3, 8, 3, 8]]);
  await draw("2", [-6, 5], [6, 5]);
  await erase(await placeOf(3));
  assert.deepEqual(await robotsOf(), [0, 1, 2, 4]);
  await lab.page.evaluate(() => window.avoLab.select(1));
  await lab.page.keyboard.press("Delete");
  assert.deepEqual(await robotsOf(), [0, 2, 4]);
  await steps(lab.page, 40);
  assert.ok((await placeOf(4))[0] > -2, "so does one that was added later");
  await backAndForth(50);
});

test("Escape gives up what is drawn or dragged, and nothing else", async () => {
  await lab.page.evaluate(() => window.avoLab.select(1));
  for (const [key, from, to] of [["1", [-8, 0], [-6, 3]], ["2", [-6, -5], [6, -5]], ["3", [-2, -3], [2, -3]]]) {
    await lab.page.keyboard.press(key);
    await lab.page.mouse.move(...(await pixels(from)));
    await lab.page.mouse.down();
    await lab.page.mouse.move(...(await pixels(to)), { steps: 3 });
    await lab.page.keyboard.press("Escape");
    await lab.page.mouse.up();
    assert.equal(await textOf(), SCENE, `tool ${key}`);
  }
  assert.equal(await lab.page.evaluate(() => window.avoLab.selected), 1);
});

test("sliders change the text, and the run goes on from where it is", async () => {
  await steps(lab.page, 15);
  const before = await placeOf(0);
  await lab.page.evaluate(() => window.avoLab.set("time_horizon", 5));
  assert.match(await textOf(), /^time_horizon: 5$/m);
  assert.equal(await lab.page.evaluate(() => window.avoLab.info.options.time_horizon), 5);
  assert.deepEqual(await placeOf(0), before);
  await lab.page.evaluate(() => window.avoLab.set("method", "orca"));
  assert.equal(await lab.page.evaluate(() => window.avoLab.info.options.method), "orca");
  await steps(lab.page, 5);
});

test("what was typed gives way to another scene, and comes back under its own name", async () => {
  const typed = SCENE.replace("duration: 60", "duration: 30");
  const field = lab.page.locator(".editor-text");
  const back = lab.page.getByRole("button", { name: "Back to your text of editing" });
  await field.fill(typed);
  await lab.page.locator("#scenes").click();
  await lab.page.locator(".scene-card", { hasText: "office" }).first().click();
  const text = await textOf();
  assert.equal(await field.inputValue(), text);
  await openText(lab.page, "version: 1\n", "refused"); // has no robots
  await lab.page.evaluate(() => window.avoLab.set("time_horizon", 4)); // which is about the office
  assert.equal(await field.inputValue(), "version: 1\n");
  await back.click();
  assert.equal(await field.inputValue(), typed);
  assert.equal(await back.isVisible(), false);
  assert.match(await lab.page.locator(".editor-says").innerText(), /The text of editing, not applied yet/);
  await field.press("Control+Enter");
  assert.deepEqual(await lab.page.evaluate(() => [window.avoLab.name, window.avoLab.text]), ["editing", typed]);
});

test("keys: space plays, the arrows step and go on from any speed to the next one", async () => {
  await lab.page.locator("canvas").first().focus().catch(() => {});
  await lab.page.keyboard.press("ArrowRight");
  await lab.page.keyboard.press("ArrowRight");
  assert.equal(await lab.page.evaluate(() => window.avoLab.moment.steps), 2);
  await lab.page.keyboard.press("ArrowLeft");
  assert.equal(await lab.page.evaluate(() => window.avoLab.moment.steps), 1);
  await lab.page.keyboard.press(" ");
  await lab.page.waitForFunction(() => window.avoLab.moment.steps > 3);
  await lab.page.keyboard.press(" ");
  assert.equal(await lab.page.evaluate(() => window.avoLab.playing), false);
  const speed = () => lab.page.locator("select.speed option:checked").innerText();
  for (const [key, next] of [["ArrowUp", "4×"], ["ArrowDown", "2×"]]) {
    await lab.page.evaluate(() => { window.avoLab.speed = 3; });
    assert.equal(await speed(), "3×");
    await lab.page.keyboard.press(key);
    assert.equal(await speed(), next);
  }
});

test("a dialog that the mouse opened gives the keys back", async () => {
  for (const button of ["#help", "#scenes"]) {
    await lab.page.locator(button).click();
    await lab.page.keyboard.press("Escape");
    await lab.page.waitForFunction(() => document.querySelector("dialog") === null);
    await lab.page.keyboard.press(" ");
    assert.equal(await lab.page.evaluate(() => window.avoLab.playing), true, button);
    await lab.page.keyboard.press(" ");
  }
});

test("a robot that is clicked is inspected", async () => {
  await steps(lab.page, 30);
  const at = await placeOf(1);
  await lab.page.mouse.click(...(await pixels(at)));
  assert.equal(await lab.page.evaluate(() => window.avoLab.selected), 1);
  await frames(lab.page, 3);
  assert.match(await lab.page.locator("#inspector").innerText(), /robot 1/i);
});
