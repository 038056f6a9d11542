// Cohesion: how far a group walks at the pace of its slowest member (SPEC B14).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/steering/crowd_bodies.h"

namespace muster {

struct Characters;

/// Factor of the slowest member's speed up to which members behind walk; their own top speed still bounds
/// them.
inline constexpr double kCatchUpFactor = 1.15;
/// Least share of the slowest member's pace for a member far ahead.
inline constexpr double kLeastPace = 0.45;
/// Change of that share per metre ahead of the last members [1/m].
inline constexpr double kPacePerMetre = 0.14;

/// Bounds speeds, so that members with less of their path left wait for members with more.
class Cohesion {
public:
    /// Sets `pace`, the share of its top speed at which each of `members` walks, for a cohesion in (0, 1]:
    /// near 0 every member is free, at 1 all keep to the slowest. The last members are the tenth with the
    /// longest paths; unmatched members and members without a path neither count nor wait.
    void setPaces(double cohesion, const CrowdBodies& bodies, const Characters& now,
                  std::span<const std::int32_t> members, std::span<double> pace);

private:
    std::vector<double> left_;  // Costs of the members with a path [m].
};

}  // namespace muster
