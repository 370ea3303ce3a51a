// SPDX-License-Identifier: Apache-2.0
// Reduces long columns to few pixels, and keeps their extremes.
import { STATUSES } from "../../avo/avo.ts";

/** Stands in place of a status if a robot decided nothing, or was absent. */
export const NO_DECISION = 255;

/** Keeps at most about `most` rows: of each group of rows the one with the lowest value, or with the highest. */
export function thinned(times: ArrayLike<number>, values: ArrayLike<number>, most: number, lowest: boolean): [number[], (number | null)[]] {
  const group = Math.max(1, Math.ceil(times.length / most));
  const at: number[] = [], extreme: (number | null)[] = [];
  for (let first = 0; first < times.length; first += group) {
    let best = first;
    for (let k = first; k < Math.min(first + group, times.length); ++k)
      if (lowest ? values[k]! < values[best]! : values[k]! > values[best]!) best = k;
    at.push(times[best]!);
    extreme.push(Number.isFinite(values[best]!) ? values[best]! : null);
  }
  return [at, extreme];
}

/** From calm to alarming, which is not the order of PlanStatus. */
const BY_ALARM = ["optimal", "least_unsafe", "refused", "detour", "braking", "overlapping", "invalid_input"];

/** Returns the place of a status in that order. */
export function alarmOf(status: number): number {
  return BY_ALARM.indexOf(STATUSES[status]!);
}

/** Returns for each pixel the worst status of its steps; -1 if nothing was decided. */
export function worstByPixel(statuses: Uint8Array, times: ArrayLike<number>, end: number, width: number): Int8Array {
  const worst = new Int8Array(width).fill(-1);
  for (let k = 1; k < statuses.length; ++k) {  // row 0 is the start, before the first decision
    const status = statuses[k]!;
    if (status === NO_DECISION) continue;
    const first = Math.floor(times[k - 1]! / end * width), last = Math.max(first + 1, Math.ceil(times[k]! / end * width));
    for (let x = first; x < last && x < width; ++x) {
      if (worst[x]! < 0 || alarmOf(status) > alarmOf(worst[x]!)) worst[x] = status;
    }
  }
  return worst;
}
