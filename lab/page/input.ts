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

/** It teaches by its comments how a scene is written. */
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

/** A Lab with a scene that always opens. */
export function first(library: Library): PageLab {
  return makeLab(library, FIRST, "first steps", {});
}

/** What is wrong with it, the Lab's error says. */
export async function openInput(lab: PageLab, input: Input): Promise<void> {
  if (input.kind === "recording") return lab.openFile(input.name, bytesOfBase64(input.base64));
  const { name, yaml, overrides, files, start_at_rest, limit_speed } = input;
  lab.openText(yaml, name, { overrides, files, start_at_rest, limit_speed });
}
