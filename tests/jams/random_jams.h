// The random jams by which waits are judged. Seeds and generator stand before any model was tuned.
#pragma once

#include "jams/jam_files.h"
#include "jams/quickest_flow.h"

#if MUSTER_HAS_LEMON

namespace muster::testing {

inline constexpr std::uint64_t kRandomJams = 20;  ///< Seeds 1, 2, ... this.
inline constexpr double kWorthAWait = 1.3;        ///< Nearest passage alone over all passages, at least.

/// The passage that the middle of the crowd reaches first.
inline std::size_t nearestPassage(const JamScene& scene) {
    const Vec2 crowd = scene.def.groups[0].position;
    std::size_t best = 0;
    for (std::size_t p = 1; p < scene.passages.size(); ++p) {
        const auto away = [&](std::size_t k) {
            return distance(crowd, lerp(scene.passages[k].a, scene.passages[k].b, 0.5));
        };
        if (away(p) < away(best)) best = p;
    }
    return best;
}

/// The first scene by this seed in which the nearest passage alone takes at least 1.3 times the bound.
inline JamScene randomJam(std::uint64_t seed) {
    Random random(seed);
    for (;;) {
        JamScene scene = sceneOf(randomWallPlan(random));
        const std::vector<Vec2> starts = startsOf(scene);
        JamScene alone = scene;
        alone.passages = {scene.passages[nearestPassage(scene)]};
        if (quickestFlowAfterCommands(alone, starts) >=
            kWorthAWait * quickestFlowAfterCommands(scene, starts))
            return scene;
    }
}

}  // namespace muster::testing

#endif
