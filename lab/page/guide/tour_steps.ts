// SPDX-License-Identifier: Apache-2.0
// The paper in six steps: van den Berg, Snape, Guy, Manocha, Reciprocal Collision Avoidance with Acceleration-Velocity
// Obstacles, ICRA 2011. Each step has a small scene, an observation, and an experiment.
import type { Library } from "../../avo/avo.ts";

/** Sets a key of the scene: by a slider if it has a range, otherwise by buttons. */
export interface Try {
  label: string;
  path: string;
  range?: { least: number; most: number; step: number; unit: string; start: number };
  words?: string[];
}

export interface TourStep {
  title: string;
  paragraphs: string[];
  look: string[];
  tries: Try[];
  reference: string;
  robot: number;
  time: number;   // s, at the beginning
  speed: number;  // simulated seconds per second
  scene(library: Library): string;
}

const ONE = (method: string): string => `version: 1
name: one robot and a moving obstacle
method: ${method}
control_time: 2
duration: 20
robots:
  - {position: [-8, 0], velocity: [2, 0], goal: [8, 0], radius: 0.5, max_speed: 2, max_acceleration: 1}
moving_obstacles:
  - {position: [-1, 3.8], velocity: [-0.3, -1.2], radius: 1}
`;

const TWO = `version: 1
name: two robots exchange places
method: avo_paper
control_time: 2
duration: 20
robots:
  - {position: [-8, 0.3], velocity: [2, 0], goal: [8, 0.3], radius: 0.5, max_speed: 2, max_acceleration: 1}
  - {position: [8, 0], velocity: [-2, 0], goal: [-8, 0], radius: 0.5, max_speed: 2, max_acceleration: 1}
`;

const SEVEN = `version: 1
name: seven robots on a circle
method: avo_paper
control_time: 2
time_horizon: 4
duration: 30
groups:
  - number: 7
    radius: 0.5
    placement: {circle: {center: [0, 0], min_radius: 8, spacing: 2}}
    goals: antipodal
`;

/** Returns a built-in scene that decides by `method`. */
function crossing(library: Library, method: string): string {
  const text = library.builtinText("crossing-streams") ?? "";
  return text.replace(/^version: 1$/m, `version: 1\nmethod: ${method}`);
}

export const TOUR: TourStep[] = [
  {
    title: "The velocity obstacle",
    paragraphs: [
      "A robot meets an obstacle that keeps its velocity. Which velocities would let the two collide within the time τ? " +
        "For each time t the answer is a disc; the union of these discs is a cone whose tip is cut off: the velocity obstacle.",
      "Outside of it no collision comes before τ, if the robot has its new velocity at once. No robot has.",
    ],
    look: ["Dark in the inspector: the velocity obstacle, moved by the velocity of the obstacle.",
      "v′ lies on its rim, as near to vᵖʳᵉᶠ as it can.", "Acceleration, below: what this asks for exceeds the limit many times."],
    tries: [{ label: "look ahead, τ", path: "time_horizon", range: { least: 1, most: 10, step: 0.5, unit: "s", start: 4 } }],
    reference: "§III-A, Definition 1, Eqs. (4) to (6), Fig. 2", robot: 0, time: 1.5, speed: 1,
    scene: () => ONE("velocity_obstacle").replace("control_time: 2\n", "time_horizon: 4\n"),
  },
  {
    title: "The acceleration-velocity obstacle",
    paragraphs: [
      "Now the robot approaches its new velocity by proportional control: at any time its acceleration is the rest of the " +
        "change, divided by δ. So it comes near the new velocity only after a few δ, and it moves on a curve meanwhile.",
      "The velocities that collide on the way are again a union of discs. It is bent, because at early times the present " +
        "velocity counts more than the new one. What can be chosen is a disc of the radius δ aₘₐₓ around v.",
    ],
    look: ["The obstacle's rim is a curve now: the exact boundary of Eq. (29).", "The solid circle is the reach D(v, δ aₘₐₓ).",
      "The large dot is the velocity after this step: a part of the step from v to v′.",
      "Acceleration, below: it stays within the limit."],
    tries: [{ label: "control time, δ", path: "control_time", range: { least: 0.5, most: 4, step: 0.25, unit: "s", start: 2 } }],
    reference: "§III-B, Definition 2, Eqs. (7) to (13), (27) to (29), Figs. 3 and 4", robot: 0, time: 1.5, speed: 1,
    scene: () => ONE("avo_paper"),
  },
  {
    title: "Reciprocity",
    paragraphs: [
      "If both are robots that decide, each can leave a part of the work to the other. The set of safe relative velocities is " +
        "made convex by one half-plane, and each of the two gets its share of it.",
      "The shares are in proportion to what each can change: α = a_A / (a_A + a_B). No message is sent: both compute the same line.",
    ],
    look: ["One line in the inspector: the half-plane of the other robot. Hover it, and the robot stands out in both views.",
      "Select the other robot: its half-plane is the same, turned by 180°.", "The list of neighbors tells the share."],
    tries: [{ label: "aₘₐₓ of robot 1", path: "robots.1.max_acceleration", range: { least: 0.2, most: 2, step: 0.1, unit: "m/s²", start: 1 } }],
    reference: "§IV-A to IV-C, Eqs. (15) to (21), Fig. 5", robot: 0, time: 2, speed: 1,
    scene: () => TWO,
  },
  {
    title: "Half-planes and the linear program",
    paragraphs: [
      "Among many robots each neighbor gives a half-plane. Their intersection with the reach is convex: the bright region CA_A. " +
        "The robot takes the velocity in it that is nearest to vᵖʳᵉᶠ, by a linear program in two dimensions.",
      "What holds the choice are one or two of the half-planes: those bind, and are drawn bold. All others could be left out.",
    ],
    look: ["v′ lies in a corner or on an edge of the bright region.", "Hover the bold lines: the sentence above names the same robots.",
      "Play, and watch how the region closes as the robots come together."],
    tries: [{ label: "look ahead, τ", path: "time_horizon", range: { least: 1, most: 10, step: 0.5, unit: "s", start: 4 } }],
    reference: "§IV-D, Eqs. (22) and (23), Fig. 6(a)", robot: 0, time: 2.5, speed: 1,
    scene: () => SEVEN,
  },
  {
    title: "When it becomes dense",
    paragraphs: [
      "In a crowd there may be no bright region at all: CA_A is empty. Then the least unsafe velocity is taken, and the guarantee is gone.",
      "Four streams of 16 robots cross here, by the paper's method. From 13 s on discs overlap. Each contact is marked where it happens.",
    ],
    look: ["Clearance, below: it falls under 0.", "The status turns to least_unsafe, then overlapping; the history keeps it.",
      "Orca collides as well, and asks for 16 times the acceleration that the robots have."],
    tries: [{ label: "method", path: "method", words: ["avo_paper", "orca"] }],
    reference: "§IV-D (empty CA_A), §VI-B; PAPER.md says how much", robot: 5, time: 14, speed: 3,
    scene: (library) => crossing(library, "avo_paper"),
  },
  {
    title: "The certificate",
    paragraphs: [
      "This library's own method, avo, keeps the paper's half-planes as a proposal. Beside them stands a certificate: a robot only " +
        "does what keeps it apart from all others while all brake. Each can check that alone, and braking is always allowed.",
      "The same streams now pass each other without a contact, and within the limits of acceleration and speed.",
    ],
    look: ["The green region: velocities that the certificate admits for the next step.",
      "The braking paths of the robot and of its neighbors in the world: they never meet.",
      "Status refused: the certificate has refused a proposal and admitted another one."],
    tries: [{ label: "certificate", path: "certificate", words: ["braking_trajectories", "none"] }],
    reference: "Not in the paper: docs/certificate.md proves it", robot: 5, time: 14, speed: 3,
    scene: (library) => crossing(library, "avo"),
  },
];
