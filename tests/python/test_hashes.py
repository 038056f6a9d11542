"""The same bits as the native program: the references of tests/hashes."""

from __future__ import annotations

import pytest

import muster

QUICK = ["block fast", "block exact", "corridor fast", "open fast", "cars fast", "three-paths fast", "paper/x01-points exact",
         "paper/x08-congestion fast", "paper/x10-pacman fast", "paper/x11-transport fast"]  # fmt: skip


def references(root) -> dict[str, tuple[int, str]]:
    lines = (root / "tests/hashes/references.txt").read_text().splitlines()
    return {f"{name} {plan}": (int(steps), hash) for name, plan, steps, hash in map(str.split, lines)}


@pytest.mark.parametrize("run", QUICK)
def test_play_ends_as_the_references_say(run: str, root, scenarios) -> None:
    name, plan = run.split()
    figures = muster.play(scenarios / f"{name}.json", parameters={"plan.solver": 1 if plan == "fast" else 0})
    assert (figures.steps, f"{figures.hash:016x}") == references(root)[run]


@pytest.mark.parametrize("threads", [1, 2, 0])
def test_worlds_step_to_the_reference_on_any_number_of_threads(threads: int, root, scenarios) -> None:
    steps, hash = references(root)["block fast"]
    scenario = muster.Scenario.load(scenarios / "block.json")
    world = muster.World(scenario, threads)
    for command in scenario.commands:
        world.submit(command)
    world.step(steps)
    assert f"{world.hash():016x}" == hash


def test_figures_are_those_of_the_program(program, scenarios) -> None:
    file = scenarios / "course.json"
    native = program("play", file, "--demo", "--seconds", "12", "--json")
    ours = muster.play(file, seconds=12.0)
    assert f"{ours.hash:016x}" == native["hash"]
    assert (ours.steps, ours.characters, ours.stuck) == (native["steps"], native["characters"], native["stuck"])
    assert ours.walked.sum == pytest.approx(native["walked"]["sum_m"], rel=1e-12)
    assert 100.0 * ours.worst_penetration == pytest.approx(native["worst_penetration_pct"], rel=1e-12)


def test_a_world_from_python_data_is_that_of_its_file(program, tmp_path) -> None:
    definition = muster.WorldDef(
        name="Made in Python",
        box=((-30, -20), (30, 20)),
        parameters={"plan.exponent": 1.5},
        obstacles=[muster.ObstacleDef(polygon=[(-1, -5), (1, -5), (1, 5), (-1, 5)]), muster.ObstacleDef(centre=(6, 3), radius=1.5)],
        patches=[muster.PatchDef(polygon=[(3, -9), (9, -9), (9, -6), (3, -6)], motion=3)],
        groups=[muster.GroupDef(count=30, formation=muster.FormationDef(kind="wedge", spacing=1.1), position=(-15, 0))],
    )
    definition.groups[0].orders = [muster.Order.move((15.0, 0.0))]
    file = tmp_path / "made.json"
    muster.save_scenario(definition, file)
    native = program("play", file, "--seconds", "10", "--json")
    world = muster.World(definition)
    world.step(600)
    assert f"{world.hash():016x}" == native["hash"]
