// SPDX-License-Identifier: Apache-2.0
// A scene that is simulated.
import { addText, addWhole, emptyBytes, taken } from "./bytes.ts";
import { AvoError, fromImage, get, getText, imageOf, put } from "./instance.ts";
import type { Instance } from "./instance.ts";
import { momentOf } from "./moment.ts";
import type { Box, BrakingPath, Contact, Moment, Outline, RobotSetup, SceneInfo, SceneOptions } from "./types.ts";

/** So many steps are done again at most where one fails. */
const STEPS_BETWEEN_IMAGES = 256;
/** m: beyond all obstacles; a scene has to have a robot. */
const FAR = "[1e6, 1e6]";

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

  /** Discs that overlap now, each pair once. */
  contacts(): Contact[] {
    return this.#read(() => JSON.parse(this.#text("contacts")) as Contact[]);
  }

  /** Inside the box [left, bottom, right, top], m/s: of each neighbor that the robot avoids by its obstacle the
   * boundary of that, Eq. (29), moved by the neighbor's new velocity. */
  outlines(robot: number, [left, bottom, right, top]: Box): Outline[] {
    return this.#read(() => JSON.parse(this.#text("outlines", robot, left, bottom, right, top)) as Outline[]);
  }

  /** A node each of a grid over the box, m/s, bottom row first: 1 where the certificate lets the robot have that velocity
   * at the end of the step. Nothing of an airplane, which falls back on a circle. */
  admitted(robot: number, [left, bottom, right, top]: Box, columns: number, rows: number): Uint8Array {
    return this.#read(() => {
      const size = this.#instance.functions["admitted"]!(robot, left, bottom, right, top, columns, rows);
      return get(this.#instance, size);
    });
  }

  /** Of the robot and then of those that it sees: where they come to if they brake now. */
  brakingPaths(robot: number): BrakingPath[] {
    return this.#read(() => JSON.parse(this.#text("braking_paths", robot)) as BrakingPath[]);
  }

  /** Its number. Throws AvoError, as all edits do, and then changes nothing. */
  addRobot(setup: RobotSetup): number {
    return this.#change(() => this.#add("add_robots_of", "robot", JSON.stringify({ version: 1, robots: [setup] })));
  }

  removeRobot(robot: number): void {
    this.#change(() => this.#instance.functions["remove_robot"]!(robot));
  }

  setGoal(robot: number, x: number, y: number): void {
    this.#change(() => this.#instance.functions["set_goal"]!(robot, x, y));
  }

  /** Puts it down elsewhere, at rest; it keeps its number. */
  moveRobot(robot: number, x: number, y: number): void {
    this.#change(() => this.#instance.functions["move_robot"]!(robot, x, y));
  }

  /** `yaml` is what may stand in a list of obstacles, e.g. "{polyline: [[0, 0], [1, 0]]}". Its number. */
  addObstacle(yaml: string): number {
    const text = `obstacles: [${yaml}\n]\nversion: 1\nrobots: [{position: ${FAR}, goal: ${FAR}}]\n`;
    return this.#change(() => this.#add("add_obstacle_of", "obstacle", text));
  }

  removeObstacle(obstacle: number): void {
    this.#change(() => this.#instance.functions["remove_obstacle"]!(obstacle));
  }

  /** Another simulation, in which this scene with a changed text goes on: robots and moving obstacles are where those of
   * the same numbers are in this one, as fast, on the way to the same goals and points, and remember the same; who came or
   * left here did so there. What the text says anew holds: settings, walls, other goals, further robots; at step 0 also
   * other starts. With the same text it goes on with the same bits. Its time is this one's; with other sensing, or clocks
   * that are free and other ones, it is 0. Throws AvoError where the scene is refused. */
  carriedInto(yaml: string | Uint8Array, options: SceneOptions = {}): Simulation {
    const copy = fromImage(this.#module, new Uint8Array(this.#instance.memory.buffer));
    readScene(copy, yaml, options, true);
    return new Simulation(this.#module, copy);
  }

  #add(name: string, called: string, yaml: string): number {
    const bytes = emptyBytes();
    addText(bytes, called);
    addText(bytes, yaml);
    put(this.#instance, taken(bytes));
    return this.#instance.functions[name]!();
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

/** The scene in `yaml` is that of the instance then; it may take over from the one that runs there. */
export function readScene(instance: Instance, yaml: string | Uint8Array, options: SceneOptions, takesOver = false): void {
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
  addWhole(bytes, takesOver ? 1 : 0);
  put(instance, taken(bytes));
  try {
    instance.functions["read_scene"]!();
  } catch (error) {
    throw error instanceof AvoError ? error : new AvoError(`the module failed: ${String(error)}`);
  }
}
