#include "lab/verify/scenes/hall.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/random.h"
#include "muster/parameter_table.h"

namespace muster {
namespace {

Box around(const std::vector<Box>& boxes) {
    Box all = boxes.front();
    for (const Box& box : boxes) {
        all.min = {std::min(all.min.x, box.min.x), std::min(all.min.y, box.min.y)};
        all.max = {std::max(all.max.x, box.max.x), std::max(all.max.y, box.max.y)};
    }
    return all;
}

void sortOut(std::vector<double>& lines) {
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
}

/// The parts of a box outside of all rooms, as rectangles: columns of cells between the sides of rooms,
/// joined where they are equal.
std::vector<Box> wallsOf(const Box& all, const std::vector<Box>& rooms) {
    std::vector<double> xs, ys;
    for (const Box& room : rooms) {
        xs.insert(xs.end(), {room.min.x, room.max.x});
        ys.insert(ys.end(), {room.min.y, room.max.y});
    }
    sortOut(xs);
    sortOut(ys);
    const auto isFree = [&](Vec2 p) {
        return std::any_of(rooms.begin(), rooms.end(), [p](const Box& room) { return room.contains(p); });
    };
    std::vector<Box> open, walls;
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
        std::vector<Box> column;
        for (std::size_t k = 0; k + 1 < ys.size(); ++k) {
            if (isFree({0.5 * (xs[i] + xs[i + 1]), 0.5 * (ys[k] + ys[k + 1])})) continue;
            if (!column.empty() && column.back().max.y == ys[k])
                column.back().max.y = ys[k + 1];
            else
                column.push_back({{xs[i], ys[k]}, {xs[i + 1], ys[k + 1]}});
        }
        // A box that goes on from the column before grows; the others are done.
        for (Box& box : open) {
            const auto same = std::find_if(column.begin(), column.end(), [&](const Box& c) {
                return c.min.y == box.min.y && c.max.y == box.max.y && box.max.x == c.min.x;
            });
            if (same == column.end()) {
                walls.push_back(box);
            } else {
                same->min.x = box.min.x;
            }
        }
        open = std::move(column);
    }
    walls.insert(walls.end(), open.begin(), open.end());
    (void)all;
    return walls;
}

ObstacleDef wallOf(const Box& box) {
    return {.polygon = cornersOf(box)};
}

}  // namespace

Polygon cornersOf(const Box& box) {
    return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
}

Hall::Hall(std::vector<Box> rooms, bool ring) {
    def.name = "Hall";
    def.box = around(rooms);
    def.ring = ring;
    def.parameters = *parameterPreset("people");
    for (const Box& wall : wallsOf(def.box, rooms)) obstacle(wall);
}

AreaId Hall::exit(const Box& box, const std::string& name, double rate) {
    def.areas.push_back({.name = name, .polygon = cornersOf(box), .rate = rate});
    return {static_cast<std::uint32_t>(def.areas.size())};
}

void Hall::obstacle(const Box& box) {
    def.obstacles.push_back(wallOf(box));
}

void Hall::pillar(Vec2 centre, double radius) {
    def.obstacles.push_back({.centre = centre, .radius = radius});
}

void Hall::stairs(const Box& box, double ascent, double up, double down) {
    def.patches.push_back(
        {.name = "Stairs", .polygon = cornersOf(box), .speed = up, .ascent = ascent, .speedDown = down});
}

void Hall::crowd(const CrowdDef& crowd) {
    GroupDef group{.name = crowd.name,
                   .count = static_cast<std::int32_t>(crowd.starts.size()),
                   .starts = crowd.starts,
                   .bodies = crowd.bodies,
                   .conduct = crowd.conduct,
                   .orders = {crowd.order},
                   .people = crowd.people};
    for (const Vec2 p : crowd.starts) group.position += p / static_cast<double>(crowd.starts.size());
    def.groups.push_back(group);
}

Region Hall::ground() const {
    std::vector<Polygon> walls;
    for (const ObstacleDef& obstacle : def.obstacles) {
        Polygon shape = obstacle.polygon;
        for (int i = 0; obstacle.polygon.empty() && i < 32; ++i) {
            const double angle = 2.0 * 3.14159265358979 * i / 32;
            shape.push_back(obstacle.centre + obstacle.radius * Vec2{std::cos(angle), std::sin(angle)});
        }
        walls.push_back(std::move(shape));
    }
    return regionOutside(def.box, walls).value();
}

std::vector<Vec2> scattered(const Box& box, std::int32_t count, std::uint64_t seed, double margin) {
    const Vec2 low = box.min + Vec2{margin, margin};
    const double width = box.width() - 2.0 * margin, height = box.height() - 2.0 * margin;
    // Rows of a lattice of triangles; the spacing shrinks until there are as many points as are wanted.
    std::vector<Vec2> places;
    double spacing = std::sqrt(2.0 * (width + 0.5) * (height + 0.5) / (std::sqrt(3.0) * count));
    for (; static_cast<std::int32_t>(places.size()) < count; spacing *= 0.995) {
        places.clear();
        const double rise = spacing * std::sqrt(0.75);
        const auto rows = static_cast<std::int32_t>(std::floor(height / rise + 1e-9)) + 1;
        const double spare = height - (rows - 1) * rise;
        for (std::int32_t r = 0; r < rows; ++r) {
            const double shift = r % 2 == 0 ? 0.0 : 0.5 * spacing;
            for (double x = shift; x <= width + 1e-9; x += spacing)
                places.push_back(low + Vec2{x, rows > 1 ? r * (rise + spare / (rows - 1)) : 0.5 * height});
        }
    }
    Random random(seed);
    while (static_cast<std::int32_t>(places.size()) > count)
        places.erase(places.begin() + random.below(static_cast<std::uint32_t>(places.size())));
    const double reach = std::min(0.5 * std::max(spacing - 0.46, 0.0), 0.3 * spacing);
    for (Vec2& p : places) {
        p += Vec2{random.uniform(-reach, reach), random.uniform(-reach, reach)} * std::sqrt(0.5);
        p = Box{low, box.max - Vec2{margin, margin}}.clamp(p);
    }
    return places;
}

PeopleDef personsOf(const Distribution& speed) {
    return {.speed = speed};
}

PeopleDef menOfImo() {
    return personsOf(Distribution::uniform(0.97, 1.62));
}

double numberIn(const std::string& text) {
    return std::atof(text.c_str());
}

std::string wordIn(const std::string& text, std::size_t index) {
    std::istringstream words(text);
    std::string word;
    for (std::size_t i = 0; i <= index; ++i) word.clear(), words >> word;
    return word;
}

std::vector<Vec2> curveOf(std::span<const Crossing> crossed) {
    std::vector<Vec2> curve;
    for (const Crossing& c : crossed) curve.push_back({c.time, static_cast<double>(curve.size() + 1)});
    return curve;
}

}  // namespace muster
