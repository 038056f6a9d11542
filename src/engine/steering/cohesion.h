// Cohesion: how far a group walks at the pace of its slowest (SPEC B14).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/steering/crowd_bodies.h"

namespace muster {

struct Characters;

/// Who falls behind walks at most so many times as fast as the slowest, and never above its own top speed.
inline constexpr double kCatchUp = 1.15;
/// Who is far ahead walks at least at this share of the pace of the slowest.
inline constexpr double kLeastPace = 0.45;
/// Change of that share per metre ahead of the last [1/m].
inline constexpr double kPacePerMetre = 0.14;

/// Bounds speeds, so that those who have less of their way left wait for those who have more.
class Cohesion {
public:
    /// Sets `pace`, the share of its top speed at which each of `members` walks, for a cohesion in (0, 1]:
    /// at 0 everybody is free, at 1 all keep to the slowest. "The last" are the tenth with the longest ways;
    /// the unmatched and those without a way neither count nor wait.
    void setPaces(double cohesion, const CrowdBodies& bodies, const Characters& now,
                  std::span<const std::int32_t> members, std::span<double> pace);

private:
    std::vector<double> left_;  // Costs of those who have a way [m].
};

}  // namespace muster
