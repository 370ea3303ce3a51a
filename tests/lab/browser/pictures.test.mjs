// SPDX-License-Identifier: Apache-2.0
// States of the page look as they did when a person looked at them (references/).
//   AVO_LAB_STATES: names of states, or "all"; AVO_LAB_PICTURES: a folder where pictures that differ are left
import assert from "node:assert/strict";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { close, launch, open } from "./browser.mjs";
import { difference } from "./pictures.mjs";
import { picture, STATES } from "./states.mjs";

const MOST = 0.02; // share of the cells that may differ: fonts and edges are another machine's
const asked = (process.env.AVO_LAB_STATES ?? "first inspector office space").split(" ");
const states = asked[0] === "all" ? STATES : STATES.filter(({ name }) => asked.includes(name));

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

test("there are the states that were asked for", () => {
  assert.equal(states.length, asked[0] === "all" ? 11 : asked.length);
});

for (const state of states) {
  test(state.name, async () => {
    const lab = await open(browser, { width: state.width, height: state.height, ...state.context });
    const shown = await picture(lab.page, state);
    const folder = process.env.AVO_LAB_PICTURES;
    if (folder) {
      mkdirSync(folder, { recursive: true });
      writeFileSync(join(folder, `${state.name}.png`), shown);
    }
    const reference = readFileSync(new URL(`references/${state.name}.png`, import.meta.url));
    const differing = await difference(browser, reference, shown);
    assert.ok(differing <= MOST, `${(100 * differing).toFixed(1)} % of the picture differ, at most ${100 * MOST} % may`);
    await close(lab);
  });
}

test("a picture of something else differs", async () => {
  const [one, other] = ["first", "office"].map((name) => readFileSync(new URL(`references/${name}.png`, import.meta.url)));
  assert.ok((await difference(browser, one, other)) > 2 * MOST);
  assert.equal(await difference(browser, one, one), 0);
});
