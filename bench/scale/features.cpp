#include "scale/features.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"

namespace muster::scale {
namespace {

constexpr MotionId kDuck = 2;
constexpr MotionId kCrawl = 3;
constexpr MotionId kSwim = 4;
constexpr double kTreeSpacing = 3.2;  // Edge of the lattice of trees [m].
constexpr double kTreeJitter = 0.7;   // Largest offset of a tree from its lattice point [m].
constexpr double kFieldRange = 0.9;   // Range of the potential fields of trees [m].

Polygon rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

void addBlock(double x0, double y0, double x1, double y1, WorldDef& world) {
    world.obstacles.push_back({.name = "Block", .polygon = rectangle(x0, y0, x1, y1)});
}

PatchDef patch(const char* name, const Polygon& polygon, MotionId motion) {
    return {.name = name, .polygon = polygon, .motion = motion};
}

// Endless motion by `offset` and back at `speed`.
TimedPath shuttle(Vec2 offset, double speed) {
    const double time = length(offset) / speed;
    return {.waypoints = {{0.0, {0.0, 0.0}, 0.0}, {time, offset, 0.0}, {2.0 * time, {0.0, 0.0}, 0.0}},
            .loop = true};
}

// A block on the course, and a car that crosses ahead of it.
void addBlockScene(const FeatureSize& size, double side, WorldDef& world) {
    addBlock(-size.halfLength, -size.halfWidth, size.halfLength, size.halfWidth, world);
    world.obstacles.push_back({.name = "Car",
                               .centre = {-size.halfLength - 3.0, -0.5 * side - 2.0},
                               .radius = 0.8,
                               .path = shuttle({0.0, side + 4.0}, 1.5)});
}

// Two walls from the edges of the box, with a passage along x between them.
void addWalls(double halfLength, double halfWidth, WorldDef& world) {
    addBlock(-halfLength, halfWidth, halfLength, world.box.max.y, world);
    addBlock(-halfLength, world.box.min.y, halfLength, -halfWidth, world);
}

void addTrees(const FeatureSize& size, std::uint64_t seed, WorldDef& world) {
    Random random(seed * 104729 + 5);
    const auto columns = static_cast<std::int32_t>(std::ceil(2.0 * size.halfLength / kTreeSpacing));
    const auto rows = static_cast<std::int32_t>(std::ceil(2.0 * size.halfWidth / kTreeSpacing));
    for (std::int32_t r = 0; r < rows; ++r)
        for (std::int32_t c = 0; c < columns; ++c) {
            ObstacleDef tree;
            tree.name = "Tree";
            tree.radius = random.uniform(0.3, 0.5);
            tree.centre.x = -size.halfLength + (c + 0.5) * kTreeSpacing +
                            random.uniform(-kTreeJitter, kTreeJitter);
            tree.centre.y = -size.halfWidth + (r + 0.5) * kTreeSpacing +
                            random.uniform(-kTreeJitter, kTreeJitter);
            tree.range = kFieldRange;
            tree.strength = 0.35;
            world.obstacles.push_back(tree);
        }
}

// Three parallel passages: under a net, in the open with a moving beam to duck under, and through a pool.
void addPaths(const FeatureSize& size, double side, WorldDef& world) {
    const double wall = std::max(0.8, 0.06 * side);
    const double lane = (2.0 * size.halfWidth - 2.0 * wall) / 3.0;
    addWalls(size.halfLength, size.halfWidth, world);
    const double inner = 0.5 * lane;
    addBlock(-size.halfLength, inner, size.halfLength, inner + wall, world);
    addBlock(-size.halfLength, -inner - wall, size.halfLength, -inner, world);
    const double length = 0.6 * size.halfLength;
    world.patches.push_back(patch("Net", rectangle(-length, inner + wall, length, size.halfWidth), kCrawl));
    world.patches.push_back(patch("Pool", rectangle(-length, -size.halfWidth, length, -inner - wall), kSwim));
    PatchDef beam = patch("Beam", rectangle(-size.halfLength, -inner, -size.halfLength + 1.5, inner), kDuck);
    beam.path = shuttle({2.0 * size.halfLength - 1.5, 0.0}, 1.0);
    world.patches.push_back(beam);
}

}  // namespace

FeatureSize featureSize(const std::string& scene, double side) {
    if (scene == "block") return {std::max(1.5, 0.15 * side), std::max(1.8, 0.18 * side)};
    if (scene == "corridor") return {std::max(3.0, 0.2 * side), std::max(2.5, 0.22 * side)};
    if (scene == "woodland") return {std::max(6.4, 0.4 * side), std::max(6.4, 0.6 * side)};
    if (scene == "paths") return {std::max(4.0, 0.2 * side), std::max(6.5, 0.55 * side)};
    return {};
}

void addFeature(const std::string& scene, double side, std::uint64_t seed, WorldDef& world) {
    const FeatureSize size = featureSize(scene, side);
    if (scene == "block") addBlockScene(size, side, world);
    if (scene == "corridor") addWalls(size.halfLength, size.halfWidth, world);
    if (scene == "woodland") addTrees(size, seed, world);
    if (scene == "paths") addPaths(size, side, world);
}

}  // namespace muster::scale
