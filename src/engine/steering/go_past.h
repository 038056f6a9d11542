// Going past those who stay until their premovement time is over: they do not make room.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/neighbour_list.h"
#include "engine/ground/environment/environment.h"
#include "engine/steering/characters.h"
#include "engine/steering/crowd_bodies.h"

namespace muster {

/// Turns the velocities of walkers who come up to some who stand, by the least angle at which neither these
/// nor walls are in the way; of two alike to the right. Who finds none goes straight on, and waits.
class GoPast {
public:
    /// Changes `wanted` [m/s] of those who do not stand; `standing` is 1 for who does. `places` is where each
    /// is bound for [m]: who stands behind that, or on it, is not gone past.
    void run(const CrowdBodies& bodies, const Characters& now, const Environment& environment,
             const NeighbourList& neighbours, std::span<const std::uint8_t> standing,
             std::span<const Vec2> places, std::span<Vec2> wanted);

private:
    // Somebody who stands near a walker.
    struct Stander {
        Vec2 to;      // From the walker [m].
        double keep;  // Distance to keep from its middle [m].
    };

    void list(const CrowdBodies& bodies, const Characters& now, std::int32_t walker, std::size_t first,
              std::size_t end, Vec2 toPlace);
    bool turn(double side, Vec2& unit) const;

    std::vector<std::pair<std::int32_t, std::int32_t>> near_;  // Walker, and who stands near it; sorted.
    std::vector<Stander> standers_;                            // Of one walker.
};

}  // namespace muster
