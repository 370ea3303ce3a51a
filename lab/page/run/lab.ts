// SPDX-License-Identifier: Apache-2.0
// The interface of the page's views: one scene, live or recorded, at one moment, and the user's actions on it.
import type { AvoError, Library, Moment, SceneInfo, SceneOptions, Simulation } from "../../avo/avo.ts";

/** moment: another step or time is shown. past: more of a recording has been read. scene: other robots, walls, options
 * or another run. text: the YAML changed. Listeners read what they need from the Lab; several events of one kind within
 * a frame may come as one. */
export type LabEvent = "moment" | "past" | "scene" | "selection" | "highlight" | "playing" | "error" | "text" | "theme" | "coloring";

/** The results of each step of the run so far: column k describes the moment at times[k]. All lengths are `size`. */
export interface Past {
  readonly size: number;
  readonly times: Float64Array;               // s
  readonly clearance: Float64Array;           // m, the least of all pairs of robots; +inf for a single robot
  readonly speed_ratio: Float64Array;         // largest |v| / max_speed
  readonly acceleration_ratio: Float64Array;  // largest |a| / max_acceleration
  readonly arrived: Float64Array;             // number of robots
  readonly contacts: Float64Array;            // number of overlapping pairs; in a live run also with walls
  readonly statuses: Uint32Array[];           // by PlanStatus: the number of the step's decisions with it
  /** Statuses of one robot's decisions, column by column; 255 if it decided nothing or was absent. */
  statusOf(robot: number): Uint8Array;
}

/** A contact of two discs, from `time` to `last` (s): one mark on the map. */
export interface Contact {
  time: number;
  last: number;
  a: string;      // "robots.3", "moving_obstacles.0", "obstacles.2"
  b: string;
  x: number;      // m
  y: number;
  z?: number;     // in space
  depth: number;  // m, the largest depth, which was at (x, y)
}

/** The world view's canvas, for pictures and films of it. */
export interface WorldPicture {
  readonly canvas: HTMLCanvasElement;
  draw(): void;  // draws at once; the pixels can be read until the present task ends
}

/** A text that was to be opened, with its name and options. */
export interface SceneDraft { name: string; yaml: string; options: SceneOptions }

export interface Lab {
  readonly library: Library;
  readonly name: string;                       // of the scene or the recording
  readonly text: string;                       // the scene's YAML
  readonly options: SceneOptions;              // of its simulation
  readonly moment: Moment;
  readonly info: SceneInfo;
  readonly live: Simulation | null;            // null if a recording is shown
  readonly playing: boolean;
  speed: number;                               // simulated seconds per second
  readonly end: number;                        // s, of the run or the recording
  readonly selected: number | null;            // number of a robot
  readonly highlighted: string | null;         // "robots.3" | "moving_obstacles.0" | "walls.4" hovered in any view
  readonly past: Past;
  readonly contacts: readonly Contact[];
  readonly theme: "light" | "dark";
  readonly picture: WorldPicture | null;       // null until the world view exists
  error: AvoError | null;
  readonly refused: SceneDraft | null;         // the text that `error` is about, if it was to be opened
  on(event: LabEvent, listener: () => void): () => void;
  select(robot: number | null): void;
  highlight(name: string | null): void;
  // on an error it keeps the present run and sets `error`
  openText(yaml: string, name?: string, options?: SceneOptions): void;
  openFile(name: string, bytes: Uint8Array): Promise<void>;             // by its content: YAML, CSV, HDF5
  set(path: string, value: unknown): void;     // set("robots.0.radius", 0.4), or "robots.*.radius" for all
  textWith(path: string, value: unknown): string;  // the text that set() would make
  play(): void;
  pause(): void;
  stepForward(): void;
  stepBack(): void;
  seek(time: number): void;
  restart(): void;
}
