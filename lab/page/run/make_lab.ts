// SPDX-License-Identifier: Apache-2.0
// The Lab: one run at a time, the user's actions on it, and its listeners.
import { AvoError, type Library, type RecordedScene, type SceneFile, type SceneOptions, type Simulation } from "../../avo/avo.ts";
import type { Lab, LabEvent, SceneDraft, WorldPicture } from "./lab.ts";
import { LiveRun } from "./live_run.ts";
import { opening } from "./opening.ts";
import { moveOn, shareOf, type Playback } from "./playback.ts";
import { whyChangeless } from "./recorded_run.ts";
import type { Run } from "./run.ts";
import { withRobotKey, withValue } from "../text/scene_text.ts";
import type { Coloring } from "../map/world_layers.ts";

/** The page's own functions of the Lab, besides those for all views. */
export interface PageLab extends Lab {
  theme: "light" | "dark";
  picture: WorldPicture | null;
  coloring: Coloring;      // of the robots on the map
  readonly share: number;  // 0 to 1: the position of the picture between `before` and `moment`
  readonly run: Run;
  /** As in Lab; `files` are files that a scene may read, and `scene` is for a recording that contains none. */
  openFile(name: string, bytes: Uint8Array, files?: SceneFile[], scene?: RecordedScene | null): Promise<void>;
  /** Advances the time by `elapsed` seconds, and informs listeners of the changes. */
  frame(elapsed: number): void;
  /** Does `edit` to the simulation now, and again whenever the run passes this place; returns false and sets `error` if
   * it is refused. */
  edit(edit: (simulation: Simulation) => void): boolean;
  /** Continues with another text from the robots' present places; at the start of a run, and in space, from its start. */
  carryOn(yaml: string): boolean;
  /** Sets another text for the same run, which is already in the state that the text describes. */
  noteText(yaml: string): void;
  /** Shows why an action is refused. */
  refuse(message: string): void;
  say(event: LabEvent): void;
}

type Mutable<T> = { -readonly [Key in keyof T]: T[Key] };

/** Sets a message of the library, or about a file. */
function asError(error: unknown): AvoError {
  return error instanceof AvoError ? error : new AvoError(error instanceof Error ? error.message : String(error));
}

/** The shared state of the Lab's parts. */
export interface Core {
  readonly library: Library;
  readonly lab: Mutable<PageLab>;
  readonly playback: Playback;
  run: Run;
  told: Pick<Run, "text" | "info">;  // the state that listeners know
  fail(error: unknown, refused?: SceneDraft | null): false;
  /** Does an action that may be refused; returns true if it was not. */
  attempt(action: () => void, draft?: SceneDraft): boolean;
  /** Emits these events, and events for other changes. */
  tell(...events: LabEvent[]): void;
  /** Shows another time or run. */
  shown(...events: LabEvent[]): void;
}

const SPACE_IS_WRITTEN = "robots of space are added, moved and removed in the text of the scene";

/** Informs a new listener of earlier events. */
const TELLING_ORDER = ["text", "scene", "moment"] as const;

export function makeLab(library: Library, yaml: string, name: string, options: SceneOptions): PageLab {
  const run: Run = new LiveRun(library.simulate(yaml, { ...options, name }), yaml);
  const lab = {} as Mutable<PageLab>;
  const core: Core = {
    library,
    lab,
    playback: { playing: false, speed: 1, time: 0, target: null },
    run,
    told: { text: run.text, info: run.info },
    fail(error, refused = null) {
      lab.error = asError(error);
      lab.refused = refused;
      lab.say("error");
      return false;
    },
    attempt(action, draft) {
      try {
        action();
      } catch (error) {
        return core.fail(error, draft);
      }
      clearError(lab);
      return true;
    },
    tell(...events) {
      const { text, info } = core.run;
      const all = new Set(events);
      if (text !== core.told.text) all.add("text");
      if (info !== core.told.info) all.add("scene");
      core.told = { text, info };
      for (const event of TELLING_ORDER) if (all.has(event)) lab.say(event);
    },
    shown(...events) {
      core.playback.time = core.run.moment.time;
      core.tell(...events);
    },
  };
  const parts = [stateOf(core, name, options), listeningTo(core), opening(core), editing(core), going(core)];
  for (const part of parts) Object.defineProperties(lab, Object.getOwnPropertyDescriptors(part));
  return lab;
}

export function clearError(lab: Mutable<PageLab>): void {
  if (!lab.error) return;
  lab.error = lab.refused = null;
  lab.say("error");
}

function stateOf(core: Core, name: string, options: SceneOptions): Partial<PageLab> {
  const { library, lab, playback } = core;
  return {
    library,
    options,
    name,
    error: null,
    refused: null,
    selected: null,
    highlighted: null,
    theme: "light",
    coloring: "goal",
    picture: null,
    get text() { return core.run.text; },
    get run() { return core.run; },
    get moment() { return core.run.moment; },
    get info() { return core.run.info; },
    get live() { return core.run.live; },
    get playing() { return playback.playing; },
    get speed() { return playback.speed; },
    set speed(speed: number) { playback.speed = speed; lab.say("playing"); },
    get end() { return core.run.end; },
    get past() { return core.run.past; },
    get contacts() { return core.run.contacts; },
    get share() { return shareOf(playback, core.run); },
  };
}

function listeningTo({ lab, fail }: Core): Partial<PageLab> {
  const listeners = new Map<LabEvent, Set<() => void>>();
  return {
    say: (event) => listeners.get(event)?.forEach((listener) => listener()),
    refuse: (message) => void fail(message),
    on(event, listener) {
      const all = listeners.get(event) ?? new Set();
      listeners.set(event, all.add(listener));
      return () => { all.delete(listener); };
    },
    select(robot) {
      if (robot === lab.selected) return;
      lab.selected = robot;
      lab.say("selection");
    },
    highlight(what) {
      if (what === lab.highlighted) return;
      lab.highlighted = what;
      lab.say("highlight");
    },
  };
}

function editing(core: Core): Partial<PageLab> {
  const { library, lab } = core;
  return {
    edit(change) {
      const live = core.run;
      if (!(live instanceof LiveRun)) return lab.carryOn(lab.text);  // which says why it is refused
      if (live.info.dimensions === 3) return core.fail(SPACE_IS_WRITTEN);
      return core.attempt(() => {
        live.edit((simulation) => { change(simulation); return simulation; });
        core.shown("scene", "moment");
      });
    },
    carryOn(yaml) {
      const live = core.run;
      if (!(live instanceof LiveRun)) return core.fail(whyChangeless(lab.text));
      const options = { ...lab.options, name: lab.name };
      return core.attempt(() => {
        const begins = live.moment.steps === 0 && !live.handmade;
        if (begins || core.run.info.dimensions === 3) core.run = new LiveRun(library.simulate(yaml, options), yaml);
        else live.edit((simulation) => simulation.carriedInto(yaml, options), yaml);
        core.shown("text", "scene", "moment");
      });
    },
    noteText(yaml) {
      if (core.run instanceof LiveRun) core.run.noteText(yaml);
      core.tell();
    },
    textWith(path, value) {
      const all = /^robots\.\*\.(\w+)$/.exec(path);
      return all ? withRobotKey(lab.text, all[1]!, Number(value)) : withValue(lab.text, path, value);
    },
    set(path, value) {
      try {
        lab.carryOn(lab.textWith(path, value));
      } catch (error) {
        core.fail(error);
      }
    },
  };
}

function going(core: Core): Partial<PageLab> {
  const { lab, playback } = core;
  const went = (done: Promise<void> | void): void => {
    const tell = () => core.shown("scene", "moment");
    if (done) done.then(tell, core.fail);
    else tell();
  };
  return {
    play() {
      const { run } = core;
      if (playback.playing) return;
      if (!run.canStep()) went(run.goTo(run.start));
      Object.assign(playback, { playing: true, time: run.moment.time, target: null });
      lab.say("playing");
    },
    pause() {
      if (!playback.playing && playback.target === null) return;
      Object.assign(playback, { playing: false, target: null });
      lab.say("playing");
    },
    stepForward() {
      lab.pause();
      core.attempt(() => { if (core.run.canStep() && core.run.step()) core.shown("moment"); });
    },
    stepBack() {
      lab.pause();
      went(core.run.stepBack());
    },
    seek(time) {
      const { run } = core;
      const known = run.past.times[run.past.size - 1]!;
      playback.target = run.live && time > known + 1e-9 ? time : null;
      went(run.goTo(time));
    },
    restart() {
      lab.pause();
      if (core.run instanceof LiveRun) lab.openText(lab.text);
      else went(core.run.goTo(core.run.start));
    },
    frame(elapsed) {
      const { run } = core;
      try {
        const arrived = run.live?.allAtGoal() ?? false;
        if (moveOn(playback, run, elapsed)) {
          core.tell("moment");
          if (!arrived && run.live?.allAtGoal()) lab.pause();
        }
        if (playback.playing && !run.canStep() && playback.time >= run.moment.time - 1e-9) lab.pause();
      } catch (error) {
        lab.pause();
        core.fail(error);
      }
    },
  };
}
