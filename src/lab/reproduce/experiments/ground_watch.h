// Measures what characters do on the ground of each motion, by their positions.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/world.h"

namespace muster {

/// Measures the ground on which characters walk: lengths and times by motion. Their number must not change.
class GroundWatch {
public:
    /// Call before the first step.
    explicit GroundWatch(const World& world);
    /// Call after every step. A step counts where it begins and ends on ground of one motion.
    void observe(const World& world);

    /// Time that all characters together were on ground of the motion [s].
    double seconds(MotionId motion) const;
    /// Length that all characters together walked on ground of the motion [m].
    double metres(MotionId motion) const;
    /// Mean speed on ground of the motion [m/s]; NaN where nobody was on it.
    double speed(MotionId motion) const;
    /// Number of characters that have been on ground of the motion.
    std::int32_t visitors(MotionId motion) const;
    /// Share of the time on ground of the motion in which a character had another motion id; NaN where nobody
    /// was on it.
    double wrongShare(MotionId motion) const;

private:
    struct Tally {
        std::int64_t steps = 0;
        std::int64_t wrong = 0;
        double metres = 0.0;
        std::vector<std::uint8_t> visited;  // By character: whether it has been on the ground.
    };

    double stepTime_;
    std::vector<Vec2> position_;
    std::vector<MotionId> ground_;
    std::vector<Tally> tallies_;  // Tallies by motion.
};

}  // namespace muster
