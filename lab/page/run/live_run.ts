// SPDX-License-Identifier: Apache-2.0
// A run that is simulated while it is shown, and that can go back.
import type { Moment, SceneInfo, Simulation } from "../../avo/avo.ts";
import { ContactLog } from "./contact_log.ts";
import { History, type Edit, type Place } from "./history.ts";
import { PastColumns } from "./past.ts";
import { lastAt, type Run } from "./run.ts";

/** `moment`, `info`, the past's row and the contacts belong to `place`; step k of the past is step k of the run. */
export class LiveRun implements Run {
  info: SceneInfo;
  moment: Moment;
  before: Moment | null = null;
  readonly past = new PastColumns();
  readonly start = 0;
  private readonly log = new ContactLog();
  private readonly history = new History();
  private place: Place;
  private latest: Moment | null = null;  // the present moment, once it has been read

  /** `began` is the scene's text. */
  constructor(simulation: Simulation, private readonly began: string) {
    this.place = { step: 0, edits: 0, simulation, offset: 0 };
    this.info = simulation.info();
    this.moment = this.now();
    this.note();
    this.history.keep(this.place, true);
  }

  get live(): Simulation { return this.place.simulation; }
  get text(): string { return this.edits.reduce((text, edit) => edit.text ?? text, this.began); }
  get handmade(): boolean { return this.edits.some(({ text }) => text === null); }
  get contacts() { return this.log.list; }
  get end(): number { return Math.max(this.info.duration, this.past.times[this.past.size - 1]!); }

  /** The edits before this moment. */
  private get edits(): Edit[] { return this.history.edits.slice(0, this.place.edits); }

  canStep(): boolean {
    return this.live.canStep() && this.moment.time < this.info.duration - 1e-9;
  }

  step(): boolean {
    const before = this.moment;
    this.advance();
    this.before = before;
    this.moment = this.now();
    return true;
  }

  stepBack(): void {
    if (this.place.step > 0) this.goToStep(this.place.step - 1);
  }

  goTo(time: number): void {
    this.goToStep(lastAt(this.past.times, time));
  }

  /** Does `apply` now, and again whenever the run passes this place. A `text` that takes over gives another simulation. */
  edit(apply: (simulation: Simulation) => Simulation, text: string | null = null): void {
    const { step, edits, offset } = this.place;
    const time = this.live.time + offset;
    const saved = this.live.save();
    const simulation = this.live;
    try {
      this.place.simulation = apply(simulation);
    } catch (error) {
      simulation.restore(saved);
      throw error;
    }
    this.history.forgetAfter(step, edits);
    this.past.truncate(step);
    this.log.forgetAfter(time);
    this.history.edits.push({ step, apply, text });
    this.place.edits = edits + 1;
    this.place.offset = time - this.live.time;
    this.history.keep(this.place, true);
    this.info = this.live.info();
    this.before = null;
    this.latest = null;
    this.moment = this.now();
    this.note();
  }

  /** Notes that this text contains the last edit. */
  noteText(text: string): void {
    const last = this.history.edits[this.place.edits - 1];
    if (last) last.text = text;
  }

  private goToStep(step: number): void {
    if (step < this.place.step) this.place = this.history.before(step);
    this.latest = null;
    this.catchUp();
    while (this.place.step < step - 1) this.advance();
    const before = this.place.step < step ? this.now() : null;
    if (before) this.advance();
    this.info = this.live.info();
    this.before = before;
    this.moment = this.now();
  }

  /** Does one step, and the edits at the step that it leads to. */
  private advance(): void {
    this.live.step();
    ++this.place.step;
    this.latest = null;
    this.catchUp();
    this.history.keep(this.place);
    if (this.past.size === this.place.step) this.note();
  }

  private catchUp(): void {
    for (;;) {
      const edit = this.history.edits[this.place.edits];
      if (!edit || edit.step > this.place.step) return;
      const time = this.live.time + this.place.offset;
      this.place.simulation = edit.apply(this.live);
      this.place.offset = time - this.live.time;
      ++this.place.edits;
      this.info = this.live.info();
      this.latest = null;
    }
  }

  /** Returns the present moment, in the run's time. */
  private now(): Moment {
    if (!this.latest) {
      this.latest = this.live.moment();
      this.latest.time += this.place.offset;
      this.latest.steps = this.place.step;
    }
    return this.latest;
  }

  /** Adds the present moment to the past. */
  private note(): void {
    const { info, past } = this;
    const moment = this.now();
    const near = info.walls.length + info.boxes.length + info.moving_obstacles.length > 0 || moment.clearance.some((clearance) => clearance < 0);
    const touches = near ? this.live.contacts() : [];
    this.log.note(touches, moment.time, past.size ? past.times[past.size - 1]! : moment.time);
    past.push(moment, info, touches.length);
  }
}
