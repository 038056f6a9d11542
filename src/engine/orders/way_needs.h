// Requirements of a formation on its route, and the cost of a metre of a route.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/orders/held_spot.h"
#include "muster/vec2.h"

namespace muster {

/// The room that a formation needs.
struct WayNeeds {
    double half = 0.0;     ///< Half its width [m].
    double margin = 0.0;   ///< Further distance to obstacles that it keeps where that costs little [m].
    double least = 0.0;    ///< Share of its width below which it does not narrow, [0, 1].
    double radius = 0.25;  ///< Radius of bodies [m].
    /// True if places flow through narrow ground, which then costs no more than a margin.
    bool flows = false;
    std::vector<HeldSpot> held;  ///< Agents that hold their ground, through which nobody goes.

    /// Cost of a metre of a route with this room to both sides [m]; infinite where nobody passes.
    double cost(double clearance) const;

    /// Lets an archive read or write the needs.
    template <class Archive>
    void visit(Archive& archive) {
        archive(half, margin, least, radius, flows, held);
    }
    friend bool operator==(const WayNeeds&, const WayNeeds&) = default;
};

/// A search for a route from one point to another.
struct WayQuery {
    Vec2 from;       ///< [m]
    Vec2 to;         ///< [m]
    WayNeeds needs;  ///< Needs of the formation.

    /// Lets an archive read or write the query.
    template <class Archive>
    void visit(Archive& archive) {
        archive(from, to, needs);
    }
    friend bool operator==(const WayQuery&, const WayQuery&) = default;
};

}  // namespace muster
