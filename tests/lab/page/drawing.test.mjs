// SPDX-License-Identifier: Apache-2.0
// What the drawings are made of: views, ticks, and columns that are thinned.
import assert from "node:assert/strict";
import { test } from "node:test";
import { digits } from "../../../lab/page/frame/elements.ts";
import { thinned, worstByPixel } from "../../../lab/page/run/thinned.ts";
import { cssOf, directionColor } from "../../../lab/page/map/colors.ts";
import { Labels } from "../../../lab/page/inspector/labels.ts";
import { boxOf, panned, ticks, toScreen, toVelocity, zoomed } from "../../../lab/page/inspector/velocity_view.ts";

const VIEW = { center: [0.3, -0.2], scale: 90, width: 400, height: 300 };
const near = (a, b) => a.forEach((value, k) => assert.ok(Math.abs(value - b[k]) < 1e-9, `${a} ${b}`));

test("a view goes there and back, and zooms about a pixel", () => {
  near(toVelocity(VIEW, ...toScreen(VIEW, [1.25, -2])), [1.25, -2]);
  const closer = zoomed(VIEW, 3, 30, 250);
  assert.equal(closer.scale, 270);
  near(toVelocity(closer, 30, 250), toVelocity(VIEW, 30, 250));
  near(toScreen(panned(VIEW, 17, -5), [0, 0]), [toScreen(VIEW, [0, 0])[0] + 17, toScreen(VIEW, [0, 0])[1] - 5]);
  near(boxOf(VIEW), [0.3 - 200 / 90, -0.2 - 150 / 90, 0.3 + 200 / 90, -0.2 + 150 / 90]);
});

test("ticks are round numbers with as many digits as they need", () => {
  assert.deepEqual(ticks(-1.1, 1.1, 5).map((tick) => tick.text), ["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
  assert.deepEqual(ticks(0, 30, 4).map((tick) => tick.text), ["0", "10", "20", "30"]);
  assert.deepEqual(ticks(0.001, 0.0031, 3).map((tick) => tick.text), ["0.001", "0.002", "0.003"]);
});

test("thinned columns keep what exceeds most", () => {
  const times = Array.from({ length: 1000 }, (_, k) => k), values = times.map((k) => (k === 513 ? -1 : k === 700 ? Infinity : 3));
  const [at, lowest] = thinned(times, values, 100, true);
  assert.equal(at.length, 100);
  assert.deepEqual([Math.min(...lowest), at[lowest.indexOf(-1)]], [-1, 513]);
  assert.deepEqual(thinned(times, values, 100, false)[1][70], null);  // of infinity there is no place on a chart
  assert.deepEqual(thinned([0, 1], [5, 6], 100, true), [[0, 1], [5, 6]]);
});

test("a pixel of the history has the worst status of its steps", () => {
  const times = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10], statuses = Uint8Array.from([255, 0, 0, 0, 4, 0, 0, 2, 0, 255, 0]);
  assert.deepEqual([...worstByPixel(statuses, times, 10, 5)], [0, 4, 0, 2, 0]);
  assert.deepEqual([...worstByPixel(statuses, times, 20, 5)], [4, 2, 0, -1, -1]);
  assert.deepEqual([...worstByPixel(statuses, times, 10, 10)], [0, 0, 0, 4, 0, 0, 2, 0, -1, 0]);
  // a detour (6) is calmer than braking (3)
  assert.deepEqual([...worstByPixel(Uint8Array.from([255, 6, 3, 6, 2]), [0, 1, 2, 3, 4], 4, 2)], [3, 6]);
});

/** A canvas that only measures: 7 pixels a letter. */
const measuring = { measureText: (text) => ({ width: 7 * text.length }), strokeText() {}, fillText() {}, save() {}, restore() {} };

test("labels of one place do not cover each other, nor what is kept free", () => {
  const labels = new Labels(measuring, { left: 0, top: 0, right: 300, bottom: 300 });
  labels.keepFree(150, 150, 5);
  const label = { formula: "label", size: 16, color: "", halo: "", distance: 7 };
  const places = Array.from({ length: 12 }, (_, k) => labels.place(150 + (k % 3), 150, label));
  const covers = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
  places.forEach((place, k) => {
    assert.ok(!covers(place, { left: 145, top: 145, right: 155, bottom: 155 }), `the point, by label ${k}`);
    places.slice(0, k).forEach((other, j) => assert.ok(!covers(place, other), `labels ${j} and ${k}`));
  });
  assert.equal(labels.place(150, 150, { ...label, optional: true }), null, "there is no room left near the point");
});

// The same numbers are in tests/unit/figures/colors_test.cpp and in tests/python/svg_test.py.
test("directions have the colors of figures and of Python", () => {
  const expected = { 0: "#56b4e9", 100: "#c47aa8", 180: "#de7f00", 250: "#c2ad00", "-30": "#30a8a5" };
  for (const [degrees, color] of Object.entries(expected))
    assert.equal(cssOf(directionColor(Number(degrees) * Math.PI / 180, "light")), color, degrees);
});

test("numbers for people", () => {
  assert.deepEqual([digits(-0.001), digits(-1.5), digits(Infinity), digits(NaN), digits(2, 0)], ["0.00", "−1.50", "∞", "–", "2"]);
});
