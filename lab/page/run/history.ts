// SPDX-License-Identifier: Apache-2.0
// The way back of a live run: saved states at some steps, and what the user did between steps. A run is a function of
// its text and of these edits, so whoever goes back and forth again comes to the same bits.
import type { Simulation } from "../../avo/avo.ts";

/** What the user did at a step; `apply` does it again, and returns the simulation that goes on. */
export interface Edit {
  step: number;
  apply(simulation: Simulation): Simulation;
  text: string | null;  // of the scene from here on; null: it says nothing of this
}

interface Keyframe {
  step: number;
  edits: number;           // how many of the edits it has seen
  simulation: Simulation;  // that the bytes are of
  saved: Uint8Array;
  offset: number;          // s, from the simulation's time to the run's
}

export interface Place {
  step: number;
  edits: number;
  simulation: Simulation;
  offset: number;
}

const KEYFRAME_BYTES = 64e6;     // of all saved states together; more of them make going back quicker
const MOST_SIMULATIONS = 6;      // that keyframes hold: each has memory of its own
const FIRST_INTERVAL = 8;        // steps

/** Keyframes are by ascending step and edits; the first one is the start and stays. */
export class History {
  readonly edits: Edit[] = [];
  private keyframes: Keyframe[] = [];
  private interval = FIRST_INTERVAL;
  private bytes = 0;

  /** Keeps the state at `place`, if it is `asked` for or time for another one. */
  keep(place: Place, asked = false): void {
    const last = this.keyframes[this.keyframes.length - 1];
    if (last && (last.step > place.step || last.edits > place.edits)) return;  // gone back
    if (last && last.step === place.step && last.edits === place.edits) return;
    if (last && !asked && place.step - last.step < this.interval) return;
    const saved = place.simulation.save();
    this.keyframes.push({ ...place, saved });
    this.bytes += saved.length;
    while (this.bytes > KEYFRAME_BYTES && this.keyframes.length > 2) this.thin();
    this.releaseOldest();
  }

  /** The nearest state to go on from to `step`, restored. */
  before(step: number): Place {
    let k = this.keyframes.length - 1;
    while (k > 0 && this.keyframes[k]!.step > step) --k;
    const { simulation, saved, edits, offset, step: at } = this.keyframes[k]!;
    simulation.restore(saved);
    return { simulation, edits, offset, step: at };
  }

  /** What came after this place is no more: the run goes another way from here. */
  forgetAfter(step: number, edits: number): void {
    this.edits.splice(edits);
    const kept = this.keyframes.filter((frame, k) => k === 0 || (frame.step <= step && frame.edits <= edits));
    this.replace(kept);
  }

  private thin(): void {
    this.interval *= 2;
    this.replace(this.keyframes.filter((_, k) => k % 2 === 0));
  }

  private releaseOldest(): void {
    const held = [...new Set(this.keyframes.map((frame) => frame.simulation))];
    if (held.length <= MOST_SIMULATIONS) return;
    const oldest = held[1];  // the first one is the start's
    this.replace(this.keyframes.filter((frame, k) => k === 0 || frame.simulation !== oldest));
  }

  private replace(kept: Keyframe[]): void {
    this.keyframes = kept;
    this.bytes = kept.reduce((sum, frame) => sum + frame.saved.length, 0);
  }
}
