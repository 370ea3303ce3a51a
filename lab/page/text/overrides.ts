// SPDX-License-Identifier: Apache-2.0
// Overrides of the command line become part of a scene's text: there the user can edit and save them.
import { isMap, isScalar, isSeq, parseDocument } from "yaml";
import type { SceneOptions } from "../../avo/avo.ts";
import { withWritten } from "./scene_text.ts";

/** Returns the same scene. Overrides remain that only they can express: those of single robots of a group or of a file. */
export function folded(yaml: string, options: SceneOptions): { yaml: string; options: SceneOptions } {
  const overrides: string[] = [];
  for (const override of options.overrides ?? []) {
    const text = withOverride(yaml, override, overrides.length > 0);
    if (text === null) overrides.push(override);
    else yaml = text;
  }
  const nothing = overrides.length === (options.overrides?.length ?? 0);
  return { yaml, options: nothing ? options : { ...options, overrides } };
}

/** Returns null if the override remains. `othersStay`: the lists of robots decide which robots these overrides mean. */
function withOverride(yaml: string, override: string, othersStay: boolean): string | null {
  const [, path, value] = /^([^=]+)=([^]*)$/.exec(override) ?? [];
  if (path === undefined || (othersStay && /^(robots|robots_from|groups)$/.test(path))) return null;
  try {
    return withWritten(yaml, path, flowText(valueOf(value!)));
  } catch {
    return null;
  }
}

/** Numbers are texts in the result, digit by digit as they were given. */
function valueOf(yaml: string): unknown {
  const document = parseDocument(yaml, { schema: "failsafe", uniqueKeys: false, logLevel: "silent" });
  if (document.errors.length) throw document.errors[0]!;
  return document.contents;
}

/** Returns one line; quoted text stays quoted. */
function flowText(node: unknown): string {
  if (isSeq(node)) return `[${node.items.map(flowText).join(", ")}]`;
  if (isMap(node)) return `{${node.items.map(({ key, value }) => `${flowText(key)}: ${flowText(value)}`).join(", ")}}`;
  if (!isScalar(node) || node.source === "" && node.type === "PLAIN") return "null";
  const text = String(node.value);
  return node.type === "PLAIN" && /^[\w.+~-]+$/.test(text) ? text : JSON.stringify(text);
}
