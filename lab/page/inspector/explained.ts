// SPDX-License-Identifier: Apache-2.0
// The decision of a robot at the present moment, with its drawings, from one simulation.
import type { SceneInfo, Simulation } from "../../avo/avo.ts";
import type { Lab } from "../run/lab.ts";
import type { Decision } from "./decision.ts";
import { neighborTable, numbersTable } from "./decision_tables.ts";
import { isCertified, parseDecision } from "./decision.ts";
import type { SpaceSource } from "./space_canvas.ts";
import type { Box } from "./velocity_view.ts";
import type { Law, Why } from "./why.ts";
import { lawOf, why } from "./why.ts";

/** What the inspector shows of a decision, of the plane or of space. */
export interface Explained {
  text: string;  // as `avo explain --json` prints it
  robot: number;
  sentence: string;
  method: string;
  /** Returns the velocity space, and what has to be said of it. In space it is cut for the neighbor that is pointed at. */
  drawnFor(pointed: string | null): { source: SpaceSource; note: string };
  numbers(): HTMLElement;
  neighbors(lab: Lab): HTMLElement;
}

export interface ExplainedInPlane extends Explained {
  decision: Decision;
  law: Law;
  why: Why;
}

const FINE = 96, COARSE = 40;  // nodes per side

/** Throws an error of the library, e.g. for a parked robot. `quick`: the run is playing. */
export function explained(simulation: Simulation, info: SceneInfo, robot: number, quick: boolean): ExplainedInPlane {
  const text = simulation.explain(robot);
  const decision = parseDecision(text);
  const law = lawOf(info);
  const found = why(decision, law, info);
  const source: SpaceSource = {
    space: { decision, law, why: found },
    outlines: (box: Box) => simulation.outlines(robot, box),
    admitted(box: Box) {
      if (!isCertified(decision)) return null;
      const columns = quick ? COARSE : FINE;
      const rows = Math.max(2, Math.round(columns * (box[3] - box[1]) / (box[2] - box[0])));
      return { box, columns, rows, cells: simulation.admitted(robot, box, columns, rows) };
    },
  };
  return {
    text, robot, decision, law, why: found,
    sentence: decision.sentence,
    method: law.method,
    drawnFor: () => ({ source, note: "" }),
    numbers: () => numbersTable(decision),
    neighbors: (lab) => neighborTable(lab, decision, found, law),
  };
}
