"""Floor plans: GeoJSON in metres as obstacles, areas and rooms.

    import muster

    plan = muster.load_floor_plan("building.geojson")
    definition = muster.WorldDef(box=plan.box, obstacles=plan.obstacles, areas=plan.areas)

Lines are walls, polygons are obstacles. A polygon with the property `place` is ground instead: "room", or an area by the word of its
kind ("exit", "source", "waiting"). The studio opens the same files, and takes their walls and obstacles.
"""

from __future__ import annotations

import json
import math
import os
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Iterator, Mapping

from ._types import AreaDef, AreaKind, ObstacleDef, Vec2
from .errors import IoError, ParseError
from .scenario import PathLike

_KINDS = [kind.value for kind in AreaKind]
_DEGREES = re.compile(r"CRS84|EPSG:*(4326|4258)$", re.IGNORECASE)


@dataclass(slots=True)
class Room:
    """Ground of a floor plan that has a name.

    Attributes:
        name: Its name.
        polygon: Its corners [m].
        people: How many the plan says are in it; 0 where it says nothing.
    """

    name: str
    polygon: list[Vec2]
    people: int = 0


@dataclass(slots=True)
class FloorPlan:
    """What a floor plan holds. Coordinates are those of the file.

    Attributes:
        box: The least box round all that is in it: lower left and upper right corner [m].
        obstacles: Walls and other obstacles, by the names of the file; a line has one for each of its stretches.
        areas: Exits, sources and waiting areas.
        rooms: Rooms by their names.
    """

    box: tuple[Vec2, Vec2] = ((0.0, 0.0), (0.0, 0.0))
    obstacles: list[ObstacleDef] = field(default_factory=list)
    areas: list[AreaDef] = field(default_factory=list)
    rooms: dict[str, Room] = field(default_factory=dict)


def load_floor_plan(path: PathLike, *, wall_width: float = 0.2) -> FloorPlan:
    """Reads a floor plan from GeoJSON in metres; lines are walls of that width [m].

    Fails with IoError, or with ParseError: `FILE: PLACE: found X, expected Y`. Longitudes and latitudes are refused: a file whose
    numbers could be such has to name another coordinate system under `crs`.
    """
    try:
        text = Path(path).read_text(encoding="utf-8")
    except OSError as error:
        raise IoError(f"{os.fspath(path)}: {error.strerror}") from error
    return parse_floor_plan(text, wall_width=wall_width, source_name=os.fspath(path))


def parse_floor_plan(content: str | Mapping[str, Any], *, wall_width: float = 0.2, source_name: str = "floor plan") -> FloorPlan:
    """The same from the text of a file, or from its content as a dict."""
    try:
        root = json.loads(content) if isinstance(content, str) else content
        return _plan_of(root, wall_width)
    except (json.JSONDecodeError, UnicodeDecodeError) as error:
        raise ParseError(f"{source_name}: {error}") from error
    except ParseError as error:
        raise ParseError(f"{source_name}: {error}") from None


def _plan_of(root: Any, wall_width: float) -> FloorPlan:
    plan = FloorPlan()
    for where, geometry, properties in _shapes(root, "$", {}):
        if geometry["type"] == "LineString":
            line = _points(geometry.get("coordinates"), f"{where}.coordinates", 2)
            plan.obstacles += [_obstacle(wall, properties) for wall in _walls(line, wall_width)]
        else:
            _add_polygon(plan, _outline(geometry, where), properties, where)
    plan.box = _box_of(plan)
    _refuse_degrees(root, plan.box)
    return plan


def _box_of(plan: FloorPlan) -> tuple[Vec2, Vec2]:
    outlines = [one.polygon for one in plan.obstacles] + [one.polygon for one in plan.areas] + [one.polygon for one in plan.rooms.values()]
    corners = [corner for outline in outlines for corner in outline]
    if not corners:
        raise ParseError("$: found no lines and no polygons, expected a floor plan")
    xs, ys = zip(*corners)
    return (min(xs), min(ys)), (max(xs), max(ys))


def _shapes(node: Any, where: str, properties: Mapping[str, Any]) -> Iterator[tuple[str, Mapping[str, Any], Mapping[str, Any]]]:
    """Every line and polygon with its place in the file and its properties."""
    if not isinstance(node, Mapping):
        return
    kind = node.get("type")
    if kind == "FeatureCollection":
        for i, feature in enumerate(node.get("features") or []):
            yield from _shapes(feature, f"{where}.features[{i}]", {})
    elif kind == "Feature":
        yield from _shapes(node.get("geometry"), f"{where}.geometry", node.get("properties") or {})
    elif kind == "GeometryCollection":
        for i, one in enumerate(node.get("geometries") or []):
            yield from _shapes(one, f"{where}.geometries[{i}]", properties)
    elif kind in ("MultiPolygon", "MultiLineString"):
        for i, one in enumerate(node.get("coordinates") or []):
            yield f"{where}[{i}]", {"type": kind.removeprefix("Multi"), "coordinates": one}, properties
    elif kind in ("Polygon", "LineString"):
        yield where, node, properties


def _points(given: Any, where: str, least: int) -> list[Vec2]:
    points: list[Vec2] = []
    for i, one in enumerate(given if isinstance(given, list) else []):
        pair = one[:2] if isinstance(one, (list, tuple)) else []
        if len(pair) < 2 or not all(isinstance(v, (int, float)) and math.isfinite(v) for v in pair):
            raise ParseError(f"{where}[{i}]: found {one!r:.80}, expected two numbers")
        point = (float(pair[0]), float(pair[1]))
        if not points or point != points[-1]:
            points.append(point)
    if len(points) < least:
        raise ParseError(f"{where}: found {len(points)} points, expected {least} or more")
    return points


def _outline(geometry: Mapping[str, Any], where: str) -> list[Vec2]:
    rings = geometry.get("coordinates")
    if not isinstance(rings, list) or len(rings) != 1:
        found = len(rings) - 1 if isinstance(rings, list) and rings else "no outline"
        raise ParseError(f"{where}.coordinates: found {found} holes, expected one outline; draw what has holes as lines")
    points = _points(rings[0], f"{where}.coordinates[0]", 4)
    return points[:-1] if points[0] == points[-1] else points


def _obstacle(polygon: list[Vec2], properties: Mapping[str, Any]) -> ObstacleDef:
    height = properties.get("height")
    usual = ObstacleDef().height
    return ObstacleDef(name=_name(properties), polygon=polygon, height=float(height) if isinstance(height, (int, float)) else usual)


def _name(properties: Mapping[str, Any]) -> str:
    name = properties.get("name")
    return name if isinstance(name, str) else ""


def _add_polygon(plan: FloorPlan, polygon: list[Vec2], properties: Mapping[str, Any], where: str) -> None:
    place = properties.get("place")
    if place is None:
        plan.obstacles.append(_obstacle(polygon, properties))
    elif place == "room":
        name = _name(properties)
        if not name or name in plan.rooms:
            raise ParseError(f"{where}: found the name {name!r}, expected one that no other room has")
        plan.rooms[name] = Room(name, polygon, int(properties.get("people") or 0))
    elif place in _KINDS:
        area = AreaDef(name=_name(properties), kind=AreaKind(place), polygon=polygon)
        area.open = bool(properties.get("open", area.open))
        area.rate = float(properties.get("rate", area.rate))
        plan.areas.append(area)
    else:
        raise ParseError(f"{where}: found the place {place!r:.80}, expected room, {', '.join(_KINDS[:-1])} or {_KINDS[-1]}")


def _walls(line: list[Vec2], width: float) -> Iterator[list[Vec2]]:
    """One rectangle for each stretch. Corners are closed; at its ends a wall is as long as its line, so that gaps are as drawn."""
    closed = line[0] == line[-1]
    for i, ((ax, ay), (bx, by)) in enumerate(zip(line, line[1:])):
        half = 0.5 * width / math.hypot(bx - ax, by - ay)
        x, y = half * (bx - ax), half * (by - ay)
        before = 1.0 if closed or i > 0 else 0.0
        after = 1.0 if closed or i + 2 < len(line) else 0.0
        ax, ay, bx, by = ax - before * x, ay - before * y, bx + after * x, by + after * y
        yield [(ax + y, ay - x), (bx + y, by - x), (bx - y, by + x), (ax - y, ay + x)]


def _refuse_degrees(root: Mapping[str, Any], box: tuple[Vec2, Vec2]) -> None:
    """By RFC 7946 coordinates are longitudes and latitudes unless the file says otherwise."""
    crs = root.get("crs")
    properties = crs.get("properties") if isinstance(crs, Mapping) else None
    name = properties.get("name") if isinstance(properties, Mapping) else None
    told = isinstance(name, str) and not _DEGREES.search(name)
    (left, low), (right, high) = box
    if not told and left >= -180.0 and right <= 180.0 and low >= -90.0 and high <= 90.0:
        raise ParseError('$.crs: found longitudes and latitudes, expected metres; {"properties": {"name": "metres"}} says that they are')
