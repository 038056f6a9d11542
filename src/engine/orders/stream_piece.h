// A march in one piece: a formation keeps its shape and goes through poses, as one that wheels, reverses or
// keeps its heading.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "muster/order.h"

namespace muster {

/// The pose of a formation that keeps its shape, as a function of a number q from 0 to 1. Owns its memory.
class StreamPiece {
public:
    /// Takes the poses of the march; `reach` is the greatest distance of its places from its middle [m].
    void start(std::span<const Pose> poses, double reach);
    /// True where it has no poses.
    bool empty() const { return poses_.empty(); }
    /// Upper bound of the length of the path of a place [m].
    double length() const { return done_.empty() ? 0.0 : done_.back(); }
    /// The pose at `q`.
    Pose at(double q) const;

private:
    std::vector<Pose> poses_;
    std::vector<double> done_;  // Greatest length of a place's path up to each pose [m].
};

/// A march in one piece.
struct PieceDef {
    Pose from;                     ///< Pose at the begin.
    std::span<const Vec2> way;     ///< Route of its middle, one point or more [m].
    Turn turn = Turn::Keep;        ///< Manner of turning on the route; not Flow.
    std::optional<double> facing;  ///< Heading of its front at the end [rad].
    double reach = 1.0;            ///< Greatest distance of its places from its middle [m].
};

/// Lists the poses of the march. `reversed`: whether its rear is its front, before and after.
void listPoses(const PieceDef& def, bool& reversed, std::vector<Pose>& poses);

}  // namespace muster
