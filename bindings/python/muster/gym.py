"""A crowd as an environment for learning, by the interface of Gymnasium, which need not be there.

Groups are given goals; an action names a target and a heading for each group, relative to where the group is. The reward is by how
much the mean distance of characters to the goals of their groups shrinks [m].
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._core import World
from ._types import GiveOrder, Manner, Order, Vec2
from .scenario import Definition, as_scenario

try:
    from gymnasium import Env as _Base
    from gymnasium.spaces import Box as _Box
except ImportError:
    _Base = object

    @dataclass(frozen=True)
    class _Box:  # type: ignore[no-redef]
        """The part of gymnasium.spaces.Box that is used here."""

        low: Any
        high: Any
        shape: tuple[int, ...]
        dtype: Any = np.float32

        def sample(self) -> NDArray[np.float32]:
            """A random action; unlike Gymnasium's, from a generator of its own."""
            return np.random.default_rng().uniform(self.low, self.high, self.shape).astype(self.dtype)

        def contains(self, x: Any) -> bool:
            """Whether an array has the shape and lies in the bounds."""
            array = np.asarray(x)
            return array.shape == self.shape and bool(np.all(array >= self.low) and np.all(array <= self.high))


class CrowdEnv(_Base):  # type: ignore[misc]
    """Leads each group of a scenario to its goal.

    scenario: In any form that World takes; its groups keep their numbers of characters.
    goals: A point (x, y) for each group [m].
    radius: Characters within it are there [m].
    decision: Time between two actions [s].
    seconds: Time until an episode is cut [s].
    reach: Largest distance of a target from the group along each axis [m].

    An action has shape (groups, 3), float32: target relative to the group's middle, -1 to 1 in units of `reach`, and heading,
    -1 to 1 in units of pi. An observation has shape (characters, 6), float32: position relative to the goal of the
    character's group [m], velocity [m/s], and heading (unit vector), in ascending order of ids.
    """

    metadata: dict[str, Any] = {"render_modes": []}

    def __init__(
        self,
        scenario: Definition,
        goals: list[Vec2],
        *,
        radius: float = 6.0,
        decision: float = 1.0,
        seconds: float = 60.0,
        reach: float = 10.0,
        threads: int = 1,
    ) -> None:
        self._scenario = as_scenario(scenario)
        groups = self._scenario.definition.groups
        if len(goals) != len(groups):
            raise ValueError(f"goals: found {len(goals)}, expected {len(groups)}, one for each group")
        self._goals = np.asarray(goals, dtype=np.float64)
        self._radius, self._decision, self._seconds, self._reach = radius, decision, seconds, reach
        self._threads = threads
        self._world: World | None = None
        count = sum(group.count for group in groups)
        self.action_space = _Box(low=-1.0, high=1.0, shape=(len(groups), 3), dtype=np.float32)
        self.observation_space = _Box(low=-math.inf, high=math.inf, shape=(count, 6), dtype=np.float32)

    @property
    def world(self) -> World:
        """The world of the episode. Fails before the first reset()."""
        if self._world is None:
            raise RuntimeError("world: found no episode, expected reset() before")
        return self._world

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[np.float32], dict[str, Any]]:
        """Begins an episode; the same seed and actions give the same episode, bit for bit. None for the scenario's seed."""
        if _Base is not object:
            super().reset(seed=seed)
        self._world = World(self._scenario.changed(seed=seed).definition, self._threads)
        for command in self._scenario.commands:
            self._world.submit(command)
        return self._observation(), self._info()

    def step(self, action: Any) -> tuple[NDArray[np.float32], float, bool, bool, dict[str, Any]]:
        """Gives each group its order, lets `decision` seconds pass, and gives observation, reward, whether all are there, whether
        the time is up, and `info`: time [s], mean_distance [m], arrived (share)."""
        world = self.world
        wanted = np.clip(np.asarray(action, dtype=np.float64).reshape(self.action_space.shape), -1.0, 1.0)
        before = self._distances().mean()
        for group, (x, y, turn) in zip(world.groups, wanted):
            middle = world.characters.position[group.members].mean(axis=0)
            target = (float(middle[0] + self._reach * x), float(middle[1] + self._reach * y))
            order = Order.move(target, float(math.pi * turn))
            order.manner = Manner.MARCH
            world.submit(GiveOrder(group=group.id, order=order))
        world.step(max(1, round(self._decision / world.parameters["time.step"])))
        info = self._info()
        reward = float(before - info["mean_distance"])
        return self._observation(), reward, info["arrived"] == 1.0, world.time >= self._seconds, info

    def _offsets(self) -> NDArray[np.float64]:
        """Of characters from the goals of their groups [m]."""
        characters = self.world.characters
        offsets: NDArray[np.float64] = characters.position - self._goals[characters.group]
        return offsets

    def _distances(self) -> NDArray[np.float64]:
        offsets = self._offsets()
        distances: NDArray[np.float64] = np.hypot(offsets[:, 0], offsets[:, 1])
        return distances

    def _observation(self) -> NDArray[np.float32]:
        characters = self.world.characters
        return np.hstack([self._offsets(), characters.velocity, characters.heading]).astype(np.float32)

    def _info(self) -> dict[str, Any]:
        distances = self._distances()
        return {
            "time": self.world.time,
            "mean_distance": float(distances.mean()),
            "arrived": float((distances <= self._radius).mean()),
        }
