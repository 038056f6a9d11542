"""Worlds: steps, commands, orders, snapshots."""

from __future__ import annotations

import math
import pickle

import numpy as np
import pytest
from conftest import walkers

import muster


def test_time_is_steps_times_step_time() -> None:
    world = muster.World(muster.WorldDef(groups=[muster.GroupDef(count=4)], parameters={"time.step": 0.05}))
    world.step(7)
    world.step()
    world.step(0)
    assert world.step_count == 8
    assert world.time == pytest.approx(0.4)
    with pytest.raises(muster.InvalidArgumentError, match="count: found -1, expected 0 or more"):
        world.step(-1)


def test_one_character_walks_as_mechanics_say() -> None:
    """From rest to top speed v with acceleration a: after time t it is at v t - v^2 / (2 a) on a straight way."""
    speed, acceleration = 1.5, 3.0
    body = muster.Body(max_speed=speed, acceleration=acceleration)
    definition = walkers(1, bodies=[body], position=(-20.0, 0.0))
    definition.parameters = {"place.speed": 50.0}
    world = muster.World(definition)
    world.submit(muster.SetPose(1, (20.0, 0.0)))
    world.step(360)
    free = speed * world.time - speed**2 / (2.0 * acceleration)
    walked = world.characters.position[0, 0] + 20.0
    assert walked <= free + speed / 60.0
    assert walked >= 0.97 * free  # The controller comes near top speed from below.
    assert world.characters.position[0, 1] == pytest.approx(0.0, abs=1e-6)
    assert np.hypot(*world.characters.velocity[0]) == pytest.approx(speed, rel=1e-3)


def test_a_formation_marches_to_its_target_and_faces_as_ordered() -> None:
    world = muster.World(walkers(25))
    world.submit(muster.GiveOrder(group=1, order=muster.Order.move((12.0, -5.0), math.pi / 2)))
    world.step(60 * 25)
    assert world.characters.position.mean(axis=0) == pytest.approx([12.0, -5.0], abs=0.05)
    assert world.groups[0].position == pytest.approx((12.0, -5.0), abs=1e-6)
    assert world.groups[0].angle == pytest.approx(math.pi / 2)
    assert world.groups[0].mean_lag < 0.1


def test_events_tell_of_an_order_from_begin_to_end() -> None:
    world = muster.World(walkers(9))
    world.submit(muster.GiveOrder(1, order=muster.Order.go((5.0, 0.0))))
    kinds = []
    for _ in range(900):
        world.step()
        kinds += [event.kind for event in world.events if event.subject == 1]
    assert [k for k in kinds if k.name.startswith("ORDER")][:3] == ["orderGiven", "orderBegun", "orderDone"]
    assert muster.EventKind.ARRIVED in kinds


def test_lists_are_sorted_by_id() -> None:
    definition = walkers(6)
    definition.groups += [muster.GroupDef(count=3, position=(10.0, 0.0)), muster.GroupDef(count=4, position=(-10.0, 0.0))]
    definition.obstacles = [muster.ObstacleDef(centre=(x, 20.0), radius=1.0) for x in (5.0, -5.0, 0.0)]
    definition.items = [muster.ItemDef((1.0, 30.0)), muster.ItemDef((0.0, 30.0))]
    world = muster.World(definition)
    world.submit(muster.SplitGroup(1, muster.SplitBy.SHARES, shares=[1.0, 1.0]))
    world.submit(muster.RemoveThing(muster.ThingKind.OBSTACLE, 2))
    world.submit(muster.PutThing(obstacle=muster.ObstacleDef(centre=(-20.0, 20.0), radius=1.0)))
    world.submit(muster.RemoveGroup(2))
    world.step(2)
    assert [group.id for group in world.groups] == [1, 3, 4]
    assert [obstacle.id for obstacle in world.obstacles] == [1, 3, 4]
    assert [item.id for item in world.items] == [1, 2]
    assert np.all(np.diff(world.characters.id.astype(np.int64)) > 0)
    assert [int(g) for g in np.unique(world.characters.group)] == [0, 1, 2]
    for index, group in enumerate(world.groups):
        assert np.array_equal(np.flatnonzero(world.characters.group == index), group.members)


def test_a_group_that_has_ended_says_so() -> None:
    definition = walkers(3)
    definition.groups.append(muster.GroupDef(count=2, position=(9.0, 0.0)))
    world = muster.World(definition)
    group = world.group(2)
    world.submit(muster.RemoveGroup(2))
    world.step()
    with pytest.raises(muster.NotFoundError, match="group: found 2, expected the id of one of the world"):
        _ = group.count
    with pytest.raises(LookupError):
        world.group(99)


def test_commands_wait_for_their_step_and_are_numbered() -> None:
    world = muster.World(walkers(5))
    first = world.submit(muster.ChangeGroup(1, count=8), step=3)
    second = world.submit(muster.ChangeGroup(1, count=7), step=3)
    other = world.submit(muster.ChangeGroup(1, count=9), step=5, client=4)
    assert (first.step, first.sequence, second.sequence, other.sequence) == (3, 0, 1, 0)
    counts = []
    for _ in range(6):
        world.step()
        counts.append(len(world.characters))
    assert counts == [5, 5, 5, 7, 7, 9]
    with pytest.raises(muster.InvalidArgumentError, match="step"):
        world.submit(muster.ChangeGroup(1, count=8), step=2)


def test_what_cannot_be_applied_is_found_in_the_rejections() -> None:
    world = muster.World(walkers(5))
    command = world.submit(muster.RemoveThing("obstacle", 7))
    world.step()
    [rejection] = world.rejections
    assert rejection.command == command
    assert isinstance(rejection.error, muster.Error)
    assert "7" in str(rejection.error)
    world.step()
    assert world.rejections == []


def test_snapshots_continue_bit_for_bit() -> None:
    world = muster.World(walkers(20))
    world.submit(muster.GiveOrder(1, order=muster.Order.move((8.0, 3.0))))
    world.step(50)
    snapshot = world.snapshot()
    world.step(100)
    expected = world.hash()
    other = muster.World.restore(snapshot, threads=2)
    assert other.step_count == 50
    other.step(100)
    assert other.hash() == expected
    world.rewind(snapshot)
    world.step(100)
    assert world.hash() == expected
    with pytest.raises(muster.ParseError):
        muster.World.restore(b"nothing")
    with pytest.raises(muster.ParseError):
        world.rewind(snapshot[:-1])
    assert world.hash() == expected


def test_a_forecast_is_that_of_the_straight_way() -> None:
    world = muster.World(walkers(4))
    forecast = world.forecast(1, muster.Order.move((16.0, 0.0)))
    assert forecast.arrives
    assert forecast.way[-1] == pytest.approx((16.0, 0.0))
    assert forecast.seconds >= 16.0 / 2.0
    with pytest.raises(muster.NotFoundError):
        world.forecast(5, muster.Order.face(0.0))


def test_standings_tell_who_is_in_place_and_what_bars_the_others() -> None:
    world = muster.World(walkers(4))
    world.step(90)
    assert world.standings == [muster.Standing.IN_PLACE] * 4
    world.submit(muster.GiveOrder(1, order=muster.Order.move((12.0, 0.0))))
    world.step(30)
    assert world.standings == [muster.Standing.ON_THE_WAY] * 4


def test_the_way_ahead_goes_round_a_wall() -> None:
    definition = muster.WorldDef(box=((-20.0, -20.0), (20.0, 20.0)), groups=[muster.GroupDef(count=1, starts=[(-5.0, 0.0)], position=(5.0, 0.0))])
    definition.obstacles = [muster.ObstacleDef(polygon=[(-0.5, -6.0), (0.5, -6.0), (0.5, 6.0), (-0.5, 6.0)])]
    world = muster.World(definition)
    world.step()
    way = world.way_ahead(int(world.characters.id[0]))
    length = np.hypot(*np.diff(way, axis=0).T).sum()
    corner = 2.0 * math.hypot(4.5, 6.0) + 1.0  # Along the wall's corners without the body's radius.
    assert corner <= length <= 1.1 * corner
    with pytest.raises(muster.NotFoundError, match="character: found 77"):
        world.way_ahead(77)


def test_parameters_are_read_and_set() -> None:
    world = muster.World(walkers(2))
    table = {parameter.name: parameter for parameter in muster.parameter_table()}
    assert world.parameters == {name: parameter.default for name, parameter in table.items()}
    world.submit(muster.SetParameter("character.maxSpeed", 1.25))
    world.step()
    assert world.parameters["character.maxSpeed"] == 1.25
    assert set(muster.parameter_preset("paper")) <= set(table)
    assert muster.parameter_preset("muster") == {}


def test_failures_travel_between_processes() -> None:
    with pytest.raises(muster.NotFoundError) as caught:
        muster.parameter_preset("none")
    again = pickle.loads(pickle.dumps(caught.value))
    assert (type(again), str(again), again.code) == (muster.NotFoundError, str(caught.value), "not found")


def test_areas_are_read_with_what_they_have_seen() -> None:
    square = [(10.0, -2.0), (12.0, -2.0), (12.0, 2.0), (10.0, 2.0)]
    definition = walkers(6)
    definition.ring = True
    definition.areas = [
        muster.AreaDef(name="Door", polygon=square),
        muster.AreaDef(kind="source", polygon=square, rate=2.0, until=9.0, timetable=[muster.Arrivals(3.0, 4)]),
    ]
    world = muster.World(definition)
    assert world.ring
    assert [(area.id, area.group, area.passed) for area in world.areas] == [(1, 0, 0), (2, 1, 0)]
    assert world.areas[1].definition == definition.areas[1]
    world.submit(muster.PutThing(id=1, area=muster.AreaDef(name="Door", polygon=square, open=False)))
    world.submit(muster.PutThing(area=muster.AreaDef(kind=muster.AreaKind.WAITING, polygon=square)))
    world.submit(muster.RemoveThing("area", 2))
    world.step()
    assert [area.id for area in world.areas] == [1, 3]
    assert not world.areas[0].definition.open
    assert world.areas[1].definition.kind == muster.AreaKind.WAITING
    assert not world.rejections
    world.submit(muster.ChangeGroup(group=1, people=[muster.adults()]))
    world.step()
    assert world.groups[0].definition.people == [muster.adults()]


def test_orders_without_places_are_made_by_name() -> None:
    leave = muster.Order.leave([2, 3])
    assert leave.kind == muster.OrderKind.LEAVE and leave.exits == [2, 3]
    assert muster.Order.leave().exits == []
    wait = muster.Order.wait(4, 30.0)
    assert (wait.kind, wait.area, wait.seconds) == (muster.OrderKind.WAIT, 4, 30.0)
    walk = muster.Order.walk(0.5)
    assert (walk.kind, walk.facing) == (muster.OrderKind.WALK, 0.5)
    with pytest.raises(muster.InvalidArgumentError, match="no waiting area"):
        muster.validate_command(muster.Command(body=muster.GiveOrder(1, order=muster.Order(kind="wait"))))


def test_people_are_adults_or_what_one_says() -> None:
    adults = muster.adults()
    assert adults.speed == muster.Distribution.normal(1.34, 0.26, 0.5, 2.2)
    assert adults.speed.quantile(0.5) == pytest.approx(1.34, abs=0.01)
    assert adults.speed.quantile(0.1587) == pytest.approx(1.34 - 0.26, abs=0.01)
    assert muster.Distribution.uniform(10.0, 100.0).quantile(0.25) == pytest.approx(32.5)
    assert muster.Distribution.constant(2.0).quantile(0.9) == 2.0
    assert muster.walking_speed_at_age(20.0) == pytest.approx(1.62)
    with pytest.raises(muster.InvalidArgumentError, match="share: found 1"):
        adults.speed.quantile(1.0)
    definition = walkers(4)
    definition.groups[0].people = [muster.PeopleDef(name="Slow", speed=muster.Distribution.constant(0.6))]
    text = muster.write_scenario(definition)
    assert muster.parse_scenario(text).groups[0].people == definition.groups[0].people
