# SPDX-License-Identifier: Apache-2.0
"""Thirty drones cross a sphere under a ceiling: how near they come, and where they are, as arrays."""
import numpy as np

import avo.space

scene = avo.space.Scenario({
    "version": 1,
    "space": 3,
    "name": "crossing",
    "groups": [{"count": 30, "sphere": {"radius": 8}, "goal": "antipodal", "jitter": 0.2, "downwash": 0.5}],
    "obstacles": [{"ceiling": 9}],
})
simulation = avo.space.Simulation(scene)
heights = []
nearest = np.inf
while not simulation.all_at_goal() and simulation.time < scene.duration:
    simulation.step()
    position = simulation.position()
    apart = np.linalg.norm(position[:, None] - position, axis=2)
    nearest = min(nearest, float(apart[apart > 0.0].min()))
    heights.append(position[:, 2].max())

print(f"{int(simulation.at_goal().sum())} of {len(simulation)} drones arrived after {simulation.time:.1f} s")
print(f"nearest: {nearest:.2f} m between centers of balls of 0.5 m; the highest at {max(heights):.2f} m")
