// SPDX-License-Identifier: Apache-2.0
// A simulation of a scene.
import { addText, addWhole, emptyBytes, taken } from "./bytes.ts";
import { AvoError, fromImage, get, getText, imageOf, put } from "./instance.ts";
import type { Instance } from "./instance.ts";
import { momentOf } from "./moment.ts";
import type { Box, BrakingPath, Contact, Dimensions, Moment, Outline, RobotSetup, SceneInfo, SceneOptions, VelocityCut } from "./types.ts";

/** The most steps that are repeated if one fails. */
const STEPS_BETWEEN_IMAGES = 256;
/** m: beyond all obstacles; the scene of a single obstacle needs a robot. */
const FAR = "[1e6, 1e6]";

/** What a scene of space does not have throws AvoError there: edits, outlines(), admitted(), carriedInto(). */
export class Simulation {
  readonly dimensions: Dimensions;
  #module: WebAssembly.Module;
  #instance: Instance;
  // The state to return to if a call throws: the module cannot unwind.
  #image: Uint8Array | null = null;
  #steps = 0; // steps since then

  /** For the package alone: Library.simulate() makes a simulation. */
  constructor(module: WebAssembly.Module, instance: Instance) {
    this.#module = module;
    this.#instance = instance;
    this.dimensions = instance.functions["dimensions"]!() as Dimensions;
  }

  /** Does one step of all robots. Throws AvoError; the simulation is unchanged then. */
  step(): void {
    this.#change(() => this.#instance.functions["step"]!(), false);
    ++this.#steps;
  }

  /** Returns s. */
  get time(): number {
    return this.#instance.functions["time"]!();
  }

  get steps(): number {
    return this.#instance.functions["steps"]!();
  }

  /** Returns whether the next step ends within the scene's duration. */
  canStep(): boolean {
    return this.#instance.functions["can_step"]!() !== 0;
  }

  allAtGoal(): boolean {
    return this.#instance.functions["all_at_goal"]!() !== 0;
  }

  /** Returns a hash. It is equal for equal states, bit by bit, and equal to the hash of the native library. */
  stateHash(): bigint {
    return BigInt.asUintN(64, this.#instance.functions["state_hash"]!() as unknown as bigint);
  }

  moment(): Moment {
    return momentOf(get(this.#instance, this.#instance.functions["moment"]!()), this.dimensions);
  }

  info(): SceneInfo {
    return JSON.parse(this.#text("info")) as SceneInfo;
  }

  /** Returns everything that the future depends on, as Simulation::save() of the native library writes it. In space it
   * is the memory of the module, for simulations of the same scene by the same module alone. */
  save(): Uint8Array {
    if (this.dimensions === 3) return imageOf(this.#instance);
    return get(this.#instance, this.#instance.functions["save"]!());
  }

  /** Continues from a state that a simulation of this scene has saved; in the plane, on any machine. */
  restore(saved: Uint8Array): void {
    if (this.dimensions === 3) {
      this.#instance = fromImage(this.#module, saved);
      this.#image = null;
      return;
    }
    this.#change(() => {
      put(this.#instance, saved);
      this.#instance.functions["restore"]!();
    });
  }

  /** Returns the text of `avo explain --json`. Throws AvoError for a robot that does not decide. */
  explain(robot: number): string {
    return this.#read(() => this.#text("explain", robot));
  }

  /** Returns the text of `avo run --json` so far; "null" without `metrics`, and once a state was restored. */
  summary(): string {
    return this.#text("summary") || "null";
  }

  /** Returns the bodies that overlap now, each pair once. */
  contacts(): Contact[] {
    return this.#read(() => JSON.parse(this.#text("contacts")) as Contact[]);
  }

  /** Returns, for each neighbor that the robot avoids by its obstacle, the obstacle's boundary, Eq. (29), moved by the
   * neighbor's new velocity. Boundaries lie inside the box [left, bottom, right, top], m/s. */
  outlines(robot: number, [left, bottom, right, top]: Box): Outline[] {
    return this.#read(() => JSON.parse(this.#text("outlines", robot, left, bottom, right, top)) as Outline[]);
  }

  /** Returns an entry for each node of a grid over the box, m/s, bottom row first. It is 1 if the certificate admits
   * that velocity at the end of the step. The result is empty for an airplane, which falls back on a circle. */
  admitted(robot: number, [left, bottom, right, top]: Box, columns: number, rows: number): Uint8Array {
    return this.#read(() => {
      const size = this.#instance.functions["admitted"]!(robot, left, bottom, right, top, columns, rows);
      return get(this.#instance, size);
    });
  }

  /** Does the same for a scene of space, on a plane through the velocities; the box is on its two axes. */
  admittedInCut(robot: number, { place, along, across }: VelocityCut, box: Box, columns: number, rows: number): Uint8Array {
    return this.#read(() => {
      put(this.#instance, new Uint8Array(Float64Array.of(...place, ...along, ...across, ...box).buffer));
      return get(this.#instance, this.#instance.functions["admitted_in_cut"]!(robot, columns, rows));
    });
  }

  /** Returns the rings of the boundary of the obstacle of "robots.I" or "moving_obstacles.K" in space, Eq. (29). The cut
   * has to be the plane of p and v of the two. There are none with downwash, nor for a moving obstacle that accelerates. */
  outlineInCut(robot: number, other: string, { place, along, across }: VelocityCut, box: Box): [number, number][][] {
    return this.#read(() => {
      put(this.#instance, new Uint8Array(Float64Array.of(...place, ...along, ...across, ...box).buffer));
      const [kind, number] = other.split(".");
      return JSON.parse(this.#text("outline_in_cut", robot, Number(number), kind === "robots" ? 0 : 1)) as [number, number][][];
    });
  }

  /** Returns the braking paths if all brake now: of the robot, and then of the neighbors that it sees. */
  brakingPaths(robot: number): BrakingPath[] {
    return this.#read(() => JSON.parse(this.#text("braking_paths", robot)) as BrakingPath[]);
  }

  /** Adds a robot and returns its number. Throws AvoError, as all edits do, and then changes nothing. */
  addRobot(setup: RobotSetup): number {
    return this.#change(() => this.#add("add_robots_of", "robot", JSON.stringify({ version: 1, robots: [setup] })));
  }

  removeRobot(robot: number): void {
    this.#change(() => this.#instance.functions["remove_robot"]!(robot));
  }

  setGoal(robot: number, x: number, y: number): void {
    this.#change(() => this.#instance.functions["set_goal"]!(robot, x, y));
  }

  /** Places the robot elsewhere, at rest; it keeps its number. */
  moveRobot(robot: number, x: number, y: number): void {
    this.#change(() => this.#instance.functions["move_robot"]!(robot, x, y));
  }

  /** Adds an obstacle and returns its number. `yaml` is an entry of a list of obstacles, e.g. "{polyline: [[0, 0], [1,
   * 0]]}". */
  addObstacle(yaml: string): number {
    const text = `obstacles: [${yaml}\n]\nversion: 1\nrobots: [{position: ${FAR}, goal: ${FAR}}]\n`;
    return this.#change(() => this.#add("add_obstacle_of", "obstacle", text));
  }

  removeObstacle(obstacle: number): void {
    this.#change(() => this.#instance.functions["remove_obstacle"]!(obstacle));
  }

  /** Returns another simulation, in which this scene continues with a changed text. Robots and moving obstacles with
   * the same numbers keep places, velocities, goals, waypoints and memories. Robots that were added or removed here are
   * added or removed there. The changes of the text take effect: settings, walls, other goals, further robots; at step
   * 0 also other starts. With the same text, it continues with the same bits. It has the same time; with other sensing,
   * or other clocks that are free, its time is 0. Throws AvoError if the scene is refused. */
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

  /** Does an edit, or a step; it is undone if it throws. */
  #change<T>(action: () => T, isEdit = true): T {
    if (this.#image === null || this.#steps >= (isEdit ? 1 : STEPS_BETWEEN_IMAGES)) {
      this.#image = imageOf(this.#instance);
      this.#steps = 0;
    }
    const result = this.#attempt(action);
    if (isEdit) this.#image = null;
    return result;
  }

  /** Does something that changes nothing, unless it throws. */
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

/** Makes the scene in `yaml` the scene of the instance; it may take over from the scene that runs there. */
export function readScene(instance: Instance, yaml: string | Uint8Array, options: SceneOptions, takesOver = false): void {
  const bytes = emptyBytes();
  addText(bytes, options.name ?? "scene");
  addText(bytes, yaml);
  addWhole(bytes, options.start_at_rest ? 1 : 0);
  addWhole(bytes, options.limit_speed ? 1 : 0);
  addWhole(bytes, options.recorded ? 1 : 0);
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
