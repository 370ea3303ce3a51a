// SPDX-License-Identifier: Apache-2.0
// Trails: the places of all robots at a few times in the last seconds.
import { vectorOf } from "./discs.ts";
import type { Vec3 } from "./vec3.ts";
import type { Shown } from "./shown.ts";

const SECONDS = 4;         // of the scene's time scale: a robot travels a few of its diameters
const SEGMENTS = 4000;     // the limit for all robots together
const MOST_SAMPLES = 24;   // for one robot

interface Sample { time: number; places: Map<number, Vec3> }

/** Samples by ascending time. */
export interface Trails { samples: Sample[] }

/** Stores the places of all robots at a step. */
export function noteTrails(trails: Trails, shown: Shown): void {
  const { moment } = shown;
  const { samples } = trails;
  while (samples.length && samples[samples.length - 1]!.time >= moment.time - 1e-9) samples.pop();
  const keep = Math.min(MOST_SAMPLES, Math.max(4, Math.floor(SEGMENTS / Math.max(1, moment.robot.length))));
  const last = samples[samples.length - 1];
  if (last && moment.time - last.time > SECONDS) samples.length = 0;  // the time has jumped
  if (last && samples.length && moment.time - last.time < SECONDS / keep - 1e-6) return;
  samples.push({ time: moment.time, places: new Map(Array.from(moment.robot, (robot, i) => [robot, vectorOf(shown.world, 3, i)])) });
  while (samples.length > keep || samples[0]!.time < moment.time - SECONDS - 1e-6) samples.shift();
}

export type VisitPiece = (row: number, ax: number, ay: number, bx: number, by: number, young: number) => void;

/** Calls `visit` for each piece between two samples; young: from 1 (now) to 0 (about to disappear). */
export function forTrails({ samples }: Trails, { moment, project }: Shown, visit: VisitPiece): void {
  moment.robot.forEach((robot, row) => {
    let from: Vec3 | undefined;
    for (const { time, places } of samples) {
      if (time > moment.time - 1e-9) break;  // the picture has not reached that place yet
      const place = places.get(robot);
      const to = place && project(...place);
      if (from && to && (from[0] !== to[0] || from[1] !== to[1])) {
        visit(row, from[0], from[1], to[0], to[1], 1 - (moment.time - time) / SECONDS);
      }
      if (to) from = to;
    }
  });
}

/** Does the same for the pieces from the last samples to the robots' places in the picture. */
export function forHeads({ samples }: Trails, shown: Shown, visit: VisitPiece): void {
  const last = samples[samples.length - 1];
  const newest = last && last.time > shown.moment.time - 1e-9 ? samples[samples.length - 2] : last;
  if (!newest) return;
  shown.moment.robot.forEach((robot, row) => {
    const place = newest.places.get(robot);
    const from = place && shown.project(...place);
    if (from) visit(row, from[0], from[1], shown.x[row]!, shown.y[row]!, 1);
  });
}
