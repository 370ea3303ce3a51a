// SPDX-License-Identifier: Apache-2.0
// Icons of buttons, drawn by lines on a field of 20 x 20.

const PATHS: Record<string, string> = {
  play: "M6 4 16 10 6 16Z",
  pause: "M6 4h2.6v12H6Z M11.4 4H14v12h-2.6Z",
  forward: "M4 4 12 10 4 16Z M14 4h2v12h-2Z",
  back: "M16 4 8 10l8 6Z M4 4h2v12H4Z",
  restart: "M10 4a6 6 0 1 1-5.6 3.8 M4 3.5v4.6h4.6",
  move: "M5 3l10.5 7-4.6.9L14 16l-2.3 1.2-2.9-5L5 15.2Z",
  robot: "M10 4.5a5.5 5.5 0 1 0 .01 0Z M10 7.4v5.2 M7.4 10h5.2",
  wall: "M4 16 16 4 M2.6 14.6l2.8 2.8 M14.6 2.6l2.8 2.8",
  erase: "M5 5l10 10 M15 5 5 15",
  plus: "M10 4v12 M4 10h12",
  minus: "M4 10h12",
  orbit: "M10 3a7 7 0 1 0 .01 0Z M3 10c3 3.4 11 3.4 14 0 M10 3c-3.4 3-3.4 11 0 14",
  fit: "M3 8V3h5 M12 3h5v5 M17 12v5h-5 M8 17H3v-5",
};
const OUTLINES = new Set(["restart", "robot", "wall", "erase", "plus", "minus", "orbit", "fit"]);

export function icon(name: string): SVGSVGElement {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  svg.setAttribute("viewBox", "0 0 20 20");
  svg.setAttribute("aria-hidden", "true");
  svg.setAttribute("class", OUTLINES.has(name) ? "icon icon-outline" : "icon");
  const path = document.createElementNS(space, "path");
  path.setAttribute("d", PATHS[name] ?? "");
  svg.append(path);
  return svg;
}
