#include "scale/city.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "base/text_file.h"
#include "engine/ground/routes/route_search.h"
#include "scale/spots.h"

namespace muster::scale {
namespace {

constexpr const char* kMap = "Berlin_0_256.map";
constexpr std::int32_t kCells = 48;  // Side of the part of the map that is used [cells].

// The part of the map with its lower left corner at column x, row y from the bottom.
MapGrid cutOut(const MapGrid& map, std::int32_t x, std::int32_t y) {
    MapGrid part{.width = kCells, .height = kCells};
    for (std::int32_t row = 0; row < kCells; ++row) {
        const std::int32_t from = map.height - y - kCells + row;
        part.cells += map.cells.substr(static_cast<std::size_t>(from) * map.width + x, kCells);
    }
    return part;
}

double freeShare(const MapGrid& part) {
    const auto free = std::count_if(part.cells.begin(), part.cells.end(),
                                    [](char c) { return c == '.' || c == 'G'; });
    return static_cast<double>(free) / static_cast<double>(part.cells.size());
}

// A part with streets and blocks: the one, of a lattice of parts, whose share of free ground is nearest to 55
// %.
MapGrid streets(const MapGrid& map) {
    MapGrid best;
    double off = 2.0;
    for (std::int32_t y = 0; y + kCells <= map.height; y += kCells / 2)
        for (std::int32_t x = 0; x + kCells <= map.width; x += kCells / 2) {
            MapGrid part = cutOut(map, x, y);
            const double here = std::fabs(freeShare(part) - 0.55);
            if (here >= off) continue;
            off = here;
            best = std::move(part);
        }
    return best;
}

// Finds the lattice point with most free ground for a formation of that side, among those that `wanted`
// accepts.
template <class Wanted>
bool openest(const Environment& ground, double side, Wanted wanted, Vec2& found) {
    const Box box = ground.def().box;
    const double step = box.width() / 24.0;
    std::int32_t most = 0;
    for (double y = box.min.y + step; y < box.max.y; y += step)
        for (double x = box.min.x + step; x < box.max.x; x += step) {
            if (!wanted(Vec2{x, y}) || ground.distanceToObstacle({x, y}) < 1.0) continue;
            std::int32_t free = 0;
            for (int b = -4; b <= 4; ++b)
                for (int a = -4; a <= 4; ++a) {
                    const Vec2 p = Vec2{x, y} + Vec2{0.125 * a * side, 0.125 * b * side};
                    free += box.contains(p) && ground.distanceToObstacle(p) >= 0.4 ? 1 : 0;
                }
            if (free <= most) continue;
            most = free;
            found = {x, y};
        }
    return most > 0;
}

// Finds the path between the two most open squares that are far enough from each other.
Status findCourse(const Environment& ground, const SceneDef& def, double side, std::vector<Vec2>& path) {
    RouteGraph routes;
    routes.update(ground, 0.4);
    Vec2 from;
    Vec2 to;
    const double apart = side + kAway;
    if (!openest(
            ground, side, [](Vec2) { return true; }, from) ||
        !openest(
            ground, side, [&](Vec2 p) { return distance(p, from) >= apart && routes.reachable(p, from); },
            to))
        return Status(StatusCode::LimitExceeded,
                      "scene city: found no two squares " + std::to_string(apart) + " m apart");
    if (def.seed % 2 == 0) std::swap(from, to);
    path = findRoute(routes, from, to);
    if (path.size() < 2)
        return Status(StatusCode::LimitExceeded, "scene city: found no way between its squares");
    return {};
}

}  // namespace

Status makeCity(const SceneDef& def, Scene& scene) {
    const std::string path = (def.maps.empty() ? "." : def.maps) + "/" + kMap;
    const auto text = readTextFile(path);
    if (!text.ok()) return Status(StatusCode::NotFound, "scene city: found no map " + path);
    const Result<MapGrid> map = parseMap(*text);
    if (!map.ok()) return map.status().within(path);
    if (map->width < kCells || map->height < kCells)
        return Status(StatusCode::NotFound, "scene city: the map is too small");
    MapGround city{.grid = streets(*map)};
    // Large enough for two formations at that distance; a street of some cells is then about as wide as half
    // a formation.
    city.def.metresPerCell = std::max(2.0 * scene.side + 1.5 * kAway, 4.0 * scene.side) / kCells;
    const double size = kCells * city.def.metresPerCell;
    scene.world.box = {{0.0, 0.0}, {size, size}};
    scene.world.map = std::move(city);
    const Result<Environment> ground = groundOf(scene.world);
    if (!ground.ok()) return ground.status().within("scene city");
    if (Status status = findCourse(*ground, def, scene.side, scene.course.points); !status.ok())
        return status;
    Random random(def.seed * 7919 + 17);
    scene.course.speed = random.uniform(1.2, 1.5);
    if (def.regime == Regime::Far) {
        scene.seconds = 60.0 + 3.0 * size / 0.8;
        return addCrowd(def, {scene.course.points.back(), 0.0}, scene.course.points.front(), scene);
    }
    scene.course.turn = 0.1;
    if (def.regime == Regime::Reversing) scene.course.reverseEvery = 2.5;
    letLag(scene.world.parameters);
    const CoursePose pose = poseAt(scene.course, 0.0);
    return addCrowd(def, pose, behind(pose), scene);
}

}  // namespace muster::scale
