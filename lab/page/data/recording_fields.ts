// SPDX-License-Identifier: Apache-2.0
// The facts that a recording stores about itself, as named fields (io/recording/recording_fields.h).
import { refuse } from "./bytes.ts";
import { concatenated } from "./compression.ts";

/** Fields by name; texts verbatim. */
export type Fields = Map<string, Uint8Array | bigint>;

/** Refuses another text; `where`: in front of its name. */
export function requireText(fields: Fields, name: string, must: string, where = ""): void {
  const value = fields.get(name);
  const found = value instanceof Uint8Array ? new TextDecoder().decode(value) : null;
  if (found === must) return;
  refuse(`${where}${name}: found ${found === null ? "none" : JSON.stringify(found.slice(0, 40))}, must be ${must}`);
}

/** Returns the fields as a spool has them. */
export function packed(fields: Fields): Uint8Array {
  const parts: Uint8Array[] = [];
  const add = (number: bigint) => { parts.push(new Uint8Array(BigUint64Array.of(number).buffer)); };
  const addText = (text: Uint8Array) => {
    add(BigInt(text.length));
    parts.push(text);
  };
  for (const [name, value] of fields) {
    addText(new TextEncoder().encode(name));
    add(typeof value === "bigint" ? 0n : 1n);
    if (typeof value === "bigint") add(value);
    else addText(value);
  }
  return concatenated(parts);
}
