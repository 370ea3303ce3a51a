// SPDX-License-Identifier: Apache-2.0
// The view of space without a browser: the projection, what a click means, boxes, and the cut through a velocity space.
import assert from "node:assert/strict";
import { test } from "node:test";
import { fillClearance, touchesIn } from "../../../lab/page/map/discs.ts";
import { axesOf, ELEVATION, PLAN, projectionOf, showNext, turnBy } from "../../../lab/page/map/orbit.ts";
import { inFront } from "../../../lab/page/map/picking.ts";
import { shownOf } from "../../../lab/page/map/shown.ts";
import { isHidden, solidOf, stageOf } from "../../../lab/page/map/stage.ts";
import { besidePlane, cutBall, cutHalfSpace, cutOfNobody, cutOfPair, inPlane } from "../../../lab/page/inspector/cut.ts";
import { moversAt } from "../../../lab/page/run/recorded_movers.ts";
import { SPACE_SCENES } from "../../../lab/page/text/space_scenes.ts";
import { randomNumbers } from "../data/native.mjs";
import { library, steps } from "../wasm/module.mjs";

const random = randomNumbers(5);
const between = (low, high) => low + (high - low) * random();
const vector = (size = 1) => [between(-size, size), between(-size, size), between(-size, size)];
const dot = (a, b) => a.reduce((sum, value, k) => sum + value * b[k], 0);
const near = (found, wanted, slack = 1e-9) =>
  found.forEach((value, k) => assert.ok(Math.abs(value - wanted[k]) <= slack, `${found} is not ${wanted}`));

test("plan and elevation show x, y and z as drawings do; the view keeps lengths", () => {
  near(projectionOf({ ...PLAN, pivot: [0, 0, 0] })(1, 2, 3), [1, 2, 3]);
  near(projectionOf({ ...ELEVATION, pivot: [0, 0, 0] })(1, 2, 3), [1, 3, -2]);
  near(projectionOf({ turn: 1, tilt: 0.3, pivot: [4, 5, 6] })(4, 5, 6), [0, 0, 0]);
  for (let k = 0; k < 50; ++k) {
    const orbit = { turn: between(-4, 4), tilt: between(-1.5, 1.5) };
    const axes = axesOf(orbit);
    axes.forEach((a, i) => axes.forEach((b, j) => near([dot(a, b)], [i === j ? 1 : 0])));
    const [right, up, towards] = axes;
    near([right[1] * up[2] - right[2] * up[1], right[2] * up[0] - right[0] * up[2], right[0] * up[1] - right[1] * up[0]], towards);
  }
});

test("a drag turns as the hand moves the near side, and the tilt ends at the plan", () => {
  const orbit = { turn: 0, tilt: 0, pivot: [0, 0, 0] };
  const before = projectionOf(orbit)(0, -1, 0);  // nearest to the viewer
  turnBy(orbit, 20, 0);
  assert.ok(projectionOf(orbit)(0, -1, 0)[0] > before[0], "to the right");
  turnBy(orbit, 0, 20);
  assert.ok(projectionOf(orbit)(0, -1, 0)[1] < before[1], "down");
  turnBy(orbit, 0, 1e5);
  assert.equal(orbit.tilt, PLAN.tilt);
  const views = [0, 1, 2].map(() => (showNext(orbit), orbit.tilt));
  assert.equal(new Set(views).size, 3);
});

const scene = (robots, more = "") => library.simulate(`version: 1\nspace: 3\n${more}robots:\n${robots.map((robot) => `  - ${robot}\n`).join("")}`);
const runOf = (simulation, before = null) => ({ moment: simulation.moment(), before, info: simulation.info() });

test("a click takes the ball in front, and in the elevation another one than in the plan", () => {
  const run = runOf(scene(["{position: [0, 0, 0], goal: [0, 0, 0]}", "{position: [0, 0.2, 4], goal: [0, 0, 4]}", "{position: [0, -4, 0.2], goal: [0, -4, 0]}"]));
  const frontOf = (view, x, y) => {
    const shown = shownOf(run, 1, projectionOf({ ...view, pivot: [0, 0, 0] }));
    return inFront(shown, (i) => Math.hypot(shown.x[i] - x, shown.y[i] - y));
  };
  assert.equal(frontOf(PLAN, 0, 0), 1, "the highest");
  assert.equal(frontOf(ELEVATION, 0, 0), 2, "the one at the least y");
  assert.equal(frontOf(PLAN, 0, -4), 2);
  assert.equal(frontOf(PLAN, 3, 3), undefined);
  assert.equal(inFront({ order: null, radius: [] }, () => 0), undefined, "in the plane discs do not hide each other");
});

test("between two steps places lie between, and goals and velocities are those of the picture", () => {
  const simulation = scene(["{position: [0, 0, 0], velocity: [0, 0, 1], goal: [0, 0, 9]}"]);
  const before = simulation.moment();
  steps(simulation, 1);
  const shown = shownOf(runOf(simulation, before), 0.5, projectionOf({ ...ELEVATION, pivot: [0, 0, 1] }));
  near([shown.y[0]], [simulation.moment().position[2] / 2 - 1]);
  near([...shown.goal], [0, 8]);
  assert.ok(shown.velocity[1] >= 1 && Math.abs(shown.velocity[0]) < 1e-9);
});

const floor = { min: [null, null, null], max: [null, null, -1], heading: 0, radius: 0, obstacle: 0 };
const ceiling = { min: [null, null, 3], max: [null, null, null], heading: 0, radius: 0, obstacle: 1 };
const crate = { min: [1, -1, 0], max: [2, 1, 2], heading: Math.PI / 2, radius: 0, obstacle: 2 };

test("boxes hide what is behind them; a box that the viewer is in hides nothing", () => {
  const [up, down] = [[0, 0, 1], [0, 0, -1]];
  assert.equal(isHidden([floor], [0, 0, 0], up), false);
  assert.equal(isHidden([floor], [0, 0, 0], down), false);
  assert.equal(isHidden([ceiling], [0, 0, 0], up), false);
  assert.equal(isHidden([crate], [0, 1.5, -1], up), true, "turned by 90 degrees it is at y from 1 to 2");
  assert.equal(isHidden([crate], [1.5, 0, -1], up), false);
  assert.equal(isHidden([crate], [0, 1.5, 3], up), false, "it is on top");
  assert.equal(isHidden([{ ...crate, radius: 0.5 }], [0, 2.4, -1], up), true);
});

test("infinite boxes end at the bounds of the scene; all sides are drawn", () => {
  const bounds = { min: [-5, -5, -1], max: [5, 5, 3] };
  const { faces, edges } = solidOf(floor, bounds);
  assert.equal(faces.length, 6);
  assert.equal(edges.length, 12);
  const top = faces.find(({ normal }) => normal[2] === 1);
  near(top.corner, [-5, -5, -1]);
  near([Math.hypot(...top.a) * Math.hypot(...top.b)], [100]);
  for (const { corner, a, b, normal } of solidOf(crate, bounds).faces) {
    near([dot(a, normal), dot(b, normal)], [0, 0]);
    const middle = corner.map((value, k) => value + (a[k] + b[k]) / 2 - [0, 1.5, 1][k]);
    assert.ok(dot(middle, normal) > 0, "normals point outwards");
  }
  const { moment, info } = runOf(scene(["{position: [0, 0, 0], goal: [4, 0, 1]}"], "obstacles: [{floor: -6}]\n"));
  const stage = stageOf(moment, info);
  assert.deepEqual(stage.bounds, { min: [-0.5, -0.5, -6], max: [4.5, 0.5, 1.5] });
});

test("moving obstacles of a recording are where the simulation has them", () => {
  const simulation = scene(["{position: [0, 0, 0], goal: [0, 0, 0]}"], `moving_obstacles:
  - {position: [-12, 40, 0], velocity: [10, 0, 9], acceleration: [0, 0, -9.81], radius: 0.2}
  - {trajectory: [[0.55, -40, 30, 2], [2.05, 40, 27, 2], [2.5, 40, 27, 5]], radius: 2}
`);
  const info = simulation.info();
  const moments = Array.from({ length: 40 }, () => (simulation.step(), simulation.moment()));
  for (const { time, moving_obstacles } of moments) near([...moversAt(info, time)], [...moving_obstacles]);
  assert.ok(moments.some((moment) => moment.moving_obstacles[9] !== 0), "one of them is on its way");
  assert.equal(moversAt({ moving_obstacles: [{ radius: 1 }] }, 1).length, 0, "of the plane");
});

test("clearances and contacts of recorded balls count the air below a ball", () => {
  const simulation = scene(["{position: [0, 0, 3], goal: [0, 0, 3], downwash: 2}", "{position: [9, 0, 0], goal: [9, 0, 0]}"]);
  const { moment, info } = runOf(simulation);
  moment.position.set([0.6, 0, 1.5], 3);
  fillClearance(moment, info);
  near([...moment.clearance], [-0.4, -0.4], 1e-6);
  const [touch] = touchesIn(moment, info);
  near([touch.x, touch.y, touch.z, touch.depth], [0.3, 0, 1.5, 0.4]);
  moment.position.set([0.6, 0, 0], 3);
  fillClearance(moment, info);
  near([moment.clearance[0]], [Math.hypot(0.6, 1) - 1], 1e-6);
});

test("scenes of space that the page has are described, and begin", () => {
  for (const { name, yaml, description } of SPACE_SCENES) {
    assert.match(description, /^\S.{10,120}; in space$/, name);
    assert.equal(steps(library.simulate(yaml, { name }), 1).dimensions, 3, name);
  }
});

const DRONES = "version: 1\nspace: 3\ngroups:\n  - {count: 30, sphere: {radius: 5}, goal: antipodal, jitter: 0.2, downwash: 1}\n";

test("the cut for a neighbor contains its half-space's normal, p, and the velocity", () => {
  const simulation = steps(library.simulate(DRONES), 15);
  let checked = 0;
  for (let robot = 0; robot < 30; ++robot) {
    const decision = JSON.parse(simulation.explain(robot));
    for (const half of decision.half_spaces) {
      const plane = cutOfPair(decision, half.neighbor);
      near([dot(plane.along, plane.across), dot(plane.along, plane.normal), dot(plane.across, plane.normal)], [0, 0, 0]);
      near([dot(half.normal, plane.normal)], [0], 1e-6);
      near([besidePlane(plane, decision.velocity)], [0]);
      const other = decision.neighbors.find(({ neighbor }) => neighbor === half.neighbor);
      const v = decision.velocity.map((value, k) => value - other.velocity[k]);
      near([dot(v, plane.normal)], [0], 1e-6);
      if (++checked % 7) continue;
      const cut = cutHalfSpace(plane, half);
      const at = [between(-2, 2), between(-2, 2)];
      const place = plane.along.map((value, k) => at[0] * value + at[1] * plane.across[k] + plane.offset * plane.normal[k]);
      near([dot(cut.normal, at) - cut.offset], [dot(half.normal, place) - half.offset], 1e-6);
    }
  }
  assert.ok(checked > 300, `${checked} half-spaces`);
});

test("half-spaces and ellipsoids are cut where the plane meets them", () => {
  for (let k = 0; k < 200; ++k) {
    const decision = { velocity: vector(), preferred_velocity: vector(), position: vector(5), half_spaces: [],
      neighbors: [{ neighbor: 1, position: vector(5), velocity: vector() }] };
    const plane = k % 2 ? cutOfPair(decision, 1) : cutOfNobody(decision);
    const place = ([x, y]) => plane.along.map((value, i) => x * value + y * plane.across[i] + plane.offset * plane.normal[i]);
    near(inPlane(plane, place([0.3, -0.7])), [0.3, -0.7]);
    const half = { normal: vector(), offset: between(-1, 1) };
    const cut = cutHalfSpace(plane, half);
    const on = [cut.offset * cut.normal[0], cut.offset * cut.normal[1]];
    near([dot(half.normal, place(on))], [half.offset]);
    const [center, radius, vertical] = [vector(0.4), 2, between(0.3, 3)];
    const disc = cutBall(plane, center, radius, vertical);
    if (!disc) continue;
    const { angle, ratio } = disc.squeeze ?? { angle: 0, ratio: 1 };
    assert.ok(ratio >= 1);
    for (const turn of [0, 1, 2, 3, 4, 5]) {
      const [a, b] = [disc.radius * Math.cos(turn), disc.radius * ratio * Math.sin(turn)];
      const rim = place([disc.center[0] + a * Math.cos(angle) - b * Math.sin(angle), disc.center[1] + a * Math.sin(angle) + b * Math.cos(angle)]);
      const away = rim.map((value, i) => (value - center[i]) / (i === 2 ? vertical : 1));
      near([Math.hypot(...away)], [radius], 1e-6);
    }
  }
});
