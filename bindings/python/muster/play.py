"""Runs of scenarios to their end, as `muster play` does."""

from __future__ import annotations

import math
from typing import Callable, Mapping

from ._core import RunMetrics, TakeWriter, World
from ._types import RunFigures
from .scenario import Definition, PathLike, as_scenario


def play(
    scenario: Definition,
    *,
    seconds: float | None = None,
    longest: float = 120.0,
    seed: int | None = None,
    parameters: Mapping[str, float] | None = None,
    threads: int = 1,
    take: PathLike | None = None,
    observe: Callable[[World], object] | None = None,
    path_ratio: bool = False,
) -> RunFigures:
    """Plays a scenario with the commands that it carries, and gives the figures of the run.

    scenario: A Scenario, the path of a scenario file (its gestures are played too), a WorldDef, or a dict.
    seconds: Simulated time [s]; None until all have arrived and stand or have left, at most `longest` [s] after the last command.
    seed, parameters: Other than the scenario's.
    threads: As for World.
    take: Records a take into this file.
    observe: Called with the world before the first step and after every step; the run ends early where it returns False.
    path_ratio: Whether the figure of that name is computed, which takes a cost field per character.

    The hash in the figures is that of `muster play --demo`.
    """
    run = as_scenario(scenario).changed(seed=seed, parameters=parameters)
    world = World(run.definition, threads)
    writer = TakeWriter(take, run.definition) if take is not None else None
    for command in run.commands:
        world.submit(command)
        if writer:
            writer.command(command)
    last = max((command.step for command in run.commands), default=0)
    metrics = RunMetrics(world)
    going = observe is None or observe(world) is not False
    while going and not _ended(world, metrics, last, seconds, longest):
        world.step()
        metrics.observe()
        if writer:
            writer.observe(world)
        going = observe is None or observe(world) is not False
    if writer:
        writer.finish(world)
    return metrics.figures(path_ratio)


def _ended(world: World, metrics: RunMetrics, last: int, seconds: float | None, longest: float) -> bool:
    """Whether a run with the last command in that step is over."""
    step_time = world.parameters["time.step"] if world.step_count == 0 else world.time / world.step_count
    wanted = last * step_time + longest if seconds is None else seconds
    if world.step_count >= math.floor(wanted / step_time + 0.5):
        return True
    second = math.ceil(1.0 / step_time)
    due = seconds is None and world.step_count > last + 2 * second and world.step_count % (second // 2) == 0
    return due and metrics.settled()
