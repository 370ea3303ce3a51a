// SPDX-License-Identifier: Apache-2.0
// Walls in a scene's text: finds the entry of `obstacles` that a wall comes from, and moves it in the text.
import type { SceneInfo } from "../../avo/avo.ts";
import { valueAt, withValue } from "./scene_text.ts";

type Point = [number, number];
type Wall = SceneInfo["walls"][number];
type Entry = Record<string, unknown>;

const near = (a: number, b: number) => Math.abs(a - b) < 1e-9;
const same = (a: Point, b: Point) => near(a[0], b[0]) && near(a[1], b[1]);
const NUMBERS = /([-+]?[\d.]+(?:e[-+]?\d+)?)\s+([-+]?[\d.]+(?:e[-+]?\d+)?)/gi;

/** An entry of `obstacles`, and the path of the list or the text that contains its points. */
interface Source { entry: number; path: string; points: Point[]; radius: number; wkt: string | null }

/** Returns null for a wall of a map or of a file. The list may have been different at the run's time, so the number
 * alone may be wrong. */
function sourceOf(yaml: string, wall: Wall): Source | null {
  const entries = (valueAt(yaml, "obstacles") ?? []) as Entry[];
  const has = ({ points, radius }: Source) =>
    near(radius, wall.radius) && points.some((p) => same(p, wall.a)) && points.some((p) => same(p, wall.b));
  const sources = entries.map(sourceIn).filter(has);
  return sources.find(({ entry }) => entry === wall.obstacle) ?? sources[0] ?? null;
}

function sourceIn(known: Entry, entry: number): Source {
  const shape = ["polyline", "polygon"].find((key) => key in known);
  const wkt = typeof known["wkt"] === "string" ? known["wkt"] : null;
  const disc = known["disc"] as { center: Point; radius: number } | undefined;
  const points = shape ? (known[shape] as Point[]) : wkt ? pointsOf(wkt) : disc ? [disc.center] : [];
  return { entry, path: `obstacles.${entry}.${shape ?? (wkt ? "wkt" : "disc.center")}`, points, radius: disc?.radius ?? 0, wkt };
}

function pointsOf(wkt: string): Point[] {
  return [...wkt.matchAll(NUMBERS)].map((pair) => [Number(pair[1]), Number(pair[2])]);
}

/** Returns the text with `vertex` of the wall, or the whole obstacle, moved by (dx, dy) m. */
export function withWallMoved(yaml: string, wall: Wall, vertex: Point | null, dx: number, dy: number): string | null {
  const source = sourceOf(yaml, wall);
  if (!source) return null;
  const moved = (p: Point): Point => (vertex && !same(p, vertex) ? p : [round(p[0] + dx), round(p[1] + dy)]);
  if (source.wkt) {
    const text = source.wkt.replace(NUMBERS, (pair, x, y) => {
      const [nx, ny] = moved([Number(x), Number(y)]);
      return vertex && !same([Number(x), Number(y)], vertex) ? pair : `${nx} ${ny}`;
    });
    return withValue(yaml, source.path, text);
  }
  if (source.path.endsWith("center")) return withValue(yaml, source.path, moved(source.points[0]!));
  return withValue(yaml, source.path, source.points.map(moved));
}

/** Returns the text without the whole obstacle that contains the wall. */
export function withoutWall(yaml: string, wall: Wall): string | null {
  const source = sourceOf(yaml, wall);
  return source && withValue(yaml, `obstacles.${source.entry}`, undefined);
}

/** Rounds to a millimeter. */
export const round = (meters: number) => Math.round(1000 * meters) / 1000;
