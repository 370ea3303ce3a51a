// SPDX-License-Identifier: Apache-2.0
// Opens another run in the Lab: a scene's text, or a file.
import type { Library, SceneOptions } from "../../avo/avo.ts";
import { formatOf, openRecording } from "../data/open.ts";
import { LiveRun } from "./live_run.ts";
import { clearError, type Core, type PageLab } from "./make_lab.ts";
import { folded } from "../text/overrides.ts";
import { infoOf, liveOptions } from "./recorded_scene.ts";
import { RecordedRun } from "./recorded_run.ts";
import type { Run } from "./run.ts";

function start(core: Core, next: Run): void {
  const { lab } = core;
  const isShown = () => core.run === next;
  if (core.run instanceof RecordedRun) core.run.close();
  core.run = next;
  if (next instanceof RecordedRun) {
    next.readPast(() => { if (isShown()) lab.say("past"); }).catch((error) => { if (isShown()) core.fail(error); });
  }
  lab.pause();
  if (lab.selected !== null && !next.moment.robot.includes(lab.selected)) lab.select(null);
  core.shown("text", "scene", "moment");
}

/** The library refuses text that is not UTF-8 in its own words. */
function yamlOf(library: Library, bytes: Uint8Array, name: string): string {
  const yaml = new TextDecoder().decode(bytes);
  if (yaml.includes("\ufffd")) library.simulate(bytes, { name });
  return yaml;
}

export function opening(core: Core): Partial<PageLab> {
  const { library, lab } = core;
  const open = (next: Run, name: string, options: SceneOptions): void => {
    lab.name = name;
    lab.options = options;
    start(core, next);
  };
  return {
    openText(yaml, name = lab.name, options = lab.options) {
      const read = () => {
        const simulation = library.simulate(yaml, { ...options, name });
        const scene = folded(yaml, options);
        open(new LiveRun(simulation, scene.yaml), name, scene.options);
      };
      core.attempt(read, { yaml, name, options });
    },
    async openFile(name, bytes, files = [], scene = null) {
      try {
        if (formatOf(name, bytes) === "yaml") return lab.openText(yamlOf(library, bytes, name), name, { files });
        const recording = await openRecording(library, name, bytes);
        recording.scene ??= scene;
        const { info, goals } = infoOf(recording, library);
        const { yaml, options } = folded(recording.scene?.yaml ?? "", liveOptions(recording));
        const next = await RecordedRun.open(recording, info, yaml, goals);
        clearError(lab);
        open(next, name, options);
      } catch (error) {
        core.fail(error);
      }
    },
  };
}
