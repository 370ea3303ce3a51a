// SPDX-License-Identifier: Apache-2.0
// The unit vector of a heading in the bits of the library (core/elementary.h, core/double_double.h): Math.cos and Math.sin
// differ from it by a last bit here and there.

type DoubleDouble = readonly [high: number, low: number];

function fastTwoSum(a: number, b: number): DoubleDouble {
  const sum = a + b;
  return [sum, b - (sum - a)];
}

function twoSum(a: number, b: number): DoubleDouble {
  const sum = a + b;
  const part = sum - a;
  return [sum, (a - (sum - part)) + (b - part)];
}

function halves(a: number): DoubleDouble {
  const scaled = (2 ** 27 + 16) * a;
  const high = scaled - (scaled - a);
  return [high, a - high];
}

function twoProduct(a: number, b: number): DoubleDouble {
  const product = a * b;
  const x = halves(a), y = halves(b);
  return [product, ((x[0] * y[0] - product) + x[0] * y[1] + x[1] * y[0]) + x[1] * y[1]];
}

function plus(a: DoubleDouble, b: DoubleDouble): DoubleDouble {
  const sum = twoSum(a[0], b[0]);
  return fastTwoSum(sum[0], sum[1] + (a[1] + b[1]));
}

function times(a: DoubleDouble, b: DoubleDouble): DoubleDouble {
  const product = twoProduct(a[0], b[0]);
  return fastTwoSum(product[0], product[1] + (a[0] * b[1] + a[1] * b[0]));
}

const HALF_PI = [1.5707963267948966, 6.123233995736766e-17, -1.4973849048591698e-33];  // in parts of 53 bits each
const ROUND = 1.5 * 2 ** 52;  // a + ROUND - ROUND is the whole number nearest to a
// coefficients of Taylor's series: of x^7 and up, of x^6 and up
const SINE_TAIL = [-1 / 5040, 1 / 362880, -1 / 39916800, 1 / 6227020800, -1 / 1307674368000, 1 / 355687428096000, -1 / 121645100408832000];
const COSINE_TAIL = [-1 / 720, 1 / 40320, -1 / 3628800, 1 / 479001600, -1 / 87178291200, 1 / 20922789888000, -1 / 6402373705728000];

const polynomial = (coefficients: number[], z: number): number => coefficients.reduceRight((sum, c) => z * (c + sum), 0);

function sineNearZero(r: DoubleDouble): number {
  const square = times(r, r);
  const fifth = plus([1 / 120, 2 ** -56 / 120], [polynomial(SINE_TAIL, square[0]), 0]);
  const third = plus([-1 / 6, -(2 ** -54) / 6], times(square, fifth));
  return plus(r, times(r, times(square, third)))[0];
}

function cosineNearZero(r: DoubleDouble): number {
  const square = times(r, r);
  const fourth = plus([1 / 24, 2 ** -54 / 24], [polynomial(COSINE_TAIL, square[0]), 0]);
  const second = plus([-0.5, 0], times(square, fourth));
  return plus([1, 0], times(square, second))[0];
}

/** [cos x, sin x] for |x| <= 2^40 rad. */
export function direction(x: number): [number, number] {
  if (Math.abs(x) < 2 ** -27) return [1, x];
  const quarters = (x * 0.6366197723675814 + ROUND) - ROUND;  // x / (π/2)
  let rest: DoubleDouble = [x, 0];
  if (quarters !== 0) {
    const first = twoProduct(quarters, HALF_PI[0]!), second = twoProduct(quarters, HALF_PI[1]!);
    rest = twoSum(x, -first[0]);
    for (const part of [first[1], ...second, quarters * HALF_PI[2]!]) rest = plus(rest, [-part, 0]);
  }
  const sine = sineNearZero(rest), cosine = cosineNearZero(rest);
  const turned: [number, number][] = [[cosine, sine], [-sine, cosine], [-cosine, -sine], [sine, -cosine]];
  return turned[((quarters % 4) + 4) % 4]!;
}
