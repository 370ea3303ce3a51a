# SPDX-License-Identifier: Apache-2.0
"""What a notebook shows of a scene."""
import math
import xml.etree.ElementTree as ElementTree

import avo
import avo.svg
import numpy as np
import pytest
from avo._colors import css, direction_color, robot_colors

TAG = "{http://www.w3.org/2000/svg}"


def parts(text, tag):
    return list(ElementTree.fromstring(text).iter(TAG + tag))


@pytest.mark.parametrize("name", ["circle-100", "office", "mixed-yard", "person", "warehouse"])
def test_scenes_and_simulations_are_drawn(name):
    scene = avo.Scenario(name)
    simulation = avo.Simulation(scene)
    for shown in (scene, simulation):
        text = shown._repr_svg_()
        assert parts(text, "title")[0].text == name
        assert len(parts(text, "circle")) == len(scene.robots) + len(scene.moving_obstacles)
        assert len(parts(text, "path")) == len(scene.robots) + len(scene.obstacles)  # goals are crosses


def test_robots_are_drawn_where_they_are():
    simulation = avo.Simulation("circle-3")
    simulation.step(20)
    discs = parts(simulation._repr_svg_(), "circle")
    drawn = [[float(disc.get(key)) for key in ("cx", "cy", "r")] for disc in discs]
    assert np.allclose(drawn, np.column_stack([simulation.position(), simulation.radius()]), atol=1e-4)


def test_all_is_within_the_picture():
    image = ElementTree.fromstring(avo.Scenario("office")._repr_svg_())
    x, y, width, height = map(float, image.get("viewBox").split())
    for disc in image.iter(TAG + "circle"):
        cx, cy, r = (float(disc.get(key)) for key in ("cx", "cy", "r"))
        assert x <= cx - r and cx + r <= x + width
        assert y <= -cy - r and -cy + r <= y + height  # y is up


def test_paths_are_lines():
    simulation = avo.Simulation("circle-3")
    paths = []
    for _ in range(10):
        paths.append(simulation.position())
        simulation.step()
    text = avo.svg.draw(simulation, np.array(paths))
    assert len(parts(text, "path")) == 3 + 3
    assert max(path.get("d").count("L") for path in parts(text, "path")) == 9
    with pytest.raises(ValueError, match=r"paths: found shape \(3,\), must be \(steps, n, 2\)"):
        avo.svg.draw(simulation, [1, 2, 3])


@pytest.mark.parametrize("scene, paths, message", [
    ("circle-3", [[[math.nan, 0.0]]], "paths: found a number that is not finite, must be finite"),
    ("circle-3", [[[math.inf, 0.0]]], "paths: found a number that is not finite, must be finite"),
    ("circle-3", "way", "paths: found an array of <U3, must be real numbers"),
    ("circle-3", [[1.0], [1.0, 2.0]], "paths: found what is no array, must be real numbers"),
    ("circle-3", [[[1j, 0.0]]], "paths: found an array of complex128, must be real numbers"),
    (None, None, "scene: found str, must be a Scenario or a Simulation"),
])
def test_what_cannot_be_drawn_is_refused(scene, paths, message):
    with pytest.raises(ValueError) as error:
        avo.svg.draw(avo.Scenario(scene) if scene else "circle-3", paths)
    assert str(error.value) == message


def test_names_are_escaped():
    scene = avo.Scenario({"version": 1, "name": "<a & b>", "robots": [{"position": [0, 0], "goal": [1, 0]}]})
    assert parts(scene._repr_svg_(), "title")[0].text == "<a & b>"


# The same numbers are in tests/unit/figures/colors_test.cpp and in tests/lab/page/drawing.test.mjs.
def test_directions_have_the_colors_of_figures_and_of_the_lab():
    expected = {0: "#56b4e9", 100: "#c47aa8", 180: "#de7f00", 250: "#c2ad00", -30: "#30a8a5"}
    assert {degrees: css(direction_color(math.radians(degrees))) for degrees in expected} == expected


def test_robots_have_different_colors():
    for count in (1, 6, 7, 30):
        angles = 2 * np.pi * np.arange(count) / count
        assert len(set(robot_colors(np.column_stack([np.cos(angles), np.sin(angles)])))) == count
