"""Floor plans from GeoJSON."""

from __future__ import annotations

import json
from typing import Any

import pytest

import muster

METRES = {"type": "name", "properties": {"name": "metres"}}


def feature(kind: str, coordinates: Any, **properties: Any) -> dict[str, Any]:
    return {"type": "Feature", "properties": properties, "geometry": {"type": kind, "coordinates": coordinates}}


def collection(*features: dict[str, Any], **more: Any) -> dict[str, Any]:
    return {"type": "FeatureCollection", "crs": METRES, "features": list(features), **more}


def square(x: float, y: float, size: float) -> list[list[list[float]]]:
    return [[[x, y], [x + size, y], [x + size, y + size], [x, y + size], [x, y]]]


def bounds(obstacle: muster.ObstacleDef) -> list[float]:
    xs, ys = zip(*obstacle.polygon)
    return [min(xs), min(ys), max(xs), max(ys)]


def test_walls_are_as_wide_as_told_and_leave_gaps_as_drawn() -> None:
    north = feature("LineString", [[0, 0], [4, 0]], name="West of the door")
    angle = feature("LineString", [[5, 0], [10, 0], [10, 5]])
    plan = muster.parse_floor_plan(collection(north, angle), wall_width=0.4)
    assert [wall.name for wall in plan.obstacles] == ["West of the door", "", ""]
    assert bounds(plan.obstacles[0]) == pytest.approx([0, -0.2, 4, 0.2])
    # The corner is closed, and the ends are where they were drawn.
    assert bounds(plan.obstacles[1]) == pytest.approx([5, -0.2, 10.2, 0.2])
    assert bounds(plan.obstacles[2]) == pytest.approx([9.8, -0.2, 10.2, 5])
    assert plan.box[1] == pytest.approx((10.2, 5.0))


def test_a_closed_line_leaves_no_gap() -> None:
    plan = muster.parse_floor_plan(collection(feature("LineString", square(0, 0, 10)[0])), wall_width=0.2)
    assert [bounds(wall) for wall in plan.obstacles][0] == pytest.approx([-0.1, -0.1, 10.1, 0.1])
    assert len(plan.obstacles) == 4
    assert bounds(plan.obstacles[3]) == pytest.approx([-0.1, -0.1, 0.1, 10.1])


def test_polygons_are_obstacles_areas_and_rooms() -> None:
    plan = muster.parse_floor_plan(
        collection(
            feature("Polygon", square(0, 0, 1), name="Desk", height=0.8),
            feature("MultiPolygon", [square(3, 0, 1), square(5, 0, 1)]),
            feature("Polygon", square(200, 0, 2), place="exit", name="East", rate=1.5, open=False),
            feature("Polygon", square(0, 20, 9), place="room", name="Hall", people=60),
            feature("Point", [0, 0]),
        )
    )
    assert [(one.name, one.height) for one in plan.obstacles] == [("Desk", 0.8), ("", 3.0), ("", 3.0)]
    [east] = plan.areas
    assert (east.kind, east.name, east.rate, east.open) == (muster.AreaKind.EXIT, "East", 1.5, False)
    assert east.polygon == [(200, 0), (202, 0), (202, 2), (200, 2)]
    assert plan.rooms["Hall"].people == 60
    assert plan.box == ((0.0, 0.0), (202.0, 29.0))


def test_people_leave_by_the_exit_of_a_plan() -> None:
    outside = feature("LineString", [[9, 0], [0, 0], [0, 6], [9, 6]])
    door = [feature("LineString", [[9, 0], [9, 2.5]]), feature("LineString", [[9, 3.5], [9, 6]])]
    way_out = feature("Polygon", square(9.5, 2.0, 2), place="exit", name="Door")
    plan = muster.parse_floor_plan(collection(outside, *door, way_out))
    guests = muster.GroupDef(count=12, position=(4.0, 3.0), people=[muster.adults()], orders=[muster.Order.leave()])
    definition = muster.WorldDef(box=plan.box, obstacles=plan.obstacles, areas=plan.areas, groups=[guests])
    definition.parameters = muster.parameter_preset("people")
    world = muster.World(definition)
    for _ in range(30):
        world.step(60)
    assert (world.areas[0].passed, len(world.characters.id)) == (12, 0)


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        ('{"type": ', "floor plan: Expecting value"),
        ({"type": "FeatureCollection", "crs": METRES, "features": [None, {"type": "Feature", "geometry": None}]}, "found no lines"),
        (collection(feature("LineString", [[0, 0], [0, "a"]])), r"\$.features\[0\].geometry.coordinates\[1\]: found .*expected two numbers"),
        (collection(feature("LineString", [[0, 0], [0, 0]])), "found 1 points, expected 2 or more"),
        (collection(feature("Polygon", square(0, 0, 9) + square(1, 1, 2))), "found 1 holes, expected one outline"),
        (collection(feature("Polygon", square(0, 0, 9), place="kitchen")), "found the place 'kitchen', expected room, exit, source or waiting"),
        (collection(feature("Polygon", square(0, 0, 9), place="room")), "found the name '', expected one that no other room has"),
        (collection(feature("Polygon", square(13.4, 52.5, 0.001)), crs=None), "found longitudes and latitudes, expected metres"),
    ],
)
def test_what_is_wrong_gets_one_sentence(content: Any, sentence: str) -> None:
    with pytest.raises(muster.ParseError, match=sentence):
        muster.parse_floor_plan(content)


def test_files_are_read_and_named_in_failures(tmp_path) -> None:
    path = tmp_path / "house.geojson"
    path.write_text(json.dumps(collection(feature("Polygon", square(0, 0, 1)))))
    assert muster.load_floor_plan(path).box == ((0.0, 0.0), (1.0, 1.0))
    path.write_text("[]")
    with pytest.raises(muster.ParseError, match="house.geojson: "):
        muster.load_floor_plan(path)
    with pytest.raises(muster.IoError, match="none.geojson: "):
        muster.load_floor_plan(tmp_path / "none.geojson")
