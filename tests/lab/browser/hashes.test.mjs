// SPDX-License-Identifier: Apache-2.0
// The page comes to the same bits as the command line: of each scene the state hash after some seconds.
//   AVO_LAB_SCENES: names of built-in scenes, or "all"
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { close, launch, open, openText, stateHash, steps } from "./browser.mjs";

const AVO = process.env.AVO_COMMAND;
const SECONDS = 20;
const asked = (process.env.AVO_LAB_SCENES ?? "circle-10 office cars-100 planes-12").split(" ");

let browser, lab;
before(async () => {
  browser = await launch();
  lab = await open(browser);
});
after(async () => {
  await close(lab);
  await browser.close();
});

async function names() {
  if (asked[0] !== "all") return asked;
  const told = await lab.page.evaluate(() => window.avoLab.library.builtinScenes().map((scene) => scene.name));
  assert.ok(told.length > 20, `${told.length} scenes`);
  return told.map((name) => name.replace(/-N$/, "-100"));
}

/** By scene: how many steps the command line has made, and the hash of its last state. */
function natively(scenes) {
  const folder = mkdtempSync(join(tmpdir(), "avo-lab-"));
  try {
    const [spec, table] = [join(folder, "sweep.yaml"), join(folder, "runs.csv")];
    writeFileSync(spec, JSON.stringify({ version: 1, scenes, parameters: { duration: [SECONDS] }, until_arrived: false }));
    execFileSync(AVO, ["sweep", spec, "--out", table, "-q"]);
    const [head, ...rows] = readFileSync(table, "utf8").trim().split("\n").map((line) => line.split(","));
    const field = (row, column) => row[head.indexOf(column)];
    return new Map(rows.map((row) => [field(row, "scene"), { steps: Number(field(row, "steps")), hash: field(row, "state_hash") }]));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test("each scene has the state hash of the command line", async (t) => {
  const scenes = await names();
  const native = natively(scenes);
  for (const name of scenes) {
    await t.test(name, async () => {
      const { steps: count, hash } = native.get(name);
      assert.ok(count >= 100, `${count} steps`);
      const text = await lab.page.evaluate((scene) => window.avoLab.library.builtinText(scene), name);
      await openText(lab.page, text, name);
      await steps(lab.page, count);
      assert.equal(await stateHash(lab.page), hash);
    });
  }
});
