// SPDX-License-Identifier: Apache-2.0
// Edits of a scene's YAML that keep everything else, byte by byte: comments, columns, order.
import { isSeq } from "yaml";
import { adding, edited, find, parsed, putting, takingOut, type Key } from "./text_edits.ts";

/** Returns "robots.0.radius" as keys; whole numbers are indices into lists. */
function keysOf(path: string): Key[] {
  return path.split(".").map((key) => (/^\d+$/.test(key) ? Number(key) : key));
}

/** Returns the text with `value` at `path`. The last keys of the path may be new. undefined removes the value. */
export function withValue(yaml: string, path: string, value: unknown): string {
  const source = parsed(yaml);
  if (value === undefined) return edited(yaml, takingOut(source, keysOf(path)));
  return withWritten(yaml, path, flow(value, source.isJson));
}

/** Does the same with a value that is YAML. */
export function withWritten(yaml: string, path: string, value: string): string {
  return edited(yaml, putting(parsed(yaml), keysOf(path), value));
}

/** Returns the text with one more entry at the end of a list; it makes the list if necessary. */
export function withEntry(yaml: string, list: string, value: unknown): string {
  const source = parsed(yaml);
  return edited(yaml, adding(source, keysOf(list), flow(value, source.isJson)));
}

/** Returns the text with `key: value` in each of `robots`, of `groups` and in `robots_from`: for all robots. */
export function withRobotKey(yaml: string, key: string, value: number): string {
  const source = parsed(yaml);
  const holders: Key[][] = ["robots", "groups"].flatMap((list) => {
    const { node, missing } = find(source, [list]);
    return isSeq(node) && !missing.length ? node.items.map((_, k) => [list, k]) : [];
  });
  if (has(yaml, "robots_from")) holders.push(["robots_from"]);
  return edited(yaml, holders.flatMap((holder) => putting(source, [...holder, key], flow(value))));
}

/** Returns the value at `path` in plain JavaScript, or undefined. */
export function valueAt(yaml: string, path: string): unknown {
  const source = parsed(yaml);
  const { node, missing } = find(source, keysOf(path));
  return missing.length ? undefined : node?.toJS(source.document);
}

/** Returns the number of robots in the list `robots`; robots of files and groups are numbered after them. */
export function robotsListed(yaml: string): number {
  const { node, missing } = find(parsed(yaml), ["robots"]);
  return isSeq(node) && !missing.length ? node.items.length : 0;
}

export function hasMoreRobots(yaml: string): boolean {
  return has(yaml, "groups") || has(yaml, "robots_from");
}

function has(yaml: string, key: string): boolean {
  return find(parsed(yaml), [key]).missing.length === 0;
}

/** Writes numbers without the noise of binary fractions. Texts are plain if YAML permits that and none must be
 * `quoted`, e.g. [1, 2] and {radius: 0.5}. */
export function flow(value: unknown, quoted = false): string {
  const write = (part: unknown) => flow(part, quoted);
  if (typeof value === "number") return String(Number(value.toPrecision(12)));
  if (Array.isArray(value)) return `[${value.map(write).join(", ")}]`;
  if (value && typeof value === "object") {
    const entries = Object.entries(value).filter(([, of]) => of !== undefined);
    return `{${entries.map(([key, of]) => `${quoted ? JSON.stringify(key) : key}: ${write(of)}`).join(", ")}}`;
  }
  if (typeof value !== "string") return String(value);
  const isPlain = !quoted && /^[A-Za-z]([\w -]*[\w-])?$/.test(value) && !/^(true|false|null|yes|no|on|off)$/i.test(value);
  return isPlain ? value : JSON.stringify(value);
}
