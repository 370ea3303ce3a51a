// SPDX-License-Identifier: Apache-2.0
// The library in a browser or in Node.js: scenes are read, simulated, edited and explained with the same bits and the
// same words as natively.
import { addText, emptyBytes, taken } from "./bytes.ts";
import { getText, instantiate, put } from "./instance.ts";
import { readHeader, readTable, writeTable, type TableForm } from "./recordings.ts";
import { readScene, Simulation } from "./simulation.ts";
import type { BuiltinScene, Dimensions, RecordingHeader, SceneOptions, Setting } from "./types.ts";

export { AvoError } from "./instance.ts";
export { TABLE_ROW, TABLE_TIME, type TableForm } from "./recordings.ts";
export type { Simulation } from "./simulation.ts";
export type * from "./types.ts";

/** How a decision was made, by Moment's numbers. */
export const STATUSES = ["optimal", "least_unsafe", "refused", "braking", "overlapping", "invalid_input", "detour"];

export interface Library {
  readonly version: string;
  readonly simdTarget: string; // instruction set of the kernels: simd128 or scalar
  builtinScenes(): BuiltinScene[];
  /** Returns the YAML of a built-in scene, or of circle-N and uniform-N for any N. */
  builtinText(name: string): string | undefined;
  settings(): Setting[];
  /** Returns the header of a recording from its fields as a spool has them. Throws AvoError without a file's name. */
  readHeader(fields: Uint8Array): RecordingHeader;
  /** Reads a recording as CSV, part by part: whole times, see TABLE_TIME. Robots have numbers below `mostRobots`. Throws
   * AvoError in the words of `avo check`. */
  readTable(name: string, file: Uint8Array, dimensions: Dimensions, mostRobots: number): Iterable<Float64Array>;
  /** Returns the lines of such times, as `avo run --record FILE.csv` writes them. */
  writeTable(times: Float64Array, form: TableForm): string;
  /** Throws AvoError, and then affects no other object. A text as bytes must be UTF-8. */
  simulate(yaml: string | Uint8Array, options?: SceneOptions): Simulation;
}

/** Loads the library from the bytes of avo.wasm, or from their compiled module. */
export async function load(source: BufferSource | WebAssembly.Module): Promise<Library> {
  const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
  const instance = instantiate(module);
  const known = JSON.parse(getText(instance, instance.functions["library"]!())) as {
    version: string;
    simd_target: string;
    builtin_scenes: BuiltinScene[];
    settings: Setting[];
  };
  return {
    version: known.version,
    simdTarget: known.simd_target,
    builtinScenes: () => structuredClone(known.builtin_scenes),
    settings: () => structuredClone(known.settings),
    builtinText(name) {
      const bytes = emptyBytes(), asked = instantiate(module); // the scene may be refused
      addText(bytes, name);
      put(asked, taken(bytes));
      return getText(asked, asked.functions["builtin_text"]!()) || undefined;
    },
    readHeader: (fields) => readHeader(instantiate(module), fields), // which may be refused
    readTable: (name, file, dimensions, mostRobots) => readTable(instantiate(module, file), name, dimensions, mostRobots),
    writeTable: (times, form) => writeTable(instance, times, form),
    simulate: (yaml, options = {}) => {
      const instance = instantiate(module);
      readScene(instance, yaml, options);
      return new Simulation(module, instance);
    },
  };
}
