// SPDX-License-Identifier: Apache-2.0
// Vectors of three numbers.
export type Vec3 = [number, number, number];

export const dot3 = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross3 = (a: Vec3, b: Vec3): Vec3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const minus3 = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times3 = (factor: number, a: Vec3): Vec3 => [factor * a[0], factor * a[1], factor * a[2]];
export const norm3 = (a: Vec3): number => Math.hypot(...a);
export const unit3 = (a: Vec3): Vec3 => times3(1 / norm3(a), a);
export const plus3 = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
