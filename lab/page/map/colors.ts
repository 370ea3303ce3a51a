// SPDX-License-Identifier: Apache-2.0
// Colors that people with red-green blindness can tell apart: those of Okabe and Ito, arranged in a circle for
// directions. A robot's shape shows its state.

export type Rgb = [number, number, number];  // sRGB, 0 to 1

const BLUE = "#0072b2";
const SKY = "#56b4e9";
const GREEN = "#009e73";
const YELLOW = "#f0e442";
const ORANGE = "#e69f00";
const VERMILION = "#d55e00";
const PURPLE = "#cc79a7";

const CIRCLE = [SKY, BLUE, PURPLE, VERMILION, ORANGE, YELLOW, GREEN].map((hex) => toLab(rgbOf(hex)));
const RAMP = ["#243f7d", "#3d6f9e", "#6f9f9a", "#b9bd76", "#ffe94e"].map((hex) => toLab(rgbOf(hex)));

/** Returns the color of a direction in rad; opposite directions differ most. No color is dark on a dark background, or
 * light on a light one. */
export function directionColor(angle: number, theme: "light" | "dark"): Rgb {
  const turn = angle / (2 * Math.PI);
  const [light, a, b] = between(CIRCLE, (turn - Math.floor(turn)) * CIRCLE.length, true);
  const [least, most] = theme === "dark" ? [0.62, 0.88] : [0.48, 0.74];
  return toRgb([Math.min(most, Math.max(least, light)), a, b]);
}

/** Returns the color of a speed from slow, 0, to fast, 1. */
export function shareColor(share: number): Rgb {
  return toRgb(between(RAMP, Math.min(1, Math.max(0, share)) * (RAMP.length - 1), false));
}

export function rgbOf(css: string): Rgb {
  const hex = css.trim().replace("#", "");
  const full = hex.length === 3 ? [...hex].map((digit) => digit + digit).join("") : hex;
  return [0, 2, 4].map((at) => parseInt(full.slice(at, at + 2), 16) / 255) as Rgb;
}

export function cssOf(rgb: Rgb): string {
  return `#${rgb.map((part) => Math.round(255 * part).toString(16).padStart(2, "0")).join("")}`;
}

function between(stops: Rgb[], at: number, around: boolean): Rgb {
  const k = Math.floor(at);
  const share = at - k;
  const from = stops[k % stops.length]!;
  const to = stops[around ? (k + 1) % stops.length : Math.min(k + 1, stops.length - 1)]!;
  return from.map((part, i) => part + share * (to[i]! - part)) as Rgb;
}

// Oklab: equal steps look equal (Bjorn Ottosson, 2020).
function toLab(rgb: Rgb): Rgb {
  const [r, g, b] = rgb.map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)) as Rgb;
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

function toRgb([light, a, b]: Rgb): Rgb {
  const l = (light + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (light - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (light - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const linear = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
  return linear.map((c) => {
    const share = Math.min(1, Math.max(0, c));
    return share <= 0.0031308 ? 12.92 * share : 1.055 * share ** (1 / 2.4) - 0.055;
  }) as Rgb;
}
