// What a formation needs of its way, and what a metre of a way costs it.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/orders/held_spot.h"
#include "muster/vec2.h"

namespace muster {

/// The room that a formation needs.
struct WayNeeds {
    double half = 0.0;           ///< Half its width [m].
    double margin = 0.0;         ///< Keeps so much farther from obstacles where that costs little [m].
    double least = 0.0;          ///< Share of its width below which it does not narrow, [0, 1].
    double radius = 0.25;        ///< Radius of bodies [m].
    bool flows = false;          ///< Places flow where it is narrower: that costs no more than a margin.
    std::vector<HeldSpot> held;  ///< Those through whom nobody goes.

    /// Cost of a metre of a way with so much room to both sides [m]; infinite where nobody passes.
    double cost(double clearance) const;

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(half, margin, least, radius, flows, held);
    }
    friend bool operator==(const WayNeeds&, const WayNeeds&) = default;
};

/// A search for a way from one point to another.
struct WayQuery {
    Vec2 from;       ///< [m]
    Vec2 to;         ///< [m]
    WayNeeds needs;  ///< Of the formation.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(from, to, needs);
    }
    friend bool operator==(const WayQuery&, const WayQuery&) = default;
};

}  // namespace muster
