// SPDX-License-Identifier: Apache-2.0
// Files that nobody should drop: the page says one line, keeps what it has, and works on.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { close, frames, launch, open, stateHash, steps } from "./browser.mjs";

const AVO = process.env.AVO_COMMAND;
let browser, lab, folder;
before(async () => {
  browser = await launch();
  lab = await open(browser);
  folder = mkdtempSync(join(tmpdir(), "avo-lab-"));
});
after(async () => {
  rmSync(folder, { recursive: true });
  await close(lab);
  await browser.close();
});

/** What the page says of a file that is dropped; null: nothing. */
const drop = (name, bytes) => lab.page.evaluate(async ([called, base64]) => {
  const file = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  try {
    await window.avoLab.openFile(called, file);
  } catch (error) {
    return `thrown: ${error.message}`;
  }
  return window.avoLab.error?.message ?? null;
}, [name, Buffer.from(bytes).toString("base64")]);

const HOSTILE = {
  "nothing.yaml": "",
  "nul.yaml": "version: 1\0\nrobots: []\n",
  "not-utf-8.yaml": Buffer.from([0x76, 0xff, 0xfe, 0x3a]),
  "deep.yaml": "[".repeat(100000),
  "bomb.yaml": "a: &a [x,x,x,x,x,x,x,x,x]\nb: &b [*a,*a,*a,*a,*a,*a]\nrobots: [*b,*b,*b,*b]\n",
  "huge-number.yaml": `version: 1\nrobots:\n  - {position: [${"9".repeat(400)}, 0], goal: [1, 0]}\n`,
  "many.yaml": "version: 1\ngroups:\n  - {number: 1000000000, placement: {circle: {radius: 5}}, goals: opposite}\n",
  "script.yaml": "version: 1\nname: <img src=x onerror=alert(1)>\nrobots: </script><script>alert(1)</script>\n",
  "bytes.h5": Buffer.from("\x89HDF\r\n\x1a\n" + "\xff".repeat(500), "latin1"),
  "head.csv": "time,robot\n0,0\n",
  "nan.csv": "time,robot,x,y,vx,vy\n0,0,nan,0,0,0\n",
  "back.csv": "time,robot,x,y,vx,vy\n1,0,0,0,0,0\n0,0,0,0,0,0\n",
  "picture.png": Buffer.from("\x89PNG\r\n\x1a\n0000", "latin1"),
};

for (const [name, bytes] of Object.entries(HOSTILE)) {
  test(`${name} is refused in one line`, async () => {
    await lab.page.evaluate(() => window.avoLab.openText(window.avoLab.library.builtinText("circle-10"), "circle-10"));
    await steps(lab.page, 3);
    const hash = await stateHash(lab.page);
    const said = await drop(name, bytes);
    assert.ok(said, "it says something");
    assert.doesNotMatch(said, /^thrown/);
    assert.doesNotMatch(said.trim(), /\n/);
    assert.ok(said.length < 1000, `${said.length} characters`);
    await frames(lab.page, 2);
    assert.equal(await stateHash(lab.page), hash, "what was there is there");
    await steps(lab.page, 2);
    assert.notEqual(await stateHash(lab.page), hash, "and moves on");
  });
}

test("a recording that is cut off or changed is refused, or shown as far as it is whole", async () => {
  const path = join(folder, "run.h5");
  execFileSync(AVO, ["run", "circle-10", "--duration", "10", "--record", path, "-q"]);
  const whole = readFileSync(path);
  assert.equal(await drop("run.h5", whole), null);
  assert.equal(await lab.page.evaluate(() => window.avoLab.live), null, "a recording is shown");
  for (let k = 0; k < 40; ++k) {
    const length = Math.floor((whole.length * k) / 40);
    assert.ok(await drop("cut.h5", whole.subarray(0, length)), `cut off at ${length}`);
    const changed = Buffer.from(whole);
    changed[(k * 7919) % whole.length] ^= 1 << k % 8;
    const said = await drop("changed.h5", changed); // some bytes tell nothing, e.g. of names
    assert.ok(said === null || !/^thrown/.test(said), said);
  }
  assert.equal(await drop("run.h5", whole), null, "and the page still reads");
});

test("names of scenes and files are text, never markup", async () => {
  const name = "<img src=x onerror=\"window.hacked=1\">";
  const text = `version: 1\nname: '${name}'\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n`;
  assert.equal(await drop(`${name}.yaml`, text), null);
  await lab.page.evaluate(() => window.avoLab.select(0));
  await frames(lab.page, 5);
  assert.equal(await lab.page.evaluate(() => window.hacked), undefined);
  assert.equal(await lab.page.locator("img[src=x]").count(), 0);
});
