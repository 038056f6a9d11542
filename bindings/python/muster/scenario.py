"""Scenarios: a definition and the commands that belong to it."""

from __future__ import annotations

import copy
import json
import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Mapping, Union

from . import _core
from ._types import Command, WorldDef

PathLike = Union[str, "os.PathLike[str]"]
Definition = Union[WorldDef, "Scenario", Mapping[str, Any], str, "os.PathLike[str]"]


@dataclass(slots=True)
class Scenario:
    """What a run starts from.

    Attributes:
        definition: The world.
        commands: The touches and other commands that the scenario carries, in ascending order of steps.
    """

    definition: WorldDef
    commands: list[Command] = field(default_factory=list)

    @classmethod
    def load(cls, path: PathLike) -> Scenario:
        """Reads a scenario file, and the gestures file that it names. Fails with ParseError or IoError: `FILE: PATH: found X,
        expected Y`."""
        definition = load_scenario(path)
        return cls(definition, _core.load_scenario_gestures(os.fspath(path), definition))

    def changed(self, *, seed: int | None = None, parameters: Mapping[str, float] | None = None) -> Scenario:
        """A copy with another seed, and with these parameters on top of its own."""
        definition = copy.copy(self.definition)
        if seed is not None:
            definition.seed = seed
        definition.parameters = {**definition.parameters, **(parameters or {})}
        return Scenario(definition, list(self.commands))


def load_scenario(path: PathLike) -> WorldDef:
    """The definition in a scenario file. Fails with ParseError or IoError: `FILE: PATH: found X, expected Y`."""
    return _core.load_scenario(os.fspath(path))


def parse_scenario(content: str | Mapping[str, Any], *, source_name: str = "scenario", base_folder: PathLike = "") -> WorldDef:
    """The definition in a scenario file's text, or in its content as a dict.

    Relative map files are looked for in `base_folder`; without one only embedded maps are allowed. `source_name` stands for the
    file in failures. Fails with ParseError.
    """
    return _core.parse_scenario(_as_text(content), source_name, os.fspath(base_folder))


def save_scenario(definition: WorldDef, path: PathLike) -> None:
    """Writes a scenario file. Fails with InvalidArgumentError, or with OSError."""
    text = _core.write_scenario(definition)
    Path(path).write_text(text, encoding="utf-8")


def load_gestures(path: PathLike, step_time: float = 1.0 / 60.0) -> list[Command]:
    """The commands of a gestures file for worlds of that step time [s], in ascending order of (step, client, sequence).
    Fails as load_scenario() does."""
    return _core.load_gestures(os.fspath(path), step_time)


def parse_gestures(
    content: str | Mapping[str, Any], step_time: float = 1.0 / 60.0, *, source_name: str = "gestures"
) -> list[Command]:
    """The same from the text of a gestures file, or from its content as a dict."""
    return _core.parse_gestures(_as_text(content), source_name, step_time)


def _as_text(content: str | Mapping[str, Any]) -> str:
    if isinstance(content, str):
        return content
    if not isinstance(content, Mapping):
        raise TypeError(f"content: found {type(content).__name__}, expected a file's text, or its content as a dict")
    return json.dumps(dict(content))


def as_definition(given: Definition) -> WorldDef:
    """The definition of a world, in whichever form it is given."""
    if isinstance(given, WorldDef):
        return given
    if isinstance(given, Scenario):
        return given.definition
    if isinstance(given, Mapping):
        return parse_scenario(given)
    if isinstance(given, (str, os.PathLike)):
        return load_scenario(given)
    raise TypeError(f"definition: found {type(given).__name__}, expected a WorldDef, a Scenario, a dict or the path of a file")


def as_scenario(given: Definition) -> Scenario:
    """A scenario with its commands, in whichever form it is given. Of files the gestures are read too."""
    if isinstance(given, Scenario):
        return given
    if isinstance(given, (str, os.PathLike)):
        return Scenario.load(given)
    return Scenario(as_definition(given))
