// A world that is played and watched.
#pragma once

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "muster/world.h"

namespace muster::testing {

/// A world with its commands. Every step is watched: no command is refused, and all numbers are finite.
struct Played {
    World world;
    std::uint32_t sequence = 0;

    explicit Played(const WorldDef& def) : world(World::create(def).value()) {}
    /// For the next step.
    void give(CommandBody body) {
        REQUIRE(world.submit({world.stepCount(), 1, sequence++, std::move(body)}).ok());
    }
    /// Steps, watching what must hold in each.
    void run(double seconds) {
        const int steps = static_cast<int>(std::lround(seconds / world.parameters().stepTime));
        for (int s = 0; s < steps; ++s) {
            world.step();
            for (const Rejection& rejection : world.rejections()) FAIL_CHECK(rejection.status.message());
            watch();
        }
    }
    void watch() {
        const CharactersView c = world.characters();
        deepest = std::max(deepest, world.contacts().worstPenetration);
        for (std::size_t i = 0; i < c.size(); ++i)
            REQUIRE((isFinite(c.position[i]) && isFinite(c.velocity[i])));
    }
    /// Of a character [m].
    double radius(std::size_t i) const {
        const double own = world.characters().body[i].radius;
        return own > 0.0 ? own : world.parameters().character.radius;
    }
    /// Of a group, the greatest distance of a matched character to its place [m].
    double farthest(std::size_t group) const {
        const CharactersView c = world.characters();
        double most = 0.0;
        for (std::size_t i = 0; i < c.size(); ++i)
            if (c.group[i] == group && c.place[i] >= 0)
                most = std::max(most, distance(c.position[i], world.group(group).placePositions[c.place[i]]));
        return most;
    }
    double deepest = 0.0;  ///< Overlap of the deepest pair in any step, as a share.
};

}  // namespace muster::testing
