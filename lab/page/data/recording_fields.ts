// SPDX-License-Identifier: Apache-2.0
// The facts that a recording stores about itself: its attributes, restricted to what io/recording/recording_fields.cpp
// allows.
import type { StoredBlocks } from "./blocks.ts";
import { refuse } from "./bytes.ts";
import { textOf } from "./graymap.ts";
import type { RecordedScene, Recording } from "./recording.ts";
import { inQuotes } from "./words.ts";

/** Attributes by name; texts verbatim. */
export type Fields = Map<string, Uint8Array | bigint>;

export interface RecordingHeader {
  robots: number;
  every: number;
  headings: boolean;
  scene: RecordedScene;
}

export interface OpenedBlocks { header: RecordingHeader; fields: Fields; stored: StoredBlocks }

const FORMAT = "avo recording 1";

export function textField(fields: Fields, name: string): string {
  const value = fields.get(name);
  if (value === undefined) refuse(`found no attribute "${name}"`);
  if (typeof value === "bigint") refuse(`${name}: found another type, must be a text`);
  return textOf(value);
}

function numberField(fields: Fields, name: string, least: number, most: number): number {
  const value = fields.get(name);
  if (value === undefined) refuse(`found no attribute "${name}"`);
  if (typeof value !== "bigint") refuse(`${name}: found another type, must be a whole number`);
  if (value < BigInt(least) || value > BigInt(most)) refuse(`${name}: found ${value}, must be ${least} to ${most}`);
  return Number(value);
}

export function requireFormat(fields: Fields): void {
  const format = fields.get("format");
  const found = format instanceof Uint8Array ? textOf(format) : null;
  if (found !== FORMAT) refuse(`format: found ${found === null ? "none" : inQuotes(found)}, must be ${FORMAT}`);
}

function sceneOf(fields: Fields): RecordedScene {
  const scene: RecordedScene = {
    name: textField(fields, "scene_name"),
    yaml: textField(fields, "scene"),
    overrides: [],
    files: [],
    start_at_rest: numberField(fields, "start_at_rest", 0, 1) === 1,
    limit_speed: numberField(fields, "limit_speed", 0, 1) === 1,
  };
  const overrides = [...fields.keys()].filter((name) => name.startsWith("override.")).length;
  for (let k = 0; k < overrides; ++k) scene.overrides.push(textField(fields, `override.${k}`));
  for (const [name, value] of fields) {
    const file = /^(builtin_)?file\.(.*)$/s.exec(name);
    if (file === null || typeof value === "bigint") continue;
    scene.files.push({ path: file[2], text: textOf(value), builtin: file[1] !== undefined });
  }
  return scene;
}

export function headerOf(fields: Fields): RecordingHeader {
  textField(fields, "version");
  textField(fields, "build");
  numberField(fields, "seed", 0, 2 ** 64);
  return {
    robots: numberField(fields, "robots", 1, 1_000_000),
    every: numberField(fields, "every", 1, 100_000_000),
    headings: numberField(fields, "headings", 0, 1) === 1,
    scene: sceneOf(fields),
  };
}

export function attributesOf(fields: Fields): Recording["attributes"] {
  const attributes: Recording["attributes"] = {};
  for (const [name, value] of fields) {
    if (typeof value !== "bigint") attributes[name] = textOf(value);
    else attributes[name] = value > BigInt(Number.MAX_SAFE_INTEGER) ? value : Number(value);
  }
  return attributes;
}
