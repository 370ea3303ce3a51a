// SPDX-License-Identifier: Apache-2.0
// Playback: it does as many steps per frame as the speed requires and the machine can do, and interpolates between two
// steps.
import type { Run } from "./run.ts";

const FRAME_BUDGET = 24;  // ms of steps per frame, so that the page stays responsive
const LONGEST_FRAME = 0.1;  // s: after a visit to another tab, the run is where it was

export interface Playback {
  playing: boolean;
  speed: number;         // simulated seconds per second
  time: number;          // s, the shown time; between `before` and `moment` of the run while it plays
  target: number | null; // s, the time that the run has to reach
}

/** Advances by `elapsed` seconds of real time. Returns true if a step was taken. */
export function moveOn(playback: Playback, run: Run, elapsed: number): boolean {
  if (playback.target !== null) return headFor(playback, run);
  if (!playback.playing) return false;
  playback.time += Math.min(elapsed, LONGEST_FRAME) * playback.speed;
  const stepped = stepTo(run, playback.time);
  if (run.moment.time < playback.time) playback.time = run.moment.time;  // it was too slow, or it is over
  return stepped;
}

function headFor(playback: Playback, run: Run): boolean {
  const stepped = stepTo(run, playback.target! - 1e-9);
  if (run.moment.time >= playback.target! - 1e-9 || !run.canStep()) playback.target = null;
  playback.time = run.moment.time;
  return stepped;
}

function stepTo(run: Run, time: number): boolean {
  const begun = performance.now();
  let stepped = false;
  while (run.moment.time < time && run.canStep() && performance.now() - begun < FRAME_BUDGET) {
    if (!run.step()) break;
    stepped = true;
  }
  return stepped;
}

/** Returns 0 to 1: the position of the picture between the run's `before` and its `moment`. */
export function shareOf(playback: Playback, run: Run): number {
  const { before, moment } = run;
  if (!before || !playback.playing || playback.target !== null) return 1;
  const span = moment.time - before.time;
  return span > 0 ? Math.min(1, Math.max(0, (playback.time - before.time) / span)) : 1;
}
