// Going past characters that stand until their premovement time is over and make no room.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/neighbour_list.h"
#include "engine/ground/environment/environment.h"
#include "engine/steering/character_arrays.h"
#include "engine/steering/crowd_bodies.h"

namespace muster {

/// Turns the velocities of walkers that come up to standing characters, by the least angle at which neither
/// these nor walls are in the way; of two equal angles to the right. A walker without such an angle goes
/// straight on, and waits.
class GoPast {
public:
    /// Changes `wanted` [m/s] of walkers; `standing` is 1 for standing characters. `places` holds the point
    /// for which each character is bound [m]: a walker does not go past a character behind that point, or on
    /// it.
    void run(const CrowdBodies& bodies, const Characters& now, const Environment& environment,
             const NeighbourList& neighbours, std::span<const std::uint8_t> standing,
             std::span<const Vec2> places, std::span<Vec2> wanted);

private:
    // A standing character near a walker.
    struct Stander {
        Vec2 to;      // Vector from the walker [m].
        double keep;  // Distance to keep from its middle [m].
    };

    void list(const CrowdBodies& bodies, const Characters& now, std::int32_t walker, std::size_t first,
              std::size_t end, Vec2 toPlace);
    bool turn(double side, Vec2& unit) const;

    // Each walker, and a standing character near it; sorted.
    std::vector<std::pair<std::int32_t, std::int32_t>> near_;
    std::vector<Stander> standers_;  // Standing characters near one walker.
};

}  // namespace muster
