// SPDX-License-Identifier: Apache-2.0
// The page with a scene of space: the view turns, a click finds a ball, the inspector has the words of avo explain, and
// recordings open.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { close, frames, launch, open, openText, pixelsOf, steps } from "./browser.mjs";

const DRONES = `version: 1
space: 3
groups:
  - {count: 20, sphere: {radius: 6}, goal: antipodal, jitter: 0.2, downwash: 1}
obstacles: [{floor: -8}, {box: {min: [-1, -1, -1], max: [1, 1, 1]}}]
`;
const TOUCHING = `version: 1
space: 3
certificate: none
time_horizon: 0.1
robots:
  - {position: [-3, 0, 1], goal: [3, 0, 1]}
  - {position: [3, 0.1, 1.1], goal: [-3, 0, 1]}
`;

let browser, lab, folder;
const inFolder = (name) => join(folder, name);
const avo = (...words) => execFileSync(process.env.AVO_COMMAND, words, { encoding: "utf8", cwd: folder });
before(async () => {
  browser = await launch();
  lab = await open(browser);
  folder = mkdtempSync(join(tmpdir(), "avo-lab-"));
  writeFileSync(inFolder("drones.yaml"), DRONES);
  writeFileSync(inFolder("touching.yaml"), TOUCHING);
});
after(async () => {
  rmSync(folder, { recursive: true });
  await close(lab);
  await browser.close();
});

const inPage = (work, argument) => lab.page.evaluate(work, argument);
const placeOf = (robot) => inPage((i) => [...window.avoLab.moment.position.slice(3 * i, 3 * i + 3)], robot);
const apart = ([ax, ay], [bx, by]) => Math.hypot(ax - bx, ay - by);

test("a drag turns the view about the middle, v shows the plan and the elevation, and nothing else changes", async () => {
  await openText(lab.page, DRONES, "drones.yaml");
  await steps(lab.page, 12);
  const hash = await inPage(() => String(window.avoLab.live.stateHash()));
  const [middle, side] = [await pixelsOf(lab.page, [0, 0, -1]), await pixelsOf(lab.page, [5, 0, -1])];
  await lab.page.mouse.move(middle[0] + 240, middle[1] - 20);
  await lab.page.mouse.down();
  await lab.page.mouse.move(middle[0] + 150, middle[1] + 10, { steps: 3 });
  await lab.page.mouse.up();
  assert.ok(apart(await pixelsOf(lab.page, [0, 0, -1]), middle) < 12, "the middle stays");
  assert.ok(apart(await pixelsOf(lab.page, [5, 0, -1]), side) > 20, "the side moves");
  const shape = async () => {
    const [o, x, y, z] = await Promise.all([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map((place) => pixelsOf(lab.page, place)));
    return [x, y, z].map((axis) => [Math.sign(Math.round(axis[0] - o[0])), Math.sign(Math.round(o[1] - axis[1]))].join());
  };
  await lab.page.keyboard.press("v");  // from aside
  await lab.page.keyboard.press("v");
  assert.deepEqual(await shape(), ["1,0", "0,1", "0,0"], "the plan");
  await lab.page.keyboard.press("v");
  assert.deepEqual(await shape(), ["1,0", "0,0", "0,1"], "the elevation");
  await lab.page.keyboard.press("v");
  assert.equal(await inPage(() => String(window.avoLab.live.stateHash())), hash);
});

test("a click selects the ball in front, and the inspector has the words of avo explain", async () => {
  const robot = await inPage(() => {  // the nearest to the viewer of the plan
    const { position, robot } = window.avoLab.moment;
    return [...robot].sort((a, b) => position[3 * b + 2] - position[3 * a + 2])[0];
  });
  await lab.page.keyboard.press("v");
  await frames(lab.page, 2);
  await lab.page.mouse.click(...(await pixelsOf(lab.page, await placeOf(robot))));
  assert.equal(await inPage(() => window.avoLab.selected), robot);
  await frames(lab.page, 3);
  const told = JSON.parse(avo("explain", "drones.yaml", "--robot", String(robot), "--time", "1.2", "--json"));
  const shown = await lab.page.locator("#inspector").innerText();
  assert.ok(shown.includes(told.sentence), `${shown}\nhas no: ${told.sentence}`);
  assert.match(shown, /The cut through v in the plane of p and v of robot \d+/);
  assert.ok(!shown.includes("Compare methods"));
  const other = told.neighbors[3].neighbor;
  await lab.page.locator(`tr[data-name="robots.${other}"]`).hover();
  await lab.page.getByText(`in the plane of p and v of robot ${other}.`).waitFor();
  assert.ok(await lab.page.getByRole("button", { name: "Obstacles" }).isVisible());
});

test("back and forth leads to the bits of the command line; a change begins anew", async () => {
  avo("run", "drones.yaml", "--duration", "3", "-q", "--record", "drones.csv");
  await inPage(() => window.avoLab.seek(3));
  await lab.page.waitForFunction(() => window.avoLab.moment.time > 3 - 1e-6);
  const told = readFileSync(inFolder("drones.csv"), "utf8").trim().split("\n").slice(-20).flatMap((row) => row.split(",").slice(2, 5).map(Number));
  const places = () => inPage(() => [...window.avoLab.moment.position]);
  assert.deepEqual(await places(), told);
  await inPage(() => window.avoLab.seek(0.7));
  assert.notDeepEqual(await places(), told);
  await inPage(() => window.avoLab.seek(3));
  assert.deepEqual(await places(), told);
  await lab.page.keyboard.press("2");  // to add a robot
  assert.match(await inPage(() => window.avoLab.error.message), /in the text of the scene/);
  await inPage(() => window.avoLab.set("time_horizon", 2));
  assert.deepEqual(await inPage(() => [window.avoLab.moment.steps, window.avoLab.info.options.time_horizon, window.avoLab.error]), [0, 2, null]);
});

test("the list of scenes has those of space", async () => {
  await lab.page.keyboard.press("s");
  await lab.page.keyboard.type("window space");
  await lab.page.keyboard.press("Enter");
  const told = await inPage(() => [window.avoLab.name, window.avoLab.error?.message, window.avoLab.info.dimensions, window.avoLab.moment.robot.length]);
  assert.deepEqual(told, ["window", undefined, 3, 50]);
});

test("on a phone one finger turns the view, and two zoom", async () => {
  const phone = await open(browser, { width: 390, height: 844, hasTouch: true, isMobile: true });
  await openText(phone.page, DRONES, "drones.yaml");
  await frames(phone.page, 2);
  const fingers = await phone.page.context().newCDPSession(phone.page);
  const touch = (type, ...points) => fingers.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const swipe = async (...paths) => {
    const at = (share) => paths.map(([from, to]) => from.map((x, k) => x + share * (to[k] - x)));
    await touch("touchStart", ...at(0));
    for (const share of [0.25, 0.5, 0.75, 1]) await touch("touchMove", ...at(share));
    await touch("touchEnd");
    await frames(phone.page, 2);
  };
  const height = async () => apart(await pixelsOf(phone.page, [0, 0, 0]), await pixelsOf(phone.page, [0, 0, 1]));
  const [middle, before] = [await pixelsOf(phone.page, [0, 0, -1]), await height()];
  const beside = (x, y = 0) => [middle[0] + x, middle[1] + y];
  await swipe([beside(-30), beside(-60)], [beside(30), beside(60)]);
  assert.ok(Math.abs((await height()) / before - 2) < 0.1, "twice as large");
  const side = await pixelsOf(phone.page, [3, 0, -1]);
  await swipe([beside(60, 60), beside(-30, 60)]);
  assert.ok(apart(await pixelsOf(phone.page, [3, 0, -1]), side) > 10, "it turned");
  assert.ok(Math.abs((await height()) / before - 2) < 0.1, "about the vertical");
  await close(phone);
});

const openFile = (name) => inPage(([called, base64]) =>
  window.avoLab.openFile(called, Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))), [name, readFileSync(inFolder(name)).toString("base64")]);

test("recordings open, as HDF5 and as CSV, and tell contacts", async () => {
  avo("run", "touching.yaml", "--duration", "4", "-q", "--record", "touching.h5");
  avo("run", "touching.yaml", "--duration", "4", "-q", "--record", "touching.csv");
  for (const name of ["touching.h5", "touching.csv"]) {
    await openFile(name);
    assert.equal(await inPage(() => window.avoLab.error?.message), undefined);
    assert.equal(await inPage(() => window.avoLab.info.dimensions), 3);
    await lab.page.waitForFunction(() => window.avoLab.past.size === 41);
    const [contact, ...others] = await inPage(() => window.avoLab.contacts.map((one) => ({ ...one })));
    assert.deepEqual([contact.a, contact.b, others], ["robots.0", "robots.1", []], name);
    assert.ok(contact.depth > 0 && Math.abs(contact.z - 1) < 0.3, JSON.stringify(contact));
  }
  await openFile("touching.h5");
  await inPage(() => window.avoLab.select(0));
  await frames(lab.page, 3);
  assert.match(await lab.page.locator("#inspector").innerText(), /Robot 0 /);
});

test("avo lab makes a page of a scene of space, and of a recording with its scene", async () => {
  avo("lab", "drones.yaml", "--no-open", "--set", "seed=7");
  avo("lab", "touching.csv", "--scene", "touching.yaml", "--out", "recorded.html", "--no-open");
  for (const [name, robots, live] of [["drones.html", 20, true], ["recorded.html", 2, false]]) {
    const made = await open(browser, { path: inFolder(name) });
    const told = await made.page.evaluate(() => [window.avoLab.error, window.avoLab.moment.robot.length, window.avoLab.live !== null, window.avoLab.info.dimensions]);
    assert.deepEqual(told, [null, robots, live, 3]);
    await close(made);
  }
});
