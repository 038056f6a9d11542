"""Batches: many runs over processes."""

from __future__ import annotations

import functools
import multiprocessing
import os
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from typing import Any, Callable, Iterable, TypeVar, overload

from ._types import RunFigures
from .errors import UnsupportedError
from .play import play
from .scenario import Definition, as_scenario

Input = TypeVar("Input")
Output = TypeVar("Output")


@overload
def run_batch(
    what: Callable[[Input], Output], inputs: Iterable[Input], *, processes: int | None = None
) -> list[Output]: ...
@overload
def run_batch(
    what: Definition, inputs: Iterable[int], *, processes: int | None = None, **options: Any
) -> list[RunFigures]: ...
def run_batch(what: Any, inputs: Iterable[Any], *, processes: int | None = None, **options: Any) -> list[Any]:
    """Calls a function with each input, or plays a scenario with each seed, over several processes.

    what: A function of one input that other processes can import (not a lambda, and not one of a notebook); or a scenario, in
        any form that World takes.
    inputs: The inputs; for a scenario its seeds.
    processes: So many; None for one per core; 1 for this process itself.
    options: For a scenario: those of play(), as seconds=30.0 or parameters={"plan.solver": 0}.

    Gives the results in the order of the inputs: for scenarios RunFigures. They are the same for every number of processes, but
    for step times. The first failure is raised, with a note that says which input it belongs to. Programs call it below
    `if __name__ == "__main__":`, since new processes import the program.
    """
    given = list(inputs)
    if callable(what):
        if options:
            raise TypeError(f"run_batch: found {', '.join(options)}, expected options for scenarios only")
        work = what
    else:
        work = functools.partial(_play_seed, as_scenario(what), options)
    if processes is None:
        processes = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if processes < 1:
        raise ValueError(f"processes: found {processes}, expected 1 or more")
    if processes == 1:
        return [_noted(work, i, value) for i, value in enumerate(given)]
    return _over_processes(work, given, min(processes, max(1, len(given))))


def _over_processes(work: Callable[[Any], Any], given: list[Any], processes: int) -> list[Any]:
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(processes, mp_context=context) as pool:
        try:
            futures = [pool.submit(_noted, work, i, value) for i, value in enumerate(given)]
            return [future.result() for future in futures]
        except BrokenProcessPool:
            raise UnsupportedError(
                "run_batch: found a process that ended before its result, expected a function that other processes can import "
                'and a call below `if __name__ == "__main__":`'
            ) from None
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def _noted(work: Callable[[Any], Any], index: int, value: Any) -> Any:
    """Calls the function; a failure says which input it belongs to."""
    try:
        return work(value)
    except Exception as error:
        error.add_note(f"input {index} of the batch: {value!r:.200}")
        raise


def _play_seed(scenario: Any, options: dict[str, Any], seed: int) -> RunFigures:
    return play(scenario, seed=seed, **options)
