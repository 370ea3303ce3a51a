// SPDX-License-Identifier: Apache-2.0
// The Lab: one run at a time, what the user does with it, and who is told.
import { AvoError, type Library, type SceneFile, type SceneOptions, type Simulation } from "../avo/avo.ts";
import { formatOf, openRecording } from "./data/open.ts";
import type { RecordedScene } from "./data/recording.ts";
import type { Lab, LabEvent, SceneDraft, WorldPicture } from "./lab.ts";
import { LiveRun } from "./live_run.ts";
import { moveOn, shareOf, type Playback } from "./playback.ts";
import { infoOf, liveOptions } from "./recorded_scene.ts";
import { RecordedRun } from "./recorded_run.ts";
import type { Run } from "./run.ts";
import { withRobotKey, withValue } from "./scene_text.ts";
import type { Coloring } from "./world_layers.ts";

/** What the page itself does with the Lab, besides what all views may do. */
export interface PageLab extends Lab {
  theme: "light" | "dark";
  picture: WorldPicture | null;
  coloring: Coloring;      // of the robots on the map
  readonly share: number;  // 0 to 1: how far the picture is from `before` to `moment`
  readonly run: Run;
  /** As in Lab; `files` are what a scene may read, `scene` is that of a recording that has none in itself. */
  openFile(name: string, bytes: Uint8Array, files?: SceneFile[], scene?: RecordedScene | null): Promise<void>;
  /** Time passes by `elapsed` seconds; tells listeners of what that changed. */
  frame(elapsed: number): void;
  /** Does `edit` to the simulation now, and again whenever the run comes by here; false and `error` if it is refused. */
  edit(edit: (simulation: Simulation) => void): boolean;
  /** Goes on with another text from where the robots are; at the start of a run: from its start. */
  carryOn(yaml: string): boolean;
  /** Another text for the same run, which has come to be what the text says. */
  noteText(yaml: string): void;
  /** Says why something is not done. */
  refuse(message: string): void;
  say(event: LabEvent): void;
}

type Mutable<T> = { -readonly [Key in keyof T]: T[Key] };

/** A message of the library, or of what a file is. */
function asError(error: unknown): AvoError {
  return error instanceof AvoError ? error : new AvoError(error instanceof Error ? error.message : String(error));
}

export function makeLab(library: Library, yaml: string, name: string, options: SceneOptions): PageLab {
  let run: Run = new LiveRun(library.simulate(yaml, { ...options, name }));
  let text = yaml;
  /** What is no UTF-8, the library refuses in its words. */
  function yamlOf(bytes: Uint8Array, name: string): string {
    const yaml = new TextDecoder().decode(bytes);
    if (yaml.includes("\ufffd")) library.simulate(bytes, { name });
    return yaml;
  }
  const playback: Playback = { playing: false, speed: 1, time: 0, target: null };
  const listeners = new Map<LabEvent, Set<() => void>>();
  const say = (event: LabEvent) => listeners.get(event)?.forEach((listener) => listener());

  function fail(error: unknown, refused: SceneDraft | null = null): false {
    lab.error = asError(error);
    lab.refused = refused;
    say("error");
    return false;
  }
  function clearError(): void {
    if (!lab.error) return;
    lab.error = lab.refused = null;
    say("error");
  }
  /** Does what may be refused; true if it was not. */
  function attempt(action: () => void, draft?: SceneDraft): boolean {
    try {
      action();
    } catch (error) {
      return fail(error, draft);
    }
    clearError();
    return true;
  }
  function pauseNow(): void {
    if (!playback.playing && playback.target === null) return;
    playback.playing = false;
    playback.target = null;
    say("playing");
  }
  function shown(...events: LabEvent[]): void {
    playback.time = run.moment.time;
    for (const event of events) say(event);
  }
  function start(next: Run): void {
    if (run instanceof RecordedRun) run.close();
    run = next;
    if (next instanceof RecordedRun) {
      next.readPast(() => { if (run === next) say("past"); }).catch((error) => { if (run === next) fail(error); });
    }
    pauseNow();
    if (lab.selected !== null && !run.moment.robot.includes(lab.selected)) lab.select(null);
    shown("scene", "moment");
  }
  function went(done: Promise<void> | void): void {
    const tell = () => shown("scene", "moment");
    if (done) done.then(tell, fail);
    else tell();
  }

  const lab: Mutable<PageLab> = {
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
    get text() { return text; },
    get run() { return run; },
    get moment() { return run.moment; },
    get info() { return run.info; },
    get live() { return run.live; },
    get playing() { return playback.playing; },
    get speed() { return playback.speed; },
    set speed(speed: number) { playback.speed = speed; say("playing"); },
    get end() { return run.end; },
    get past() { return run.past; },
    get contacts() { return run.contacts; },
    get share() { return shareOf(playback, run); },
    say,
    refuse: (message: string) => void fail(message),
    on(event: LabEvent, listener: () => void) {
      const all = listeners.get(event) ?? new Set();
      listeners.set(event, all.add(listener));
      return () => { all.delete(listener); };
    },
    select(robot: number | null) {
      if (robot === lab.selected) return;
      lab.selected = robot;
      say("selection");
    },
    highlight(what: string | null) {
      if (what === lab.highlighted) return;
      lab.highlighted = what;
      say("highlight");
    },
    openText(yaml: string, name = lab.name, options: SceneOptions = lab.options) {
      attempt(() => {
        const next = new LiveRun(library.simulate(yaml, { ...options, name }));
        text = yaml;
        lab.name = name;
        lab.options = options;
        say("text");
        start(next);
      }, { yaml, name, options });
    },
    async openFile(name: string, bytes: Uint8Array, files: SceneFile[] = [], scene: RecordedScene | null = null) {
      try {
        if (formatOf(name, bytes) === "yaml") return lab.openText(yamlOf(bytes, name), name, { files });
        const recording = await openRecording(name, bytes);
        recording.scene ??= scene;
        const { info, goals } = infoOf(recording, library);
        const next = await RecordedRun.open(recording, info, goals);
        text = recording.scene?.yaml ?? "";
        lab.name = name;
        lab.options = liveOptions(recording);
        clearError();
        say("text");
        start(next);
      } catch (error) {
        fail(error);
      }
    },
    edit(change: (simulation: Simulation) => void) {
      const live = run;
      if (!(live instanceof LiveRun)) return false;
      return attempt(() => {
        live.edit((simulation) => { change(simulation); return simulation; });
        shown("scene", "moment");
      });
    },
    carryOn(yaml: string) {
      const live = run;
      if (!(live instanceof LiveRun)) return fail("a recording does not change; run its scene to try something else");
      const options = { ...lab.options, name: lab.name };
      return attempt(() => {
        if (live.moment.steps === 0) run = new LiveRun(library.simulate(yaml, options));
        else live.edit((simulation) => simulation.carriedInto(yaml, options));
        text = yaml;
        say("text");
        shown("scene", "moment");
      });
    },
    noteText(yaml: string) {
      text = yaml;
      say("text");
    },
    textWith(path: string, value: unknown) {
      const all = /^robots\.\*\.(\w+)$/.exec(path);
      return all ? withRobotKey(text, all[1]!, Number(value)) : withValue(text, path, value);
    },
    set(path: string, value: unknown) {
      try {
        lab.carryOn(lab.textWith(path, value));
      } catch (error) {
        fail(error);
      }
    },
    play() {
      if (playback.playing) return;
      if (!run.canStep()) went(run.goTo(run.start));
      playback.time = run.moment.time;
      playback.target = null;
      playback.playing = true;
      say("playing");
    },
    pause: pauseNow,
    stepForward() {
      pauseNow();
      attempt(() => { if (run.canStep() && run.step()) shown("moment"); });
    },
    stepBack() {
      pauseNow();
      went(run.stepBack());
    },
    seek(time: number) {
      const known = run.past.times[run.past.size - 1]!;
      if (run.live && time > known + 1e-9) playback.target = time;
      else playback.target = null;
      went(run.goTo(time));
    },
    restart() {
      pauseNow();
      if (run instanceof LiveRun) lab.openText(text);
      else went(run.goTo(run.start));
    },
    frame(elapsed: number) {
      try {
        const arrived = run.live?.allAtGoal() ?? false;
        if (moveOn(playback, run, elapsed)) {
          say("moment");
          if (!arrived && run.live?.allAtGoal()) pauseNow();
        }
        if (playback.playing && !run.canStep() && playback.time >= run.moment.time - 1e-9) pauseNow();
      } catch (error) {
        pauseNow();
        fail(error);
      }
    },
  };
  return lab;
}
