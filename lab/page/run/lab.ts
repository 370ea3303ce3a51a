// SPDX-License-Identifier: Apache-2.0
// What the views of the page know of it: one scene, live or recorded, at one moment, and what the user does with it.
import type { AvoError, Library, Moment, SceneInfo, SceneOptions, Simulation } from "../../avo/avo.ts";

/**
 * moment: another step or time is shown. past: more of a recording has been read. scene: other robots, walls, options or another run. text: the YAML changed.
 * Listeners read what they need from the Lab; several events of one kind within a frame may come as one.
 */
export type LabEvent = "moment" | "past" | "scene" | "selection" | "highlight" | "playing" | "error" | "text" | "theme" | "coloring";

/** What each step of the run so far came to: column k is about the moment at times[k]. Lengths are `size`. */
export interface Past {
  readonly size: number;
  readonly times: Float64Array;               // s
  readonly clearance: Float64Array;           // m, least of all pairs of robots; +inf where there is one
  readonly speed_ratio: Float64Array;         // largest |v| / max_speed
  readonly acceleration_ratio: Float64Array;  // largest |a| / max_acceleration
  readonly arrived: Float64Array;             // number of robots
  readonly contacts: Float64Array;            // pairs that overlap, of a live run with walls too
  readonly statuses: Uint32Array[];           // by PlanStatus: how many decisions of the step had it
  /** Statuses of one robot's decisions, column by column; 255 where it decided nothing or was not there. */
  statusOf(robot: number): Uint8Array;
}

/** Where two discs touched, from `time` to `last` (s): one mark on the map. */
export interface Contact {
  time: number;
  last: number;
  a: string;      // "robots.3", "moving_obstacles.0", "obstacles.2"
  b: string;
  x: number;      // m
  y: number;
  depth: number;  // m, at its deepest, which was at (x, y)
}

/** The world view's canvas, for pictures and films of it. */
export interface WorldPicture {
  readonly canvas: HTMLCanvasElement;
  draw(): void;  // now; the pixels can be read until the present task ends
}

/** A text that was to be opened, and what for. */
export interface SceneDraft { name: string; yaml: string; options: SceneOptions }

export interface Lab {
  readonly library: Library;
  readonly name: string;                       // of the scene or the recording
  readonly text: string;                       // the scene's YAML
  readonly options: SceneOptions;              // with which it is simulated
  readonly moment: Moment;
  readonly info: SceneInfo;
  readonly live: Simulation | null;            // null: a recording is shown
  readonly playing: boolean;
  speed: number;                               // simulated seconds a second
  readonly end: number;                        // s, of the run or the recording
  readonly selected: number | null;            // number of a robot
  readonly highlighted: string | null;         // "robots.3" | "moving_obstacles.0" | "walls.4" hovered in any view
  readonly past: Past;
  readonly contacts: readonly Contact[];
  readonly theme: "light" | "dark";
  readonly picture: WorldPicture | null;       // null until the world view stands
  error: AvoError | null;
  readonly refused: SceneDraft | null;         // the text that `error` is about, where it was to be opened
  on(event: LabEvent, listener: () => void): () => void;
  select(robot: number | null): void;
  highlight(name: string | null): void;
  openText(yaml: string, name?: string, options?: SceneOptions): void;  // on error keeps what is there and says `error`
  openFile(name: string, bytes: Uint8Array): Promise<void>;             // by its content: YAML, CSV, HDF5
  set(path: string, value: unknown): void;     // set("robots.0.radius", 0.4), or "robots.*.radius" of all
  textWith(path: string, value: unknown): string;  // the text as set() would make it
  play(): void;
  pause(): void;
  stepForward(): void;
  stepBack(): void;
  seek(time: number): void;
  restart(): void;
}
