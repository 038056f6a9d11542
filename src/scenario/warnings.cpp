#include <cstdio>

#include "muster/scenario/scenario.h"

namespace muster {
namespace {

std::string at(Vec2 p) {
    char buffer[64];
    std::snprintf(buffer, sizeof(buffer), "(%.2f, %.2f)", p.x, p.y);
    return buffer;
}

/// The definition's ground as it stands at the start.
Result<Environment> groundOf(const WorldDef& def) {
    EnvironmentDef ground{def.box, def.cell, def.parameters.fieldRange, def.parameters.fieldStrength, def.clips};
    auto environment = Environment::create(ground);
    if (!environment.ok()) return environment;
    std::vector<ObstacleDef> obstacles = def.obstacles;
    if (def.map) {
        for (ObstacleDef& piece : mapObstacles(def.map->grid, def.map->def)) obstacles.push_back(std::move(piece));
    }
    for (const ObstacleDef& obstacle : obstacles) {
        if (const auto id = environment->addObstacle(obstacle); !id.ok()) return id.status();
    }
    environment->setTime(0.0);
    return environment;
}

std::string nameOf(const Environment& environment, ObstacleId id) {
    const ObstacleDef* obstacle = environment.obstacle(id);
    if (obstacle != nullptr && !obstacle->name.empty()) return "\"" + obstacle->name + "\"";
    return "obstacle " + std::to_string(id.value);
}

void warnOfGaps(const WorldDef& def, const Environment& environment, std::size_t most,
                std::vector<std::string>& warnings) {
    const double diameter = 2.0 * def.parameters.radius;
    for (const NarrowGap& gap : environment.narrowGaps(diameter, static_cast<std::int32_t>(most))) {
        if (warnings.size() >= most) return;
        char width[32];
        std::snprintf(width, sizeof(width), "%.2f", gap.width);
        warnings.push_back("the gap between " + nameOf(environment, gap.a) + " and " + nameOf(environment, gap.b) +
                           " at " + at(gap.where) + " is " + width + " m wide, narrower than a character");
    }
}

void warnOfStarts(const WorldDef& def, const Environment& environment, std::size_t most,
                  std::vector<std::string>& warnings) {
    for (const GroupDef& group : def.groups) {
        std::int32_t blocked = 0;
        Vec2 example;
        for (Vec2 p : group.starts) {
            if (def.box.contains(p) && environment.distanceToObstacle(p) >= def.parameters.radius) continue;
            if (blocked++ == 0) example = p;
        }
        if (group.starts.empty() && !def.box.contains(group.position)) {
            warnings.push_back("group \"" + group.name + "\" stands outside the world box");
        }
        if (blocked > 0 && warnings.size() < most) {
            warnings.push_back(std::to_string(blocked) + " characters of group \"" + group.name +
                               "\" start in an obstacle or outside, the first at " + at(example));
        }
    }
}

}  // namespace

std::vector<std::string> scenarioWarnings(const WorldDef& def, std::size_t most) {
    std::vector<std::string> warnings;
    const auto environment = groundOf(def);
    if (!environment.ok()) return {environment.status().message()};
    warnOfGaps(def, *environment, most, warnings);
    warnOfStarts(def, *environment, most, warnings);
    return warnings;
}

}  // namespace muster
