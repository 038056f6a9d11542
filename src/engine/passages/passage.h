// Passages: gaps between obstacles that let a limited number of people a second through.
#pragma once

#include <optional>
#include <span>

#include "engine/ground/environment/environment.h"
#include "muster/vec2.h"

namespace muster {

/// The narrowest gap between two obstacles, or between an obstacle and the edge of the world.
struct Passage {
    Vec2 a, b;           ///< Its ends, on the surfaces of the two obstacles [m].
    double speed = 1.0;  ///< Travel speed of the ground in it, relative to running, above 0.
    double left = 0.0;   ///< Depth of the narrows to the left of the line from `a` to `b` [m].
    double right = 0.0;  ///< Depth of the narrows to the right [m].
    double pace = 1.0;   ///< Share of the nominal flow that gets through, above 0.

    double width() const { return distance(a, b); }  ///< Clear width [m].
    /// Capacity [1/s], where specificFlow() gives `flow` [1/(s m)].
    double capacity(double flow) const { return flow * throughput(); }
    double throughput() const { return width() * speed * pace; }  ///< Clear width at full flow [m].
    Vec2 middle() const { return 0.5 * (a + b); }                 ///< Middle of the line from `a` to `b` [m].
    /// Positive on the left of the line from `a` to `b`, negative on the right.
    double leftOf(Vec2 p) const { return cross(b - a, p - a); }
    /// True on the left; points on the line, within rounding, count as left.
    bool onLeft(Vec2 p) const { return leftOf(p) > -1e-6 * width(); }

    /// Lets an archive read or write the passage.
    template <class Archive>
    void visit(Archive& archive) {
        archive(a, b, speed, left, right, pace);
    }
};

/// The passage of least capacity on a path, given by points at most a cell apart; among nearly equal ones the
/// first. None where no obstacle or edge of the world lies within 3 m of the path. Moving obstacles do not
/// count. Its ends are the nearest points of the two surfaces, exactly, where these face each other across
/// the path. With `thin`, gaps in walls thinner than the steps of the path count as well, which no ray from
/// its points meets on both sides.
std::optional<Passage> narrowestPassage(const Environment& environment, std::span<const Vec2> way,
                                        bool thin = false);

}  // namespace muster
