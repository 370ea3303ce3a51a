// SPDX-License-Identifier: Apache-2.0
// What the page begins with: what the command line has put into it, else a scene that shows what this is about.
import type { Library, SceneFile } from "../avo/avo.ts";
import { bytesOfBase64 } from "./data/compression.ts";
import { makeLab, type PageLab } from "./make_lab.ts";

interface InputScene {
  kind: "scene";
  name: string;
  yaml: string;
  overrides: string[];
  files: SceneFile[];
  start_at_rest: boolean;
  limit_speed: boolean;
}

interface InputRecording {
  kind: "recording";
  name: string;
  base64: string;
}

/** embedded: the page is a part of another one, and shows no bar of its own. */
export type Input = (InputScene | InputRecording) & { embedded?: boolean };

const FIRST = "circle-20";

/** A Lab with a scene that always opens. */
export function first(library: Library): PageLab {
  return makeLab(library, library.builtinText(FIRST)!, FIRST, {});
}

/** What is wrong with it, the Lab's error says. */
export async function openInput(lab: PageLab, input: Input): Promise<void> {
  if (input.kind === "recording") return lab.openFile(input.name, bytesOfBase64(input.base64));
  const { name, yaml, overrides, files, start_at_rest, limit_speed } = input;
  lab.openText(yaml, name, { overrides, files, start_at_rest, limit_speed });
}
