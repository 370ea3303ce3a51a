// SPDX-License-Identifier: Apache-2.0
// Animated GIFs (GIF89a): one palette for all frames, and for each frame only the part that has changed.
import { ByteWriter, writeLzw } from "./lzw.ts";

const COLORS = 256;
const UNCHANGED = COLORS - 1;   // the transparent color: the pixel of the frame before stays
const CUBE_LEVELS = 5;          // of red, green and blue, besides a frame's own colors
const SHORTEST_DELAY = 0.02;    // s; browsers replace shorter delays by 0.1

export interface GifOptions {
  delay: number;                // s, from frame to frame; rounded to hundredths of seconds that add up
  // 0xrrggbb, at most 255; without it, the colors of the first frame, and an even cube of others
  palette?: readonly number[];
}

/** Returns the most frequent colors of a picture, and a cube of colors for later pictures. */
export function paletteOf(rgba: Uint8ClampedArray): number[] {
  const counts = new Map<number, number>();
  for (let k = 0; k + 3 < rgba.length; k += 4) {
    const color = (rgba[k] << 16) | (rgba[k + 1] << 8) | rgba[k + 2];
    counts.set(color, (counts.get(color) ?? 0) + 1);
  }
  const cube = Array.from({ length: CUBE_LEVELS ** 3 }, (_, k) => {
    const level = (digit: number) => Math.round((255 * (Math.floor(k / CUBE_LEVELS ** digit) % CUBE_LEVELS)) /
      (CUBE_LEVELS - 1));
    return (level(2) << 16) | (level(1) << 8) | level(0);
  });
  const own = [...counts].sort((a, b) => b[1] - a[1] || a[0] - b[0]).map(([color]) => color);
  return [...new Set([...own.slice(0, UNCHANGED - cube.length), ...cube])];
}

/** Finds the index of the nearest of some colors, and caches recent results. */
class NearestColor {
  private static readonly SLOTS = 1 << 14;
  private readonly colors = new Int32Array(NearestColor.SLOTS).fill(-1);
  private readonly indices = new Uint8Array(NearestColor.SLOTS);

  constructor(private readonly palette: readonly number[]) {}

  of(color: number): number {
    const slot = Math.imul(color, 0x9e3779b1) >>> 18;
    if (this.colors[slot] === color) return this.indices[slot];
    this.colors[slot] = color;
    return (this.indices[slot] = this.search(color));
  }

  /** Compares squared distances; green counts most and blue least, as for human eyes. */
  private search(color: number): number {
    let best = 0;
    let least = Infinity;
    for (let k = 0; k < this.palette.length; ++k) {
      const other = this.palette[k];
      const r = (color >> 16) - (other >> 16);
      const g = ((color >> 8) & 255) - ((other >> 8) & 255);
      const b = (color & 255) - (other & 255);
      const distance = 3 * r * r + 6 * g * g + b * b;
      if (distance >= least) continue;
      best = k;
      least = distance;
    }
    return best;
  }
}

/** The part of a picture that has changed. */
interface Box { left: number; top: number; right: number; bottom: number }

/** Takes frames, and returns one file. Pictures are treated as opaque. */
export class GifEncoder {
  private readonly out = new ByteWriter();
  private readonly pixels: Uint32Array;   // of the last frame, in their original colors
  private readonly indices: Uint8Array;   // the new frame, with UNCHANGED for pixels that are shown already
  private readonly shown: Uint8Array;
  private colors: NearestColor | null = null;
  private frames = 0;

  constructor(readonly width: number, readonly height: number, private readonly options: GifOptions) {
    const sane = (length: number) => Number.isInteger(length) && length >= 1 && length <= 65535;
    if (!sane(width) || !sane(height)) throw new Error(`found a picture of ${width} x ${height}, must be 1 to 65535`);
    if (!(options.delay >= SHORTEST_DELAY && options.delay <= 600))
      throw new Error(`delay: found ${options.delay} s, must be ${SHORTEST_DELAY} to 600 s`);
    this.pixels = new Uint32Array(width * height);
    this.indices = new Uint8Array(width * height);
    this.shown = new Uint8Array(width * height);
  }

  add(rgba: Uint8ClampedArray): void {
    if (rgba.length !== 4 * this.pixels.length)
      throw new Error(`found ${rgba.length} bytes, must be ${this.width} x ${this.height} pixels of 4`);
    if (this.colors === null) this.begin(this.options.palette ?? paletteOf(rgba));
    const box = this.update(rgba);
    this.writeControl();
    this.writeImage(box);
    ++this.frames;
  }

  /** Returns the whole file; no frames may follow. */
  finish(): Uint8Array {
    if (this.frames === 0) throw new Error("found no frame, must be one or more");
    this.out.u8(0x3b);
    return this.out.bytes();
  }

  private begin(palette: readonly number[]): void {
    if (palette.length < 1 || palette.length > UNCHANGED)
      throw new Error(`palette: found ${palette.length} colors, must be 1 to ${UNCHANGED}`);
    this.colors = new NearestColor(palette);
    const { out } = this;
    out.text("GIF89a");
    out.u16(this.width);
    out.u16(this.height);
    for (const byte of [0xf7, 0, 0]) out.u8(byte);  // a palette of 256 colors for all frames
    for (let k = 0; k < COLORS; ++k)
      for (const shift of [16, 8, 0]) out.u8(((palette[k] ?? 0) >> shift) & 255);
    for (const byte of [0x21, 0xff, 11]) out.u8(byte);
    out.text("NETSCAPE2.0");
    for (const byte of [3, 1, 0, 0, 0]) out.u8(byte);  // repeat forever
  }

  /** Takes over the frame, and returns the part of the picture that has changed; one pixel if nothing has. */
  private update(rgba: Uint8ClampedArray): Box {
    const colors = this.colors as NearestColor;
    const { width, pixels, indices, shown } = this;
    const first = this.frames === 0;
    const box: Box = { left: width, top: this.height, right: -1, bottom: -1 };
    for (let k = 0, y = 0; y < this.height; ++y)
      for (let x = 0; x < width; ++x, ++k) {
        const at = 4 * k;
        const color = (rgba[at] << 16) | (rgba[at + 1] << 8) | rgba[at + 2];
        indices[k] = UNCHANGED;
        if (color === pixels[k] && !first) continue;
        pixels[k] = color;
        const index = colors.of(color);
        if (index === shown[k] && !first) continue;
        shown[k] = indices[k] = index;
        if (x < box.left) box.left = x;
        if (x > box.right) box.right = x;
        if (y < box.top) box.top = y;
        box.bottom = y;
      }
    return box.right < 0 ? { left: 0, top: 0, right: 0, bottom: 0 } : box;
  }

  private writeControl(): void {
    const ends = (frames: number) => Math.round(100 * frames * this.options.delay);
    // the picture stays for the next frame; one color is transparent
    for (const byte of [0x21, 0xf9, 4, 0x05]) this.out.u8(byte);
    this.out.u16(ends(this.frames + 1) - ends(this.frames));
    this.out.u8(UNCHANGED);
    this.out.u8(0);
  }

  private writeImage({ left, top, right, bottom }: Box): void {
    const width = right + 1 - left;
    const height = bottom + 1 - top;
    this.out.u8(0x2c);
    for (const number of [left, top, width, height]) this.out.u16(number);
    this.out.u8(0);
    const part = new Uint8Array(width * height);
    for (let y = 0; y < height; ++y) {
      const begin = (top + y) * this.width + left;
      part.set(this.indices.subarray(begin, begin + width), y * width);
    }
    writeLzw(part, this.out);
  }
}
