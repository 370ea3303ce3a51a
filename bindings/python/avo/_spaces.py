# SPDX-License-Identifier: Apache-2.0
"""Spaces by duck typing, and the numbers that environments are made with."""
from __future__ import annotations

import importlib
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from ._avo import Error


def whole(name: str, given: Any, least: int, most: int) -> int:
    if isinstance(given, (int, np.integer)) and not isinstance(given, bool) and least <= given <= most:
        return int(given)
    raise Error(f"{name}: found {given!r}, must be a whole number from {least} to {most}")


def generator(seed: int | None) -> np.random.Generator:
    if seed is not None and not (isinstance(seed, (int, np.integer)) and seed >= 0):
        raise Error(f"seed: found {seed!r}, must be a whole number >= 0")
    return np.random.default_rng(seed)


def box(low: float, high: float, shape: tuple[int, ...]) -> Any:
    """Gymnasium's own space where it is installed, as wrappers and checks ask for it; else a Box."""
    try:
        spaces = importlib.import_module("gymnasium.spaces")
    except ImportError:
        return Box(low, high, shape)
    return spaces.Box(low, high, shape, np.float32)


def autoreset_mode(given: Any) -> tuple[str, Any]:
    """The name of Gymnasium's mode, and its own member of that name where it is installed; else the name."""
    names = ("NextStep", "SameStep", "Disabled")
    name = getattr(given, "value", given)
    if name not in names:
        raise Error(f"autoreset_mode: found {given!r}, must be one of {', '.join(names)}")
    try:
        modes = importlib.import_module("gymnasium.vector").AutoresetMode
    except (ImportError, AttributeError):
        return name, name
    return name, modes(name)


@dataclass
class Box:
    """A space by duck typing: arrays of a shape, between two bounds."""

    low: float
    high: float
    shape: tuple[int, ...]
    dtype: Any = np.float32

    def __post_init__(self) -> None:
        self.seed(None)

    def seed(self, seed: int | None = None) -> None:
        self._random = generator(seed)

    def sample(self) -> npt.NDArray[Any]:
        """Uniform; of an axis without bounds normal."""
        bounded = np.isfinite(self.low) and np.isfinite(self.high)
        random = self._random
        drawn = random.uniform(self.low, self.high, self.shape) if bounded else random.normal(size=self.shape)
        return drawn.astype(self.dtype)

    def contains(self, value: Any) -> bool:
        array = np.asarray(value)
        return array.shape == self.shape and bool(np.all((self.low <= array) & (array <= self.high)))
