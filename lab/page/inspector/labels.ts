// SPDX-License-Identifier: Apache-2.0
// Labels on a drawing that avoid each other: each takes the first free place around its point.
import { drawMath, mathWidth } from "./math_text.ts";

interface Taken {
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
  /** Whether the label is left out if every place is taken; otherwise it takes the first place. */
  optional?: boolean;
}

const DIRECTIONS = [[1, -1], [1, 1], [-1, -1], [-1, 1], [1, 0], [-1, 0], [0, -1], [0, 1]] as const;

export class Labels {
  private taken: Taken[] = [];
  constructor(private context: CanvasRenderingContext2D, private inside: Taken) {}

  keepFree(x: number, y: number, radius: number): void {
    this.taken.push({ left: x - radius, top: y - radius, right: x + radius, bottom: y + radius });
  }

  /** Draws at x, y or at the nearest free place beside it. */
  place(x: number, y: number, label: Label): void {
    const width = mathWidth(this.context, label.formula, label.size), height = label.size;
    const places = DIRECTIONS.map(([right, down]): Taken => {
      const left = x + right * label.distance - (right < 0 ? width : right === 0 ? 0.5 * width : 0);
      const top = y + down * label.distance - (down < 0 ? height : down === 0 ? 0.5 * height : 0);
      return { left, top, right: left + width, bottom: top + height };
    });
    const free = places.find((place) => this.isInside(place) && !this.taken.some((other) => overlap(place, other)));
    const place = free ?? (label.optional ? undefined : places.find((other) => this.isInside(other)) ?? places[0]);
    if (!place) return;
    this.taken.push(place);
    drawMath(this.context, label.formula, place.left, place.bottom - 0.18 * label.size, label.size, label.color, label.halo);
  }

  private isInside(place: Taken): boolean {
    return place.left >= this.inside.left && place.right <= this.inside.right &&
      place.top >= this.inside.top && place.bottom <= this.inside.bottom;
  }
}

function overlap(a: Taken, b: Taken): boolean {
  return a.left < b.right + 2 && b.left < a.right + 2 && a.top < b.bottom + 1 && b.top < a.bottom + 1;
}
