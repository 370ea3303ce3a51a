# SPDX-License-Identifier: Apache-2.0
"""The colors of robots: those of Okabe and Ito, as in figures (figures/colors.h) and in the lab."""
from __future__ import annotations

import numpy as np
import numpy.typing as npt

BLUE, SKY, GREEN, YELLOW = 0x0072B2, 0x56B4E9, 0x009E73, 0xF0E442
ORANGE, VERMILION, PURPLE = 0xE69F00, 0xD55E00, 0xCC79A7

_FEW = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY)
_CIRCLE = (SKY, BLUE, PURPLE, VERMILION, ORANGE, YELLOW, GREEN)
_DARKEST, _PALEST = 0.48, 0.74  # lightness
Rgb = tuple[int, int, int]
_Numbers = npt.NDArray[np.float64]

# Oklab: equal steps look equal (Bjorn Ottosson, 2020).
_TO_CONES = np.array(
    [
        [0.4122214708, 0.5363325363, 0.0514459929],
        [0.2119034982, 0.6806995451, 0.1073969566],
        [0.0883024619, 0.2817188376, 0.6299787005],
    ]
)
_TO_LAB = np.array(
    [
        [0.2104542553, 0.793617785, -0.0040720468],
        [1.9779984951, -2.428592205, 0.4505937099],
        [0.0259040371, 0.7827717662, -0.808675766],
    ]
)


def _bytes(color: int) -> Rgb:
    return color >> 16, color >> 8 & 255, color & 255


def _lab(color: int) -> _Numbers:
    parts = np.array(_bytes(color)) / 255
    linear = np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
    return np.asarray(_TO_LAB @ np.cbrt(_TO_CONES @ linear))


def direction_color(angle: float) -> Rgb:
    """The color of a direction, rad; opposite directions differ most."""
    turn = angle / (2 * np.pi) % 1.0 * len(_CIRCLE)
    k = min(int(turn), len(_CIRCLE) - 1)
    start, end = _lab(_CIRCLE[k]), _lab(_CIRCLE[(k + 1) % len(_CIRCLE)])
    lab = start + (turn - k) * (end - start)
    lab[0] = min(max(lab[0], _DARKEST), _PALEST)
    cones = (np.linalg.inv(_TO_LAB) @ lab) ** 3
    linear = np.clip(np.linalg.inv(_TO_CONES) @ cones, 0.0, 1.0)
    parts = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    red, green, blue = (int(round(255 * float(part))) for part in parts)
    return red, green, blue


def robot_colors(goals: _Numbers) -> list[Rgb]:
    """A fixed set for a few robots. For more, the color follows from where the goal is, seen from the middle of all."""
    if len(goals) <= len(_FEW):
        return [_bytes(color) for color in _FEW[: len(goals)]]
    away = goals.mean(axis=0) - goals
    return [direction_color(float(np.arctan2(y, x))) for x, y in away]


def css(color: Rgb) -> str:
    return "#{:02x}{:02x}{:02x}".format(*color)
