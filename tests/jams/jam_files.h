// The jams that come with the project's shared data, where that is at hand.
#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "jams/jam_scene.h"
#include "muster/scenario.h"
#include "test_folders.h"

namespace muster::testing {

/// Where the characters of a scene stand at first [m].
inline std::vector<Vec2> startsOf(const JamScene& scene) {
    const World world = World::create(scene.def).value();
    const std::span<const Vec2> positions = world.characters().position;
    return {positions.begin(), positions.end()};
}

/// The gaps between obstacles that stand in a row along the y axis about x = 0.
inline std::vector<JamPassage> passagesInRow(const WorldDef& def) {
    std::vector<std::pair<double, double>> spans;
    for (const ObstacleDef& obstacle : def.obstacles) {
        double low = 1e9, high = -1e9;
        for (const Vec2 p : obstacle.polygon) {
            low = std::min(low, p.y);
            high = std::max(high, p.y);
        }
        spans.push_back({low, high});
    }
    std::sort(spans.begin(), spans.end());
    std::vector<JamPassage> passages;
    for (std::size_t i = 1; i < spans.size(); ++i)
        passages.push_back({{0.0, spans[i - 1].second}, {0.0, spans[i].first}});
    return passages;
}

/// J1, J2, J3 by index; none, with a note, where the shared data is not there.
inline std::optional<JamScene> jamFile(int index) {
    const char* names[] = {"J1-door-and-detour", "J2-two-doors", "J3-three-ways-400"};
    const std::string path = sourceFolder() + "/../shared/jams/" + names[index];
    if (!std::filesystem::exists(path + ".json")) {
        std::printf("skipped: %s.json in shared/jams is not there\n", names[index]);
        return std::nullopt;
    }
    JamScene scene{.def = loadScenario(path + ".json").value()};
    scene.commands = loadGestures(path + ".gestures.json", scene.def.parameters.stepTime).value();
    scene.passages = passagesInRow(scene.def);
    scene.shift = {-2.0 * scene.def.groups[0].position.x, 0.0};
    return scene;
}

}  // namespace muster::testing
