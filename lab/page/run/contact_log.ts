// SPDX-License-Identifier: Apache-2.0
// The contacts of discs: a pair that keeps touching is one contact, stored at its deepest.
import type { Contact } from "./lab.ts";

export type Touch = Omit<Contact, "time" | "last">;

/** `latest` holds the last contact of each pair in `list`. */
export class ContactLog {
  list: Contact[] = [];
  private latest = new Map<string, Contact>();

  /** Adds the contacts at `time`; the step before was at `before`. */
  note(touches: Touch[], time: number, before: number): void {
    for (const touch of touches) {
      const pair = `${touch.a} ${touch.b}`;
      const known = this.latest.get(pair);
      if (known && known.last >= before - 1e-9) {
        known.last = time;
        if (touch.depth > known.depth) Object.assign(known, touch);
      } else {
        const contact = { ...touch, time, last: time };
        this.list.push(contact);
        this.latest.set(pair, contact);
      }
    }
  }

  forgetAfter(time: number): void {
    this.list = this.list.filter((contact) => contact.time <= time + 1e-9);
    this.latest = new Map(this.list.map((contact) => [`${contact.a} ${contact.b}`, contact]));
    for (const contact of this.list) contact.last = Math.min(contact.last, time);
  }
}
