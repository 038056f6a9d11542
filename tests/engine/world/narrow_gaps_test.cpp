// One person and one gap: who fits it walks through, who does not is told that there is no way, wherever the
// gap lies on the cells.
#include <doctest.h>

#include <algorithm>

#include "base/maths.h"
#include "engine/state/ground_class.h"
#include "engine/world/world_scenes.h"
#include "muster/parameter_table.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr double kMost = 20.0;  // For the way [s].

/// Whether one person of this radius leaves through a gap in a wall of 0.2 m at an angle to the cells.
bool leaves(double radius, double width, double angle, double shift) {
    const Rotation turn{cosine(angle), sine(angle)};
    const Vec2 middle{8.0, 8.0 + shift};
    const auto at = [&](double x, double y) { return middle + turn.apply({x, y}); };
    WorldDef def{.box = {{0, 0}, {16, 16}}, .parameters = *parameterPreset("people")};
    for (const double side : {-1.0, 1.0}) {
        const double low = std::min(0.5 * side * width, 20.0 * side);
        const double high = std::max(0.5 * side * width, 20.0 * side);
        def.obstacles.push_back({.polygon = {at(0.0, low), at(0.2, low), at(0.2, high), at(0.0, high)}});
    }
    def.groups = {
        {.count = 1, .starts = {at(-4.0, 0.7)}, .bodies = {{.radius = radius}}, .orders = {Order::leave()}}};
    def.areas = {{.polygon = {at(3.0, -3.0), at(4.0, -3.0), at(4.0, 3.0), at(3.0, 3.0)}}};
    World world = World::create(def).value();
    while (world.time() < kMost && world.characters().size() > 0) world.step();
    return world.characters().size() == 0;
}

}  // namespace

TEST_CASE("a person walks through every gap that it fits, and through none that it does not") {
    const double usual = parameterPreset("people")->character.radius;
    for (const double radius : {0.22, 0.3, 0.35, 0.4})
        for (const double angle : {0.0, 0.47})
            for (int k = 0; k < 10; ++k) {
                // Ways are those of the largest body of a class.
                const double needed = 2.0 * groundRadius(usual, groundClassFor(usual, radius));
                const double shift = 0.025 * k;
                CAPTURE(radius);
                CAPTURE(angle);
                CAPTURE(shift);
                CHECK_FALSE(leaves(radius, needed - 0.01, angle, shift));
                for (const double more : {0.01, 0.08, 0.2}) {
                    CAPTURE(more);
                    CHECK(leaves(radius, needed + more, angle, shift));
                }
            }
}
