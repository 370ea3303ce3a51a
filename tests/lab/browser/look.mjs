// SPDX-License-Identifier: Apache-2.0
// Pictures of all states, for a person to look at: node look.mjs FOLDER [STATE...]. Those that are right become the
// references by being copied there.
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { close, launch, open } from "./browser.mjs";
import { picture, STATES } from "./states.mjs";

const [folder, ...names] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
const browser = await launch();
for (const state of STATES) {
  if (names.length > 0 && !names.includes(state.name)) continue;
  const lab = await open(browser, { width: state.width, height: state.height, ...state.context });
  writeFileSync(join(folder, `${state.name}.png`), await picture(lab.page, state));
  await close(lab);
}
await browser.close();
