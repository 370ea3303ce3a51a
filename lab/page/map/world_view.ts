// SPDX-License-Identifier: Apache-2.0
// The map: it draws the Lab's content whenever that changes, and finds the thing under a pixel.
import type { Moment } from "../../avo/avo.ts";
import { emptyBox, fit, include, toPixels, type Box, type Camera, type Margin } from "./camera.ts";
import type { Rgb } from "./colors.ts";
import { vectorOf } from "./discs.ts";
import { ASIDE, ofThePlane, PLAN, projectionOf, type Orbit } from "./orbit.ts";
import type { PageLab } from "../run/make_lab.ts";
import { drawSelection } from "./selection_layer.ts";
import type { Run } from "../run/run.ts";
import { shownOf, type Shown } from "./shown.ts";
import { bodiesOf, drawBoxes, drawDownwash, drawGround } from "./space_layers.ts";
import { cornersOf, middleOf, stageOf, type Stage } from "./stage.ts";
import { noteTrails, type Trails } from "./trails.ts";
import { look, makePainter, paint, type Painter } from "./webgl.ts";
import {
  drawContacts, drawGoals, drawGrid, drawHeads, drawMovers, drawRobots, drawTrails, drawWalls, drawGoalLines, homeAngles, homeColors, Layers, robotColors,
  themePaint, type Paint,
} from "./world_layers.ts";

// pixels, for controls that float over the map; on a phone there are none beside it
const MARGIN = { x: 56, top: 48, bottom: 74 };
const PHONE_MARGIN = { x: 16, top: 84, bottom: 50 };

export interface WorldView {
  readonly canvas: HTMLCanvasElement;
  readonly camera: Camera;
  readonly orbit: Orbit | null;                   // null in the plane
  readonly shown: Shown;                          // for the last picture, or for a later moment
  preview: ((layers: Layers, paint: Paint) => void) | null;  // the preview of a gesture
  readonly whenDrawn: Set<() => void>;
  draw(): void;
  fit(): void;
  /** Requests another picture before the next frame. */
  touch(): void;
  /** Turns the view, in space. */
  turn(by: (orbit: Orbit) => void): void;
  /** Draws if necessary. Returns true if it drew. */
  frame(): boolean;
}

/** The drawn content, and flags for its outdated parts. */
interface Drawing {
  run: Run;                     // the run that has the shown stage
  space: { orbit: Orbit; stage: Stage } | null;  // null in the plane
  layers: Layers;
  trails: Trails;
  theme: Paint;
  angles: Map<number, number>;  // of the line from each robot's start to its goal, rad
  homes: Map<number, Rgb>;      // the colors of these angles
  trailsAreOld: boolean;
  isOld: boolean;
  shown: Shown;
  shownIsOld: boolean;
}

export function makeWorldView(lab: PageLab, canvas: HTMLCanvasElement): WorldView {
  const gl = canvas.getContext("webgl2", { antialias: false, alpha: false, depth: false, stencil: false });
  if (!gl) throw new Error("this browser has no WebGL2, which the map is drawn with");
  let painter: Painter | null = makePainter(gl);
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    painter = null;
  });
  canvas.addEventListener("webglcontextrestored", () => {
    painter = makePainter(gl);
    view.touch();
  });

  const shown = shownOf(lab.run, 1);
  const drawing: Drawing = {
    run: lab.run, space: spaceOf(lab, null),
    layers: new Layers(), trails: { samples: [] }, theme: themePaint(), angles: homeAngles(shown),
    homes: homeColors(homeAngles(shown), lab.theme),
    trailsAreOld: true, isOld: true, shown, shownIsOld: false,
  };
  const view: WorldView = {
    canvas,
    camera: { x: 0, y: 0, scale: 10, width: 1, height: 1 },
    get orbit() { return drawing.space?.orbit ?? null; },
    get shown() {
      if (drawing.shownIsOld) drawing.shown = shownOf(lab.run, lab.share, projectionIn(drawing));
      drawing.shownIsOld = false;
      return drawing.shown;
    },
    preview: null,
    whenDrawn: new Set(),
    touch() { drawing.isOld = true; },
    turn(by) {
      if (!drawing.space) return;
      by(drawing.space.orbit);
      drawing.trailsAreOld = drawing.isOld = drawing.shownIsOld = true;
    },
    fit() {
      fit(view.camera, boxOf(lab, view.shown, drawing.space?.stage ?? null), marginOf(view.camera));
      drawing.isOld = true;
    },
    frame() {
      if (!drawing.isOld && !lab.playing) return false;
      view.draw();
      return true;
    },
    draw() {
      drawing.isOld = false;
      drawing.shownIsOld = true;  // while the run plays, every picture is of another time
      fillLayers(lab, view, drawing);
      if (painter) paintLayers(painter, view, drawing);
      for (const done of view.whenDrawn) done();
    },
  };
  noteTrails(drawing.trails, shown);
  followLab(lab, view, drawing);
  new ResizeObserver(() => resize(view)).observe(canvas);
  resize(view);
  return view;
}

function projectionIn({ space }: Pick<Drawing, "space">): Shown["project"] {
  return space ? projectionOf(space.orbit) : ofThePlane;
}

/** Returns the surroundings of the present run, seen from where `before` was seen. */
function spaceOf(lab: PageLab, before: Drawing["space"]): Drawing["space"] {
  if (lab.info.dimensions === 2) return null;
  const stage = stageOf(lab.run.moment, lab.info);
  return { stage, orbit: { ...(before?.orbit ?? ASIDE), pivot: middleOf(stage.bounds) } };
}

/** Returns the colors' angles as the plan shows them, whatever the view. */
function anglesOf(lab: PageLab, view: WorldView): Map<number, number> {
  return homeAngles(view.orbit ? shownOf(lab.run, 1, projectionOf({ ...view.orbit, ...PLAN })) : view.shown);
}

function fillLayers(lab: PageLab, view: WorldView, { layers, trails, theme, homes, trailsAreOld, space }: Drawing): void {
  const { shown, camera } = view;
  layers.clear();
  const colors = robotColors(lab, shown, lab.coloring, homes);
  if (trailsAreOld) drawTrails(layers, trails, shown, colors);
  if (space) drawGround(layers, space.stage, shown, theme);
  else drawGrid(layers, camera, theme);
  drawGoalLines(layers, shown, colors);
  if (space) drawBoxes(layers, lab, space.stage, shown, space.orbit, theme);
  else drawWalls(layers, lab, theme);
  if (space) drawDownwash(layers, shown, colors);
  drawHeads(layers, trails, shown, colors);
  drawGoals(layers, lab, shown, colors, 1 / camera.scale);
  drawMovers(layers, lab, shown, theme);
  drawRobots(layers, shown, colors, theme, space ? bodiesOf(space.stage, shown, space.orbit) : undefined);
  drawSelection(layers, lab, shown, theme);
  drawContacts(layers, lab.contacts, lab.moment.time, shown, theme);
  view.preview?.(layers, theme);
}

function paintLayers(painter: Painter, { canvas, camera }: WorldView, drawing: Drawing): void {
  const { gl, discs, lines, faces } = painter;
  const { layers, theme } = drawing;
  const density = canvas.width / camera.width;
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.clearColor(...theme.world, 1);
  gl.clear(gl.COLOR_BUFFER_BIT);
  look(painter, camera.x, camera.y, camera.scale * density, density, [...theme.world, 0.9]);
  paint(painter, faces, layers.faces);
  paint(painter, lines, layers.ground);
  paint(painter, lines, layers.trail, drawing.trailsAreOld);
  paint(painter, lines, layers.heads);
  paint(painter, discs, layers.below);
  paint(painter, lines, layers.links);
  paint(painter, discs, layers.discs);
  paint(painter, discs, layers.above);
  drawing.trailsAreOld = false;
}

function resize(view: WorldView): void {
  const { canvas, camera } = view;
  const { clientWidth, clientHeight } = canvas;
  if (!clientWidth || !clientHeight) return;
  const density = Math.min(2, window.devicePixelRatio || 1);
  canvas.width = Math.round(clientWidth * density);
  canvas.height = Math.round(clientHeight * density);
  const first = camera.width <= 1;
  const grown = Math.min(clientWidth / camera.width, clientHeight / camera.height);
  camera.width = clientWidth;
  camera.height = clientHeight;
  if (first) view.fit();
  else camera.scale *= grown;
  view.draw();  // at once, because resizing clears a canvas
}

function followLab(lab: PageLab, view: WorldView, drawing: Drawing): void {
  const fitted = { name: lab.name, start: lab.moment };
  const redraw = () => { drawing.trailsAreOld = drawing.isOld = true; };
  lab.on("moment", () => {
    noteTrails(drawing.trails, shownOf(lab.run, 1));
    drawing.shownIsOld = true;
    redraw();
  });
  lab.on("scene", () => {
    drawing.shownIsOld = true;
    if (lab.run !== drawing.run) drawing.space = spaceOf(lab, fitted.name === lab.name ? drawing.space : null);
    drawing.run = lab.run;
    if (lab.moment.steps === 0) drawing.angles = anglesOf(lab, view);
    drawing.homes = homeColors(drawing.angles, lab.theme);
    const { name, start } = fitted;
    fitted.name = lab.name;
    if (lab.moment.steps === 0) fitted.start = lab.moment;
    if (name === lab.name && !(beginsElsewhere(fitted.start, start) && isOutside(view))) return;
    drawing.trails.samples.length = 0;
    view.fit();
  });
  lab.on("theme", () => {
    drawing.theme = themePaint();
    drawing.homes = homeColors(drawing.angles, lab.theme);
    redraw();
  });
  lab.on("coloring", redraw);
  for (const event of ["selection", "highlight"] as const) lab.on(event, view.touch);
}

/** On a low map, most of the height is for the content. */
function marginOf({ height }: Camera): Margin {
  const { x, top, bottom } = matchMedia("(max-width: 720px)").matches ? PHONE_MARGIN : MARGIN;
  return { x, top: Math.min(top, 0.36 * height), bottom: Math.min(bottom, 0.3 * height) };
}

/** Returns whether most robots begin where none began before: then another scene was opened, not a slider moved or a
 * robot dragged. */
function beginsElsewhere(now: Moment, before: Moment): boolean {
  if (now === before) return false;
  const placesOf = ({ robot, position, dimensions }: Moment) => Array.from(robot, (_, i) => vectorOf(position, dimensions, i).join(" "));
  const known = new Set(placesOf(before));
  return 2 * placesOf(now).filter((place) => !known.has(place)).length > now.robot.length;
}

/** Returns whether most robots are outside the picture. */
function isOutside({ camera, shown: { x, y } }: WorldView): boolean {
  const outside = x.filter((_, i) => {
    const [px, py] = toPixels(camera, x[i]!, y[i]!);
    return px < 0 || py < 0 || px > camera.width || py > camera.height;
  });
  return 2 * outside.length > x.length;
}

/** Returns the box of everything, goals included. */
function boxOf(lab: PageLab, shown: Shown, stage: Stage | null): Box {
  const box = emptyBox();
  const { moment } = shown;
  for (const corner of stage ? cornersOf(stage.bounds) : []) include(box, ...(shown.project(...corner).slice(0, 2) as [number, number]));
  moment.robot.forEach((_, i) => {
    include(box, shown.x[i]!, shown.y[i]!, shown.radius[i]!);
    include(box, shown.goal[2 * i]!, shown.goal[2 * i + 1]!, shown.radius[i]!);
  });
  for (const { a, b, radius } of lab.info.walls) {
    include(box, ...a, radius);
    include(box, ...b, radius);
  }
  for (const { x, y, radius } of shown.movers) include(box, x, y, radius);
  return box;
}
