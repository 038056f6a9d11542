// Standing and cohesion: who makes room where groups meet, and who waits for whom.
#include <doctest.h>

#include "engine/world/played.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

// A line of ten across the way of a column of twelve.
WorldDef meeting(double spacing) {
    WorldDef def{.box = {{-20, -20}, {20, 20}}};
    GroupDef line, column;
    line.count = 10;
    line.formation.kind = FormationKind::Line;
    line.formation.spacing = spacing;
    line.position = {0, 0};
    column.count = 12;
    column.position = {-10, 0.4};
    def.groups = {line, column};
    return def;
}

// The farthest that a member of the first group gets from where it stood, while the second one crosses.
double moved(Played& played, double seconds) {
    played.run(2.0);
    const std::vector<Vec2> stood = copyOf(played.world.characters().position);
    played.give(SetPose{GroupId{2}, {10, 0.4}, 0.0});
    double most = 0.0;
    for (int part = 0; part < 20 * seconds; ++part) {
        played.run(0.05);
        const CharactersView c = played.world.characters();
        for (std::size_t i = 0; i < c.size(); ++i)
            if (c.group[i] == 0) most = std::max(most, distance(c.position[i], stood[i]));
    }
    return most;
}

}  // namespace

TEST_CASE("a column that crosses a line which holds its ground goes round it or through, displacing nobody") {
    for (const double spacing : {0.7, 0.9, 1.3}) {
        CAPTURE(spacing);
        Played played(meeting(spacing));
        Conduct hold{.stance = Stance::Hold};
        played.give(ChangeGroup{.group = GroupId{1}, .conduct = hold});
        CHECK(moved(played, 25.0) < 0.1);
        CHECK(played.farthest(1) < 0.5);
        CHECK(played.deepest < 0.1);
    }
}

TEST_CASE("who yields is moved, and the column that it yields to comes straight through") {
    Played normal(meeting(0.9)), yielding(meeting(0.9));
    Conduct conduct{.stance = Stance::Yield};
    yielding.give(ChangeGroup{.group = GroupId{1}, .conduct = conduct});
    const double usual = moved(normal, 14.0), most = moved(yielding, 14.0);
    CHECK(most > 0.1);
    CHECK(most >= 0.8 * usual);
    CHECK(yielding.farthest(1) < 0.5);
    yielding.run(5.0);
    CHECK(yielding.farthest(0) < 0.5);
}

TEST_CASE("a group that keeps together stays closer than a free one, and arrives") {
    double spread[2], ends[2];
    for (const int k : {0, 1}) {
        WorldDef def = openFloor(16);
        def.box = {{-40, -12}, {40, 12}};
        def.groups[0].position = {-30, 0};
        Body slow{.maxSpeed = 1.2};
        def.groups[0].bodies.assign(16, Body{});
        for (const std::size_t i : {0, 5, 10}) def.groups[0].bodies[i] = slow;
        def.groups[0].conduct.cohesion = k;
        Played played(def);
        played.give(SetPose{GroupId{1}, {30, 0}, 0.0});
        spread[k] = 0.0;
        ends[k] = 0.0;
        for (int second = 1; second <= 70; ++second) {
            played.run(1.0);
            const CharactersView c = played.world.characters();
            const auto [least, most] = std::minmax_element(c.position.begin(), c.position.end(),
                                                           [](Vec2 a, Vec2 b) { return a.x < b.x; });
            spread[k] = std::max(spread[k], most->x - least->x);
            for (std::size_t i = 0; i < c.size(); ++i) {
                const double own = c.body[i].maxSpeed;
                CHECK(length(c.velocity[i]) <= (own > 0.0 ? own : 2.0) + 1e-9);
            }
            if (played.farthest(0) < 0.3 && ends[k] == 0.0) ends[k] = second;
        }
        CHECK(ends[k] > 0.0);
    }
    // 4 by 4 at 0.9 m; the free ones get ahead by a third of the way.
    CHECK(spread[0] > 12.0);
    CHECK(spread[1] < 7.5);
    CHECK(ends[1] < 1.25 * ends[0]);
}
