// SPDX-License-Identifier: Apache-2.0
// From meters to pixels: x to the right, y up, the same scale for both.

/** The middle of the picture (m) and its scale; width and height are the picture's, in CSS pixels. */
export interface Camera {
  x: number;
  y: number;
  scale: number;   // CSS pixels per meter
  width: number;
  height: number;
}

export interface Box { xmin: number; ymin: number; xmax: number; ymax: number }

export const emptyBox = (): Box => ({ xmin: Infinity, ymin: Infinity, xmax: -Infinity, ymax: -Infinity });

export function include(box: Box, x: number, y: number, reach = 0): void {
  if (!Number.isFinite(x + y)) return;
  box.xmin = Math.min(box.xmin, x - reach);
  box.xmax = Math.max(box.xmax, x + reach);
  box.ymin = Math.min(box.ymin, y - reach);
  box.ymax = Math.max(box.ymax, y + reach);
}

export function toPixels(camera: Camera, x: number, y: number): [number, number] {
  return [camera.width / 2 + (x - camera.x) * camera.scale, camera.height / 2 - (y - camera.y) * camera.scale];
}

export function toMeters(camera: Camera, px: number, py: number): [number, number] {
  return [camera.x + (px - camera.width / 2) / camera.scale, camera.y - (py - camera.height / 2) / camera.scale];
}

/** Free pixels around the fitted box. */
export interface Margin { x: number; top: number; bottom: number }

/** Shows all of `box`. */
export function fit(camera: Camera, box: Box, { x, top, bottom }: Margin): void {
  if (box.xmin > box.xmax) return;
  const width = Math.max(1, box.xmax - box.xmin);
  const height = Math.max(1, box.ymax - box.ymin);
  const room = (pixels: number) => Math.max(40, pixels);
  camera.scale = clampScale(Math.min(room(camera.width - 2 * x) / width, room(camera.height - top - bottom) / height));
  camera.x = (box.xmin + box.xmax) / 2;
  camera.y = (box.ymin + box.ymax) / 2 + (top - bottom) / 2 / camera.scale;
}

/** Zooms about a pixel, which keeps showing the same place. */
export function zoomAt(camera: Camera, px: number, py: number, factor: number): void {
  const [x, y] = toMeters(camera, px, py);
  camera.scale = clampScale(camera.scale * factor);
  const [nx, ny] = toMeters(camera, px, py);
  camera.x += x - nx;
  camera.y += y - ny;
}

const clampScale = (scale: number) => Math.min(2000, Math.max(1e-3, scale));

/** Returns 1, 2 or 5 times a power of ten: the least such number that is at least the wanted one. */
export function roundedUp(wanted: number): number {
  const power = 10 ** Math.floor(Math.log10(wanted));
  return [1, 2, 5, 10].map((digit) => digit * power).find((number) => number >= wanted * 0.999)!;
}

/** Returns the least round length (m) that is at least `pixels` wide. */
export function roundLength(camera: Camera, pixels: number): number {
  return roundedUp(pixels / camera.scale);
}
