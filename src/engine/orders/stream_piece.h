// A march in one piece: a formation that keeps its shape goes through poses, as one that wheels, reverses or
// keeps its heading.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "muster/order.h"

namespace muster {

/// Where a formation is that keeps its shape, as a function of a number q from 0 to 1. Owns its memory.
class StreamPiece {
public:
    /// Takes the poses that it goes through; `reach` is how far its places are from its middle [m].
    void start(std::span<const Pose> poses, double reach);
    /// True where it has no poses.
    bool empty() const { return poses_.empty(); }
    /// No place goes farther than that [m].
    double length() const { return done_.empty() ? 0.0 : done_.back(); }
    /// The pose at `q`.
    Pose at(double q) const;

private:
    std::vector<Pose> poses_;
    std::vector<double> done_;  // How far a place can have gone up to each pose [m].
};

/// How a formation in one piece goes.
struct PieceDef {
    Pose from;                     ///< Where it is.
    std::span<const Vec2> way;     ///< Of its middle from there on, one point or more [m].
    Turn turn = Turn::Keep;        ///< How it turns on the way; not Flow.
    std::optional<double> facing;  ///< Heading of its front at the end [rad].
    double reach = 1.0;            ///< Of its places from its middle [m].
};

/// Lists the poses that it goes through. `reversed`: whether its rear is its front, before and after.
void listPoses(const PieceDef& def, bool& reversed, std::vector<Pose>& poses);

}  // namespace muster
