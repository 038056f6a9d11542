"""Measures of trajectories, as PedPy defines them: flow, N-t, density and speed by Voronoi cells, headways.

    from muster import measure

    run = measure.Trajectories.load("run.csv")
    crossed = measure.crossings(run, ((4.0, 0.0), (4.0, 3.0)))
    print(measure.mean_flow(crossed), "persons a second")
    density, speed = measure.voronoi(run, area=((2, 0), (4, 2)), walkable=((0, 0), (10, 3)), speeds=measure.speeds(run))

An area is a rectangle by two corners, a polygon by three or more, or well-known text ("POLYGON ((...))"). Series have one value
per frame, from the first. The definitions are those of docs/people.md.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .scenario import PathLike

if TYPE_CHECKING:
    import pandas

Area = Union[str, Sequence[Sequence[float]], "Region"]
Line = Sequence[Sequence[float]]


def _point(given: Sequence[float]) -> tuple[float, float]:
    x, y = given
    return float(x), float(y)


class Region:
    """Ground or a measurement area: polygons with holes."""

    __slots__ = ("_data",)

    def __init__(self, area: Area) -> None:
        """Takes two corners of a rectangle, the corners of a polygon, or well-known text. Fails with InvalidArgumentError or
        ParseError."""
        if isinstance(area, Region):
            self._data: _core.RegionData = area._data
        elif isinstance(area, str):
            self._data = _core.RegionData.parse(area)
        else:
            corners = [_point(corner) for corner in area]
            if len(corners) == 2:
                (left, low), (right, high) = corners
                corners = [(left, low), (right, low), (right, high), (left, high)]
            self._data = _core.RegionData.polygon(corners)

    @property
    def area(self) -> float:
        """Its area [m^2]."""
        return self._data.area

    def contains(self, point: Sequence[float]) -> bool:
        """Whether a point lies in it."""
        return self._data.contains(_point(point))


def ground(world: _core.World) -> Region:
    """Where people can walk in a world: its box outside of all obstacles that do not move."""
    region = Region.__new__(Region)
    region._data = _core.RegionData.of_world(world)
    return region


class Trajectories:
    """Where persons were, frame by frame, sorted by frame and id."""

    __slots__ = ("_data",)

    def __init__(self, frame_rate: float, frames: ArrayLike, ids: ArrayLike, positions: ArrayLike) -> None:
        """Takes frames per second, and for each sighting number of the frame, id of the person and position (n, 2) [m]. Fails
        with InvalidArgumentError where one person is in one frame twice."""
        self._data = _core.TrajectoryData.make(
            frame_rate, np.asarray(frames), np.asarray(ids), np.asarray(positions, dtype=np.float64)
        )

    @classmethod
    def load(cls, path: PathLike, *, frame_rate: float = 0.0) -> Trajectories:
        """Reads CSV of `muster play --trajectory`, text of PedPy and JuPedSim, or SQLite of JuPedSim. `frame_rate` stands for
        that of a text that names none."""
        made = cls.__new__(cls)
        made._data = _core.TrajectoryData.load(os.fspath(path), frame_rate)
        return made

    @classmethod
    def of_frame(cls, frame: pandas.DataFrame, *, frame_rate: float) -> Trajectories:
        """Takes a frame of pandas with columns id, frame, x, y, as Take.trajectories() gives."""
        return cls(frame_rate, frame["frame"], frame["id"], frame[["x", "y"]].to_numpy())

    @property
    def frame_rate(self) -> float:
        """Frames per second."""
        return self._data.frame_rate

    @property
    def times(self) -> NDArray[np.float64]:
        """Times of all frames from the first to the last [s]."""
        first: NDArray[np.float64] = self._data.first_frame + np.arange(self._data.frame_count, dtype=np.float64)
        return first / self.frame_rate

    @property
    def frames(self) -> NDArray[np.int32]:
        """Number of the frame of each sighting."""
        return self._data.frames

    @property
    def ids(self) -> NDArray[np.uint32]:
        """Id of the person of each sighting."""
        return self._data.ids

    @property
    def positions(self) -> NDArray[np.float64]:
        """Position of each sighting (n, 2) [m]."""
        return self._data.positions

    @property
    def walkable(self) -> Region | None:
        """The ground, where the file has it."""
        if self._data.walkable is None:
            return None
        region = Region.__new__(Region)
        region._data = self._data.walkable
        return region


@dataclass(frozen=True)
class Crossings:
    """Crossings of a line by time, as arrays of equal length."""

    id: NDArray[np.uint32]  #: The persons.
    frame: NDArray[np.int32]  #: First frame after the crossing, as PedPy counts.
    time: NDArray[np.float64]  #: By linear interpolation [s].
    direction: NDArray[np.int32]  #: 1 to the right of the line as seen from its first end to its second; -1 to its left.
    point: NDArray[np.float64]  #: Where (n, 2) [m].

    def __len__(self) -> int:
        return len(self.id)


def crossings(trajectories: Trajectories, line: Line, *, direction: int = 0, first: bool = True) -> Crossings:
    """Who crosses a line from one point to another: the first crossing of each person, or all of them.

    A movement that ends on the line does not cross it; one that begins on it does. direction: 1 or -1 for one side only.
    """
    a, b = line
    return Crossings(*trajectories._data.crossings(_point(a), _point(b), direction, first))


def n_t(trajectories: Trajectories, crossed: Crossings) -> NDArray[np.int64]:
    """How many have crossed by each frame."""
    count = np.zeros(trajectories._data.frame_count, dtype=np.int64)
    np.add.at(count, crossed.frame - trajectories._data.first_frame, 1)
    return np.cumsum(count)


def mean_flow(crossed: Crossings, *, leave_out: float = 0.0) -> float:
    """Persons per second between the first crossing and the last; NaN for fewer than two.

    leave_out: Share of crossings that is left out at the beginning and at the end, as 0.2 for the middle three fifths.
    """
    out = int(leave_out * len(crossed))
    times = crossed.time[out : len(crossed) - out]
    if len(times) < 2 or times[-1] <= times[0]:
        return float("nan")
    return float((len(times) - 1) / (times[-1] - times[0]))


def speeds(
    trajectories: Trajectories,
    *,
    frame_step: int = 5,
    border: str = "adaptive",
    direction: Sequence[float] | None = None,
    period: float = 0.0,
) -> NDArray[np.float64]:
    """One speed per sighting [m/s]: from frame_step frames before to as many after; NaN where there is none.

    border: Where frames before or after are missing: "adaptive" takes as many on both sides as there are, "single" the side that is
        there, "exclude" none. direction: For the speed along it, which may be negative. period: Of ground joined in x [m].
    """
    along = None if direction is None else _point(direction)
    return trajectories._data.speeds(frame_step, border, along, period)


def classic_density(trajectories: Trajectories, area: Area) -> NDArray[np.float64]:
    """Persons in the area over its area, per frame [1/m^2]."""
    return trajectories._data.classic_density(Region(area)._data)


def mean_speed(trajectories: Trajectories, area: Area, speeds: ArrayLike) -> NDArray[np.float64]:
    """Mean speed of those in the area, per frame [m/s]; 0 where there is nobody."""
    return trajectories._data.mean_speed(Region(area)._data, np.asarray(speeds, dtype=np.float64))


def voronoi(
    trajectories: Trajectories,
    *,
    area: Area,
    walkable: Area | None = None,
    cut_off: float = 0.0,
    quad_segments: int = 3,
    speeds: ArrayLike | None = None,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Density and speed in the area by Voronoi cells, per frame: (density [1/m^2], speed [m/s]); no speeds give an empty one.

    walkable: Ground that bounds cells; None for that of the file. cut_off: Radius beyond which cells end [m]; 0 for none.
    quad_segments: Edges of a quarter of that circle.
    """
    ground = trajectories.walkable if walkable is None else Region(walkable)
    if ground is None:
        raise ValueError("walkable: the trajectories come without ground, expected an area")
    given = np.empty(0) if speeds is None else np.asarray(speeds, dtype=np.float64)
    return trajectories._data.voronoi(ground._data, Region(area)._data, cut_off, quad_segments, given)


def cell_areas(
    trajectories: Trajectories, frame: int, walkable: Area, *, cut_off: float = 0.0, quad_segments: int = 3
) -> NDArray[np.float64]:
    """Areas of the Voronoi cells of everybody in a frame, by id [m^2]."""
    return trajectories._data.cell_areas(frame, Region(walkable)._data, cut_off, quad_segments)


def steady_state(values: ArrayLike) -> tuple[int, int, float]:
    """The steady part of a series by the marginal standard error rule: (begin, end, mean)."""
    return _core.steady_state(np.asarray(values, dtype=np.float64))


def first_reaching(trajectories: Trajectories, values: ArrayLike, value: float) -> float:
    """Time when a series first reaches a value [s]; NaN where it never does."""
    reached: NDArray[Any] = np.flatnonzero(np.asarray(values) >= value)
    return float(trajectories.times[reached[0]]) if len(reached) else float("nan")


def headways(
    trajectories: Trajectories, *, period: float = 0.0, backwards: bool = False
) -> tuple[NDArray[np.int64], NDArray[np.uint32], NDArray[np.float64]]:
    """Who is ahead in single file along x, in every frame: (index of the sighting, id of the one ahead, distance [m]).

    period: Of ground joined in x [m]; 0 for none. backwards: People walk towards -x.
    """
    return trajectories._data.headways(period, backwards)


def last_seen(trajectories: Trajectories) -> NDArray[np.float64]:
    """When each person is seen last [s], ascending: the evacuation curve where people leave at exits."""
    return trajectories._data.last_seen()
