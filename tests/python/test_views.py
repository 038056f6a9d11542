"""Arrays without a copy: whose memory they are, and what becomes of them."""

from __future__ import annotations

import gc

import numpy as np
import pytest
from conftest import walkers

import muster
from muster import _core

ARRAYS = {
    "id": (np.uint32, ()),
    "group": (np.uint32, ()),
    "position": (np.float64, (2,)),
    "velocity": (np.float64, (2,)),
    "heading": (np.float64, (2,)),
    "place": (np.int32, ()),
    "direction": (np.float64, (2,)),
    "cost": (np.float64, ()),
    "motion": (np.int32, ()),
    "phase": (np.uint8, ()),
    "motion_time": (np.float64, ()),
    "patch": (np.uint32, ()),
    "driver": (np.uint8, ()),
    "wanted_velocity": (np.float64, (2,)),
    "goal": (np.uint32, ()),
}


@pytest.fixture
def world() -> muster.World:
    world = muster.World(walkers(30, bodies=[muster.Body(radius=0.2, mass=3.0, unit_class=5)]))
    world.submit(muster.GiveOrder(1, order=muster.Order.move((9.0, 0.0))))
    world.step(30)
    return world


def test_arrays_are_the_engines_own_and_read_only(world: muster.World) -> None:
    for name, (kind, inner) in ARRAYS.items():
        first, second = getattr(world.characters, name), getattr(world.characters, name)
        assert first.dtype == kind and first.shape == (30, *inner), name
        assert np.shares_memory(first, second) and first.ctypes.data == second.ctypes.data, name
        assert not first.flags.owndata and not first.flags.writeable, name
        with pytest.raises(ValueError):
            first[0] = 0
        with pytest.raises(ValueError):
            first.setflags(write=True)


def test_records_have_the_fields_of_their_structs(world: muster.World) -> None:
    body = world.characters.body
    assert body.dtype.names == tuple(muster.Body.__dataclass_fields__)
    assert np.all(body["radius"] == 0.2) and np.all(body["mass"] == 3.0) and np.all(body["unit_class"] == 5)
    group = world.groups[0]
    points = group.mesh_places
    corners = group.final_mesh[group.triangles[points["triangle"]]]
    places = (corners * points["weight"][:, :, None]).sum(axis=1)
    # The place travels to its point of the mesh; in the open it is reachable.
    assert np.allclose(places, group.place_targets, atol=0.3)


def test_a_view_keeps_its_world(world: muster.World) -> None:
    position = world.characters.position
    before = position.copy()
    del world
    gc.collect()
    filling = [np.full(60, -1.0) for _ in range(200)]  # Would lie where freed memory was.
    assert np.array_equal(position, before) and len(filling) == 200


def test_a_view_shows_the_present_while_the_engine_keeps_the_array(world: muster.World) -> None:
    position = world.characters.position
    before = position.copy()
    world.step(10)
    now = world.characters.position
    assert not np.array_equal(now, before)
    assert np.array_equal(position, now if position.ctypes.data == now.ctypes.data else before)


def test_views_of_arrays_that_are_gone_stay_readable() -> None:
    world = muster.World(walkers(200))
    kept = _core.kept_blocks()
    views = [getattr(world.characters, name) for name in ("position", "velocity", "cost", "id")]
    group_views = [world.groups[0].place_positions, world.groups[0].final_mesh]
    part = views[0][100:, 1]
    snapshot = world.snapshot()
    world.submit(muster.ChangeGroup(1, count=2000))
    world.step()
    assert len(world.characters) == 2000 and len(views[0]) == 200
    assert _core.kept_blocks() > kept  # The arrays grew, and the old ones are looked at.
    world.rewind(snapshot)
    world.submit(muster.RemoveGroup(1))
    world.step()
    assert len(world.characters) == 0
    for view in [*views, *group_views, part]:
        assert np.isfinite(view[np.isfinite(view)].sum())
    del world, views, group_views, view
    gc.collect()
    assert part.sum() == part.sum()  # One slice is enough to keep its block.
    assert _core.kept_blocks() <= kept + 1
    del part
    gc.collect()
    assert _core.kept_blocks() == kept


def test_many_views_and_many_worlds_leave_nothing_behind() -> None:
    kept = _core.kept_blocks()
    views = []
    for round in range(40):
        world = muster.World(walkers(1 + 37 * round % 90))
        for count in (5, 120, 2):
            world.submit(muster.ChangeGroup(1, count=count))
            views.append(world.characters.position)
            world.step()
            views.append(world.groups[0].place_positions)
        if round % 3 == 0:
            del views[::2]
    assert all(np.all(np.isfinite(view)) for view in views)
    views.clear()
    del world
    gc.collect()
    assert _core.kept_blocks() == kept


def test_an_empty_world_has_empty_arrays() -> None:
    world = muster.World(muster.WorldDef())
    world.step()
    assert world.characters.position.shape == (0, 2)
    assert world.characters.body.shape == (0,)
    assert len(world.characters) == 0 and world.groups == []
