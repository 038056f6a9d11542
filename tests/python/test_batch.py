"""Batches over processes."""

from __future__ import annotations

import pytest
from batch_functions import dies, picky, walked

import muster


def without_times(figures: muster.RunFigures) -> muster.RunFigures:
    figures.step_p50 = figures.step_p95 = figures.step_max = 0.0
    figures.stage_mean = {}
    return figures


def test_results_are_the_same_for_every_number_of_processes() -> None:
    seeds = [5, 1, 9, 1]
    alone = [walked(seed) for seed in seeds]
    assert alone[1] == alone[3] and len({hash for hash, _ in alone}) == 3
    for processes in (1, 2, 3):
        assert muster.run_batch(walked, seeds, processes=processes) == alone


def test_scenarios_are_played_by_seed(scenarios) -> None:
    options = {"seconds": 2.0, "parameters": {"plan.solver": 0}}
    definition = muster.load_scenario(scenarios / "open.json")
    definition.groups[0].jitter = 0.2
    one = muster.run_batch(definition, [3, 4], processes=1, **options)
    two = muster.run_batch(definition, [3, 4], processes=2, **options)
    assert [without_times(figures) for figures in one] == [without_times(figures) for figures in two]
    assert one[0].hash != one[1].hash and one[0].steps == 120


@pytest.mark.parametrize("processes", [1, 2])
def test_a_failure_says_which_input(processes: int) -> None:
    with pytest.raises(muster.NotFoundError, match="value: found 3, expected another one") as caught:
        muster.run_batch(picky, [1, 2, 3, 4], processes=processes)
    assert "input 2 of the batch: 3" in caught.value.__notes__


def test_a_process_that_dies_ends_the_batch() -> None:
    with pytest.raises(muster.UnsupportedError, match="found a process that ended before its result"):
        muster.run_batch(dies, [0, 1, 2], processes=2)


def test_what_makes_no_sense_is_refused() -> None:
    with pytest.raises(ValueError, match="processes: found 0, expected 1 or more"):
        muster.run_batch(walked, [1], processes=0)
    with pytest.raises(TypeError, match="found seconds"):
        muster.run_batch(walked, [1], seconds=2.0)
    assert muster.run_batch(walked, [], processes=2) == []
