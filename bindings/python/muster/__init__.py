"""Muster: interactive formation control of crowds.

A world is made from a definition, takes commands and makes steps; what is in it is read as NumPy arrays without copies:

    import muster

    world = muster.World(muster.WorldDef(groups=[muster.GroupDef(count=64)]))
    world.submit(muster.GiveOrder(group=1, order=muster.Order.move((10.0, 0.0))))
    world.step(600)
    print(world.time, world.characters.position.mean(axis=0))

Lengths are metres, times seconds, angles radians counter-clockwise from +x. Failures are muster.Error.
"""

from __future__ import annotations

from . import _types, errors, gym, measure, records
from ._core import (
    JOINT_PARENTS,
    JOINTS,
    VERSION,
    Characters,
    CrowdMotion,
    Group,
    RunMetrics,
    TakeWriter,
    World,
    adults,
    decode_command,
    default_clip_facts,
    encode_command,
    export_formats,
    gestures_schema,
    parameter_preset,
    parameter_table,
    parse_map,
    scenario_schema,
    scenario_warnings,
    validate_command,
    walking_speed_at_age,
    write_gestures,
    write_scenario,
)
from ._types import *
from .batch import run_batch
from .errors import (
    CorruptError,
    Error,
    InvalidArgumentError,
    IoError,
    LimitExceededError,
    NotFoundError,
    ParseError,
    UnsupportedError,
)
from .floor_plan import FloorPlan, Room, load_floor_plan, parse_floor_plan
from .play import play
from .records import Area, FormationCheckpoint, Item, Obstacle, Parameter, Patch, Rejection
from .scenario import Scenario, load_gestures, load_scenario, parse_gestures, parse_scenario, save_scenario
from .take import Take, TrajectoryRecorder, to_pedpy

__version__ = VERSION

__all__ = [
    "__version__",
    "adults",
    "Area",
    "Characters",
    "CorruptError",
    "CrowdMotion",
    "decode_command",
    "default_clip_facts",
    "encode_command",
    "Error",
    "errors",
    "export_formats",
    "FloorPlan",
    "FormationCheckpoint",
    "gestures_schema",
    "Group",
    "gym",
    "InvalidArgumentError",
    "IoError",
    "Item",
    "JOINT_PARENTS",
    "JOINTS",
    "LimitExceededError",
    "load_floor_plan",
    "load_gestures",
    "load_scenario",
    "measure",
    "NotFoundError",
    "Obstacle",
    "Parameter",
    "parameter_preset",
    "parameter_table",
    "parse_floor_plan",
    "parse_gestures",
    "parse_map",
    "parse_scenario",
    "ParseError",
    "Patch",
    "play",
    "records",
    "Rejection",
    "Room",
    "run_batch",
    "RunMetrics",
    "save_scenario",
    "Scenario",
    "scenario_schema",
    "scenario_warnings",
    "Take",
    "TakeWriter",
    "to_pedpy",
    "TrajectoryRecorder",
    "UnsupportedError",
    "validate_command",
    "walking_speed_at_age",
    "World",
    "write_gestures",
    "write_scenario",
]
__all__ += _types.__all__
