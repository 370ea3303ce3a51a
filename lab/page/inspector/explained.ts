// SPDX-License-Identifier: Apache-2.0
// The decision of a robot at the present moment, with its drawings, from one simulation.
import type { SceneInfo, Simulation } from "../../avo/avo.ts";
import type { Decision } from "./decision.ts";
import { isCertified, parseDecision, sceneWall } from "./decision.ts";
import type { SpaceSource } from "./space_canvas.ts";
import type { Box } from "./velocity_view.ts";
import type { Law, Why } from "./why.ts";
import { lawOf, why } from "./why.ts";

export interface Explained {
  text: string;  // as `avo explain --json` prints it
  decision: Decision;
  law: Law;
  why: Why;
  source: SpaceSource;
}

const FINE = 96, COARSE = 40;  // nodes per side

/** Throws an error of the library, e.g. for a parked robot. `quick`: the run is playing. */
export function explained(simulation: Simulation, info: SceneInfo, robot: number, quick: boolean): Explained {
  const text = simulation.explain(robot);
  const decision = parseDecision(text);
  const law = lawOf(info);
  const found = why(decision, law, info);
  const sceneName = (of: string): string =>
    of.startsWith("walls.") ? `walls.${sceneWall(decision, Number(of.slice(6)), info.walls)}` : of;
  const source: SpaceSource = {
    space: { decision, law, why: found },
    outlines: (box: Box) => simulation.outlines(robot, box).map(({ of, rings }) => ({ of: sceneName(of), rings })),
    admitted(box: Box) {
      if (!isCertified(decision)) return null;
      const columns = quick ? COARSE : FINE;
      const rows = Math.max(2, Math.round(columns * (box[3] - box[1]) / (box[2] - box[0])));
      return { box, columns, rows, cells: simulation.admitted(robot, box, columns, rows) };
    },
  };
  return { text, decision, law, why: found, source };
}
