# SPDX-License-Identifier: Apache-2.0
"""Worlds as images of pixels: no other package is needed."""
from __future__ import annotations

import numpy as np
import numpy.typing as npt

from . import svg
from ._avo import Scenario
from ._colors import robot_colors

_WIDTH = 480  # px, of the longer side
_WALL, _MOVER, _GOAL = (51, 51, 51), (153, 153, 153), 0.35  # colors; of a radius
_Image = npt.NDArray[np.uint8]
_Points = npt.NDArray[np.float64]


class _Canvas:
    """White pixels between two corners, y up."""

    def __init__(self, low: _Points, high: _Points) -> None:
        self._pixel = float((high - low).max()) / _WIDTH  # m
        width, height = np.ceil((high - low) / self._pixel).astype(int)
        self.image: _Image = np.full((height, width, 3), 255, dtype=np.uint8)
        self._x = low[0] + self._pixel * (np.arange(width) + 0.5)
        self._y = high[1] - self._pixel * (np.arange(height) + 0.5)

    def segment(self, a: _Points, b: _Points, radius: float, color: tuple[int, ...]) -> None:
        """All pixels within the radius of the segment, and at least a line of them; a disc where a is b."""
        reach = max(radius, 0.75 * self._pixel)
        low, high = np.minimum(a, b) - reach, np.maximum(a, b) + reach
        columns = np.flatnonzero((self._x >= low[0]) & (self._x <= high[0]))
        rows = np.flatnonzero((self._y >= low[1]) & (self._y <= high[1]))
        if len(columns) == 0 or len(rows) == 0:
            return
        x, y = np.meshgrid(self._x[columns], self._y[rows])
        along = b - a
        part = ((x - a[0]) * along[0] + (y - a[1]) * along[1]) / max(float(along @ along), 1e-300)
        part = np.clip(part, 0.0, 1.0)
        inside = np.hypot(x - a[0] - part * along[0], y - a[1] - part * along[1]) <= reach
        block = self.image[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
        block[inside] = color


def draw(scene: Scenario, position: _Points, movers: _Points) -> _Image:
    """(height, width, 3): the scene with its robots and moving obstacles, (m, 3), where they are now."""
    robots = svg._robots_of(scene)
    low, high = svg._bounds(robots, np.empty((0, 0, 2)), svg._obstacles_of(scene), svg._movers_of(scene))
    canvas = _Canvas(low, high)
    for wall in scene.walls:
        canvas.segment(np.array(wall.a), np.array(wall.b), wall.radius, _WALL)
    for x, y, radius in movers:
        canvas.segment(np.array((x, y)), np.array((x, y)), radius, _MOVER)
    colors = robot_colors(np.array([goal for _, _, goal in robots]))
    for (_, radius, goal), at, color in zip(robots, position, colors):
        canvas.segment(goal, goal, _GOAL * radius, color)
        canvas.segment(at, at, radius, color)
    return canvas.image
