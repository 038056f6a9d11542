"""Measures of trajectories from Python: the same functions as the program's, and files that it writes."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import muster
from muster import measure


def file_of_persons() -> measure.Trajectories:
    """Nine in a file, half a metre and half a second apart."""
    rows = [(f, i, -1.05 - 0.5 * i + 0.1 * f) for f in range(80) for i in range(9)]
    frames, ids, x = zip(*rows)
    return measure.Trajectories(10.0, frames, ids, np.column_stack([x, np.zeros(len(x))]))


def test_crossings_and_flow() -> None:
    persons = file_of_persons()
    crossed = measure.crossings(persons, ((0, -1), (0, 1)))
    assert len(crossed) == 9
    assert crossed.time[0] == pytest.approx(1.05)
    assert set(crossed.direction) == {1}
    assert measure.mean_flow(crossed) == pytest.approx(2.0)
    assert measure.mean_flow(crossed, leave_out=0.2) == pytest.approx(2.0)
    count = measure.n_t(persons, crossed)
    assert (count[10], count[11], count[79]) == (0, 1, 9)
    assert len(measure.crossings(persons, ((0, -1), (0, 1)), direction=-1)) == 0


def test_speeds_and_densities() -> None:
    persons = file_of_persons()
    speeds = measure.speeds(persons, frame_step=2)
    assert np.nanmax(np.abs(speeds - 1.0)) < 1e-9
    assert np.isnan(speeds[0])
    area = measure.Region(((-2, -0.5), (2, 0.5)))
    assert area.area == pytest.approx(4.0)
    assert area.contains((1.0, 0.0))
    density = measure.classic_density(persons, area)
    assert density[40] == pytest.approx(7 / 4.0)
    assert measure.mean_speed(persons, area, speeds)[40] == pytest.approx(1.0)
    ground = "POLYGON ((-10 -0.5, 10 -0.5, 10 0.5, -10 0.5, -10 -0.5))"
    voronoi, speed = measure.voronoi(persons, area=((-0.5, -0.5), (1, 0.5)), walkable=ground, speeds=speeds)
    assert voronoi[40] == pytest.approx(2.0)
    assert speed[40] == pytest.approx(1.0)
    assert measure.cell_areas(persons, 40, ground, cut_off=10.0)[3] == pytest.approx(0.5)
    with pytest.raises(ValueError):
        measure.voronoi(persons, area=area)


def test_the_ground_of_a_world_bounds_cells() -> None:
    wall = muster.ObstacleDef(polygon=[(4, 0), (5, 0), (5, 6), (4, 6)])
    corner = muster.ObstacleDef(polygon=[(0, 0), (2, 0), (2, 2), (1, 2), (1, 1), (0, 1)])
    ground = measure.ground(muster.World(muster.WorldDef(box=((0, 0), (10, 6)), obstacles=[wall, corner])))
    assert ground.area == pytest.approx(60 - 6 - 3)
    assert ground.contains((0.5, 1.5)) and not ground.contains((1.5, 1.5))
    # Each alone in a room of the two.
    alone = measure.Trajectories(10.0, [0, 0], [1, 2], [(3, 3), (6, 3)])
    assert measure.cell_areas(alone, 0, ground, cut_off=20.0) == pytest.approx([21.0, 30.0])


def test_headways_and_series() -> None:
    persons = file_of_persons()
    rows, ahead, distances = measure.headways(persons)
    assert distances == pytest.approx(0.5)
    assert len(rows) == 80 * 8 == len(ahead)
    assert measure.last_seen(persons)[0] == pytest.approx(7.9)
    begin, end, mean = measure.steady_state([0.0, 0.5] + [1.0, 1.01] * 30)
    assert (begin, end) == (2, 62)
    assert mean == pytest.approx(1.005)
    count = measure.classic_density(persons, ((0, -1), (100, 1)))
    assert measure.first_reaching(persons, count, 1 / 200) == pytest.approx(1.1)
    assert math.isnan(measure.first_reaching(persons, count, 1.0))


def test_what_a_take_exports_is_read(tmp_path: Path) -> None:
    definition = muster.WorldDef(groups=[muster.GroupDef(count=9, orders=[muster.Order.move((6.0, 0.0))])])
    path = tmp_path / "march.take"
    muster.play(definition, seconds=4.0, take=path)
    take = muster.Take.load(path)
    take.export(tmp_path / "march.txt", "pedpy", fps=25.0)
    text = measure.Trajectories.load(tmp_path / "march.txt")
    assert text.frame_rate == 25.0
    assert len(text.times) == 101
    again = measure.Trajectories.of_frame(take.trajectories(fps=25.0), frame_rate=25.0)
    assert np.allclose(text.positions, again.positions, atol=1e-5)
    assert np.array_equal(text.ids, again.ids)
    take.export(tmp_path / "march.sqlite", "jupedsim", fps=25.0)
    base = measure.Trajectories.load(tmp_path / "march.sqlite")
    assert np.allclose(base.positions, text.positions, atol=1e-5)
    assert base.walkable is not None
    assert base.walkable.area == pytest.approx(32.0 * 32.0)


def test_what_is_wrong_is_told(tmp_path: Path) -> None:
    with pytest.raises(muster.IoError):
        measure.Trajectories.load(tmp_path / "none.txt")
    with pytest.raises(muster.ParseError):
        measure.Region("POINT (0 0)")
    with pytest.raises(muster.InvalidArgumentError):
        measure.Trajectories(10.0, [1, 1], [1, 1], [(0, 0), (1, 1)])
    with pytest.raises(ValueError):
        measure.speeds(file_of_persons(), border="none")
