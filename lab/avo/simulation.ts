// SPDX-License-Identifier: Apache-2.0
// A scene that is simulated.
import { addText, addWhole, emptyBytes, taken } from "./bytes.ts";
import { AvoError, fromImage, get, getText, imageOf, instantiate, put } from "./instance.ts";
import type { Instance } from "./instance.ts";
import { momentOf } from "./moment.ts";
import type { Moment, SceneInfo, SceneOptions } from "./types.ts";

/** So many steps are done again at most where one fails. */
const STEPS_BETWEEN_IMAGES = 256;

export class Simulation {
  #module: WebAssembly.Module;
  #instance: Instance;
  // What to go back to where a call throws: the module cannot unwind.
  #image: Uint8Array | null = null;
  #steps = 0; // since then

  /** Of the package alone: Library.simulate() makes one. */
  constructor(module: WebAssembly.Module, instance: Instance) {
    this.#module = module;
    this.#instance = instance;
  }

  /** One step of all robots. Throws AvoError; then the simulation is as before. */
  step(): void {
    this.#change(() => this.#instance.functions["step"]!(), false);
    ++this.#steps;
  }

  /** s. */
  get time(): number {
    return this.#instance.functions["time"]!();
  }

  get steps(): number {
    return this.#instance.functions["steps"]!();
  }

  /** Whether the next step ends within the scene's duration. */
  canStep(): boolean {
    return this.#instance.functions["can_step"]!() !== 0;
  }

  allAtGoal(): boolean {
    return this.#instance.functions["all_at_goal"]!() !== 0;
  }

  /** Equal for equal states, bit by bit, and equal to that of the native library. */
  stateHash(): bigint {
    return BigInt.asUintN(64, this.#instance.functions["state_hash"]!() as unknown as bigint);
  }

  moment(): Moment {
    return momentOf(get(this.#instance, this.#instance.functions["moment"]!()));
  }

  info(): SceneInfo {
    return JSON.parse(this.#text("info")) as SceneInfo;
  }

  /** All that the future depends on, as Simulation::save() of the native library writes it. */
  save(): Uint8Array {
    return get(this.#instance, this.#instance.functions["save"]!());
  }

  /** Goes on from what a simulation of this scene has saved, anywhere. */
  restore(saved: Uint8Array): void {
    this.#change(() => {
      put(this.#instance, saved);
      this.#instance.functions["restore"]!();
    });
  }

  /** The text of `avo explain --json`. Throws AvoError for a robot that does not decide. */
  explain(robot: number): string {
    return this.#read(() => this.#text("explain", robot));
  }

  /** The text of `avo run --json` so far; "null" without `metrics`, and once a state was restored. */
  summary(): string {
    return this.#text("summary") || "null";
  }

  #text(name: string, ...words: number[]): string {
    return getText(this.#instance, this.#instance.functions[name]!(...words));
  }

  /** An edit, or a step: undone where it throws. */
  #change<T>(action: () => T, isEdit = true): T {
    if (this.#image === null || this.#steps >= (isEdit ? 1 : STEPS_BETWEEN_IMAGES)) {
      this.#image = imageOf(this.#instance);
      this.#steps = 0;
    }
    const result = this.#attempt(action);
    if (isEdit) this.#image = null;
    return result;
  }

  /** Something that changes nothing, unless it throws. */
  #read<T>(action: () => T): T {
    return this.#change(action, false);
  }

  #attempt<T>(action: () => T): T {
    try {
      return action();
    } catch (error) {
      this.#instance = fromImage(this.#module, this.#image!);
      for (let step = 0; step < this.#steps; ++step) this.#instance.functions["step"]!();
      throw error instanceof AvoError ? error : new AvoError(`the module failed: ${String(error)}`);
    }
  }
}

/** The scene in `yaml`, in an instance of its own. */
export function readScene(module: WebAssembly.Module, yaml: string | Uint8Array, options: SceneOptions): Instance {
  const bytes = emptyBytes();
  addText(bytes, options.name ?? "scene");
  addText(bytes, yaml);
  addWhole(bytes, options.start_at_rest ? 1 : 0);
  addWhole(bytes, options.limit_speed ? 1 : 0);
  const overrides = options.overrides ?? [], files = options.files ?? [];
  addWhole(bytes, overrides.length);
  for (const override of overrides) addText(bytes, override);
  addWhole(bytes, files.length);
  for (const { path, text, builtin } of files) {
    addText(bytes, path);
    addText(bytes, text);
    addWhole(bytes, builtin ? 1 : 0);
  }
  addWhole(bytes, options.metrics ? 1 : 0);
  const instance = instantiate(module);
  put(instance, taken(bytes));
  try {
    instance.functions["read_scene"]!();
  } catch (error) {
    throw error instanceof AvoError ? error : new AvoError(`the module failed: ${String(error)}`);
  }
  return instance;
}
