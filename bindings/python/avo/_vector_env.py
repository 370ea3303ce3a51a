# SPDX-License-Identifier: Apache-2.0
"""Many worlds at once, for learning: see avo.env."""
from __future__ import annotations

from typing import Any, Mapping, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import space
from ._avo import Error, Scenario, Worlds, _numbers
from ._raster import draw
from ._rewards import Flags, Floats, Reward, Step, progress
from ._spaces import autoreset_mode as mode_called
from ._spaces import box, generator, whole

Observations = npt.NDArray[np.float32]
Source = Any  # what Scenario() takes
Seeds = Union[int, Sequence[Union[int, None]], None]
_HEADING = 2  # numbers
_HUGE = 1e100  # m/s
_MOST_NEIGHBORS = 1000  # as Worlds.nearest()


class VectorEnv:
    """E worlds of N robots each, all of one scene with seeds of their own.

    A world is over when all its robots are terminated or truncated. What then happens says
    autoreset_mode, by the names of gymnasium. "NextStep": it begins anew in the step after that, in which
    actions do not count, and rewards are 0. "SameStep": it begins anew at once, and the info has
    "final_obs", of the worlds of the mask "_final_obs". "Disabled": it goes on until reset().
    """

    metadata: dict[str, Any] = {"autoreset_mode": "NextStep", "render_modes": ["rgb_array"], "render_fps": 10}
    spec = None  # it is in no registry

    def __init__(
        self,
        scene: Source,
        num_envs: int = 1,
        *,
        neighbors: int = 8,
        walls: int = 0,
        max_steps: int | None = None,
        reward: Reward | None = None,
        render_mode: str | None = None,
        autoreset_mode: Any = "NextStep",
    ) -> None:
        """scene: what Scenario() takes but a Scenario itself, as worlds differ by its seed. Scenes that place robots at
        random (as uniform-N) begin differently, others alike. neighbors: k, walls: w, 0 to 1000. max_steps: >= 1, None:
        those of the scene's duration. reward: of a Step, (E, N); None: progress and arrival. render_mode: "rgb_array",
        or None. autoreset_mode: "NextStep", "SameStep", "Disabled", or gymnasium's own member."""
        if isinstance(scene, (Scenario, space.Scenario)):
            raise Error("scene: found a Scenario, must be what one is made from: worlds differ by their seeds")
        self.dimensions = 3 if space._is_in_space(scene) else 2
        first = self._made(scene)
        usual = max(1, round(first.duration / first.time_step))
        num_envs = whole("num_envs", num_envs, 1, 1_000_000)
        neighbors = whole("neighbors", neighbors, 0, _MOST_NEIGHBORS)
        walls = whole("walls", walls, 0, _MOST_NEIGHBORS)
        if render_mode not in (None, "rgb_array"):
            raise Error(f"render_mode: found {render_mode!r}, must be 'rgb_array' or None")
        if render_mode is not None and self.dimensions == 3:
            raise Error(f"render_mode: found {render_mode!r} with a scene of space, must be None")
        self.render_mode, self._reward = render_mode, reward or progress
        self._autoreset, mode = mode_called(autoreset_mode)
        self.metadata = {**type(self).metadata, "autoreset_mode": mode}
        self.max_steps = usual if max_steps is None else whole("max_steps", max_steps, 1, 2**53)
        self._scene, self._neighbors, self._walls = scene, neighbors, walls
        in_space = self.dimensions == 3
        self._worlds: Worlds | space.Worlds = space.Worlds(num_envs, first) if in_space else Worlds(num_envs, first)
        self.num_envs, self.num_robots = num_envs, len(first.robots)
        self.time_step, self.arrival_distance = first.time_step, first.arrival_distance
        self._randoms = [generator(None)] * num_envs
        self._placed = [first] * num_envs
        self._steps = np.zeros(num_envs, dtype=np.int64)
        self._arrived = np.zeros((num_envs, self.num_robots), dtype=bool)
        self._begins_anew = np.zeros(num_envs, dtype=bool)
        fastest = max(robot.max_speed for robot in first.robots)
        robots = self.num_robots
        self._per_other, self._per_wall = 2 * self.dimensions + 2, self.dimensions + 1  # numbers
        self._has_wheels = isinstance(self._worlds, Worlds) and self._worlds.has_wheels
        own = self._per_other + (_HEADING if self._has_wheels else 0)
        self._observed = own + self._per_other * neighbors + self._per_wall * walls
        self._fastest = fastest
        self.single_observation_space = box(-np.inf, np.inf, (robots, self._observed))
        self.observation_space = box(-np.inf, np.inf, (num_envs, robots, self._observed))
        self.single_action_space = box(-fastest, fastest, (robots, self.dimensions))
        self.action_space = box(-fastest, fastest, (num_envs, robots, self.dimensions))

    def reset(
        self, *, seed: Seeds = None, options: Mapping[str, Any] | None = None
    ) -> tuple[Observations, dict[str, Any]]:
        """Begins all worlds anew. Returns observations (E, N, 6 + 6 k + 3 w) and {}. With the same seed and the
        same actions all that follows is the same, bit by bit; None: goes on with the last seed. A list has
        one seed, or None, for each world, which then begins as no other world's seed would have it.
        options: {"reset_mask": (E,) of bool}: only these worlds begin anew."""
        self._seed(seed)
        for world in np.flatnonzero(self._reset_mask(options)):
            self._begin(int(world))
        return self._observe(), {}

    def step(self, actions: npt.ArrayLike) -> tuple[Observations, Floats, Flags, Flags, dict[str, Any]]:
        """actions: (E, N, 2), m/s. Returns observations (E, N, 6 + 6 k + 3 w) and (E, N) each of
        rewards, terminated and truncated, and the info, {} but with "SameStep"."""
        anew = self._begins_anew.copy()
        before, taken = self._distances(), self._preferred(actions)
        moving = [not begins for begins in anew]
        if isinstance(self._worlds, Worlds):
            self._worlds.step(taken, moving, self._arrived)
        else:
            self._worlds.step(taken, moving)
        after = self._distances()
        came = (after <= self.arrival_distance) & ~self._arrived
        had_arrived = self._arrived.copy()
        step = Step(before, after, self.velocity(), taken, came.copy(), had_arrived.copy(), self._clearance())
        self._arrived |= came
        self._steps += 1
        for world in np.flatnonzero(anew):
            self._begin(int(world))
        terminated = self._arrived.copy()
        truncated: Flags = ~terminated & (self._steps >= self.max_steps)[:, None]
        over = np.all(terminated | truncated, axis=1)
        info = self._begin_over(over)
        # last, so that the step is counted also where the reward raises
        rewards = np.where(had_arrived | anew[:, None], 0.0, self._rewards(step))
        return self._observe(), rewards, terminated, truncated, info

    def close(self) -> None:
        """Nothing is left open."""

    def render(self) -> tuple[npt.NDArray[np.uint8], ...] | None:
        """An image (height, width, 3) of each world; None without a render mode."""
        if self.render_mode is None:
            return None
        return tuple(self._image(world) for world in range(self.num_envs))

    @property
    def unwrapped(self) -> VectorEnv:
        return self

    def position(self) -> Floats:
        """(E, N, 2), m."""
        return self._worlds.position()

    def heading(self) -> Floats:
        """(E, N), rad; 0 of robots without wheels."""
        if isinstance(self._worlds, Worlds):
            return self._worlds.heading()
        return np.zeros((self.num_envs, self.num_robots))

    def velocity(self) -> Floats:
        """(E, N, 2), m/s."""
        return self._worlds.velocity()

    def goal(self) -> Floats:
        """(E, N, 2), m."""
        return self._worlds.goal()

    def radius(self) -> Floats:
        """(E, N), m."""
        return self._worlds.radius()

    def _made(self, scene: Source, overrides: Any = None) -> Any:
        return (space.Scenario if self.dimensions == 3 else Scenario)(scene, overrides=overrides)

    def _image(self, world: int) -> npt.NDArray[np.uint8]:
        assert isinstance(self._worlds, Worlds)  # render_mode is None in space
        return draw(self._placed[world], self._worlds.center()[world], self._worlds.movers(world))

    def _rewards(self, step: Step) -> Floats:
        rewards = _numbers("reward", self._reward(step))
        if rewards.shape != (self.num_envs, self.num_robots):
            raise Error(f"reward: found shape {rewards.shape}, must be {(self.num_envs, self.num_robots)}")
        if not np.isfinite(rewards).all():
            raise Error("reward: found numbers that are not finite, must be finite")
        return rewards

    def _clearance(self) -> Floats:
        near = self._worlds.nearest(1)[:, :, 0].astype(np.float64)
        away = np.linalg.norm(near[:, :, : self.dimensions], axis=2) - near[:, :, -2]
        clearance: Floats = np.where(near[:, :, -1] != 0.0, away, np.inf)
        return clearance

    def _seed(self, seed: Seeds) -> None:
        if seed is None:
            return
        if isinstance(seed, str) or not isinstance(seed, (Sequence, np.ndarray)):
            self._randoms = [generator(seed)] * self.num_envs
            return
        if len(seed) != self.num_envs:
            raise Error(f"seed: found {len(seed)} of them, must be {self.num_envs}, one for each world")
        drawn = [generator(one) for one in seed]
        self._randoms = [last if one is None else new for one, new, last in zip(seed, drawn, self._randoms)]

    def _reset_mask(self, options: Mapping[str, Any] | None) -> Flags:
        if options is None or "reset_mask" not in options:
            return np.ones(self.num_envs, dtype=bool)
        mask = np.asarray(options["reset_mask"])
        if mask.shape != (self.num_envs,) or mask.dtype != np.bool_:
            raise Error(f"reset_mask: found {mask.dtype} {mask.shape}, must be bool {(self.num_envs,)}")
        return mask

    def _begin_over(self, over: Flags) -> dict[str, Any]:
        """Does with the worlds that are over as autoreset_mode says; returns the info."""
        if self._autoreset == "NextStep":
            self._begins_anew = over
        if self._autoreset != "SameStep" or not over.any():
            return {}
        final = self._observe()
        final[~over] = 0.0
        for world in np.flatnonzero(over):
            self._begin(int(world))
        return {"final_obs": final, "_final_obs": over}

    def _begin(self, world: int) -> None:
        seed = int(self._randoms[world].integers(2**31))
        self._placed[world] = self._made(self._scene, {"seed": seed})
        self._worlds.place(world, self._placed[world])
        self._steps[world] = 0
        self._arrived[world] = False
        self._begins_anew[world] = False

    def _distances(self) -> Floats:
        away: Floats = np.linalg.norm(self._worlds.goal() - self._worlds.position(), axis=2)
        return away

    def _preferred(self, actions: npt.ArrayLike) -> Floats:
        """Actions within max_speed; robots that have arrived come to rest at their goals."""
        wanted = _numbers("actions", actions)
        shape = (self.num_envs, self.num_robots, self.dimensions)
        if wanted.shape != shape:
            raise Error(f"actions: found shape {wanted.shape}, must be {shape}")
        preferred = np.where(self._arrived[:, :, None], self._home(), wanted)
        if not np.all(np.isfinite(preferred)):
            raise Error("actions: found a number that is not finite, must be finite")
        # of huge ones not even the square is finite
        preferred /= np.maximum(np.abs(preferred).max(axis=2) / _HUGE, 1.0)[:, :, None]
        speed = np.linalg.norm(preferred, axis=2)
        fastest = self._worlds.max_speed()
        shorter = np.where(speed > fastest, fastest / np.where(speed > 0.0, speed, 1.0), 1.0)
        return np.asarray(preferred * shorter[:, :, None], dtype=np.float64)

    def _home(self) -> Floats:
        """Straight to the goals, with half of the acceleration left when braking before them, m/s."""
        to_goal = self._worlds.goal() - self._worlds.position()
        distance = np.linalg.norm(to_goal, axis=2)
        speed = np.minimum(np.sqrt(self._worlds.max_acceleration() * distance), distance / self.time_step)
        home: Floats = to_goal * (speed / np.where(distance > 0.0, distance, 1.0))[:, :, None]
        return home

    def _observe(self) -> Observations:
        worlds = self._worlds
        own = [
            worlds.goal() - worlds.position(),
            worlds.velocity(),
            worlds.radius()[:, :, None],
            worlds.max_speed()[:, :, None],
        ]
        if self._has_wheels:
            assert isinstance(worlds, Worlds)
            heading = worlds.heading()
            own.append(np.stack([np.cos(heading), np.sin(heading)], axis=2))
        shape = (self.num_envs, self.num_robots, self._per_other * self._neighbors)
        nearest = worlds.nearest(self._neighbors).reshape(shape)
        walls = worlds.nearest_walls(self._walls).reshape((*shape[:2], self._per_wall * self._walls))
        return np.concatenate([np.concatenate(own, axis=2).astype(np.float32), nearest, walls], axis=2)
