// SPDX-License-Identifier: Apache-2.0
// Faults of text that is no YAML, in the words and at the places of the command line's parser. That parser and this one
// continue to different points, so a rare fault has the words of this one. The module has no parser of YAML. The page's
// own parser gives the editor every token of a text, and a second one would make the module larger.
import type { YAMLError } from "yaml";

export interface Fault {
  at: number; // character of the text
  why: string;
}

/** Returns the next colon that ends a key. */
function nextColon(text: string, at: number): number {
  const found = text.slice(at).search(/:(\s|$)/);
  return found < 0 ? at : at + found;
}

const lineBegin = (text: string, at: number): number => text.lastIndexOf("\n", at - 1) + 1;
const skipBlanks = (text: string, at: number): number => at + /^[ \t]*/.exec(text.slice(at))![0].length;

/** Returns the fault of a list or map in brackets that ends with the text, or that something else interrupts. */
function openFlow(text: string, at: number, what: string): Fault {
  const why = `end of ${what} flow not found`;
  if (at >= text.trimEnd().length) return { at: lineBegin(text, text.trimEnd().length), why };
  if ("]}".includes(text[at]!)) return { at, why: "illegal flow end" };
  if (/^-\s/.test(text.slice(at, at + 2))) return { at, why: "illegal block entry" };
  const continues = /[^\]}"',\s]\s*$/.test(text.slice(Math.max(0, at - 200), at)); // plain text, by this line
  return { at: continues ? nextColon(text, at) : at, why };
}

/** Returns the fault of text that belongs to nothing: inside brackets, which must end first, or outside. */
function notEnded(text: string, at: number): Fault {
  const open: string[] = [];
  const quotedOrBracket = /"(?:\\.|[^"\\])*"|'[^']*'|(?:^|\s)#.*|[[\]{}]/gm;
  for (const [found] of text.slice(0, at).matchAll(quotedOrBracket)) {
    if (found === "[" || found === "{") open.push(found);
    else if (found === "]" || found === "}") open.pop();
  }
  const innermost = open.pop();
  if (innermost === undefined) return { at, why: "end of map not found" };
  return { at, why: `end of ${innermost === "[" ? "sequence" : "map"} flow not found` };
}

/** Returns the fault by the parser's codes, and by the beginnings of its messages if a code has several. */
export function faultOf(text: string, { code, message, pos: [at] }: YAMLError): Fault {
  const says = (words: string) => message.startsWith(words);
  switch (code) {
    case "BLOCK_AS_IMPLICIT_KEY":
      if (says("A block sequence")) return { at: skipBlanks(text, at), why: "end of map not found" };
      return { at: nextColon(text, at), why: "illegal map value" };
    case "MULTILINE_IMPLICIT_KEY": {
      const block = /(?:^|\n[ \t]*)[|>][ \t]*/.exec(text.slice(at, nextColon(text, at)));
      if (block) return { at: at + block.index + block[0].length, why: "unexpected character in block scalar" };
      return { at: nextColon(text, at), why: "illegal map value" };
    }
    case "BAD_INDENT":
      if (says("Flow sequence")) return openFlow(text, at, "sequence");
      if (says("Flow map")) return openFlow(text, at, "map");
      if (says("All mapping items")) return { at: skipBlanks(text, at), why: "end of map not found" };
      if (says("All sequence items")) return { at: skipBlanks(text, at), why: "end of sequence not found" };
      break;
    case "MISSING_CHAR":
      if (says("Missing closing")) return { at, why: "illegal EOF in scalar" };
      if (says("Missing , or : between flow map")) return { at, why: "end of map flow not found" };
      if (says("Missing , between flow sequence")) return { at, why: "end of sequence flow not found" };
      if (says("Implicit map keys")) return { at, why: "end of map not found" };
      if (says("Sequence item without -")) return { at: skipBlanks(text, at), why: "end of sequence not found" };
      break;
    case "UNEXPECTED_TOKEN":
      if (says("Unexpected flow-")) return "[{".includes(text[at]!) ? notEnded(text, at) : { at, why: "illegal flow end" };
      if (says("Unexpected block-seq-ind")) return { at, why: "illegal block entry" };
      if (says("Unexpected scalar") || says("Unexpected tag")) return notEnded(text, at);
      if (says("Not a YAML token") || says("Block scalar header")) return { at, why: "unexpected character in block scalar" };
      break;
    case "TAB_AS_INDENT": {
      const item = skipBlanks(text, at);
      if (text[item] === "-") return { at: item, why: "illegal block entry" };
      return { at, why: "illegal tab when looking for indentation" };
    }
    case "BAD_ALIAS":
      if (says("Alias cannot be an empty")) return { at: at + 1, why: "alias not found after *" };
      if (says("Anchor cannot be an empty")) return { at: at + 1, why: "anchor not found after &" };
      break;
    case "BAD_SCALAR_START":
      return { at, why: "unknown token" };
    case "BAD_DQ_ESCAPE":
      return { at: at + 2, why: `unknown escape character: ${text[at + 1]}` };
  }
  return { at, why: message };
}
