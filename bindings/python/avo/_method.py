# SPDX-License-Identifier: Apache-2.0
"""What the function of an external method is given (docs/own_method.md)."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

_Floats = npt.NDArray[np.float64]
_Indices = npt.NDArray[np.int64]


@dataclass(frozen=True)
class MethodBatch:
    """The n robots of the method by ascending id, the m neighbors that they sense and the w walls near
    them. Robot i senses neighbors first_neighbor[i] up to before first_neighbor[i + 1], nearest first. So
    it is for walls, which come in no order. Arrays are copies."""

    time: float  #: s, now
    time_step: float  #: s, until the robots decide again
    id: _Indices  #: (n,)
    position: _Floats  #: (n, 2), m, of the centers of their discs
    velocity: _Floats  #: (n, 2), m/s
    preferred_velocity: _Floats  #: (n, 2), m/s: to the goal, around walls with navigation
    goal: _Floats  #: (n, 2), m
    radius: _Floats  #: (n,), m
    max_speed: _Floats  #: (n,), m/s
    max_acceleration: _Floats  #: (n,), m/s^2
    max_braking: _Floats  #: (n,), m/s^2
    heading: _Floats  #: (n,), rad, of robots that are not holonomic
    first_neighbor: _Indices  #: (n + 1,)
    first_wall: _Indices  #: (n + 1,)
    neighbor_position: _Floats  #: (m, 2), m
    neighbor_velocity: _Floats  #: (m, 2), m/s
    neighbor_radius: _Floats  #: (m,), m
    neighbor_max_acceleration: _Floats  #: (m,), m/s^2; 0: the neighbor moves on
    wall_a: _Floats  #: (w, 2), m, one end
    wall_b: _Floats  #: (w, 2), m, the other end
    wall_radius: _Floats  #: (w,), m

    def __len__(self) -> int:
        return len(self.id)

    @property
    def neighbor_robot(self) -> _Indices:
        """(m,): the row of the robot that senses each neighbor, for np.add.at()."""
        return np.repeat(np.arange(len(self)), np.diff(self.first_neighbor))

    @property
    def wall_robot(self) -> _Indices:
        """(w,): the row of the robot that each wall is near."""
        return np.repeat(np.arange(len(self)), np.diff(self.first_wall))
