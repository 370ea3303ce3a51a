# SPDX-License-Identifier: Apache-2.0
"""Scenes as SVG, for notebooks: no other package is needed."""
from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ._avo import Error, Scenario, Simulation, _numbers
from ._colors import css, robot_colors

if TYPE_CHECKING:
    from ._avo import StaticObstacle

_WIDTH = 480.0  # px, at most, also of the height
_Points = npt.NDArray[np.float64]


def draw(scene: Scenario | Simulation, paths: npt.ArrayLike | None = None) -> str:
    """The text of an SVG image: robots, their goals (crosses), static and moving obstacles.

    paths: (steps, n, 2), m: where the n robots have been, drawn as lines.
    """
    if not isinstance(scene, (Scenario, Simulation)):
        raise Error(f"scene: found {type(scene).__name__}, must be a Scenario or a Simulation")
    robots = _robots_of(scene)
    lines = np.empty((0, 0, 2)) if paths is None else _numbers("paths", paths)
    if not np.all(np.isfinite(lines)):
        raise Error("paths: found a number that is not finite, must be finite")
    if lines.ndim != 3 or lines.shape[2] != 2:
        raise Error(f"paths: found shape {lines.shape}, must be (steps, n, 2)")
    obstacles, movers = _obstacles_of(scene), _movers_of(scene)
    low, high = _bounds(robots, lines, obstacles, movers)
    size = high - low
    scale = _WIDTH / float(size.max())
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{size[0] * scale:.0f}" '
        f'height="{size[1] * scale:.0f}" viewBox="{low[0]:.6g} {-high[1]:.6g} {size[0]:.6g} {size[1]:.6g}">',
        f"<title>{escape(scene.name)}</title>",
        f'<rect x="{low[0]:.6g}" y="{-high[1]:.6g}" width="{size[0]:.6g}" height="{size[1]:.6g}" fill="#fff"/>',
        # y is up, and lines are as thin at every scale
        f'<g transform="scale(1 -1)" fill="none" stroke-width="{1.0 / scale:.6g}">',
    ]
    parts += [_obstacle(obstacle, 2.0 / scale) for obstacle in obstacles]
    parts += [_disc(position, radius, 'fill="#999"') for position, radius in movers]
    colors = [css(color) for color in robot_colors(np.array([goal for _, _, goal in robots]))] or ["#333"]
    parts += [_line(lines[:, k], colors[k % len(colors)]) for k in range(lines.shape[1])]
    for (position, radius, goal), color in zip(robots, colors):
        parts.append(_cross(goal, 0.5 * radius, color))
        parts.append(_disc(position, radius, f'fill="{color}" fill-opacity="0.7" stroke="{color}"'))
    return "\n".join([*parts, "</g>", "</svg>"]) + "\n"


def _robots_of(scene: Any) -> list[tuple[_Points, float, _Points]]:
    if hasattr(scene, "robots"):  # a Scenario
        return [(np.array(r.position), r.radius, np.array(r.goal)) for r in scene.robots]
    return list(zip(scene.position(), scene.radius().tolist(), scene.goal()))


def _obstacles_of(scene: Any) -> list[StaticObstacle]:
    if hasattr(scene, "robots"):
        return list(scene.obstacles)
    return [obstacle for _, obstacle in scene.obstacles()]


def _movers_of(scene: Any) -> list[tuple[_Points, float]]:
    if hasattr(scene, "robots"):
        return [(np.array(m.position), m.radius) for m in scene.moving_obstacles]
    return [(p, m.radius) for p, m in zip(scene.moving_obstacle_position(), scene.moving_obstacles())]


def _bounds(
    robots: list[tuple[_Points, float, _Points]],
    lines: _Points,
    obstacles: list[StaticObstacle],
    movers: list[tuple[_Points, float]],
) -> tuple[_Points, _Points]:
    """m: the lower left and the upper right corner of all that is drawn, with a margin."""
    points = [lines.reshape(-1, 2)]
    for position, radius, goal in robots:
        points.append(np.array([position - radius, position + radius, goal]))
    points += [np.array([position - radius, position + radius]) for position, radius in movers]
    for obstacle in obstacles:
        for chain in obstacle.chains:
            at = np.array(chain.points)
            points += [at - obstacle.radius, at + obstacle.radius]
    every = np.concatenate([*points, np.zeros((0, 2))])
    if len(every) == 0:
        every = np.zeros((1, 2))
    low, high = every.min(axis=0), every.max(axis=0)
    margin = 0.02 * float((high - low).max()) + 0.5
    return low - margin, high + margin


def _at(point: npt.ArrayLike) -> str:
    x, y = np.asarray(point, dtype=float)
    return f"{x:.6g} {y:.6g}"


def _disc(position: _Points, radius: float, style: str) -> str:
    x, y = position
    return f'<circle cx="{x:.6g}" cy="{y:.6g}" r="{radius:.6g}" {style}/>'


def _cross(at: _Points, size: float, color: str) -> str:
    x, y = at
    return (
        f'<path d="M{x - size:.6g} {y - size:.6g}L{x + size:.6g} {y + size:.6g}'
        f'M{x - size:.6g} {y + size:.6g}L{x + size:.6g} {y - size:.6g}" stroke="{color}"/>'
    )


def _line(points: _Points, color: str) -> str:
    return f'<path d="M{"L".join(_at(p) for p in points)}" stroke="{color}"/>' if len(points) > 0 else ""


def _obstacle(obstacle: StaticObstacle, least: float) -> str:
    """Walls as thick as they are, and at least so that they show."""
    style = (
        f'stroke="#333" stroke-width="{max(2.0 * obstacle.radius, least):.6g}" '
        'stroke-linecap="round" stroke-linejoin="round"'
    )
    fill = "#ddd" if obstacle.fill == "solid" else "none"
    lines = []
    for chain in obstacle.chains:
        points = chain.points if len(chain.points) > 1 else chain.points * 2
        lines.append("M" + "L".join(_at(p) for p in points) + ("Z" if chain.closed else ""))
    return f'<path d="{"".join(lines)}" fill="{fill}" fill-rule="evenodd" {style}/>'
