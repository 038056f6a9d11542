"""Threads of Python: others run while a world steps, and one world belongs to one thread at a time."""

from __future__ import annotations

import threading

import pytest
from conftest import walkers

import muster


def big_world() -> muster.World:
    world = muster.World(walkers(3000))
    world.submit(muster.GiveOrder(1, order=muster.Order.move((5.0, 5.0), 1.0)))
    return world


def test_other_threads_run_during_a_step_and_may_not_touch_its_world() -> None:
    world = big_world()
    ended = threading.Event()

    def steps() -> None:
        world.step(100)
        ended.set()

    thread = threading.Thread(target=steps)
    refusals = looks = 0
    thread.start()
    while not ended.is_set():
        looks += 1
        try:
            _ = world.time
        except muster.UnsupportedError as error:
            assert "found a step in another thread" in str(error)
            refusals += 1
    thread.join()
    assert refusals > 0 and looks > 100  # It could not look once if the interpreter's lock were kept.
    assert world.step_count == 100


def test_worlds_in_threads_end_as_alone() -> None:
    hashes: list[int] = []

    def run() -> None:
        world = big_world()
        world.step(20)
        hashes.append(world.hash())

    threads = [threading.Thread(target=run) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    run()
    assert len(set(hashes)) == 1 and len(hashes) == 4


def test_a_signal_ends_a_long_series_of_steps() -> None:
    import signal

    world = muster.World(walkers(50))

    def interrupt(signum: int, frame: object) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.05)
        with pytest.raises(KeyboardInterrupt):
            world.step(10**12)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
    steps = world.step_count
    world.step()
    assert world.step_count == steps + 1
