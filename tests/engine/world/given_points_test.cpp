// Places at points that are given just as far apart as places have to be.
#include <doctest.h>

#include "engine/world/turned.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A cordon between two walls: points 0.6 m apart, on which all stand from the start and hold.
WorldDef cordonBetweenWalls() {
    WorldDef def{.box = {{-20, -12}, {20, 12}}, .obstacles = {block(-8, 6, 8, 12), block(-8, -12, 8, -5.6)}};
    GroupDef holders{.formation = {.kind = FormationKind::Points}};
    for (int k = 0; k <= 17; ++k)
        if (k != 13) holders.formation.points.push_back({0, -5 + 0.6 * k});
    holders.count = 17;
    holders.starts = holders.formation.points;
    holders.conduct.stance = Stance::Hold;
    def.groups.push_back(holders);
    return def;
}

}  // namespace

TEST_CASE("who holds a cordon of points between walls stays on them") {
    for (const Lie& lie : kLies) {
        const WorldDef def = turned(cordonBetweenWalls(), lie);
        World world = World::create(def).value();
        run(world, 5.0);
        double worst = 0.0;
        for (const Vec2 p : world.characters().position) {
            double nearest = 1e9;
            for (const Vec2 point : def.groups[0].starts) nearest = std::min(nearest, distance(p, point));
            worst = std::max(worst, nearest);
        }
        INFO("turned by " << lie.angle << ": " << worst << " m off");
        CHECK(worst < 0.01);
    }
}
