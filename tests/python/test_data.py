"""Definitions and commands as plain data: defaults, conversions, and sentences for what is wrong."""

from __future__ import annotations

import copy
import dataclasses
import inspect
import math
import pickle
import re
import typing
from pathlib import Path

import numpy as np
import pytest
from conftest import walkers

import muster
from muster import _core, _types

COMMANDS = typing.get_args(_types.CommandBody)
DECLARATIONS = Path(__file__).parents[2] / "schema/commands.txt"


def test_every_type_has_the_defaults_of_the_engine() -> None:
    engine = _core.engine_defaults()
    for name, made in engine.items():
        mine = getattr(_types, name)()
        if name == "RunFigures":  # Python counts nothing before there is a run.
            made.events, made.event_persons, made.stage_mean = {}, {}, {}
        assert mine == made, name
    assert len(engine) == sum(dataclasses.is_dataclass(value) for value in vars(_types).values())


def test_every_field_is_described() -> None:
    for name in _core.engine_defaults():
        text = inspect.getdoc(getattr(_types, name)) or ""
        for field in dataclasses.fields(getattr(_types, name)):
            assert f"{field.name}: " in text, f"{name}.{field.name}"
    assert "[m/s]" in _types.Body.__doc__ and "[rad]" in _types.GroupDef.__doc__


def value_for(hint: object) -> object:
    """A value other than the default, for any type of field."""
    if hint == list[_types.Vec2]:
        return [(0.0, -2.25), (1.5, 0.5), (-1.0, 0.25)]
    if typing.get_origin(hint) is list:
        items = [value_for(typing.get_args(hint)[0]) for _ in range(3)]
        for i, item in enumerate(items):
            if isinstance(item, _types.Waypoint):
                item.time += i  # Times rise.
        return [item + i for i, item in enumerate(items)] if isinstance(items[0], int) else items
    if hint == _types.Vec2:
        return (1.5, 2.25)
    if isinstance(hint, type) and dataclasses.is_dataclass(hint):
        return filled(hint)
    if isinstance(hint, type) and issubclass(hint, _types.Enum):
        return list(hint)[-1]
    options = typing.get_args(hint)
    if type(None) in options:
        return value_for(options[0])
    return {bool: True, int: 3, float: 0.625, str: "grün"}[hint]


def filled(type_: type) -> object:
    hints = typing.get_type_hints(type_)
    made = type_(**{field.name: value_for(hints[field.name]) for field in dataclasses.fields(type_)})
    if isinstance(made, _types.ObstacleDef):
        made.radius = 0.0  # It has a polygon.
    if isinstance(made, _types.PeopleDef):
        made.age = _types.Distribution.constant(42.0)
    if isinstance(made, _types.AreaDef):
        made.kind, made.queue = _types.AreaKind.SOURCE, []
    if isinstance(made, _types.PutThing):
        made.obstacle = made.patch = made.item = made.area = None  # One of the definitions is given.
    if isinstance(made, _types.SetParameter):
        made.name = "plan.exponent"
        made.value = 1.25
    return made


def declared_in(path: Path) -> list[str]:
    return re.findall(r"^command (\w+)", path.read_text(encoding="utf-8"), re.MULTILINE)


def test_every_command_comes_back_from_bytes() -> None:
    known, former = declared_in(DECLARATIONS), declared_in(DECLARATIONS.with_name("former.txt"))
    assert [type_.__name__ for type_ in COMMANDS] == known + former
    for type_ in COMMANDS[: len(known)]:
        command = muster.Command(step=7, client=2, sequence=9, body=filled(type_))
        assert muster.decode_command(muster.encode_command(command)) == command, type_.__name__
        assert pickle.loads(pickle.dumps(command)) == command
        assert copy.deepcopy(command) == command
    with pytest.raises(muster.ParseError):
        muster.decode_command(b"\x01")


def test_a_former_command_is_the_one_that_says_the_same() -> None:
    def sent(body: object) -> object:
        return muster.decode_command(muster.encode_command(muster.Command(body=body))).body

    obstacle = muster.ObstacleDef(centre=(1.0, 2.0), radius=3.0)
    assert sent(muster.AddObstacle(obstacle)) == muster.PutThing(obstacle=obstacle)
    assert sent(muster.ChangeObstacle(7, obstacle)) == muster.PutThing(7, obstacle=obstacle)
    assert sent(muster.RemoveArea(4)) == muster.RemoveThing(muster.ThingKind.AREA, 4)
    assert sent(muster.TouchMove(3, (1.0, 2.0), 0.5)) == muster.Touch("move", 3, (1.0, 2.0), 0.5)
    assert sent(muster.PinControl(3, 4, False)) == muster.EditControl(3, 4, muster.ControlEdit.RELEASE)
    assert sent(muster.SetCount(3, 7)) == muster.ChangeGroup(3, count=7)
    assert sent(muster.SetRoles(3, [])) == muster.ChangeGroup(3, roles=[])
    assert sent(muster.ColourGroup(3)) == muster.ChangeGroup(3, colour=muster.GroupColour())
    assert sent(muster.RemoveCharacters([4, 5])) == muster.TransferCharacters([4, 5])
    assert sent(muster.PlaceGroup(3, (1.0, 2.0))) == muster.SetPose(3, (1.0, 2.0), characters=True)
    known = declared_in(DECLARATIONS)
    for type_ in COMMANDS:
        if type_.__name__ in declared_in(DECLARATIONS.with_name("former.txt")):
            assert type(sent(filled(type_))).__name__ in known


def test_points_may_be_arrays_and_words_may_stand_for_values() -> None:
    points = np.array([[0, 0], [3, 0], [3, 1]], dtype=np.int32)
    from_array = muster.FormationDef("points", points=points)
    from_lists = muster.FormationDef(muster.FormationKind.POINTS, points=[[0, 0], (3.0, 0), np.array([3, 1])])
    worlds = [muster.World(walkers(3, formation=formation)) for formation in (from_array, from_lists)]
    assert worlds[0].hash() == worlds[1].hash()
    assert worlds[0].groups[0].formation is muster.FormationKind.POINTS
    assert muster.World(walkers(np.int64(3), angle=np.float32(0.5))).groups[0].count == 3


SENTENCES = [
    (lambda d: setattr(d.groups[0], "count", "many"), "groups[0].count: found 'many', expected a whole number"),
    (lambda d: setattr(d.groups[0], "count", 1.5), "groups[0].count: found 1.5, expected a whole number"),
    (lambda d: setattr(d.groups[0], "count", 2**40), f"groups[0].count: found {2**40}, expected a whole number from -2147483648 to 2147483647"),
    (lambda d: setattr(d.groups[0], "count", True), "groups[0].count: found True, expected a whole number"),
    (lambda d: setattr(d, "seed", -1), "seed: found -1, expected a whole number from 0 to 18446744073709551615"),
    (lambda d: setattr(d.groups[0], "position", (1.0,)), "groups[0].position: found (1.0,), expected a point (x, y)"),
    (lambda d: setattr(d.groups[0], "position", (1.0, "a")), "groups[0].position[1]: found 'a', expected a number"),
    (lambda d: setattr(d.groups[0], "starts", np.zeros((2, 3))), "groups[0].starts: found 'an array of shape (2, 3)', expected one of shape (n, 2)"),
    (lambda d: setattr(d.groups[0], "starts", np.array(["a"])), "groups[0].starts: found array(['a'], dtype='<U1'), expected numbers"),
    (lambda d: setattr(d.groups[0], "starts", "ab"), "groups[0].starts: found 'ab', expected a list of points"),
    (lambda d: setattr(d.groups[0], "formation", None), "groups[0].formation: found None, expected a FormationDef"),
    (lambda d: setattr(d.groups[0].formation, "kind", "blob"), "groups[0].formation.kind: found 'blob', expected one of square, line, column,"),
    (lambda d: setattr(d.groups[0].formation, "kind", 3), "groups[0].formation.kind: found 3, expected one of square"),
    (lambda d: setattr(d.groups[0], "patrols", 1), "groups[0].patrols: found 1, expected True or False"),
    (lambda d: setattr(d, "groups", 3), "groups: found 3, expected a list"),
    (lambda d: d.groups.append(muster.ItemDef()), "groups[1]: found ItemDef(position=(0.0, 0.0), radius=0.5), expected a GroupDef"),
    (lambda d: setattr(d, "name", b"x"), "name: found b'x', expected text"),
    (lambda d: setattr(d, "name", "\ud800"), "name: found"),
    (lambda d: setattr(d, "box", (0, 1)), "box[0]: found 0, expected a point (x, y)"),
    (lambda d: d.parameters.update({"plan.exponent": 9.0}), "plan.exponent"),
    (lambda d: d.parameters.update({"plan.x": 1.0}), 'there is no parameter "plan.x"'),
    (lambda d: d.parameters.update({3: 1.0}), "parameters: found 3, expected the name of a parameter"),
    (lambda d: setattr(d.groups[0], "angle", math.nan), "angle"),
    (lambda d: setattr(d.groups[0], "count", -1), "groups[0]: count is -1, expected a number in [0, 200000]"),
    (lambda d: setattr(d.groups[0], "count", 0), "groups[0]: count is 0, expected at least 1 where no source sends people"),
]  # fmt: skip


@pytest.mark.parametrize("spoil, sentence", SENTENCES)
def test_what_is_wrong_is_named_by_one_sentence(spoil, sentence: str) -> None:
    definition = walkers(4)
    spoil(definition)
    with pytest.raises(muster.Error) as caught:
        muster.World(definition)
    assert sentence in str(caught.value)
    assert "\n" not in str(caught.value)
    assert caught.value.code in ("invalid argument", "not found")


def test_names_that_are_not_there_are_refused() -> None:
    with pytest.raises(TypeError, match="cuont"):
        muster.GroupDef(cuont=3)  # type: ignore[call-arg]
    with pytest.raises(AttributeError):
        muster.GroupDef().cuont = 3  # type: ignore[attr-defined]
    world = muster.World(walkers(3))
    with pytest.raises(muster.InvalidArgumentError, match="command: found 3, expected a command"):
        world.submit(3)  # type: ignore[arg-type]
    with pytest.raises(muster.InvalidArgumentError, match="position"):
        world.submit(muster.Touch("down", 1, (math.inf, 0.0)))
    with pytest.raises(TypeError, match="definition: found int"):
        muster.World(3)  # type: ignore[arg-type]


BAD_CALLS = [
    (lambda w, d: muster.World(d, -1), "threads: found -1, expected 1 to 256, or 0 for all cores"),
    (lambda w, d: muster.World(d, "two"), "threads: found 'two', expected a whole number"),
    (lambda w, d: w.step("x"), "count: found 'x', expected a whole number"),
    (lambda w, d: w.step(10**30), f"count: found {10**30}, expected a whole number from -9223372036854775808 to 9223372036854775807"),
    (lambda w, d: w.group("Red"), "group: found 'Red', expected a whole number"),
    (lambda w, d: w.submit(muster.ChangeGroup(1, count=2), client=-1), "client: found -1, expected a whole number from 0 to 4294967295"),
    (lambda w, d: w.submit(muster.Command(), step=3), "submit: found a Command and a step or client"),
    (lambda w, d: w.rewind("abc"), "snapshot: found 'abc', expected bytes"),
    (lambda w, d: muster.decode_command("abc"), "data: found 'abc', expected bytes"),
    (lambda w, d: muster.write_gestures([], 0.0), "step_time: found 0.0, expected a number above 0"),
    (lambda w, d: muster.write_gestures([3]), "commands[0]: found 3, expected a Command"),
    (lambda w, d: muster.load_scenario("/no/\udc80.json"), "cannot be opened"),
    (lambda w, d: w.forecast(1, 5), "order: found 5, expected an Order"),
]  # fmt: skip


@pytest.mark.parametrize("call, sentence", BAD_CALLS)
def test_bad_arguments_are_named(call, sentence: str) -> None:
    definition = walkers(4)
    with pytest.raises(muster.Error) as caught:
        call(muster.World(definition), definition)
    assert sentence in str(caught.value) and "\n" not in str(caught.value)


class Shrinking(list):
    """A list that loses its items while they are read."""

    def __init__(self) -> None:
        super().__init__()
        outer = self

        class Number:
            def __index__(self) -> int:
                outer.clear()
                return 1

        self.extend([Number(), *range(2, 50)])


def test_lists_that_change_while_they_are_read_do_no_harm() -> None:
    command = muster.Command(body=muster.TransferCharacters(Shrinking()))
    assert muster.decode_command(muster.encode_command(command)).body.ids == list(range(1, 50))


def test_a_definition_that_holds_itself_ends_in_a_sentence() -> None:
    definition = walkers(3)
    definition.groups.append(definition.groups)  # type: ignore[arg-type]
    with pytest.raises(muster.InvalidArgumentError, match=r"groups\[1\]"):
        muster.World(definition)


def test_makers_of_orders() -> None:
    line = muster.Order.move_to_line((0.0, 4.0), (0.0, -4.0))
    assert line.width == pytest.approx(8.0) and line.target == pytest.approx((0.0, 0.0)) and line.facing == pytest.approx(0.0)
    assert muster.Order.go((1.0, 2.0)).manner is muster.Manner.FREE
    assert muster.Order.follow_character(4, (1.0, 0.0)).character == 4
    assert muster.Order.guard((1.0, 1.0), (2.0, 3.0), 0.5).half_size == (2.0, 3.0)
