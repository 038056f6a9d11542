// Ground of an agent that holds its ground: others go round it.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "base/cell_list.h"
#include "engine/geometry/polygon.h"
#include "muster/vec2.h"

namespace muster {

/// Distance that an agent keeps when it passes one that holds its ground [m].
inline constexpr double kHeldMargin = 0.12;

/// An agent that holds its ground.
struct HeldSpot {
    Vec2 position;        ///< [m]
    double radius = 0.0;  ///< Radius of the body and the distance kept to it [m].

    /// Lets an archive read or write the spot.
    template <class Archive>
    void visit(Archive& archive) {
        archive(position, radius);
    }
    friend bool operator==(const HeldSpot&, const HeldSpot&) = default;
};

/// True where a body of `radius` [m] goes from `a` to `b` [m] without touching an agent that holds its
/// ground.
inline bool clearOf(std::span<const HeldSpot> held, Vec2 a, Vec2 b, double radius) {
    return std::none_of(held.begin(), held.end(), [&](const HeldSpot& spot) {
        const double apart = spot.radius + radius;
        return lengthSquared(closestOnSegment(a, b, spot.position) - spot.position) < apart * apart;
    });
}

/// Agents that hold their ground, by position. Owns its memory and reuses it.
class HeldGround {
public:
    /// Refers to `held` from now on. `most` is the largest clearance that will be asked for [m].
    void reset(std::span<const HeldSpot> held, double most) {
        held_ = held;
        centres_.clear();
        double reach = most;
        for (const HeldSpot& spot : held) {
            centres_.push_back(spot.position);
            reach = std::max(reach, most + spot.radius);
        }
        reach_ = reach;
        cells_.sort(centres_, reach);
    }
    /// The room at `p`, where `clearance` is the room without agents that hold their ground [m].
    double clearanceAt(Vec2 p, double clearance) const {
        if (held_.empty() || !cells_.grid().box().grown(reach_).contains(p)) return clearance;
        constexpr double kRounding = 1e-9;  // Rounding error of a distance [m].
        cells_.anyBeside(p, [&](std::int32_t i) {
            const HeldSpot& spot = held_[static_cast<std::size_t>(i)];
            const double reach = std::max(0.0, clearance + spot.radius + kRounding);
            if (lengthSquared(p - spot.position) < reach * reach)
                clearance = std::min(clearance, distance(p, spot.position) - spot.radius);
            return false;
        });
        return clearance;
    }

private:
    std::span<const HeldSpot> held_;
    double reach_ = 0.0;  // Reach of the cells [m].
    std::vector<Vec2> centres_;
    CellList cells_;
};

}  // namespace muster
