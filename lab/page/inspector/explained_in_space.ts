// SPDX-License-Identifier: Apache-2.0
// The decision of a robot in space at the present moment, and the cut through its velocity space.
import type { SceneInfo, Simulation, VelocityCut } from "../../avo/avo.ts";
import { digits } from "../frame/elements.ts";
import { dot3, norm3, times3, type Vec3 } from "../map/vec3.ts";
import { besidePlane, cutBall, cutHalfSpace, cutOfNobody, cutOfPair, inPlane, type CutPlane } from "./cut.ts";
import { labelOf, nameOf, shortLabelOf, violation, type Disc, type HalfPlane, type Source } from "./decision.ts";
import type { Explained } from "./explained.ts";
import type { SpaceSource } from "./space_canvas.ts";
import type { Cause, SpaceDecision } from "./space_decision.ts";
import { neighborTableInSpace, numbersTableInSpace } from "./space_tables.ts";
import type { Admitted, Outline } from "./velocity_space.ts";
import type { Box } from "./velocity_view.ts";
import { lawOf, type Cut } from "./why.ts";

const FINE = 64, COARSE = 24;  // nodes per side, for what the certificate admits
const APART = 0.005;  // m/s: a velocity that is nearer to the plane lies in it

export function explainedInSpace(simulation: Simulation, info: SceneInfo, robot: number, quick: boolean): Explained {
  const text = simulation.explain(robot);
  const decision = JSON.parse(text) as SpaceDecision;
  return {
    text, robot,
    sentence: decision.sentence,
    method: info.options.method,
    drawnFor(pointed) {
      const neighbor = neighborToCut(decision, pointed);
      const plane = (neighbor === null ? null : cutOfPair(decision, neighbor)) ?? cutOfNobody(decision);
      const admitted = (box: Box): Admitted | null => admittedIn(simulation, info, decision, plane, box, quick ? COARSE : FINE);
      const outlines = (box: Box): Outline[] => {
        const of = neighbor === null ? null : nameOf(neighbor);
        return of === null ? [] : [{ of, rings: simulation.outlineInCut(robot, of, cutOfVelocities(plane), box) }];
      };
      return { source: { ...sourceOf(decision, info, plane, neighbor), outlines, admitted }, note: noteOf(decision, plane, neighbor) };
    },
    numbers: () => numbersTableInSpace(decision),
    neighbors: (lab) => neighborTableInSpace(lab, decision),
  };
}

/** Returns the neighbor that is pointed at, or else one that shapes the decision, or else the nearest. */
function neighborToCut({ neighbors, trace }: SpaceDecision, pointed: string | null): Source | null {
  const sensed = neighbors.map(({ neighbor }) => neighbor);
  const named = sensed.find((neighbor) => nameOf(neighbor) === pointed);
  const senses = (cause: Cause) => cause !== null && sensed.includes(cause);
  return named ?? [...trace.binding, ...trace.refusing, ...trace.refusing_detour, trace.heeded].find(senses) ?? sensed[0] ?? null;
}

function sourceOf(decision: SpaceDecision, info: SceneInfo, plane: CutPlane, neighbor: Source | null): Pick<SpaceSource, "space"> {
  const vertical = info.robots.find(({ robot }) => robot === decision.robot)?.vertical ?? 1;
  const { velocity, preferred_velocity, new_velocity, next_velocity, max_acceleration, max_speed } = decision;
  const acceleration_disc = cutBall(plane, velocity, info.options.control_time * max_acceleration, vertical);
  const speed_disc = cutBall(plane, [0, 0, 0], max_speed, vertical);
  const forbids = (half: HalfPlane) => [acceleration_disc, speed_disc].every((disc) => disc === null || reachesPast(disc, half));
  const cuts: Cut[] = decision.half_spaces.flatMap((half) => {
    const cut = cutHalfSpace(plane, half);
    return cut && forbids(cut) ? [{
      ...cut, of: nameOf(half.neighbor), label: labelOf(nameOf(half.neighbor)), short: shortLabelOf(nameOf(half.neighbor)), forbids: true,
      binds: decision.trace.binding.includes(half.neighbor),
      refuses: Math.max(half.offset - dot3(half.normal, preferred_velocity), 0),
    }] : [];
  });
  return {
    space: {
      decision: {
        robot: decision.robot, target_by: "half_planes", max_acceleration,
        velocity: inPlane(plane, velocity), preferred_velocity: inPlane(plane, preferred_velocity), new_velocity: inPlane(plane, new_velocity),
        acceleration_disc, speed_disc,
      },
      law: lawOf(info),
      why: { cuts, next: inPlane(plane, next_velocity) },
      axes: neighbor === null ? ["forwards, in m/s", "upwards, in m/s"] : [`away from ${shortLabelOf(nameOf(neighbor))}, in m/s`, "across, in m/s"],
    },
  };
}

const cutOfVelocities = ({ normal, offset, along, across }: CutPlane): VelocityCut => ({ place: times3(offset, normal), along, across });

function admittedIn(simulation: Simulation, info: SceneInfo, { robot }: SpaceDecision, plane: CutPlane, box: Box, columns: number): Admitted | null {
  if (info.options.certificate === "none") return null;
  const rows = Math.max(2, Math.round(columns * (box[3] - box[1]) / (box[2] - box[0])));
  const cells = simulation.admittedInCut(robot, cutOfVelocities(plane), box, columns, rows);
  return { box, columns, rows, cells };
}

/** Returns whether a part of the disc is on the forbidden side. */
function reachesPast({ center, radius, squeeze }: Disc, half: HalfPlane): boolean {
  return violation(half, center) > -radius * (squeeze?.ratio ?? 1);
}

/** Returns where the cut is, and what lies beside it. */
function noteOf(decision: SpaceDecision, plane: CutPlane, neighbor: Source | null): string {
  const where = neighbor === null ? "The vertical cut through v." : `The cut through v in the plane of p and v of ${labelOf(nameOf(neighbor))}.`;
  const velocities: [string, Vec3][] = [["vᵖʳᵉᶠ", decision.preferred_velocity], ["v′", decision.new_velocity], ["vₙₑₓₜ", decision.next_velocity]];
  const beside = velocities.map(([name, v]) => [name, besidePlane(plane, v)] as const).filter(([, distance]) => distance > APART)
    .map(([name, distance]) => `${name} ${digits(distance)} m/s`);
  const rest = norm3(decision.velocity) === 0 ? " The robot is at rest." : "";
  return `${where}${rest}${beside.length ? ` Beside the cut: ${beside.join(", ")}.` : ""}`;
}
