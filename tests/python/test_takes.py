"""Takes: recorded here and replayed by the program, and the other way round; frames of pandas."""

from __future__ import annotations

import sqlite3
import sys
import types

import numpy as np
import pandas
import pytest
from conftest import walkers

import muster


@pytest.fixture
def recorded(tmp_path, scenarios):
    """A take that Python recorded, in which characters join and leave."""
    file = tmp_path / "ours.take"
    scenario = muster.Scenario.load(scenarios / "corridor.json")
    scenario.commands.append(muster.Command(100, 1, 0, muster.ChangeGroup(1, count=40)))
    scenario.commands.append(muster.Command(260, 1, 1, muster.TransferCharacters([2, 3])))
    return file, muster.play(scenario, seconds=7.0, take=file)


def test_the_program_replays_what_python_records(recorded, program) -> None:
    file, figures = recorded
    native = program("replay", file, "--json")
    assert native["hash"] == f"{figures.hash:016x}"
    take = muster.Take.load(file)
    report = take.replay(threads=2)
    assert report.hash == figures.hash and report.compared == len(take.marks) == 8 and report.steps == 420
    assert take.simulates_alike() and take.finished and take.torn_bytes == 0


def test_python_replays_what_the_program_records(tmp_path, program, scenarios) -> None:
    file = tmp_path / "theirs.take"
    native = program("play", scenarios / "cars.json", "--demo", "--seconds", "6", "--take", file, "--json")
    take = muster.Take.load(file)
    assert f"{take.replay().hash:016x}" == native["hash"]
    assert muster.play(take.scenario, seconds=6.0).hash == take.marks[-1].hash


def test_a_writer_step_by_step(tmp_path) -> None:
    file = tmp_path / "own.take"
    definition = walkers(6)
    world = muster.World(definition)
    writer = muster.TakeWriter(file, definition)
    writer.command(world.submit(muster.GiveOrder(1, order=muster.Order.go((4.0, 0.0)))))
    for _ in range(300):
        world.step()
        writer.observe(world)
    writer.finish(world)
    take = muster.Take.parse(file.read_bytes())
    assert take.replay().hash == world.hash()
    assert take.definition == definition
    frame = take.event_frame()
    assert "arrived" in set(frame["kind"]) and list(frame.columns) == ["step", "time", "kind", "subject", "value", "x", "y"]
    step_time = muster.World(definition).parameters["time.step"]
    assert list(frame["time"]) == [step * step_time for step in frame["step"]]
    with pytest.raises(muster.IoError):
        muster.TakeWriter(file, definition, overwrite=False)


def test_what_is_damaged_is_named(recorded, tmp_path) -> None:
    file, _ = recorded
    bytes_ = bytearray(file.read_bytes())
    bytes_[len(bytes_) // 2] ^= 0x40
    with pytest.raises(muster.CorruptError, match="mine: "):
        muster.Take.parse(bytes(bytes_), source_name="mine")
    with pytest.raises((muster.ParseError, muster.UnsupportedError)):
        muster.Take.parse(b"not a take at all")
    with pytest.raises(muster.IoError):
        muster.Take.load(tmp_path / "none.take")
    take = muster.Take.load(file)
    with pytest.raises(muster.NotFoundError, match="docx"):
        take.export(tmp_path / "x", "docx")
    with pytest.raises(muster.InvalidArgumentError, match="fps: found 0"):
        take.trajectories(fps=0.0)
    with pytest.raises(muster.InvalidArgumentError, match="from: found 99"):
        take.trajectories(begin=99.0)


def test_trajectories_are_those_of_the_programs_export(recorded, tmp_path, program) -> None:
    file, _ = recorded
    text = tmp_path / "native.txt"
    program("export", file, "--format", "pedpy", "--out", text, "--fps", "25")
    native = pandas.read_csv(text, sep=" ", comment="#", usecols=[0, 1, 2, 3], names=["id", "frame", "x", "y"])
    native = native.sort_values(["id", "frame"], ignore_index=True)
    ours = muster.Take.load(file).trajectories(fps=25.0)
    assert list(ours.columns) == ["id", "frame", "x", "y"]
    assert np.array_equal(ours[["id", "frame"]], native[["id", "frame"]])
    assert np.abs(ours[["x", "y"]].to_numpy() - native[["x", "y"]].to_numpy()).max() <= 0.51e-6  # The text has 6 decimals.
    assert ours.equals(ours.sort_values(["id", "frame"], ignore_index=True))
    mine = tmp_path / "mine.txt"
    muster.Take.load(file).export(mine, "pedpy", fps=25.0)
    assert mine.read_bytes() == text.read_bytes()


def test_jupedsim_files_hold_the_same(recorded, tmp_path) -> None:
    take = muster.Take.load(recorded[0])
    file = tmp_path / "out.sqlite"
    take.export(file, "jupedsim", fps=20.0)
    with sqlite3.connect(file) as base:
        rows = base.execute("SELECT id, frame, pos_x, pos_y FROM trajectory_data ORDER BY id, frame").fetchall()
    assert np.allclose(np.array(rows), take.trajectories(fps=20.0).to_numpy(), atol=1e-9)


def test_a_recorder_keeps_what_the_world_showed(tmp_path, program, scenarios) -> None:
    table = tmp_path / "steps.csv"
    program("play", scenarios / "block.json", "--demo", "--seconds", "3", "--trajectory", table, "--json")
    native = pandas.read_csv(table).sort_values(["id", "t"], ignore_index=True)
    recorder = muster.TrajectoryRecorder()
    muster.play(scenarios / "block.json", seconds=3.0, observe=recorder.observe)
    ours = recorder.trajectories()
    assert np.array_equal(ours["id"], native["id"]) and len(ours) == 36 * 181
    assert np.allclose(ours[["x", "y"]], native[["x", "y"]], atol=1e-5)
    assert len(muster.TrajectoryRecorder().trajectories()) == 0


def test_to_pedpy_asks_for_pedpy(recorded, monkeypatch) -> None:
    take = muster.Take.load(recorded[0])
    monkeypatch.setitem(sys.modules, "pedpy", None)
    with pytest.raises(muster.UnsupportedError, match="pedpy: found no such package"):
        muster.to_pedpy(take)
    monkeypatch.delitem(sys.modules, "pedpy")
    pedpy = pytest.importorskip("pedpy", reason="PedPy is not there (it is no Debian package)")
    made = muster.to_pedpy(take, fps=25.0)
    assert isinstance(made, pedpy.TrajectoryData) and isinstance(pedpy, types.ModuleType)
    assert made.frame_rate == 25.0 and len(made.data) == len(take.trajectories(fps=25.0))
