// SPDX-License-Identifier: Apache-2.0
// The contents of YAML text, as events with lines and columns. The command line's reader builds the same tree from
// them, by the same rules (io/text/yaml_builder.h).
import { isAlias, isMap, isScalar, isSeq, LineCounter, parseAllDocuments, Scalar } from "yaml";
import type { Document, Pair, ParsedNode } from "yaml";
import { addText, addWhole, emptyBytes, taken } from "./bytes.ts";
import type { Bytes } from "./bytes.ts";
import { faultOf } from "./yaml_faults.ts";

/** The numbers are those of lab/wasm/host_yaml.cpp. */
const BEGIN_DOCUMENT = 0, END_DOCUMENT = 1, NOTHING = 2, PLAIN_TEXT = 3, QUOTED_TEXT = 4, LIST = 5, MAP = 6, CLOSE = 7;
const ANCHOR = 9, TAG = 10, FAULT = 11;

/** The source of the events, and the bytes that they are written to. */
interface Source {
  text: string;
  lines: LineCounter;
  hasPairs: boolean;  // characters of two UTF-16 units
  bytes: Bytes;
  end: number;        // where the parser fails
}

/** Ends the events: none begins behind the fault. */
class Stopped extends Error {}

function addEvent(source: Source, event: number, at: number, text = ""): void {
  const { line, col } = source.lines.linePos(at);
  const begin = at - col + 1;
  const column = source.hasPairs ? [...source.text.slice(begin, at)].length + 1 : col;
  addWhole(source.bytes, event);
  addWhole(source.bytes, Math.max(line, 1));
  addWhole(source.bytes, Math.max(column, 1));
  addText(source.bytes, text);
}

/** Returns where the next thing begins that is neither space nor comment. */
function nextThing(text: string, at: number): number {
  for (;;) {
    const found = text.slice(at).search(/[^\s]/);
    if (found < 0) return text.length;
    at += found;
    if (text[at] !== "#") return at;
    const end = text.indexOf("\n", at);
    if (end < 0) return text.length;
    at = end;
  }
}

/** Returns where a value begins, including its anchor and tag. */
function beginOf(source: Source, node: ParsedNode): number {
  const begin = node.range[0];
  if (!("anchor" in node && node.anchor) && !("tag" in node && node.tag)) return begin;
  const properties = /(?:[&!]\S*\s+)*(?:[&!]\S*)?$/.exec(source.text.slice(Math.max(0, begin - 4096), begin));
  return begin - (properties?.[0].length ?? 0);
}

/** Refuses "{key:[1]}": for the command line's parser the colon is a part of the key. */
function refuseAdjacent(source: Source, { flow }: { flow?: boolean }, key: ParsedNode | null): void {
  if (!flow || !isScalar(key) || key.type !== Scalar.PLAIN) return;
  const colon = key.range[1];
  if (!/^:[[{]/.test(source.text.slice(colon, colon + 2))) return;
  addEvent(source, FAULT, colon + 1, "end of map flow not found");
  throw new Stopped();
}

function addNode(source: Source, node: ParsedNode | null, at: number): void {
  if (node === null) {
    if (at >= source.end) throw new Stopped();
    addEvent(source, NOTHING, nextThing(source.text, at));
    return;
  }
  const begin = beginOf(source, node);
  if (begin >= source.end) throw new Stopped();
  if (isAlias(node)) {  // if its anchor is defined, the anchor is refused instead
    addEvent(source, FAULT, begin, "the referenced anchor is not defined");
    throw new Stopped();
  }
  if (node.anchor) addEvent(source, ANCHOR, begin);
  if (node.tag && node.tag !== "!") addEvent(source, TAG, begin, node.tag);
  if (isMap(node)) {
    addEvent(source, MAP, begin);
    for (const pair of node.items as Pair<ParsedNode, ParsedNode | null>[]) {
      addNode(source, pair.key, node.range[0]);
      refuseAdjacent(source, node, pair.key);
      addNode(source, pair.value, pair.key?.range?.[1] ?? node.range[1]);
    }
    addEvent(source, CLOSE, begin);
  } else if (isSeq(node)) {
    addEvent(source, LIST, begin);
    for (const item of node.items as (ParsedNode | null)[]) addNode(source, item, node.range[0]);
    addEvent(source, CLOSE, begin);
  } else if (isScalar(node)) {
    const isPlain = node.type === Scalar.PLAIN;
    if (isPlain && node.range[0] === node.range[1]) addEvent(source, NOTHING, nextThing(source.text, begin));
    else addEvent(source, isPlain && node.tag !== "!" ? PLAIN_TEXT : QUOTED_TEXT, begin, String(node.value));
  }
}

function addDocument(source: Source, document: Document.Parsed): void {
  const fault = [...document.errors].sort((a, b) => a.pos[0] - b.pos[0])[0];
  source.end = fault ? fault.pos[0] : Infinity;
  addEvent(source, BEGIN_DOCUMENT, document.range[0]);
  try {
    if (document.contents !== null) addNode(source, document.contents as ParsedNode, document.range[1]);
    if (!fault) addEvent(source, END_DOCUMENT, document.range[1]);
  } catch (error) {
    if (!(error instanceof Stopped)) throw error;
  }
  if (!fault) return;
  const { at, why } = faultOf(source.text, fault);
  addEvent(source, FAULT, at, why);
}

/** Returns the events of text without control characters, with line ends "\n". */
export function eventsOf(text: string): Uint8Array {
  const lines = new LineCounter();
  const documents = parseAllDocuments(text, {
    schema: "failsafe", strict: true, uniqueKeys: false, merge: false, stringKeys: false, prettyErrors: false,
    logLevel: "silent", lineCounter: lines,
  });
  const source: Source = { text, lines, hasPairs: /[\ud800-\udbff]/.test(text), bytes: emptyBytes(), end: Infinity };
  if (Array.isArray(documents)) for (const document of documents) addDocument(source, document);
  return taken(source.bytes);
}
