// SPDX-License-Identifier: Apache-2.0
// The npm package as a user has it: the program of its README runs, and TypeScript accepts what the types say.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

const lab = process.env.AVO_LAB;
const folder = mkdtempSync(join(tmpdir(), "avo-package-"));
const node = (...words) => spawnSync(process.execPath, words, { cwd: folder, encoding: "utf8" });
const README = readFileSync(join(lab, "avo/README.md"), "utf8").match(/```ts\n([^]*?)```/)[1];

before(() => {
  const made = node(join(lab, "package.mjs"), "--wasm", process.env.AVO_WASM, "--out", join(folder, "made"));
  assert.equal(made.status, 0, made.stderr + made.stdout);
  mkdirSync(join(folder, "node_modules"));
  cpSync(join(folder, "made"), join(folder, "node_modules/avo"), { recursive: true });
  symlinkSync(join(lab, "node_modules/yaml"), join(folder, "node_modules/yaml"));
  writeFileSync(join(folder, "package.json"), '{"type": "module"}');
});
after(() => rmSync(folder, { recursive: true }));

test("the program of the README runs", () => {
  writeFileSync(join(folder, "readme.js"), README.replace(/(\))!/g, "$1"));
  const { status, stdout, stderr } = node("readme.js");
  assert.equal(status, 0, stderr);
  assert.match(stdout, /^10 \d+n Float64Array\(200\)/);
  assert.match(stdout, /"robot": 3,\n  "time": 10\.0,/);
});

/** What the compiler says. */
function checked(text) {
  writeFileSync(join(folder, "user.ts"), text);
  const words = ["--noEmit", "--strict", "--skipLibCheck", "false", "--target", "es2022", "--module", "nodenext", "--types", "", "user.ts"];
  return node(join(lab, "node_modules/typescript/bin/tsc"), ...words).stdout;
}

const USER = `import { AvoError, load, STATUSES, type Moment } from "avo";
const library = await load(new Uint8Array());
try {
  const simulation = library.simulate("version: 1", { name: "mine", overrides: ["method=orca"] });
  simulation.step();
  const moment: Moment = simulation.moment();
  const word: string = STATUSES[moment.status[0] ?? 0] ?? "";
  const hash: bigint = simulation.stateHash();
  console.log(word, hash, simulation.info().robots.length);
} catch (error) {
  if (error instanceof AvoError) console.log(error.line, error.column);
}
`;

test("its types are those of its README and of programs like this", () => {
  assert.equal(checked(USER), "");
  assert.match(checked(USER.replace("simulation.step()", "simulation.stop()")), /'stop' does not exist/);
});
