# SPDX-License-Identifier: Apache-2.0
"""A robot crosses a crowd whose tracks were recorded: people who do not react to it."""
import random

import avo

random.seed(4)
people = []
for _ in range(12):  # stands for tracks of a data set, t, x, y
    y, speed, start = random.uniform(-6, 6), random.uniform(0.8, 1.4), random.uniform(0, 8)
    people.append({"radius": 0.3, "max_deviation": 0.5, "max_speed": 2.0,
                   "trajectory": [[start + 0.5 * k, -8 + 0.5 * k * speed, y + 0.1 * (k % 3)] for k in range(40)]})
scene = avo.Scenario({"version": 1, "duration": 60, "moving_obstacles": people, "robots": [
    {"position": [0, -10], "goal": [0, 10], "radius": 0.3, "max_speed": 1.5, "max_acceleration": 1.5}]})
summary = avo.run(scene)
print(f"{summary['arrived']} arrived after {summary['last_arrival']:.1f} s, "
      f"touched in motion: {summary['mover_collisions_in_motion']}")
assert summary["arrived"] == 1 and summary["mover_collisions_in_motion"] == 0
