// SPDX-License-Identifier: Apache-2.0
// Colors of the inspector's drawings. Data are distinguishable for color-blind eyes (after Okabe and Ito), and also by
// form.

export interface Palette {
  ink: string;
  soft: string;       // lines and text beside the point
  frame: string;
  chosen: string;     // the set from which the robot may choose
  beyond: string;     // outside that set
  forbidden: string;
  forbidden_beyond: string;
  highlight: string;
  preferred: string;  // v^pref
  decided: string;    // v'
  admitted: [number, number, number, number];  // red, green, blue, of 255 each, and the opacity
  halo: string;
}

const LIGHT: Palette = {
  ink: "#16191d", soft: "#6a727c", frame: "#c3c8ce",
  chosen: "#ffffff", beyond: "#eceef1", forbidden: "#b9bec6", forbidden_beyond: "#d9dce1",
  highlight: "#d07c00", preferred: "#0072b2", decided: "#d55e00", admitted: [0, 158, 115, 0.3],
  halo: "rgba(255,255,255,0.9)",
};

const DARK: Palette = {
  ink: "#eef1f4", soft: "#99a3ae", frame: "#454d57",
  chosen: "#4a5663", beyond: "#1d2228", forbidden: "#15181c", forbidden_beyond: "#171a1f",
  highlight: "#f5b041", preferred: "#6cb8f0", decided: "#ff8a5c", admitted: [40, 200, 150, 0.34],
  halo: "rgba(22,26,31,0.9)",
};

export function paletteOf(theme: "light" | "dark"): Palette {
  return theme === "dark" ? DARK : LIGHT;
}

/** By PlanStatus: from calm to alarming in lightness as well as in hue. */
export const STATUS_COLORS: Record<string, { light: string; dark: string; says: string }> = {
  optimal: { light: "#a9c9e2", dark: "#33597a", says: "v′ satisfies all half-planes" },
  least_unsafe: { light: "#e69f00", dark: "#e0a030", says: "no velocity satisfies all half-planes: the least unsafe one" },
  refused: { light: "#3b8fc4", dark: "#62b2e6", says: "the certificate refused that choice, or it left no evasive maneuver, and another one is taken" },
  braking: { light: "#22577a", dark: "#b5dcf5", says: "nothing but braking is admitted" },
  overlapping: { light: "#b3261e", dark: "#ff6f61", says: "in contact, or braking no longer avoids it" },
  invalid_input: { light: "#000000", dark: "#ffffff", says: "a number is not finite or out of range: it brakes" },
  detour: { light: "#5c9f6b", dark: "#7cc48c", says: "the route is blocked, and it turns off to the right" },
};
