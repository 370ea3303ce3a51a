// SPDX-License-Identifier: Apache-2.0
// Text that is no YAML, in the words of the command line's parser, and where that one notices it. The two parsers read
// on for different lengths, so that a rare fault has this one's own words.
import type { YAMLError } from "yaml";

export interface Fault {
  at: number; // character of the text
  why: string;
}

/** The next colon that ends a key. */
function nextColon(text: string, at: number): number {
  const found = text.slice(at).search(/:(\s|$)/);
  return found < 0 ? at : at + found;
}

const lineBegin = (text: string, at: number): number => text.lastIndexOf("\n", at - 1) + 1;
const skipBlanks = (text: string, at: number): number => at + /^[ \t]*/.exec(text.slice(at))![0].length;

/** A list or map in brackets that ends with the text, or where something else stands. */
function openFlow(text: string, at: number, what: string): Fault {
  if (at >= text.trimEnd().length) return { at: lineBegin(text, text.trimEnd().length), why: `end of ${what} flow not found` };
  return { at, why: text[at] === "]" || text[at] === "}" ? "illegal flow end" : "illegal block entry" };
}

/** By the parser's codes, and the beginnings of its messages where a code has several. */
export function faultOf(text: string, { code, message, pos: [at] }: YAMLError): Fault {
  const says = (words: string) => message.startsWith(words);
  switch (code) {
    case "BLOCK_AS_IMPLICIT_KEY":
      if (says("A block sequence")) return { at, why: "end of map not found" };
      return { at: nextColon(text, at), why: "illegal map value" };
    case "MULTILINE_IMPLICIT_KEY":
      return { at: nextColon(text, at), why: "illegal map value" };
    case "BAD_INDENT":
      if (says("Flow sequence")) return openFlow(text, at, "sequence");
      if (says("Flow map")) return openFlow(text, at, "map");
      break;
    case "MISSING_CHAR":
      if (says("Missing closing")) return { at, why: "illegal EOF in scalar" };
      if (says("Missing , or : between flow map")) return { at, why: "end of map flow not found" };
      if (says("Missing , between flow sequence")) return { at, why: "end of sequence flow not found" };
      if (says("Sequence item without -")) return { at: skipBlanks(text, at), why: "end of sequence not found" };
      break;
    case "UNEXPECTED_TOKEN":
      if (says("Unexpected flow-")) return { at, why: "illegal flow end" };
      if (says("Unexpected block-seq-ind")) return { at, why: "illegal block entry" };
      if (says("Unexpected scalar")) return { at, why: "end of map not found" };
      if (says("Not a YAML token")) return { at, why: "unexpected character in block scalar" };
      break;
    case "TAB_AS_INDENT": {
      const item = skipBlanks(text, at);
      if (text[item] === "-") return { at: item, why: "illegal block entry" };
      return { at, why: "illegal tab when looking for indentation" };
    }
    case "BAD_SCALAR_START":
      return { at, why: "unknown token" };
    case "BAD_DQ_ESCAPE":
      return { at: at + 2, why: `unknown escape character: ${text[at + 1]}` };
  }
  return { at, why: message };
}
