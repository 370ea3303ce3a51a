// SPDX-License-Identifier: Apache-2.0
// Scenes of space that the page has in itself, beside the built-in scenes of the library.
import type { BuiltinScene } from "../../avo/avo.ts";
import balls from "../../../examples/space/balls.yaml";
import building from "../../../examples/space/building.yaml";
import helicopter from "../../../examples/space/helicopter.yaml";
import shaft from "../../../examples/space/shaft.yaml";
import sphere from "../../../examples/space/sphere-100.yaml";
import window from "../../../examples/space/window.yaml";

const TEXTS: Record<string, string> = { "sphere-100": sphere, window, shaft, building, helicopter, balls };

/** The first line of each is a comment that describes it. */
export const SPACE_SCENES: BuiltinScene[] = Object.entries(TEXTS).map(([name, yaml]) =>
  ({ name, yaml, description: `${/^# (.*)/.exec(yaml)?.[1] ?? ""}; in space` }));
