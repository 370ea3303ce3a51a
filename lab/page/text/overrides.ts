// SPDX-License-Identifier: Apache-2.0
// What the command line sets beside a scene becomes part of its text: there it can be changed, and is saved.
import { isMap, isScalar, isSeq, parseDocument } from "yaml";
import type { SceneOptions } from "../../avo/avo.ts";
import { withWritten } from "./scene_text.ts";

/** The same scene. Overrides stay that only they can say: of single robots of a group or of a file. */
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

/** Null where it stays. `othersStay`: which robots these mean, the lists of robots decide. */
function withOverride(yaml: string, override: string, othersStay: boolean): string | null {
  const [, path, value] = /^([^=]+)=([^]*)$/.exec(override) ?? [];
  if (path === undefined || (othersStay && /^(robots|robots_from|groups)$/.test(path))) return null;
  try {
    return withWritten(yaml, path, flowText(valueOf(value!)));
  } catch {
    return null;
  }
}

/** Numbers are texts in it, digit by digit as they were given. */
function valueOf(yaml: string): unknown {
  const document = parseDocument(yaml, { schema: "failsafe", uniqueKeys: false, logLevel: "silent" });
  if (document.errors.length) throw document.errors[0]!;
  return document.contents;
}

/** In one line; what is quoted stays so. */
function flowText(node: unknown): string {
  if (isSeq(node)) return `[${node.items.map(flowText).join(", ")}]`;
  if (isMap(node)) return `{${node.items.map(({ key, value }) => `${flowText(key)}: ${flowText(value)}`).join(", ")}}`;
  if (!isScalar(node) || node.source === "" && node.type === "PLAIN") return "null";
  const text = String(node.value);
  return node.type === "PLAIN" && /^[\w.+~-]+$/.test(text) ? text : JSON.stringify(text);
}
