#include <algorithm>
#include <utility>

#include "base/cell_list.h"
#include "engine/state/draw_person.h"
#include "files/scenario/warning_parts.h"

namespace muster {
namespace {

// Bodies may overlap by this share of their mean diameter, as figures of runs have it.
constexpr double kOverlap = 0.1;

/// A character whose start is given.
struct Start {
    std::size_t group = 0;
    Vec2 position;
    double radius = 0.0;
};

std::vector<Start> startsOf(const WarnedScene& scene) {
    std::vector<Start> starts;
    for (std::size_t g = 0; g < scene.def.groups.size(); ++g) {
        const std::vector<Vec2>& points = scene.def.groups[g].starts;
        for (std::size_t k = 0; k < std::min(points.size(), scene.bodies[g].size()); ++k)
            starts.push_back({g, points[k], scene.radiusOf(g, k)});
    }
    return starts;
}

void warnOfOverlaps(const WarnedScene& scene, WarningList& warnings) {
    const std::vector<Start> starts = startsOf(scene);
    if (starts.size() < 2) return;
    std::vector<Vec2> points;
    double largest = 0.0;
    for (const Start& start : starts) {
        points.push_back(start.position);
        largest = std::max(largest, start.radius);
    }
    CellList cells;
    cells.sort(points, 2.0 * largest);
    std::vector<std::uint8_t> overlaps(starts.size(), 0);
    cells.forPairs(2.0 * largest, [&](std::int32_t i, std::int32_t j) {
        const double apart = (1.0 - kOverlap) * (starts[i].radius + starts[j].radius);
        if (distance(points[i], points[j]) < apart) overlaps[i] = overlaps[j] = 1;
    });
    const auto count = std::count(overlaps.begin(), overlaps.end(), 1);
    if (count == 0) return;
    const auto first = std::find(overlaps.begin(), overlaps.end(), 1) - overlaps.begin();
    warnings.add(std::to_string(count) + " characters start on top of others, the first of " +
                 groupText(scene.def, starts[first].group) + " at " + pointText(points[first]) +
                 "; they will be moved apart");
}

}  // namespace

WarnedScene warnedScene(const WorldDef& def, const Environment& ground) {
    WarnedScene scene{def, ground, {}};
    std::uint32_t next = 1;  // As characters are numbered.
    for (const GroupDef& group : def.groups) {
        scene.bodies.push_back(drawMembers(group, def.seed, next));
        next += static_cast<std::uint32_t>(group.count);
    }
    return scene;
}

double WarnedScene::leastRadius() const {
    double least = def.parameters.character.radius;
    for (const std::vector<Body>& group : bodies)
        for (const Body& body : group)
            if (body.radius > 0.0) least = std::min(least, body.radius);
    return least;
}

void warnOfStarts(const WarnedScene& scene, WarningList& warnings) {
    const WorldDef& def = scene.def;
    for (const GroupDef& group : def.groups) {
        std::int32_t blocked = 0;
        Vec2 example;
        for (Vec2 p : group.starts) {
            if (def.box.contains(p) && scene.ground.distanceToObstacle(p) >= def.parameters.character.radius)
                continue;
            if (blocked++ == 0) example = p;
        }
        if (group.starts.empty() && !def.box.contains(group.position))
            warnings.add("group \"" + group.name + "\" stands outside the world box");
        if (blocked > 0)
            warnings.add(std::to_string(blocked) + " characters of group \"" + group.name +
                         "\" start in an obstacle or outside, the first at " + pointText(example));
    }
    warnOfOverlaps(scene, warnings);
}

}  // namespace muster
