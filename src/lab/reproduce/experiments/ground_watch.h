// Measures what characters do on the ground of each motion, by their positions.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/world.h"

namespace muster {

/// Measures on what ground characters walk, how far and for how long. Their number must not change.
class GroundWatch {
public:
    /// Call before the first step.
    explicit GroundWatch(const World& world);
    /// Call after every step. A step counts where it begins and ends on ground of one motion.
    void observe(const World& world);

    double seconds(MotionId motion) const;  ///< Time that all characters together were on its ground [s].
    double metres(MotionId motion) const;   ///< Way that all characters together walked on its ground [m].
    /// Mean speed on its ground [m/s]; NaN where nobody was on it.
    double speed(MotionId motion) const;
    /// Characters that have been on its ground.
    std::int32_t visitors(MotionId motion) const;
    /// Share of the time on its ground in which a character had another motion id; NaN where nobody was on
    /// it.
    double wrongShare(MotionId motion) const;

private:
    struct Tally {
        std::int64_t steps = 0;
        std::int64_t wrong = 0;
        double metres = 0.0;
        std::vector<std::uint8_t> visited;  // By character.
    };

    double stepTime_;
    std::vector<Vec2> position_;
    std::vector<MotionId> ground_;
    std::vector<Tally> tallies_;  // By motion.
};

}  // namespace muster
