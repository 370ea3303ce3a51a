# SPDX-License-Identifier: Apache-2.0
"""A fleet among walls, and a plot of the paths that its robots took: fleet.svg."""
import pathlib

import numpy as np

import avo

scene = avo.Scenario("office")
simulation = avo.Simulation(scene)
metrics = avo.Metrics(scene)
metrics.observe(simulation)
paths = [simulation.position()]
while not simulation.all_at_goal() and simulation.can_step_by(scene.duration):
    simulation.step()
    metrics.observe(simulation)
    paths.append(simulation.position())

summary = metrics.summary()
print(f"{summary['arrived']} of {summary['robots']} robots arrived, the last after {summary['last_arrival']:.1f} s")
print(f"nearest: {summary['min_clearance']:.3f} m, to walls {summary['min_static_clearance']:.3f} m")
pathlib.Path("fleet.svg").write_text(avo.svg.draw(simulation, np.array(paths)))
