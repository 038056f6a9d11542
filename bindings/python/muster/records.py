"""What is read of a world besides arrays, as plain data: a copy of the moment."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ._types import AreaDef, Command, FormationCheckpointDef, ItemDef, ObstacleDef, PatchDef, Vec2
from .errors import Error


@dataclass(slots=True, frozen=True, eq=False)
class Obstacle:
    """An obstacle and its current position.

    Attributes:
        id: Unique id, never used again.
        definition: Definition as added or last changed.
        outline: Current corners, shape (n, 2) [m]; empty for a disc.
        centre: Current centre of the disc or of the area [m].
    """

    id: int
    definition: ObstacleDef
    outline: NDArray[np.float64]
    centre: Vec2


@dataclass(slots=True, frozen=True, eq=False)
class Patch:
    """A patch and its current position.

    Attributes:
        id: Unique id, never used again.
        definition: Definition as added or last changed.
        outline: Current corners, shape (n, 2) [m].
    """

    id: int
    definition: PatchDef
    outline: NDArray[np.float64]


@dataclass(slots=True, frozen=True)
class Item:
    """An item to collect.

    Attributes:
        id: Unique id, never used again.
        definition: Where it lies.
        collected: True once a character has collected it.
    """

    id: int
    definition: ItemDef
    collected: bool


@dataclass(slots=True, frozen=True)
class FormationCheckpoint:
    """A disc that changes formations.

    Attributes:
        id: Unique id, never used again.
        definition: Where it lies and what it does; its `group` counts in the definition of the world only.
        group: Id of the group that it concerns; 0 for any.
    """

    id: int
    definition: FormationCheckpointDef
    group: int


@dataclass(slots=True, frozen=True)
class Area:
    """An exit, a source or a waiting area, and what it has seen.

    Attributes:
        id: Unique id, never used again.
        definition: Definition as added or last changed; its `group` counts in the definition of the world only.
        group: Of a source: id of the group whom its people join; else 0.
        passed: People who have left by an exit, or come by a source.
        waiting: People of a source for whom there is no room yet.
    """

    id: int
    definition: AreaDef
    group: int
    passed: int
    waiting: int


@dataclass(slots=True, frozen=True)
class Rejection:
    """A command that could not be applied in its step.

    Attributes:
        command: The command.
        error: Why: the exception that submit() would have raised.
    """

    command: Command
    error: Error


@dataclass(slots=True, frozen=True)
class Parameter:
    """A parameter of behaviour.

    Attributes:
        name: Name in files, in WorldDef.parameters and in SetParameter: "plan.exponent".
        unit: "m", "s", "m/s", "1", "switch", "mode", "steps", "count"...
        minimum: Smallest allowed value.
        maximum: Largest allowed value.
        default: Value where nothing is said.
        whole: True where only whole numbers are valid.
        description: One sentence.
    """

    name: str
    unit: str
    minimum: float
    maximum: float
    default: float
    whole: bool
    description: str
