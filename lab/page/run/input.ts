// SPDX-License-Identifier: Apache-2.0
// The initial input of the page: the command line's, or else a scene that introduces the subject.
import type { Library, RecordedScene, SceneFile } from "../../avo/avo.ts";
import { bytesOfBase64 } from "../data/compression.ts";
import { makeLab, type PageLab } from "./make_lab.ts";

/** A file that a scene reads: as base64 if it is not text. */
type InputFile = SceneFile | { path: string; base64: string; builtin: boolean };

type SceneOfInput = Omit<RecordedScene, "files"> & { files: InputFile[] };

interface InputScene extends SceneOfInput {
  kind: "scene";
}

interface InputRecording {
  kind: "recording";
  name: string;
  base64: string;
  scene?: SceneOfInput;  // for a recording that contains no scene
}

/** embedded: the page is part of another page, and shows no bar of its own. */
export type Input = (InputScene | InputRecording) & { embedded?: boolean };

/** Its comments explain how to write a scene. */
const FIRST = `# Press Space to run this. Then change a number, and Ctrl+Enter runs the new text.
version: 1
name: first steps
control_time: 2      # s, how fast velocities follow: δ
time_horizon: 3      # s, how far ahead a robot looks: τ
groups:
  - number: 22       # robots
    radius: 0.5            # m
    max_speed: 2           # m/s
    max_acceleration: 1    # m/s^2
    placement: {circle: {min_radius: 10, spacing: 2}}
    goals: antipodal
robots:              # these can be set one by one
  - {position: [-4, 0], goal: [4, 0]}
  - {position: [4, 0.2], goal: [-4, 0]}
obstacles:
  - {disc: {center: [0, 3], radius: 0.6}}
`;

/** Returns a Lab with a scene that always opens. */
export function first(library: Library): PageLab {
  return makeLab(library, FIRST, "first steps", {});
}

function sceneOf({ name, yaml, overrides, files, start_at_rest, limit_speed }: SceneOfInput): RecordedScene {
  const texts = files.map((file) => "text" in file ? file
    : { path: file.path, text: bytesOfBase64(file.base64), builtin: file.builtin });
  return { name, yaml, overrides, files: texts, start_at_rest, limit_speed };
}

/** Opens the input; the Lab's error reports a fault. */
export async function openInput(lab: PageLab, input: Input): Promise<void> {
  if (input.kind === "recording")
    return lab.openFile(input.name, bytesOfBase64(input.base64), [], input.scene ? sceneOf(input.scene) : null);
  const { name, yaml, ...options } = sceneOf(input);
  lab.openText(yaml, name, options);
}
