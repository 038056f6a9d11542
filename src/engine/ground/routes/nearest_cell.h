// The cell at which a point enters the graph of routes.
#pragma once

#include <optional>

#include "engine/ground/routes/route_graph.h"

namespace muster {

/// The anchor of `p`: the cell of `p`, or one of its neighbours, to whose stand point the line is clear;
/// where none is, the nearest one. `componentOf(cell, tile)` gives the component of a cell of the grid, -1
/// for none, and its tile.
template <class ComponentOf>
std::optional<RouteAnchor> anchorOf(const RouteGround& ground, Vec2 p, const ComponentOf& componentOf) {
    const Grid& grid = ground.grid();
    const Cell at = grid.nearestCell(p);
    std::optional<RouteAnchor> best;
    double least = 0.0;
    bool bestClear = false;
    const auto look = [&](Cell c) {
        if (!grid.contains(c)) return;
        RouteAnchor anchor;
        anchor.cell = c;
        anchor.component = componentOf(c, anchor.tile);
        if (anchor.component < 0) return;
        const std::optional<Vec2> point = ground.standPoint(c);
        if (!point) return;
        anchor.point = *point;
        const double squared = lengthSquared(*point - p);
        if (best && bestClear && squared >= least) return;
        const bool clear = ground.lineClear(p, *point);
        if (best && (clear != bestClear ? bestClear : squared >= least)) return;
        best = anchor;
        least = squared;
        bestClear = clear;
    };
    look(at);
    if (bestClear) return best;
    for (std::int32_t d = 0; d < kDirections; ++d) look({at.x + kOffsets[d].x, at.y + kOffsets[d].y});
    return best;
}

}  // namespace muster
