// SPDX-License-Identifier: Apache-2.0
// What the tests of the package share: the module, and native programs beside it.
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { load } from "../../../lab/avo/avo.ts";

export const library = await load(await WebAssembly.compile(readFileSync(process.env.AVO_WASM)));

/** What a native program prints. */
export function native(program, args, input = "") {
  const { status, stdout, stderr } = spawnSync(program, args, { encoding: "utf8", input, maxBuffer: 1 << 30 });
  if (status !== 0) throw new Error(`${program}: ${status}: ${stderr}`);
  return stdout;
}

export const hex = (hash) => `0x${hash.toString(16).padStart(16, "0")}`;

/** A simulation of a built-in scene. */
export const builtin = (name, options = {}) => library.simulate(library.builtinText(name), { name, ...options });

export function steps(simulation, count) {
  for (let k = 0; k < count; ++k) simulation.step();
  return simulation;
}

/** The message of the AvoError that it throws; fails where it throws nothing, or anything else. */
export function refused(action) {
  try {
    action();
  } catch (error) {
    if (error.name === "AvoError") return error.message;
    throw error;
  }
  throw new Error("it was not refused");
}
