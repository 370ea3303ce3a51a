// SPDX-License-Identifier: Apache-2.0
// The history of a live run: saved states at some steps, and the user's actions between steps. The text and these edits
// determine the run, so going back and forth gives the same bits.
import type { Simulation } from "../../avo/avo.ts";

/** An action of the user at a step; `apply` repeats it, and returns the simulation that continues. */
export interface Edit {
  step: number;
  apply(simulation: Simulation): Simulation;
  text: string | null;  // of the scene from here on; null: it does not contain the edit
}

interface Keyframe {
  step: number;
  edits: number;           // number of the edits before it
  simulation: Simulation;  // the simulation of these bytes
  saved: Uint8Array;
  offset: number;          // s, from the simulation's time to the run's
}

export interface Place {
  step: number;
  edits: number;
  simulation: Simulation;
  offset: number;
}

const KEYFRAME_BYTES = 64e6;     // of all saved states together; with more of them going back is faster
const MOST_SIMULATIONS = 6;      // in keyframes: each has its own memory
const FIRST_INTERVAL = 8;        // steps

/** Keyframes are sorted by ascending step and edits; the first one is the start and stays. */
export class History {
  readonly edits: Edit[] = [];
  private keyframes: Keyframe[] = [];
  private interval = FIRST_INTERVAL;
  private bytes = 0;

  /** Saves the state at `place`, if it is `asked` for or another one is due. */
  keep(place: Place, asked = false): void {
    const last = this.keyframes[this.keyframes.length - 1];
    if (last && (last.step > place.step || last.edits > place.edits)) return;  // the run has gone back
    if (last && last.step === place.step && last.edits === place.edits) return;
    if (last && !asked && place.step - last.step < this.interval) return;
    const saved = place.simulation.save();
    this.keyframes.push({ ...place, saved });
    this.bytes += saved.length;
    while (this.bytes > KEYFRAME_BYTES && this.keyframes.length > 2) this.thin();
    this.releaseOldest();
  }

  /** Restores and returns the nearest state from which `step` can be reached. */
  before(step: number): Place {
    let k = this.keyframes.length - 1;
    while (k > 0 && this.keyframes[k]!.step > step) --k;
    const { simulation, saved, edits, offset, step: at } = this.keyframes[k]!;
    simulation.restore(saved);
    return { simulation, edits, offset, step: at };
  }

  /** Forgets everything after this place: the run continues differently from here. */
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
    const oldest = held[1];  // the first one belongs to the start
    this.replace(this.keyframes.filter((frame, k) => k === 0 || frame.simulation !== oldest));
  }

  private replace(kept: Keyframe[]): void {
    this.keyframes = kept;
    this.bytes = kept.reduce((sum, frame) => sum + frame.saved.length, 0);
  }
}
