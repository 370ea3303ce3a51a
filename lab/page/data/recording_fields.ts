// SPDX-License-Identifier: Apache-2.0
// The facts that a recording stores about itself, restricted to what io/recording/recording_fields.cpp allows.
import type { StoredBlocks } from "./blocks.ts";
import { refuse } from "./bytes.ts";
import { concatenated } from "./compression.ts";
import type { RecordedScene } from "./recording.ts";

/** Fields by name; texts verbatim. */
export type Fields = Map<string, Uint8Array | bigint>;

export interface RecordingHeader { robots: number; every: number; headings: boolean; scene: RecordedScene }
export interface OpenedBlocks { header: RecordingHeader; stored: StoredBlocks }

const FIRST_PART = "part.0.";

const decoded = (bytes: Uint8Array) => new TextDecoder("utf-8", { ignoreBOM: true }).decode(bytes);

/** Joins the parts of long texts: the text "scene" may be in "part.0.scene", "part.1.scene" and so on. */
function joinParts(fields: Fields): void {
  for (const first of [...fields.keys()].filter((key) => key.startsWith(FIRST_PART))) {
    const name = first.slice(FIRST_PART.length);
    const parts: Uint8Array[] = [];
    for (let part = fields.get(first); part instanceof Uint8Array; part = fields.get(`part.${parts.length}.${name}`))
      parts.push(part);
    fields.set(name, concatenated(parts));
  }
}

function textField(fields: Fields, name: string): string {
  const value = fields.get(name);
  if (value === undefined) refuse(`found no attribute "${name}"`);
  if (typeof value === "bigint") refuse(`${name}: found another type, must be a text`);
  return decoded(value);
}

/** Refuses another text; `where`: in front of its name. */
export function requireText(fields: Fields, name: string, must: string, where = ""): void {
  const value = fields.get(name);
  const found = value instanceof Uint8Array ? decoded(value) : null;
  if (found !== must) refuse(`${where}${name}: found ${found === null ? "none" : JSON.stringify(found.slice(0, 40))}, must be ${must}`);
}

function numberField(fields: Fields, name: string, least: number, most: number): number {
  const value = fields.get(name);
  if (value === undefined) refuse(`found no attribute "${name}"`);
  if (typeof value !== "bigint") refuse(`${name}: found another type, must be a whole number`);
  if (value < BigInt(least) || value > BigInt(most)) refuse(`${name}: found ${value}, must be ${least} to ${most}`);
  return Number(value);
}

function sceneOf(fields: Fields): RecordedScene {
  const overrides = [...fields.keys()].filter((name) => name.startsWith("override."));
  const scene: RecordedScene = {
    name: textField(fields, "scene_name"),
    yaml: textField(fields, "scene"),
    overrides: overrides.map((_, k) => textField(fields, `override.${k}`)),
    files: [],
    start_at_rest: numberField(fields, "start_at_rest", 0, 1) === 1,
    limit_speed: numberField(fields, "limit_speed", 0, 1) === 1,
  };
  for (const [name, text] of fields) {
    const [, builtin, path] = /^(builtin_)?file\.(.*)$/s.exec(name) ?? [];
    if (path !== undefined && typeof text !== "bigint") scene.files.push({ path, text, builtin: builtin !== undefined });
  }
  return scene;
}

export function headerOf(fields: Fields): RecordingHeader {
  joinParts(fields);
  return {
    robots: numberField(fields, "robots", 1, 1_000_000),
    every: numberField(fields, "every", 1, 100_000_000),
    headings: numberField(fields, "headings", 0, 1) === 1,
    scene: sceneOf(fields),
  };
}
