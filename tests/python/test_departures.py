"""Figures of people who leave by exits and come by sources."""

from __future__ import annotations

import muster


def test_play_tells_who_left_and_who_came() -> None:
    guests = muster.GroupDef(name="Guests", count=9, orders=[muster.Order.leave()])
    door = muster.AreaDef(name="Door", polygon=[(9.0, -1.0), (10.0, -1.0), (10.0, 1.0), (9.0, 1.0)])
    stop = muster.AreaDef(kind="source", polygon=[(-9.0, 5.0), (-6.0, 5.0), (-6.0, 8.0), (-9.0, 8.0)], group=0)
    stop.timetable = [muster.Arrivals(time=1.0, count=3)]
    figures = muster.play(muster.WorldDef(groups=[guests], areas=[door, stop]))
    departures = figures.departures
    assert departures.left == 12 and figures.characters == 0
    assert 0.0 < departures.first < departures.left50 < departures.left95 <= departures.last == figures.arrived100
    assert figures.steps < 60 * 60
    (exit,) = departures.exits
    assert (exit.id, exit.name, exit.left, exit.last) == (1, "Door", 12, departures.last)
    assert exit.flow == (exit.left - 1) / (exit.last - exit.first)
    (source,) = departures.sources
    assert (source.id, source.entered, source.waiting) == (2, 3, 0)
