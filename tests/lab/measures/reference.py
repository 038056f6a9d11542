#!/usr/bin/env python3
"""Prints the numbers of reference_test.cpp: measures of twelve persons by PedPy's definitions, computed by SciPy and Shapely.

PedPy itself is used instead of them where it is installed. Needs python3-scipy and python3-shapely.
"""

import math

import numpy as np
from scipy.spatial import Voronoi
from shapely.geometry import LineString, Point, Polygon

FPS, FRAMES, PERSONS = 10.0, 40, 12
WALKABLE = Polygon(
    [(0, 0), (8, 0), (8, 3), (5, 3), (5, 4), (8, 4), (8, 6), (0, 6)],
    [[(3.0, 2.0), (3.0, 2.4), (4.0, 2.4), (4.0, 2.0)]],
)
AREA = Polygon([(2.0, 1.0), (6.5, 1.0), (6.5, 5.0), (2.0, 5.0)])
LINE = LineString([(4.5, 0.0), (4.5, 6.0)])
RADIUS, QUAD = 1.2, 3
STEP = 5


def position(person, frame):
    """As positionOf() in the test: back and forth, at speeds of their own."""
    t = frame / FPS
    x = 0.6 + 0.5 * (person % 4) + (0.9 + 0.05 * person) * t + 0.2 * math.sin(1.3 * t + person)
    y = 0.5 + 0.46 * person + 0.15 * math.cos(0.7 * t + 2.0 * person)
    return x, y


def inside(p):
    return WALKABLE.contains(Point(p))


def cells(points):
    low_x, low_y, high_x, high_y = WALKABLE.bounds
    far = 100 * max(high_x - low_x, high_y - low_y)
    blind = [(-far, -far), (far, -far), (-far, far), (far, far)]
    voronoi = Voronoi(np.array(list(points) + blind))
    for i, p in enumerate(points):
        region = voronoi.regions[voronoi.point_region[i]]
        assert -1 not in region
        cell = Polygon(voronoi.vertices[region]).convex_hull.intersection(WALKABLE)
        cell = cell.intersection(Point(p).buffer(RADIUS, QUAD))
        if cell.geom_type != "Polygon":
            cell = next(part for part in cell.geoms if part.intersects(Point(p)))
        yield cell


def speed(person, frame):
    here = [f for f in range(FRAMES) if inside(position(person, f))]
    first, last = here[0], here[-1]
    both = min(STEP, frame - first, last - frame)
    if both == 0:
        return math.nan
    (ax, ay), (bx, by) = position(person, frame - both), position(person, frame + both)
    return math.hypot(bx - ax, by - ay) / (2 * both / FPS)


def main():
    for frame in (0, 13, 27):
        present = [i for i in range(PERSONS) if inside(position(i, frame))]
        points = [position(i, frame) for i in present]
        density = velocity = 0.0
        for i, cell in zip(present, cells(points)):
            shared = cell.intersection(AREA).area
            density += shared / cell.area
            v = speed(i, frame)
            velocity += 0.0 if math.isnan(v) else v * shared
        classic = sum(AREA.contains(Point(p)) for p in points) / AREA.area
        print(frame, len(present), f"{classic:.12f} {density / AREA.area:.12f} {velocity / AREA.area:.12f}")
    crossed = {}
    for i in range(PERSONS):
        for f in range(1, FRAMES):
            a, b = position(i, f - 1), position(i, f)
            if inside(a) and inside(b) and LineString([a, b]).intersects(LINE) and b[0] != 4.5:
                crossed.setdefault(i, f)
    print("first crossings", sorted((f, i) for i, f in crossed.items()))


main()
