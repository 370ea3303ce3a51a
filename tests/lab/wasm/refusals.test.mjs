// SPDX-License-Identifier: Apache-2.0
// What is refused is refused in the words of the command line, with line and column, and harms nothing.
//   AVO_REFUSALS: the program that writes the bad scenes of the command line's tests
import assert from "node:assert/strict";
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { avo, randomNumbers } from "../data/native.mjs";
import { builtin, library, native, refused, steps } from "./module.mjs";

const folder = mkdtempSync(join(tmpdir(), "avo-refusals-"));
after(() => rmSync(folder, { recursive: true }));
native(process.env.AVO_REFUSALS, [folder]);
const names = readdirSync(folder).filter((name) => name.endsWith(".yaml")).map((name) => name.slice(0, -5));

test("there are the bad scenes", () => assert.ok(names.length > 130, `${names.length}`));

for (const name of names) {
  test(name, () => {
    const wanted = readFileSync(join(folder, `${name}.txt`), "utf8");
    const found = refused(() => library.simulate(readFileSync(join(folder, `${name}.yaml`)), { name: "bad.yaml" }));
    assert.ok(found.startsWith("bad.yaml:"), found);
    assert.equal(found.slice("bad.yaml:".length), wanted);
  });
}

// Faults of the text itself, which the command line's parser words. Of texts with one character wrong by chance that
// both refuse, this parser says nine in ten as that one does.
const FAULTY = [
  "version: 1\nrobots: {a: 1\n", "version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0}\n", "version: 1\nrobots: ]\n",
  "version: 1\nname: 'a\nrobots: 1\n", "version: 1\nrobots:\n - a\n- b\n", "a: b: c\n", "version: 1\nname: a: b\n",
  "version: 1\nrobots:\n  - position: [0,0]\n   goal: [1,0]\n", "version 1\nrobots: []\n", "version: 1\nname: @x\n",
  "version: 1\nname: `x\n", "version: 1\nname: %x\n", "version: 1\nname: \"a\\qb\"\n", "version: 1\nname: | x\n y\n",
  "version: 1\nrobots:\n  - {position: [0 0], goal [1, 0]}\n", "version: 1\nrobots: - a\n", "version: 1\nname: \"x\" y\n",
  "version: 1\ngroups:\n  - number: 1\n  x radius: 1\n    max_speed: 1\n", "version: 1\ngroups:\n  - number: 1\n -  radius: 1\n",
  "version: 1\nobstacles:\n  - a: 1\n   - b: 1\n", "version: 1\nrobots:\n  - {goal:[1, 0], position: [0, 0]}\n",
  "version: 1\nrobots:\n  - {goal: [1, 0] x position: [0, 0]}\n", "version: 1\nrobots:\n  - {goal: [1, 0]x}\n",
  "version: 1\nrobots:\n  - {goal: 1[1, 0]}\n", "version: 1\ngroups:\n  - a: {b: 1\n    c: 1\n", "version: 1\n>name: 1\n",
  "version: 1\nname: >x: 1\n", "version: 1\n*  name: x\n", "version: 1\nname: &, x\n", "version: 1\nrobots\n: 1\n",
  "version: 1\nrobots:\n- {position: [0, 0], goal: [1, 0]\n- {position: [0, 0]}\n", "version: 1\n\tname: x\n",
];
for (const text of FAULTY) {
  test(`${JSON.stringify(text)} is refused as by avo validate`, () => {
    const file = join(folder, "faulty.yaml");
    writeFileSync(file, text);
    const { status, stderr } = avo("validate", file);
    assert.equal(status, 3);
    assert.equal(`${refused(() => library.simulate(text, { name: file }))}\n`, stderr);
  });
}

test("what was removed is read in scenes of recordings alone", () => {
  const scene = (more) => `version: 1\nrobots: [{position: [0, 0], goal: [1, 0]}]\n${more}`;
  const removed = scene("samples: 0\nprecision: double\ncertificate: stopping_capsules\nright_of_way: told\n");
  const hash = (yaml, options) => steps(library.simulate(yaml, options), 5).stateHash();
  assert.match(refused(() => library.simulate(removed)), /the removed key "samples", must be left out/);
  assert.equal(hash(removed, { recorded: true }), hash(scene("")));
});

test("an error has line and column", () => {
  try {
    library.simulate("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], radius: -1}\n", { name: "x:7.yaml" });
    assert.fail();
  } catch (error) {
    assert.deepEqual([error.name, error.line, error.column], ["AvoError", 3, 46]);
  }
});

test("a call that throws changes nothing", () => {
  const simulation = steps(builtin("office"), 30);
  const hash = simulation.stateHash();
  assert.match(refused(() => simulation.restore(new Uint8Array([1, 2, 3]))), /^saved/);
  assert.match(refused(() => simulation.explain(99)), /99/);
  assert.equal(simulation.stateHash(), hash);
  assert.equal(steps(simulation, 30).stateHash(), steps(builtin("office"), 60).stateHash());
});

test("text that was changed by chance is a scene or is refused, in one line", () => {
  const random = randomNumbers(20);
  const texts = ["office", "mixed-yard", "person", "arena"].map((name) => Buffer.from(library.builtinText(name)));
  const PIECES = ["\0", "\xff", "&a ", "*a", "[", "{", "- ", "? ", ": ", "!!x ", "'", "\"", "\t", "1e999", "nan", "~", "#", "|\n", ">", "\u{1f916}", "\r", "---\n"];
  let refusals = 0;
  for (let k = 0; k < 600; ++k) {
    let text = texts[k % texts.length];
    for (let left = 1 + Math.floor(3 * random()); left > 0; --left) {
      const at = Math.floor(random() * text.length), end = at + Math.floor(random() * 12);
      const piece = Buffer.from(PIECES[Math.floor(random() * PIECES.length)], random() < 0.1 ? "latin1" : "utf8");
      text = Buffer.concat([text.subarray(0, at), piece, text.subarray(end)]);
    }
    try {
      library.simulate(text, { name: "chance" });
    } catch (error) {
      assert.equal(error.name, "AvoError", `${error.stack}\n${text}`);
      assert.match(error.message, /^chance[^\n]*$/, `${text}`);
      assert.doesNotMatch(error.message, /module failed/, `${error.message}\n${text}`);
      ++refusals;
    }
  }
  assert.ok(refusals > 300 && refusals < 600, `${refusals} refused`);
});

test("texts that want too much are refused", () => {  // how soon, scripts/lab-check tells
  for (const [piece, times] of [["[", 100000], ["{", 100000], ["- ", 100000], ["? ", 100000], ["!", 100000], ["&a ", 100000], ["---\n", 20000]]) {
    refused(() => library.simulate(piece.repeat(times), { name: "bomb" }));
  }
});
