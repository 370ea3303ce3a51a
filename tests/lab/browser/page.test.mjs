// SPDX-License-Identifier: Apache-2.0
// The page as a whole: its size, what the inspector tells, links, files that are saved, and recordings.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { after, before, test } from "node:test";
import { close, frames, launch, open, openText, stateHash, steps } from "./browser.mjs";

const AVO = process.env.AVO_COMMAND;
const avo = (...words) => execFileSync(AVO, words, { encoding: "utf8" });
let browser, folder;
before(async () => {
  browser = await launch();
  folder = mkdtempSync(join(tmpdir(), "avo-lab-"));
});
after(async () => {
  rmSync(folder, { recursive: true });
  await browser.close();
});

const builtinText = (lab, name) => lab.page.evaluate((scene) => window.avoLab.library.builtinText(scene), name);

async function withBuiltin(name, count, options = {}) {
  const lab = await open(browser, options);
  await openText(lab.page, await builtinText(lab, name), name);
  await steps(lab.page, count);
  return lab;
}

test("it is one file of 2 MB at most", () => {
  assert.ok(statSync(process.env.AVO_LAB_PAGE).size <= 2e6, `${statSync(process.env.AVO_LAB_PAGE).size} bytes`);
});

test("what the inspector shows is what avo explain says", async () => {
  const lab = await withBuiltin("doorway", 60);
  for (const robot of [0, 7, 13, 19]) {
    await lab.page.evaluate((number) => window.avoLab.select(number), robot);
    await frames(lab.page, 3);
    const native = avo("explain", "doorway", "--robot", String(robot), "--time", "6", "--json");
    assert.equal(await lab.page.evaluate((number) => window.avoLab.live.explain(number), robot), native);
    const decision = JSON.parse(native);
    const shown = await lab.page.locator("#inspector").innerText();
    assert.match(shown, new RegExp(`Robot ${robot}\\b`));
    assert.match(shown, new RegExp(decision.status.replace("_", "[_ ]"), "i"));
    assert.match(shown, new RegExp(`\\(${decision.state}\\)`));
  }
  await close(lab);
});

/** What "Copy link" puts behind the address. */
async function linkedBy(lab) {
  await lab.page.getByRole("button", { name: "Copy link" }).click();
  await lab.page.waitForFunction(() => location.hash.startsWith("#scene="));
  return lab.page.evaluate(() => location.hash);
}

test("a link holds the scene", async () => {
  const lab = await withBuiltin("office", 10);
  const hash = await linkedBy(lab);
  const text = await lab.page.evaluate(() => window.avoLab.text);
  await close(lab);
  const other = await open(browser, { hash });
  assert.equal(await other.page.evaluate(() => window.avoLab.text), text);
  await close(other);
  const damaged = await open(browser, { hash: hash.slice(0, 60) });
  assert.ok(await damaged.page.evaluate(() => window.avoLab.error?.message), "a link that was cut off says so");
  await close(damaged);
});

test("another link in the same tab is opened", async () => {
  const lab = await withBuiltin("office", 1);
  const office = await linkedBy(lab);
  await lab.page.evaluate(() => window.avoLab.edit((simulation) => simulation.setGoal(0, 1, 1)));
  await linkedBy(lab);
  await lab.page.getByText("without what was changed on the map alone").waitFor();
  await openText(lab.page, await builtinText(lab, "circle-10"), "circle-10");
  assert.equal(await lab.page.evaluate(() => location.hash), "", "the address names nothing that is not shown");
  await lab.page.evaluate(() => { location.hash = "elsewhere"; });
  assert.equal(await lab.page.evaluate(() => window.avoLab.name), "circle-10");
  await lab.page.evaluate((hash) => { location.hash = hash; }, office);
  await lab.page.waitForFunction(() => window.avoLab.name === "office");
  await lab.page.evaluate(() => { location.hash = "#scene=damaged"; });
  await lab.page.waitForFunction(() => /damaged or cut off/.test(window.avoLab.error?.message));
  assert.equal(await lab.page.evaluate(() => window.avoLab.name), "office");
  await close(lab);
});

async function saved(lab, label) {
  const [download] = await Promise.all([
    lab.page.waitForEvent("download"),
    lab.page.locator("summary", { hasText: "Save as" }).click().then(() => lab.page.locator("button", { hasText: label }).click()),
  ]);
  const path = join(folder, download.suggestedFilename());
  await download.saveAs(path);
  return path;
}

test("files that are saved are what other programs read", async () => {
  const lab = await withBuiltin("circle-10", 40);
  const yaml = await saved(lab, "Scene (YAML)");
  assert.match(avo("validate", yaml), /10 robots/);
  const csv = await saved(lab, "States so far (CSV)");
  const native = join(folder, "native.csv");
  avo("run", "circle-10", "--duration", "4", "--record", native, "-q");
  assert.equal(readFileSync(csv, "utf8"), readFileSync(native, "utf8"));
  const hash = await stateHash(lab.page);
  assert.deepEqual([...readFileSync(await saved(lab, "Picture (PNG)")).subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
  assert.equal(readFileSync(await saved(lab, "Animation (GIF)")).subarray(0, 6).toString(), "GIF89a");
  assert.deepEqual([...readFileSync(await saved(lab, "Film (WebM)")).subarray(0, 4)], [0x1a, 0x45, 0xdf, 0xa3]);
  assert.equal(await stateHash(lab.page), hash, "and the run is where it was");
  await close(lab);
});

async function openRecording(lab, path) {
  await lab.page.evaluate(
    ([name, base64]) => window.avoLab.openFile(name, Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))),
    [basename(path), readFileSync(path).toString("base64")],
  );
}

test("recordings play, as HDF5 and as CSV", async () => {
  const lab = await open(browser);
  for (const name of ["run.h5", "run.csv"]) {
    const path = join(folder, name);
    avo("run", "circle-10", "--duration", "8", "--record", path, "-q");
    if (name.endsWith("csv")) await openText(lab.page, avo("scenes", "circle-10"), "circle-10");
    await openRecording(lab, path);
    assert.equal(await lab.page.evaluate(() => window.avoLab.error?.message ?? null), null);
    await lab.page.evaluate(() => window.avoLab.seek(8));
    await lab.page.waitForFunction(() => Math.abs(window.avoLab.moment.time - 8) < 1e-6);
    const rows = avo("run", "circle-10", "--duration", "8", "--record", "-", "-q").trim().split("\n").slice(-10);
    const positions = rows.flatMap((row) => row.split(",").slice(2, 4).map(Number));
    assert.deepEqual(await lab.page.evaluate(() => [...window.avoLab.moment.position]), positions, name);
  }
  await close(lab);
});

test("a recording does not change, and says so", async () => {
  const lab = await open(browser);
  const path = join(folder, "fixed.h5");
  avo("run", "circle-10", "--duration", "4", "--record", path, "-q");
  await openRecording(lab, path);
  await lab.page.evaluate(() => window.avoLab.select(3));
  const says = async (what, act) => {
    await act();
    assert.match(await lab.page.evaluate(() => window.avoLab.error?.message ?? ""), /recording does not change/, what);
    await lab.page.evaluate(() => window.avoLab.stepForward());
    assert.equal(await lab.page.evaluate(() => window.avoLab.error), null);
  };
  for (const key of ["Delete", "2", "3", "4"]) await says(key, () => lab.page.keyboard.press(key));
  assert.equal(await lab.page.evaluate(() => window.avoLab.selected), 3);
  await says("a robot dragged", async () => {
    const [x, y] = await lab.page.evaluate(() => window.avoLab.toScreen([...window.avoLab.moment.position.slice(6, 8)]));
    await lab.page.mouse.move(x, y);
    await lab.page.mouse.down();
    await lab.page.mouse.move(x + 40, y + 40, { steps: 4 });
    await lab.page.mouse.up();
  });
  await close(lab);
});

test("a recording is saved as it was recorded, without a scene where it has none", async () => {
  const lab = await open(browser);
  const record = (...words) => avo("run", "mixed-yard", "--duration", "4", "--every", "5", ...words, "-q");
  const native = record("--record", "-");
  assert.match(native, /^time,robot,x,y,vx,vy,heading,speed,every\n/);
  for (const name of ["thin.h5", "thin.csv"]) {
    record("--record", join(folder, name));
    await openRecording(lab, join(folder, name));
    assert.equal(readFileSync(await saved(lab, "States so far (CSV)"), "utf8"), native, name);
  }
  await lab.page.locator("summary", { hasText: "Save as" }).click();
  await lab.page.locator("button", { hasText: "Scene (YAML)" }).click();
  await lab.page.locator(".tool-error", { hasText: "does not hold its scene" }).waitFor();
  await close(lab);
});

test("what the command line puts into the page is opened", async () => {
  const html = readFileSync(process.env.AVO_LAB_PAGE, "utf8");
  const empty = '<script id="avo-input" type="application/json">null</script>';
  assert.ok(html.includes(empty));
  const input = {
    kind: "scene", name: "given", yaml: "version: 1\nname: '</script>'\nrobots:\n  - {position: [0, 0], goal: [9, 0]}\n",
    overrides: ["robots.0.radius=0.25"], files: [], start_at_rest: false, limit_speed: false,
  };
  const path = join(folder, "given.html");
  writeFileSync(path, html.replace(empty, () => empty.replace("null", () => JSON.stringify(input).replaceAll("<", "\\u003c"))));
  const lab = await open(browser, { path });
  assert.deepEqual(await lab.page.evaluate(() => [window.avoLab.info.name, window.avoLab.info.robots[0].radius]), ["</script>", 0.25]);
  await openText(lab.page, await builtinText(lab, "circle-10"), "circle-10");
  const hash = await linkedBy(lab);
  await close(lab);
  const linked = await open(browser, { path, hash }); // a link of this page shows what was linked
  assert.equal(await linked.page.evaluate(() => window.avoLab.name), "circle-10");
  await close(linked);
  const damaged = await open(browser, { path, hash: hash.slice(0, 60) });
  assert.deepEqual(await damaged.page.evaluate(() => [window.avoLab.name, window.avoLab.error !== null]), ["given", true]);
  await close(damaged);
});

test("on a small phone everything is at hand, and nothing covers the other", async () => {
  const lab = await withBuiltin("circle-10", 20, { width: 320, height: 568, hasTouch: true, isMobile: true });
  const box = (selector) => lab.page.locator(selector).boundingBox();
  const apart = async (one, other) => {
    const [a, b] = [await box(one), await box(other)];
    assert.ok(a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y, `${one}, ${other}`);
  };
  assert.equal(await lab.page.evaluate(() => document.documentElement.scrollWidth), 320);
  for (const selector of ["#scenes", "#open", ".tool-menu", "#theme", "#help", "#palette", "#zoom", "#legend"]) {
    const { x, y, width, height } = await box(selector);
    assert.ok(x >= 0 && y >= 0 && x + width <= 320 && y + height <= 568, selector);
  }
  await apart("#palette", "#legend");
  await apart("#palette", "#zoom");
  await lab.page.getByRole("button", { name: "Tour" }).click();
  await frames(lab.page, 2);
  for (const selector of ["#inspector", "#world", "#transport"]) await apart(".tour", selector);
  await close(lab);
});
