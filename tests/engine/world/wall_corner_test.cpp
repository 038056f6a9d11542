// People who stand flush against a wall beside an opening: nobody stays there, wherever walls lie in the
// cells.
#include <doctest.h>

#include <cmath>

#include "engine/world/world_scenes.h"
#include "muster/parameter_table.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A wall across a hall, with an opening.
struct Opening {
    double low, width;     // Where it is along the wall [m].
    double face = 6.0;     // Where the wall begins [m].
    double thick = 1.0;    // [m]
    double cell = 0.25;    // [m]
    double radius = 0.18;  // Of all bodies [m].
    double sine = 0.0;     // Of the angle by which all is turned about the middle of the hall.
};

WorldDef hallBehind(const Opening& o, const std::vector<Vec2>& starts) {
    const Vec2 middle{6, 4};
    const double cosine = std::sqrt(1.0 - o.sine * o.sine);
    const auto turned = [&](std::vector<Vec2> points) {
        for (Vec2& p : points) p = middle + Rotation{cosine, o.sine}.apply(p - middle);
        return points;
    };
    const auto part = [&](double y0, double y1) {
        ObstacleDef def;
        const double x0 = o.face, x1 = o.face + o.thick;
        def.polygon = turned({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
        return def;
    };
    WorldDef def{.parameters = *parameterPreset("people")};
    def.parameters.character.radius = o.radius;
    def.cell = o.cell;
    def.box = o.sine == 0.0 ? Box{{0, 0}, {12, 8}} : Box{{-3, -3}, {15, 11}};
    def.obstacles = {part(-8.0, o.low), part(o.low + o.width, 16.0)};
    GroupDef group{.count = static_cast<std::int32_t>(starts.size()), .starts = turned(starts)};
    group.position = group.starts.front();
    group.orders = {Order::leave()};
    def.groups = {group};
    def.areas = {{.polygon = turned({{11, 3}, {11.9, 3}, {11.9, 5}, {11, 5}})}};
    return def;
}

std::size_t stayedAfter(const WorldDef& def, double seconds) {
    World world = World::create(def).value();
    while (world.time() < seconds && world.characters().size() > 0) world.step();
    return world.characters().size();
}

/// Of people alone, each from another point at the face of the wall beside an edge of the opening.
std::size_t stayed(const Opening& o) {
    std::size_t count = 0;
    for (const double beside : {0.2, 0.1, 0.05, 0.0})
        for (const double y : {o.low - beside, o.low + o.width + beside})
            count += stayedAfter(hallBehind(o, {{o.face - o.radius - 0.002, y}}), 16.0);
    return count;
}

/// Over offsets of the opening by a tenth of a cell, and widths from hardly wider than a body.
void checkNobodyStays(Opening o) {
    for (const double width : {2.0 * o.radius + 0.1, 0.9, 1.6})
        for (int tenth = 0; tenth < 10; tenth += 2) {
            o.low = 3.0 + 0.1 * tenth * o.cell;
            o.width = width;
            CAPTURE(o.cell);
            CAPTURE(o.radius);
            CAPTURE(o.width);
            CAPTURE(o.low);
            CHECK(stayed(o) == 0);
        }
}

}  // namespace

TEST_CASE("nobody stays beside an opening, wherever its edges lie in the cells") {
    checkNobodyStays({0, 0});
    checkNobodyStays({0, 0, 6.1, 0.1, 0.25, 0.15});
    checkNobodyStays({0, 0, 6.05, 0.3, 0.1, 0.35});
    checkNobodyStays({0, 0, 6.1, 1.0, 0.5, 0.3});
    checkNobodyStays({0, 0, 6.2, 0.3, 0.5, 0.15});
}

TEST_CASE("nobody stays beside an opening of a wall at an angle to the cells") {
    checkNobodyStays({0, 0, 6.0, 0.5, 0.25, 0.18, std::sqrt(0.5)});
    checkNobodyStays({0, 0, 6.1, 0.2, 0.25, 0.23, 0.39});
}

TEST_CASE("a crowd before a narrow mouth leaves nobody behind") {
    std::vector<Vec2> starts;
    for (double y = 2.0; y <= 6.0; y += 0.5)
        for (double x = 1.0; x <= 5.5; x += 0.5) starts.push_back({x, y});
    for (const Opening& o : {Opening{3.2, 1.6}, Opening{3.45, 1.1}, Opening{3.2, 0.45, 6.0, 0.1},
                             Opening{3.25, 0.9, 6.08, 0.1, 0.4}}) {
        CAPTURE(o.width);
        CHECK(stayedAfter(hallBehind(o, starts), 120.0) == 0);
    }
}
