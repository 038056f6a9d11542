"""What Python costs, as measured. Nothing is asserted but that the runs are the same."""

from __future__ import annotations

import time

import muster


def test_steps_beside_the_program(program, measured, scenarios) -> None:
    for name, seconds in (("block", 20.0), ("market", 10.0)):
        file = scenarios / f"{name}.json"
        native = program("play", file, "--demo", "--seconds", seconds, "--json")
        ours = muster.play(file, seconds=seconds)
        assert f"{ours.hash:016x}" == native["hash"]
        scenario = muster.Scenario.load(file)
        world = muster.World(scenario)
        for command in scenario.commands:
            world.submit(command)
        began = time.perf_counter()
        inside = 0.0
        for _ in range(ours.steps):
            world.step()
            _ = world.characters.position
            inside += world.stage_times["total"]
        whole = (time.perf_counter() - began) * 1000.0 / ours.steps
        measured(
            f"{name}, {ours.characters} characters: {whole:.3f} ms from step to step in Python with a view of all positions, "
            f"{inside / ours.steps:.3f} ms of it in the engine; median of a step {ours.step_p50:.3f} ms, of the program's {native['step_ms']['p50']:.3f} ms"
        )
