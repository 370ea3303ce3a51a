# SPDX-License-Identifier: Apache-2.0
"""What rewards of avo.env are about, and the usual one."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Callable

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]


@dataclass(frozen=True)
class Step:
    """What a reward may be about: all robots of all worlds, before and after a step."""

    distance_before: Floats  #: (E, N), m, to the goals
    distance: Floats  #: (E, N), m, after the step
    velocity: Floats  #: (E, N, 2), m/s, after the step
    actions: Floats  #: (E, N, 2), m/s, as the robots took them
    arrives: Flags  #: (E, N): whether the robot arrives in this step
    has_arrived: Flags  #: (E, N): whether it had arrived before: its reward is 0
    clearance: Floats  #: (E, N), m, to the nearest robot or moving obstacle; infinite where it senses none


Reward = Callable[[Step], npt.ArrayLike]


def progress(step: Step) -> Floats:
    """The reward that environments have without one: progress, m, and 1 on arrival."""
    rewards: Floats = step.distance_before - step.distance
    rewards[step.arrives] += 1.0
    return rewards
