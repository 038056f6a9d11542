"""Takes: recordings that replay bit for bit, and what they hold as frames of pandas and PedPy."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._types import Command, HashMark, ReplayReport, TakeAbout, TakeEvent, WorldDef
from .scenario import PathLike, Scenario

if TYPE_CHECKING:
    import pandas


class Take:
    """A whole take in memory.

    TakeWriter and play() record takes; the program's `muster replay` reads them as this does.
    """

    __slots__ = ("_data",)

    def __init__(self, data: _core.TakeData) -> None:
        self._data = data

    @classmethod
    def load(cls, path: PathLike) -> Take:
        """Reads a take. A torn last record is left out and counted in `torn_bytes`. Fails with CorruptError, naming the offset,
        where a checksum does not match; with ParseError, UnsupportedError or IoError on other files."""
        return cls(_core.TakeData.load(os.fspath(path)))

    @classmethod
    def parse(cls, data: bytes, *, source_name: str = "take") -> Take:
        """The same from bytes."""
        return cls(_core.TakeData.parse(data, source_name))

    @property
    def scenario_text(self) -> str:
        """Text of the scenario, map and clip facts embedded."""
        return self._data.scenario

    @property
    def definition(self) -> WorldDef:
        """The scenario's definition."""
        return self._data.definition

    @property
    def commands(self) -> list[Command]:
        """Commands in the order of submission."""
        return self._data.commands

    @property
    def scenario(self) -> Scenario:
        """Definition and commands, to play them again."""
        return Scenario(self.definition, self.commands)

    @property
    def marks(self) -> list[HashMark]:
        """Hashes of the state, in ascending order of steps."""
        return self._data.marks

    @property
    def events(self) -> list[TakeEvent]:
        """Events of orders, in ascending order of steps."""
        return self._data.events

    @property
    def frames(self) -> list[tuple[int, NDArray[np.uint32], NDArray[np.float64]]]:
        """Stored frames to 1 mm: step, ids (n,) in ascending order, positions (n, 2) [m]."""
        return self._data.frames

    @property
    def about(self) -> TakeAbout:
        """Its title, and the part that is to be shown."""
        return self._data.about

    @property
    def finished(self) -> bool:
        """True where the take has an end record."""
        return self._data.finished

    @property
    def torn_bytes(self) -> int:
        """Bytes of an unfinished last record that were left out."""
        return self._data.torn_bytes

    @property
    def steps(self) -> int:
        """Steps that can be replayed."""
        return self._data.steps

    def replay(self, threads: int = 1) -> ReplayReport:
        """Simulates the take again and compares every mark and event. Fails with CorruptError, naming the step of the first mark
        that differs."""
        return self._data.replay(threads)

    def simulates_alike(self, threads: int = 1) -> bool:
        """Whether this Muster simulates the take as it was recorded, up to its first mark."""
        return self._data.simulates_alike(threads)

    def export(
        self, path: PathLike, format: str, *, fps: float = 30.0, begin: float = 0.0, end: float = -1.0, threads: int = 1
    ) -> None:
        """Writes the take for another program: a name of export_formats(), as "pedpy", "jupedsim", "glb".

        fps: Frames per second, 1 to 240. begin, end: Times of the first and last frame [s]; a negative end is the take's.
        Fails with NotFoundError, InvalidArgumentError, CorruptError, LimitExceededError, UnsupportedError or IoError, and leaves
        no file then.
        """
        self._data.export(os.fspath(path), format, fps, begin, end, threads)

    def trajectories(
        self, *, fps: float = 30.0, begin: float = 0.0, end: float = -1.0, threads: int = 1
    ) -> pandas.DataFrame:
        """Where everybody was: columns id, frame, x [m], y [m], sorted by id and frame, as PedPy has them.

        Frame 0 is at `begin` [s]; there are `fps` frames per second, 1 to 240. Positions between steps are interpolated. Where
        this version simulates otherwise than the take was recorded they are those of the stored frames. Needs pandas.
        """
        ids, frames, positions = self._data.positions(fps, begin, end, threads)
        return trajectory_frame(ids, frames, positions)

    def event_frame(self) -> pandas.DataFrame:
        """The events of orders: columns step, time [s], kind, subject, value, x [m], y [m]. Needs pandas."""
        import pandas

        usual = {parameter.name: parameter.default for parameter in _core.parameter_table()}
        step_time = (usual | self.definition.parameters)["time.step"]
        rows = [
            (e.step, e.step * step_time, e.event.kind.value, e.event.subject, e.event.value, *e.event.position)
            for e in self.events
        ]
        return pandas.DataFrame(rows, columns=["step", "time", "kind", "subject", "value", "x", "y"])


def trajectory_frame(
    ids: NDArray[np.uint32], frames: NDArray[np.int64], positions: NDArray[np.float64]
) -> pandas.DataFrame:
    """Rows of one character in one frame each, as a frame with columns id, frame, x, y, sorted by id and frame."""
    import pandas

    order = np.lexsort(np.vstack([frames, ids]))
    columns: dict[str, Any] = {
        "id": ids[order].astype(np.int64),
        "frame": frames[order],
        "x": positions[order, 0],
        "y": positions[order, 1],
    }
    return pandas.DataFrame(columns)


def to_pedpy(take: Take, *, fps: float = 30.0, begin: float = 0.0, end: float = -1.0) -> Any:
    """The trajectories of a take as a pedpy.TrajectoryData. Needs PedPy, and fails with UnsupportedError without it."""
    try:
        import pedpy
    except ImportError:
        from .errors import UnsupportedError

        raise UnsupportedError("pedpy: found no such package, expected PedPy; Take.trajectories() gives the frame without it") from None
    return pedpy.TrajectoryData(data=take.trajectories(fps=fps, begin=begin, end=end), frame_rate=fps)


class TrajectoryRecorder:
    """Keeps where everybody is while a world runs: a frame at each call of observe()."""

    def __init__(self) -> None:
        self._ids: list[NDArray[np.uint32]] = []
        self._positions: list[NDArray[np.float64]] = []

    def observe(self, world: _core.World) -> None:
        """Keeps the present positions, as the next frame."""
        self._ids.append(world.characters.id.copy())
        self._positions.append(world.characters.position.copy())

    def trajectories(self) -> pandas.DataFrame:
        """What was kept, as Take.trajectories() gives it; frames count from 0. Needs pandas."""
        counts = [len(ids) for ids in self._ids]
        frames = np.repeat(np.arange(len(counts), dtype=np.int64), counts)
        ids = np.concatenate(self._ids) if counts else np.empty(0, np.uint32)
        positions = np.concatenate(self._positions) if counts else np.empty((0, 2))
        return trajectory_frame(ids, frames, positions)
