"""Functions that the processes of test_batch.py import."""

from __future__ import annotations

import os

import numpy as np

import muster


def walked(seed: int) -> tuple[int, float]:
    """Plays a scene with starts by the seed, and gives its hash and the mean distance walked [m]."""
    definition = muster.WorldDef(seed=seed, groups=[muster.GroupDef(count=9, jitter=0.3)])
    world = muster.World(definition)
    start = world.characters.position.copy()
    world.submit(muster.GiveOrder(1, order=muster.Order.go((8.0, 0.0))))
    world.step(120)
    return world.hash(), float(np.hypot(*(world.characters.position - start).T).mean())


def picky(value: int) -> int:
    if value == 3:
        raise muster.NotFoundError("value: found 3, expected another one")
    return value


def dies(value: int) -> int:
    if value == 1:
        os._exit(7)
    return value
