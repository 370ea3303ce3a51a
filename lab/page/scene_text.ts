// SPDX-License-Identifier: Apache-2.0
// Edits of a scene's YAML that leave all else as it is, byte by byte: comments, columns, order.
import { isMap, isScalar, isSeq, parseDocument, type Node, type Pair, type YAMLMap, type YAMLSeq } from "yaml";

type Key = string | number;
type Collection = YAMLMap | YAMLSeq;

/** "robots.0.radius" as keys; whole numbers are places in lists. */
function keysOf(path: string): Key[] {
  return path.split(".").map((key) => (/^\d+$/.test(key) ? Number(key) : key));
}

/** The text with `value` at `path`, whose last key may be new; undefined takes it out. */
export function withValue(yaml: string, path: string, value: unknown): string {
  const keys = keysOf(path);
  const known = nodeAt(yaml, keys);
  if (value === undefined) return known ? without(yaml, keys) : yaml;
  if (known) {
    const end = endOf(known);  // of a block of text: behind its last newline, which stays
    return splice(yaml, known.range![0], yaml[end - 1] === "\n" ? end - 1 : end, flow(value));
  }
  const holder = nodeAt(yaml, keys.slice(0, -1));
  if (!isMap(holder)) throw new Error(`the scene has nothing at ${keys.slice(0, -1).join(".") || "its top"}`);
  return withKey(yaml, holder, `${keys[keys.length - 1]}: ${flow(value)}`);
}

/** The text with one more entry at the end of a list, which is made if need be. */
export function withEntry(yaml: string, list: string, value: unknown): string {
  const known = nodeAt(yaml, keysOf(list));
  if (!isSeq(known) || known.items.length === 0) {
    const bare = known ? without(yaml, keysOf(list)) : yaml;
    return `${bare.replace(/\n*$/, "\n")}${list}:\n  - ${flow(value)}\n`;
  }
  if (known.flow) return splice(yaml, endOf(known) - 1, endOf(known) - 1, `, ${flow(value)}`);
  const dash = yaml.lastIndexOf("-", (known.items[0] as Node).range![0]);
  return insertLine(yaml, endOf(known), `${" ".repeat(dash - lineStart(yaml, dash))}- ${flow(value)}`);
}

/** The text with `key: value` in each of `robots`, of `groups` and in `robots_from`: for all robots. */
export function withRobotKey(yaml: string, key: string, value: number): string {
  const counts = ["robots", "groups"].flatMap((list) => {
    const node = nodeAt(yaml, [list]);
    return isSeq(node) ? node.items.map((_, k) => `${list}.${k}`) : [];
  });
  const paths = nodeAt(yaml, ["robots_from"]) ? [...counts, "robots_from"] : counts;
  return paths.reduce((text, path) => withValue(text, `${path}.${key}`, value), yaml);
}

/** The value at `path` in plain JavaScript, or undefined. */
export function valueAt(yaml: string, path: string): unknown {
  const node = nodeAt(yaml, keysOf(path));
  return node ? node.toJS(parseDocument(yaml)) : undefined;
}

/** How many robots stand in the list `robots`; those of files and groups are numbered after them. */
export function robotsListed(yaml: string): number {
  const robots = nodeAt(yaml, ["robots"]);
  return isSeq(robots) ? robots.items.length : 0;
}

export function hasMoreRobots(yaml: string): boolean {
  return nodeAt(yaml, ["groups"]) !== undefined || nodeAt(yaml, ["robots_from"]) !== undefined;
}

/** Numbers without the noise of binary fractions, texts plain where YAML takes them so, [1, 2] and {radius: 0.5}. */
export function flow(value: unknown): string {
  if (typeof value === "number") return String(Number(value.toPrecision(12)));
  if (Array.isArray(value)) return `[${value.map(flow).join(", ")}]`;
  if (value && typeof value === "object") {
    return `{${Object.entries(value).filter(([, of]) => of !== undefined).map(([key, of]) => `${key}: ${flow(of)}`).join(", ")}}`;
  }
  if (typeof value !== "string") return String(value);
  return /^[A-Za-z][\w -]*$/.test(value) && !/^(true|false|null|yes|no|on|off)$/i.test(value) ? value : JSON.stringify(value);
}

function nodeAt(yaml: string, keys: Key[]): Node | undefined {
  const document = parseDocument(yaml);
  const node = keys.length ? document.getIn(keys, true) : document.contents;
  return (node as Node | null) ?? undefined;
}

function withKey(yaml: string, map: YAMLMap, entry: string): string {
  if (map.flow || map.items.length === 0) {
    const end = endOf(map) - 1;
    return splice(yaml, end, end, map.items.length ? `, ${entry}` : entry);
  }
  const first = (map.items[0]!.key as Node).range![0];
  const column = first - lineStart(yaml, first);
  const plain = map.items.filter((pair) => isScalar(pair.value));  // above the long lists
  const after = plain[plain.length - 1] ?? map.items[map.items.length - 1]!;
  return insertLine(yaml, endOf(after.value as Node), " ".repeat(column) + entry);
}

function without(yaml: string, keys: Key[]): string {
  const holder = nodeAt(yaml, keys.slice(0, -1)) as Collection;
  const last = keys[keys.length - 1]!;
  const at = isSeq(holder) ? Number(last) : (holder.items as Pair[]).findIndex((pair) => isScalar(pair.key) && pair.key.value === last);
  const starts = (holder.items as (Node | Pair)[]).map((item) => ("key" in item ? (item.key as Node) : (item as Node)).range![0]);
  const ends = (holder.items as (Node | Pair)[]).map((item) => endOf(("key" in item ? item.value ?? item.key : item) as Node));
  if (holder.flow) {
    if (starts.length === 1) return splice(yaml, starts[0]!, ends[0]!, "");
    return at > 0 ? splice(yaml, ends[at - 1]!, ends[at]!, "") : splice(yaml, starts[0]!, starts[1]!, "");
  }
  if (isSeq(holder) && holder.items.length === 1) return without(yaml, keys.slice(0, -1));  // no empty list stays
  return splice(yaml, lineStart(yaml, starts[at]!), lineEnd(yaml, ends[at]!), "");
}

/** Behind the last character of the node itself, before comments and empty lines that follow it. */
function endOf(node: Node): number {
  if ((isMap(node) || isSeq(node)) && !node.flow && node.items.length) {
    const last = node.items[node.items.length - 1] as Node | Pair;
    return endOf(("key" in last ? last.value ?? last.key : last) as Node);
  }
  return node.range![1];
}

const lineStart = (text: string, at: number) => text.lastIndexOf("\n", at - 1) + 1;

/** Behind the newline of the line that ends with what ends at `at`. */
function lineEnd(text: string, at: number): number {
  if (text[at - 1] === "\n") return at;
  const newline = text.indexOf("\n", at);
  return newline < 0 ? text.length : newline + 1;
}

function insertLine(text: string, after: number, line: string): string {
  const at = lineEnd(text, after);
  return splice(text, at, at, text[at - 1] === "\n" ? `${line}\n` : `\n${line}\n`);
}

const splice = (text: string, from: number, to: number, by: string) => text.slice(0, from) + by + text.slice(to);
