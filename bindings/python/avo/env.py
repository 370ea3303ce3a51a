# SPDX-License-Identifier: Apache-2.0
"""Worlds for learning: the learner says where robots would like to go, the library keeps them apart.

VectorEnv has the interface of gymnasium's vector environments, with one more dimension for the robots. ParallelEnv has
that of PettingZoo's parallel environments. Neither package is needed.

Action of a robot: its preferred velocity (x, y), m/s; a longer one than max_speed is shortened to it.
The planner of the scene decides from it, without the memory of detours (avo.Detour). Cars and drives steer
to it, as far as they can turn: one action space is for all models. With them a Simulation moves the world.

Observation of a robot A: 6 + 6 k + 3 w numbers, float32.
- The vector to its goal (2, m), its velocity (2, m/s), its radius (m) and max_speed (m/s).
- In a scene with cars or drives its heading as a unit vector, 2 numbers more.
- Six numbers of each of the k nearest robots and moving obstacles B within the scene's sensing_radius, nearest
  first: the vector from A to B (2, m), B's velocity less A's (2, m/s), the sum of both radii (m), and 1, or -1 of
  a moving obstacle. Where there are fewer, six zeros.
- Three numbers of each of the w nearest walls: the vector to its nearest point (2, m), and 1. Where there are
  fewer, three zeros.

Reward of a robot: by how much nearer its goal has come in the step, m, and 1 more when it arrives, within the
scene's arrival_distance. It may also be what a function of a Step returns. Once it has arrived, the robot is
terminated: it gets no reward, and its actions do not count. It then goes to its goal by itself, and the others avoid
it. All robots of a world that have not arrived are truncated after max_steps.

Scenes of space (space: 3) have three numbers in place of two in each vector, and boxes in place of
walls: actions (x, y, z), observations of 8 + 8 k + 4 w numbers.
"""
from __future__ import annotations

from typing import Any, Callable, Mapping

import numpy as np
import numpy.typing as npt

from ._avo import Error, _numbers
from ._rewards import Flags, Floats, Reward, Step, progress
from ._spaces import box
from ._vector_env import Observations, Seeds, Source, VectorEnv

__all__ = [
    "Flags", "Floats", "Observations", "ParallelEnv", "Reward", "Seeds", "Source", "Step", "VectorEnv", "progress"]


class ParallelEnv:
    """One world of N robots: agents "robot_0" to "robot_N-1". Those that are terminated or truncated
    are agents no longer; reset() begins anew."""

    metadata: dict[str, Any] = {
        "name": "avo_v0", "is_parallelizable": True, "render_modes": ["rgb_array"], "render_fps": 10}
    spec = None  # it is in no registry

    def __init__(
        self,
        scene: Source,
        *,
        neighbors: int = 8,
        walls: int = 0,
        max_steps: int | None = None,
        reward: Reward | None = None,
        render_mode: str | None = None,
    ) -> None:
        """As VectorEnv; reward: (1, N)."""
        self._env = VectorEnv(
            scene, 1, neighbors=neighbors, walls=walls, max_steps=max_steps, reward=reward, render_mode=render_mode)
        self.render_mode = render_mode
        self.possible_agents = [f"robot_{k}" for k in range(self._env.num_robots)]
        self.agents: list[str] = []
        self._actions = np.zeros(self._env.action_space.shape)
        observed, fastest = self._env._observed, self._env._fastest
        self.observation_spaces = {a: box(-np.inf, np.inf, (observed,)) for a in self.possible_agents}
        self.action_spaces = {a: box(-fastest, fastest, (self._env.dimensions,)) for a in self.possible_agents}

    @property
    def num_agents(self) -> int:
        return len(self.agents)

    @property
    def max_num_agents(self) -> int:
        return len(self.possible_agents)

    def observation_space(self, agent: str) -> Any:
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> Any:
        return self.action_spaces[agent]

    def reset(
        self, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[dict[str, Observations], dict[str, dict[str, Any]]]:
        """Observations (6 + 6 k + 3 w,) and infos {} by agent."""
        observations, _ = self._env.reset(seed=seed)
        self.agents = list(self.possible_agents)
        return self._of_agents(lambda k: observations[0, k]), self._of_agents(lambda k: {})

    def step(
        self, actions: Mapping[str, npt.ArrayLike]
    ) -> tuple[dict[str, Observations], dict[str, float], dict[str, bool], dict[str, bool], dict[str, dict[str, Any]]]:
        """actions: (2,), m/s, by agent. Returns observations (6 + 6 k + 3 w,), rewards, terminations,
        truncations and infos {} by agent."""
        if not self.agents:
            raise Error("step: found no agents, must be after reset()")
        for agent in self.agents:
            if agent not in actions:
                raise Error(f"actions: found none of {agent}, must have one of each agent")
            action = _numbers(f"actions of {agent}", actions[agent])
            if action.shape != (self._env.dimensions,):
                raise Error(f"actions of {agent}: found shape {action.shape}, must be ({self._env.dimensions},)")
            self._actions[0, self._number(agent)] = action
        observations, rewards, terminated, truncated, _ = self._env.step(self._actions)
        result = (
            self._of_agents(lambda k: observations[0, k]),
            self._of_agents(lambda k: float(rewards[0, k])),
            self._of_agents(lambda k: bool(terminated[0, k])),
            self._of_agents(lambda k: bool(truncated[0, k])),
            self._of_agents(lambda k: dict[str, Any]()),
        )
        over = terminated | truncated
        self.agents = [agent for agent in self.agents if not over[0, self._number(agent)]]
        return result

    def close(self) -> None:
        """Nothing is left open."""

    def render(self) -> npt.NDArray[np.uint8] | None:
        """An image (height, width, 3); None without a render mode."""
        return None if self.render_mode is None else self._env._image(0)

    @property
    def unwrapped(self) -> ParallelEnv:
        return self

    def _number(self, agent: str) -> int:
        return self.possible_agents.index(agent)

    def _of_agents(self, value: Callable[[int], Any]) -> dict[str, Any]:
        return {agent: value(self._number(agent)) for agent in self.agents}
