// SPDX-License-Identifier: Apache-2.0
// Labels on a drawing that avoid each other: each takes the first free place around its point, near it or in a ring
// farther away.
import { drawMath, mathWidth } from "./math_text.ts";

export interface Taken {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export interface Label {
  formula: string;
  size: number;
  color: string;
  halo: string;
  distance: number;  // pixels between the point and the text
  /** Whether the label is left out if every place is taken; otherwise it takes the place that covers least. */
  optional?: boolean;
}

const RINGS = 4;  // of places; labels that may be left out have one
const DIRECTIONS = [[1, -1], [1, 1], [-1, -1], [-1, 1], [1, 0], [-1, 0], [0, -1], [0, 1]] as const;

export class Labels {
  private taken: Taken[] = [];
  constructor(private context: CanvasRenderingContext2D, private inside: Taken) {}

  keepFree(x: number, y: number, radius: number): void {
    this.taken.push({ left: x - radius, top: y - radius, right: x + radius, bottom: y + radius });
  }

  /** Draws at x, y or at the nearest free place beside it. Returns the place; null if the label is left out. */
  place(x: number, y: number, label: Label): Taken | null {
    const width = mathWidth(this.context, label.formula, label.size), height = label.size;
    const places = Array.from({ length: label.optional ? 1 : RINGS }, (_, ring) => ring * height)
      .flatMap((farther) => placesAround(x, y, width, height, label.distance + farther))
      .filter((place) => this.isInside(place));
    const hidden = (place: Taken): number => this.taken.reduce((sum, other) => sum + overlap(place, other), 0);
    let place = places.find((candidate) => hidden(candidate) === 0);
    if (!place && label.optional) return null;
    place ??= places.sort((a, b) => hidden(a) - hidden(b))[0] ?? placesAround(x, y, width, height, label.distance)[0]!;
    this.taken.push(place);
    drawMath(this.context, label.formula, place.left, place.bottom - 0.18 * label.size, label.size, label.color, label.halo);
    return place;
  }

  private isInside(place: Taken): boolean {
    return place.left >= this.inside.left && place.right <= this.inside.right &&
      place.top >= this.inside.top && place.bottom <= this.inside.bottom;
  }
}

function placesAround(x: number, y: number, width: number, height: number, distance: number): Taken[] {
  return DIRECTIONS.map(([right, down]) => {
    const left = x + right * distance - (right < 0 ? width : right === 0 ? 0.5 * width : 0);
    const top = y + down * distance - (down < 0 ? height : down === 0 ? 0.5 * height : 0);
    return { left, top, right: left + width, bottom: top + height };
  });
}

/** Returns the area, in square pixels, that both take, with a little air between them. */
function overlap(a: Taken, b: Taken): number {
  const x = Math.min(a.right, b.right + 2) - Math.max(a.left, b.left - 2);
  const y = Math.min(a.bottom, b.bottom + 1) - Math.max(a.top, b.top - 1);
  return x > 0 && y > 0 ? x * y : 0;
}
