// SPDX-License-Identifier: Apache-2.0
// Finds where a scene's text changes when a value is set, added or removed, in any form of YAML: blocks, flow, JSON,
// any line ends. All other text stays, byte by byte.
import { isCollection, isMap, isPair, isSeq, parseDocument, type CST, type Document, type Node, type Pair, type YAMLMap, type YAMLSeq } from "yaml";

export type Key = string | number;
type Collection = YAMLMap | YAMLSeq;
type Item = Node | Pair<Node, Node | null>;

/** `by` replaces the text between `from` and `to`. */
export interface Edit { from: number; to: number; by: string }

export interface Source {
  text: string;        // with "\n" for single "\r" line ends, which the parser does not know
  document: Document;
  newline: string;
  isJson: boolean;     // its keys are quoted
}

/** The node at a path, or the last node before it. */
interface Found {
  node: Node | null;
  holder: Collection | null;  // it has the node as its item `at`
  at: number;
  missing: Key[];             // the rest of the path
}

let last: { yaml: string; source: Source } | null = null;  // an editor of a text asks several times for its contents

export function parsed(yaml: string): Source {
  if (last?.yaml === yaml) return last.source;
  const text = yaml.replace(/\r(?!\n)/g, "\n");
  const document = parseDocument(text, { keepSourceTokens: true, uniqueKeys: false, prettyErrors: false, logLevel: "silent" });
  const { contents } = document;
  const key = isMap(contents) && contents.flow ? contents.items[0]?.key : null;
  const isJson = (key as { type?: string } | null)?.type === "QUOTE_DOUBLE";
  last = { yaml, source: { text, document, newline: /\r\n?|\n/.exec(yaml)?.[0] ?? "\n", isJson } };
  return last.source;
}

/** Applies the edits in linear time: there may be one edit per robot. */
export function edited(yaml: string, edits: Edit[]): string {
  let result = "", done = 0;
  for (const { from, to, by } of [...edits].sort((a, b) => a.from - b.from)) {
    result += yaml.slice(done, from) + by;
    done = to;
  }
  return result + yaml.slice(done);
}

export function find({ document }: Source, keys: Key[]): Found {
  const found: Found = { node: document.contents, holder: null, at: 0, missing: keys };
  while (found.missing.length && isCollection(found.node)) {
    const holder = found.node as Collection;
    const key = found.missing[0]!;
    const at = isSeq(holder) ? (typeof key === "number" ? key : -1) : holder.items.findIndex((pair) => String(pair.key) === String(key));
    const item = holder.items[at] as Item | undefined;
    if (item === undefined) break;
    Object.assign(found, { node: isPair(item) ? item.value : item, holder, at, missing: found.missing.slice(1) });
  }
  return found;
}

/** Puts `written` at a path. The last keys of the path may be new. */
export function putting(source: Source, keys: Key[], written: string): Edit[] {
  const found = find(source, keys);
  const [key, ...inner] = found.missing;
  if (key === undefined) return putInto(source, found, written);
  const value = inner.reduceRight((inside: string, name) => `{${keyText(source, name)}${inside}}`, written);
  if (!found.missing.some((name) => typeof name === "number")) {
    if (isMap(found.node)) return addKey(source, found.node, key, value);
    if (found.holder && isNothing(found.node)) return putInto(source, found, `{${keyText(source, key)}${value}}`);
  }
  throw new Error(`the scene has nothing at ${keys.slice(0, -1).join(".") || "its top"}`);
}

/** Puts `written` at the end of a list, which is made if necessary. */
export function adding(source: Source, keys: Key[], written: string): Edit[] {
  const found = find(source, keys);
  const { node } = found;
  if (found.missing.length === 0 && isSeq(node)) {
    if (node.flow) return addToFlow(source, node, written);
    return [lineAfter(source, endOf(source, node), `${margin(source, node)}- ${written}`)];
  }
  if (found.missing.length !== 1 || !isMap(node) || node.flow) return putting(source, keys, `[${written}]`);
  const space = margin(source, node);
  const list = `${space}${keyText(source, found.missing[0]!).trimEnd()}${source.newline}${space}  - ${written}`;
  return [lineAfter(source, endOf(source, node), list)];
}

/** Removes the node at a path; a list in a block disappears with its last entry. */
export function takingOut(source: Source, keys: Key[]): Edit[] {
  const { holder, at, missing } = find(source, keys);
  if (missing.length > 0 || !holder) return [];
  const alone = keys.length > 1 && holder.items.length === 1 && !holder.flow;
  if (alone && isSeq(holder)) return takingOut(source, keys.slice(0, -1));
  const items = tokensOf(holder);
  if (alone || !items) return putInto(source, find(source, keys.slice(0, -1)), "{}");
  return holder.flow ? takeOutOfFlow(source, holder, items, at) : takeOutOfBlock(source, holder, items, at);
}

/** Returns the tokens; a pair in a list, [a: 1], has none. */
const tokensOf = ({ srcToken }: Collection) => (srcToken as CST.BlockMap | CST.BlockSequence | CST.FlowCollection | undefined)?.items;
const isNothing = (node: Node | null) => node === null || ("value" in node && node.value === null);

function keyText({ isJson }: Source, key: Key): string {
  return isJson || !/^\w+$/.test(String(key)) ? `${JSON.stringify(String(key))}: ` : `${key}: `;
}

function putInto({ text }: Source, { node, holder, at }: Found, written: string): Edit[] {
  if (!node || !holder) throw new Error("the scene has a key without a value");
  const from = node.range![0], end = endOf({ text }, node);
  const before = /\s/.test(text[from - 1] ?? " ") ? "" : " ";
  if (end <= from) return [{ from, to: from, by: before + written + (text[from] === "#" ? " " : "") }];
  const start = lineStart(text, from);
  if (!isBlock(node) || !isBlank(text, start, from)) return [{ from, to: end, by: written }];
  // it has its own lines: append to the key or dash above them, which a comment may follow
  const { start: dash, sep } = tokensOf(holder)![at]!;
  const mark = [...dash, ...(sep ?? [])].find(({ type }) => type === "map-value-ind" || type === "seq-item-ind")!;
  return [{ from: mark.offset + 1, to: mark.offset + 1, by: ` ${written}` }, { from: start, to: lineEnd(text, end), by: "" }];
}

function addKey(source: Source, map: YAMLMap, key: Key, written: string): Edit[] {
  const entry = keyText(source, key) + written;
  if (!map.flow) {
    const plain = map.items.filter((pair) => !isCollection(pair.value));  // above the long lists
    const after = plain[plain.length - 1] ?? map.items[map.items.length - 1]!;
    return [lineAfter(source, endOf(source, after as Item), margin(source, map) + entry)];
  }
  const edits = addToFlow(source, map, entry);
  if (source.text[map.range![0]] === "{") return edits;
  const end = endOf(source, map);  // a pair in a list
  return [{ from: map.range![0], to: map.range![0], by: "{" }, ...edits, { from: end, to: end, by: "}" }];
}

/** Adds a separate line if the last entry has one. */
function addToFlow(source: Source, holder: Collection, entry: string): Edit[] {
  const { text } = source;
  const item = holder.items[holder.items.length - 1] as Item | undefined;
  if (!item) return [{ from: holder.range![0] + 1, to: holder.range![0] + 1, by: entry }];
  const end = endOf(source, item);
  const inLine = [{ from: end, to: end, by: `, ${entry}` }];
  const rest = restOfLine(text, end);
  if (!rest) return inLine;
  const begin = (isPair(item) ? item.key : item).range![0];
  const start = lineStart(text, begin);
  if (!isBlank(text, start, begin)) return inLine;
  return [{ from: end, to: end, by: rest.comma ? "" : "," }, lineAfter(source, end, text.slice(start, begin) + entry + rest.comma)];
}

function takeOutOfBlock(source: Source, holder: Collection, items: CST.CollectionItem[], at: number): Edit[] {
  const { text } = source;
  const begin = beginOf(items[at]!), end = lineEnd(text, endOf(source, holder.items[at] as Item));
  const start = lineStart(text, begin);
  if (isBlank(text, start, begin)) return [{ from: start, to: end, by: "" }];
  const next = beginOf(items[at + 1]!);  // the first of several entries, behind a dash: the next entry moves there
  if (isBlank(text, end, next)) return [{ from: begin, to: next, by: "" }];
  return [{ from: begin, to: end - (text[end - 2] === "\r" ? 2 : 1), by: "" }];
}

function takeOutOfFlow(source: Source, holder: Collection, items: CST.CollectionItem[], at: number): Edit[] {
  const { text } = source;
  const begin = beginOf(items[at]!), end = endOf(source, holder.items[at] as Item);
  const behind = commaOf(items[at + 1]);
  const comma = behind ?? commaOf(items[at]);
  const rest = restOfLine(text, end);
  const start = lineStart(text, begin);
  const without = (from: number, to: number): Edit => ({ from, to, by: "" });
  if (rest && isBlank(text, start, begin)) {
    const lines = without(start, lineEnd(text, end));
    return comma === undefined || rest.comma ? [lines] : [lines, without(comma, comma + 1)];
  }
  if (comma === undefined) return [without(begin, end)];
  if (behind !== undefined) return [without(begin, end), without(behind, afterBlanks(text, behind + 1))];
  return [without(comma, comma + 1), without(afterBlanks(text, comma + 1) === begin ? comma + 1 : begin, end)];
}

const commaOf = (item: CST.CollectionItem | undefined) => item?.start.find(({ type }) => type === "comma")?.offset;

/** Returns the begin of an entry's dash, of the question mark of a long key, or of the value itself. */
function beginOf({ start, key, value }: CST.CollectionItem): number {
  const mark = start.find(({ type }) => type === "seq-item-ind" || type === "explicit-key-ind");
  return (mark ?? key ?? value)!.offset;
}

/** Returns the end of the item itself, before comments and empty lines that follow it. */
function endOf({ text }: { text: string }, item: Item): number {
  const node = isPair(item) ? item.value ?? item.key : item;
  if (isBlock(node)) return endOf({ text }, node.items[node.items.length - 1] as Item);
  let end = node.range![1];
  while (end > 0 && /\s/.test(text[end - 1]!)) --end;
  return end;
}

const isBlock = (node: Node): node is Collection => isCollection(node) && !node.flow && node.items.length > 0;
const isBlank = (text: string, from: number, to: number) => text.slice(from, to).trim() === "";

/** Returns the offset behind a byte order mark, which is not a column. */
const lineStart = (text: string, at: number) => Math.max(text.lastIndexOf("\n", at - 1) + 1, text[0] === "\ufeff" ? 1 : 0);

/** Returns the offset behind the newline of the line of the item that ends at `at`. */
function lineEnd(text: string, at: number): number {
  const newline = text.indexOf("\n", at);
  return newline < 0 ? text.length : newline + 1;
}

function afterBlanks(text: string, at: number): number {
  while (text[at] === " ") ++at;
  return at;
}

/** Returns null if something other than a comma and a comment follows. */
function restOfLine(text: string, at: number): { comma: string } | null {
  const rest = /[ \t]*(,?)[ \t]*(?:#[^\n]*)?\r?\n/y;
  rest.lastIndex = at;
  const found = rest.exec(text);
  return found && { comma: found[1]! };
}

/** Returns the text in front of the entries of a block. */
function margin({ text }: Source, { range }: Collection): string {
  return " ".repeat(range![0] - lineStart(text, range![0]));
}

function lineAfter({ text, newline }: Source, end: number, line: string): Edit {
  const at = lineEnd(text, end);
  return { from: at, to: at, by: text[at - 1] === "\n" ? line + newline : newline + line };
}
