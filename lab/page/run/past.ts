// SPDX-License-Identifier: Apache-2.0
// The results of each step of a run, in columns, for charts and for the strip of a robot's decisions.
import { STATUSES, type Moment, type SceneInfo } from "../../avo/avo.ts";
import { robotsOf, speedOf } from "../map/discs.ts";
import type { Past } from "./lab.ts";
import { NO_DECISION } from "./thinned.ts";

const STATUS_BYTES = 32e6;  // the limit for all robots' statuses; with more robots and steps there is no strip

type Column = "times" | "clearance" | "speed_ratio" | "acceleration_ratio" | "arrived" | "contacts";
const COLUMNS: Column[] = ["times", "clearance", "speed_ratio", "acceleration_ratio", "arrived", "contacts"];

/** All columns have the same length. */
export class PastColumns implements Past {
  size = 0;
  private capacity = 256;
  private readonly columns = new Map<Column, Float64Array>(COLUMNS.map((name) => [name, new Float64Array(256)]));
  private counts = STATUSES.map(() => new Uint32Array(256));
  private decisions: Uint8Array[] = [];  // one array for each step, by robot number
  private decisionBytes = 0;

  get times() { return this.column("times"); }
  get clearance() { return this.column("clearance"); }
  get speed_ratio() { return this.column("speed_ratio"); }
  get acceleration_ratio() { return this.column("acceleration_ratio"); }
  get arrived() { return this.column("arrived"); }
  get contacts() { return this.column("contacts"); }
  get statuses() { return this.counts.map((all) => all.subarray(0, this.size)); }

  statusOf(robot: number): Uint8Array {
    return Uint8Array.from({ length: this.size }, (_, k) => this.decisions[k]?.[robot] ?? NO_DECISION);
  }

  /** Adds the row of `moment`; `contacts` is the number of pairs that overlap. */
  push(moment: Moment, info: SceneInfo, contacts: number): void {
    if (this.size === this.capacity) this.grow();
    const k = this.size++;
    const put = (name: Column, value: number) => { this.columns.get(name)![k] = value; };
    put("times", moment.time);
    put("contacts", contacts);
    const most = ratios(moment, info);
    put("speed_ratio", most.speed);
    put("acceleration_ratio", most.acceleration);
    put("clearance", moment.clearance.reduce((least, c) => (c < least ? c : least), Infinity));
    put("arrived", moment.arrived.reduce((sum, there) => sum + (there ? 1 : 0), 0));
    this.pushStatuses(k, moment);
  }

  /** Forgets all rows behind the first `size`. */
  truncate(size: number): void {
    this.size = Math.min(this.size, size);
    for (const gone of this.decisions.splice(this.size)) this.decisionBytes -= gone.length;
  }

  private pushStatuses(k: number, moment: Moment): void {
    for (const count of this.counts) count[k] = 0;
    const count = moment.robot.length ? moment.robot[moment.robot.length - 1]! + 1 : 0;
    const kept = this.decisionBytes + count <= STATUS_BYTES;
    const row = new Uint8Array(kept ? count : 0).fill(NO_DECISION);
    for (let i = 0; i < moment.robot.length; ++i) {
      if (!moment.decided[i]) continue;
      const status = moment.status[i]!;
      if (this.counts[status]) ++this.counts[status]![k]!;
      if (kept) row[moment.robot[i]!] = status;
    }
    this.decisions[k] = row;
    this.decisionBytes += row.length;
  }

  private column(name: Column): Float64Array {
    return this.columns.get(name)!.subarray(0, this.size);
  }

  private grow(): void {
    this.capacity *= 2;
    for (const [name, old] of this.columns) {
      const longer = new Float64Array(this.capacity);
      longer.set(old);
      this.columns.set(name, longer);
    }
    this.counts = this.counts.map((old) => {
      const longer = new Uint32Array(this.capacity);
      longer.set(old);
      return longer;
    });
  }
}

/** Returns the largest |v| / max_speed and |a| / max_acceleration of a moment. */
function ratios(moment: Moment, info: SceneInfo): { speed: number; acceleration: number } {
  let speed = 0;
  let acceleration = 0;
  robotsOf(moment, info).forEach((robot, i) => {
    if (!robot) return;
    speed = Math.max(speed, speedOf(moment, i, robot) / robot.max_speed);
    if (robot.model === "airplane") return;  // it has another limit across its direction of flight
    acceleration = Math.max(acceleration, moment.acceleration[i]! / robot.max_acceleration);
  });
  return { speed, acceleration };
}
