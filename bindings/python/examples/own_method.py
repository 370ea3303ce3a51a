# SPDX-License-Identifier: Apache-2.0
"""A potential field of one's own beside the methods of avo, alone and behind the certificate."""
import numpy as np
import numpy.typing as npt

import avo

STRENGTH, RANGE = 1.0, 0.5  # m/s, m


def field(batch: avo.MethodBatch) -> npt.NDArray[np.float64]:
    """The preferred velocities, and a push away from each neighbor that falls with the gap."""
    robot = batch.neighbor_robot
    away = batch.position[robot] - batch.neighbor_position
    distance = np.maximum(np.linalg.norm(away, axis=1), 1e-9)
    gap = distance - batch.radius[robot] - batch.neighbor_radius
    velocity = batch.preferred_velocity.copy()
    np.add.at(velocity, robot, away * (STRENGTH * np.exp(-gap / RANGE) / distance)[:, None])
    speed = np.maximum(np.linalg.norm(velocity, axis=1), 1e-9)
    velocity *= np.minimum(1.0, batch.max_speed / speed)[:, None]
    return velocity


runs = avo.sweep(
    {"version": 1, "scenes": ["uniform-20"], "methods": ["avo", "orca_clamped", "field", "field behind"],
     "until_arrived": True},
    own={"field": avo.OwnMethod(field), "field behind": avo.OwnMethod(field, certified=True)},
    out="runs.csv")  # for `avo compare runs.csv` and `avo report runs.csv page.html`
for run in runs:
    print(f"{run['method']:<14} {run['arrived']:>4.0f} arrived, {run['collision_pairs']:>3.0f} pairs touch, "
          f"last arrival {run['last_arrival'] or float('nan'):.1f} s")
