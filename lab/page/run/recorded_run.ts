// SPDX-License-Identifier: Apache-2.0
// A recorded run, of avo or of another program: frames are read when they are needed, and a few ahead.
import type { Moment, SceneInfo } from "../../avo/avo.ts";
import type { Recording, RecordedFrame } from "../data/recording.ts";
import { ContactLog } from "./contact_log.ts";
import { fillClearance, touchesIn, vectorOf } from "../map/discs.ts";
import { PastColumns } from "./past.ts";
import { moversAt } from "./recorded_movers.ts";
import { lastAt, type Run } from "./run.ts";

const FRAMES_KEPT = 128;
const FRAMES_AHEAD = 24;
const READING = 12;  // ms at a time, for reading the past
const RESTING = 20;  // ms in between

export type Goals = Map<number, number[]>;

/** `scene` is its text, if there is one. */
export const whyChangeless = (scene: string): string =>
  `a recording does not change${scene ? "; run its scene to try something else" : ", and this one does not hold its scene"}`;

/** Frame `index` is shown. Row k of the past is frame k, as far as frames have been read in order. */
export class RecordedRun implements Run {
  readonly live = null;
  before: Moment | null = null;
  readonly past = new PastColumns();
  private index = 0;
  private readonly log = new ContactLog();
  private readonly frames = new Map<number, Moment>();
  private readonly wanted = new Set<number>();
  private isClosed = false;

  private constructor(readonly recording: Recording, readonly info: SceneInfo, readonly text: string,
                      private readonly goals: Goals, public moment: Moment) {
    this.frames.set(0, moment);
    this.note(moment);
    this.readAhead();
  }

  /** Reads all frames for the past, while the page stays responsive; calls `tell` from time to time. */
  async readPast(tell: () => void): Promise<void> {
    let before = this.frames.get(0)!;
    let begun = performance.now();
    for (let k = 1; k < this.recording.times.length && !this.isClosed; ++k) {
      const moment = momentOf(await this.recording.frame(k), k, this.info, this.goals);
      moment.acceleration = changeOfVelocity(before, moment);
      this.note(moment);
      before = moment;
      if (performance.now() - begun < READING) continue;
      await new Promise((rested) => setTimeout(rested, RESTING));
      begun = performance.now();
      tell();
    }
    if (!this.isClosed) tell();
  }

  close(): void { this.isClosed = true; }

  /** `text` is the scene's text, "" if unknown; `goals`: by robot number (m), if known. */
  static async open(recording: Recording, info: SceneInfo, text: string, goals: Goals): Promise<RecordedRun> {
    const first = momentOf(await recording.frame(0), 0, info, goals);
    return new RecordedRun(recording, info, text, goals, first);
  }

  get contacts() { return this.log.list; }
  get start(): number { return this.recording.times[0] ?? 0; }
  readonly handmade = false;
  get end(): number { return this.recording.times[this.recording.times.length - 1] ?? 0; }

  canStep(): boolean { return this.index + 1 < this.recording.times.length; }

  step(): boolean {
    const next = this.frames.get(this.index + 1);
    if (next) this.show(this.index + 1, next, this.moment);
    this.readAhead();
    return next !== undefined;
  }

  async stepBack(): Promise<void> {
    if (this.index > 0) await this.goToFrame(this.index - 1);
  }

  async goTo(time: number): Promise<void> {
    await this.goToFrame(lastAt(this.recording.times, time));
  }

  private async goToFrame(k: number): Promise<void> {
    const before = k > 0 ? await this.read(k - 1) : null;
    this.show(k, await this.read(k), before);
    this.readAhead();
  }

  private show(k: number, moment: Moment, before: Moment | null): void {
    this.index = k;
    this.moment = moment;
    this.before = before;
    if (before) moment.acceleration = changeOfVelocity(before, moment);
  }

  private async read(k: number): Promise<Moment> {
    const known = this.frames.get(k);
    if (known) return known;
    const moment = momentOf(await this.recording.frame(k), k, this.info, this.goals);
    this.frames.set(k, moment);
    for (const old of this.frames.keys()) {
      if (this.frames.size <= FRAMES_KEPT) break;
      if (old < this.index || old > this.index + 2 * FRAMES_AHEAD) this.frames.delete(old);
    }
    return moment;
  }

  private readAhead(): void {
    const end = Math.min(this.index + FRAMES_AHEAD, this.recording.times.length - 1);
    for (let k = this.index + 1; k <= end; ++k) {
      if (this.frames.has(k) || this.wanted.has(k)) continue;
      this.wanted.add(k);
      this.read(k).catch(() => undefined).finally(() => this.wanted.delete(k));
    }
  }

  /** Adds the next moment to the past. */
  private note(moment: Moment): void {
    const touches = touchesIn(moment, this.info);
    this.log.note(touches, moment.time, this.past.size ? this.past.times[this.past.size - 1]! : moment.time);
    this.past.push(moment, this.info, touches.length);
  }
}

/** Returns the robots that are present in a frame. */
function momentOf(frame: RecordedFrame, k: number, info: SceneInfo, goals: Goals): Moment {
  const robots = [...frame.there.keys()].filter((i) => frame.there[i]);
  const { dimensions } = info;
  const vectors = (from: Float64Array) => Float64Array.from(robots.flatMap((i) => [...from.subarray(dimensions * i, dimensions * (i + 1))]));
  const unknown = new Array<number>(dimensions).fill(NaN);
  const parked = new Set(info.robots.filter((robot) => robot.parked).map((robot) => robot.robot));
  const moment: Moment = {
    dimensions,
    time: frame.time,
    steps: k,
    robot: Int32Array.from(robots),
    position: vectors(frame.position),
    velocity: vectors(frame.velocity),
    goal: Float64Array.from(robots.flatMap((i) => goals.get(i) ?? unknown)),
    heading: Float64Array.from(robots, (i) => frame.heading[i] || 0),
    acceleration: new Float64Array(robots.length),
    status: Uint8Array.from(robots, (i) => frame.status[i]!),
    decided: Uint8Array.from(robots, (i) => (parked.has(i) || k === 0 ? 0 : 1)),
    arrived: new Uint8Array(robots.length),
    clearance: Float32Array.from(robots, (i) => frame.clearance[i]!),
    moving_obstacles: moversAt(info, frame.time),
  };
  moment.arrived = moment.arrived.map((_, i) => (distanceToGoal(moment, i) <= info.options.arrival_distance ? 1 : 0));
  if (moment.clearance.some(Number.isNaN)) fillClearance(moment, info);
  return moment;
}

function distanceToGoal(moment: Moment, i: number): number {
  const [at, to] = [moment.position, moment.goal].map((of) => vectorOf(of, moment.dimensions, i));
  return Math.hypot(to![0] - at![0], to![1] - at![1], to![2] - at![2]);
}

/** Returns m/s^2, from row to row; 0 for a robot that was absent. */
function changeOfVelocity(before: Moment, now: Moment): Float64Array {
  const span = now.time - before.time;
  let at = 0;  // both are sorted by ascending numbers
  return Float64Array.from(now.robot, (robot, i) => {
    while (at < before.robot.length && before.robot[at]! < robot) ++at;
    if (before.robot[at] !== robot || span <= 0) return 0;
    const [is, was] = [vectorOf(now.velocity, now.dimensions, i), vectorOf(before.velocity, before.dimensions, at)];
    return Math.hypot(is[0] - was[0], is[1] - was[1], is[2] - was[2]) / span;
  });
}
