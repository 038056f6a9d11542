// Strokes on free ground: cuts and loops.
#include "studio/gestures/driven_world.h"

using namespace muster;
using namespace muster::testing;

namespace {

WorldDef twoNines() {
    return floorWith({squareOf(9, {-3, 0}), squareOf(9, {3, 0})});
}

/// A loop along the sides of a box, which ends just before its beginning.
std::vector<Vec2> loopRound(Vec2 least, Vec2 most) {
    return {least, {most.x, least.y}, most, {least.x, most.y}, {least.x, least.y + 0.2}};
}

constexpr double kStretch = 0.2;  // Time for each stretch of a stroke [s].

}  // namespace

TEST_CASE("A stroke across a formation cuts it where it goes") {
    DrivenWorld driven(sixteen(), "touch");
    const auto before = driven.positions();
    driven.down(1, {-4, 1});
    driven.step();
    driven.glide({{1, {4, 1}}}, 0.3);
    CHECK(driven.marks().stroke.size() > 5);
    CHECK(driven.world.groupCount() == 1);
    driven.up(1);
    driven.step();
    REQUIRE(driven.world.groupCount() == 2);
    CHECK(driven.marks().stroke.empty());
    CHECK(driven.marks().notice.empty());
    const std::size_t smaller = driven.members(0).size() < driven.members(1).size() ? 0 : 1;
    CHECK(driven.members(smaller).size() == 4);
    CHECK(driven.members(1 - smaller).size() == 12);
    for (const std::uint32_t id : driven.members(smaller)) CHECK(driven.positionOf(id).y > 1.0);
    driven.run(3.0);
    CHECK(driven.farthestFrom(before) < 0.3);
}

TEST_CASE("A cut covers at least 0.7 of the way across; a shorter one leaves a notice") {
    DrivenWorld driven(sixteen(), "touch");  // Places reach from x = -1.5 to 1.5.
    driven.draw({{-4, 0.1}, {0.5, 0.1}}, 0.5);
    CHECK(driven.world.groupCount() == 1);
    CHECK(driven.marks().notice.find("crosses no formation") != std::string::npos);
    driven.draw({{-4, 0.1}, {0.7, 0.1}}, 0.5);
    CHECK(driven.world.groupCount() == 2);
    CHECK(driven.marks().notice.empty());
}

TEST_CASE("A stroke beside a formation cuts nothing") {
    DrivenWorld driven(sixteen(), "touch");
    driven.draw({{-4, 3}, {4, 3}}, 0.5);
    CHECK(driven.world.groupCount() == 1);
    CHECK(!driven.marks().notice.empty());
    driven.down(1, {6, 6});
    CHECK(driven.marks().notice.empty());  // The next gesture begins without it.
}

TEST_CASE("A stroke across two formations cuts both") {
    DrivenWorld driven(twoNines(), "touch");
    driven.draw({{-6, 0.5}, {6, 0.5}}, 0.5);
    REQUIRE(driven.world.groupCount() == 4);
    std::size_t people = 0;
    for (std::size_t g = 0; g < 4; ++g) {
        const std::size_t count = driven.members(g).size();
        CHECK((count == 3 || count == 6));
        people += count;
    }
    CHECK(people == 18);
}

TEST_CASE("A cancelled stroke cuts nothing") {
    DrivenWorld driven(sixteen(), "touch");
    driven.down(1, {-4, 0});
    driven.step();
    driven.glide({{1, {4, 0}}}, 0.3);
    driven.cancel(1);
    driven.run(0.1);
    CHECK(driven.world.groupCount() == 1);
    CHECK(driven.marks().stroke.empty());
    CHECK(driven.marks().notice.empty());
}

TEST_CASE("A loop round two formations joins them") {
    DrivenWorld driven(twoNines(), "touch");
    const GroupId first = driven.world.group(0).id;
    driven.draw(loopRound({-6, -4}, {6, 4}), kStretch);
    REQUIRE(driven.world.groupCount() == 1);
    CHECK(driven.world.group(0).id == first);
    CHECK(driven.members(0).size() == 18);
    CHECK(driven.marks().notice.empty());
    driven.run(6.0);
    CHECK(driven.extent().x < 6.0);  // One square instead of two with a gap between them.
}

TEST_CASE("Formations of which a loop holds 60 % are joined; of which it holds less are not") {
    DrivenWorld most(twoNines(), "touch");
    most.draw(loopRound({-6, -4}, {3.5, 4}), kStretch);  // All of the left one, six of the right one.
    CHECK(most.world.groupCount() == 1);
    DrivenWorld few(twoNines(), "touch");
    few.draw(loopRound({-6, -4}, {2.5, 4}), kStretch);  // Three of the right one, which are taken out.
    REQUIRE(few.world.groupCount() == 3);
    CHECK(few.members(0).size() == 9);
    CHECK(few.members(1).size() == 6);
    CHECK(few.members(2).size() == 3);
}

TEST_CASE("A loop round a part takes that part out") {
    DrivenWorld driven(sixteen(), "touch");
    std::vector<std::uint32_t> corner;
    for (const std::uint32_t id : driven.members(0))
        if (driven.positionOf(id).x < 0 && driven.positionOf(id).y < 0) corner.push_back(id);
    REQUIRE(corner.size() == 4);
    driven.draw(loopRound({-4, -4}, {0, 0}), kStretch);
    REQUIRE(driven.world.groupCount() == 2);
    CHECK(driven.members(1) == corner);
    CHECK(driven.members(0).size() == 12);
    CHECK(driven.marks().notice.empty());
}

TEST_CASE("A loop round most of one formation takes those out, too") {
    DrivenWorld driven(sixteen(), "touch");
    driven.draw(loopRound({-4, -4}, {4, 1}), kStretch);
    REQUIRE(driven.world.groupCount() == 2);
    CHECK(driven.members(0).size() == 4);
    CHECK(driven.members(1).size() == 12);
}

TEST_CASE("A loop round nobody leaves a notice, and one round a whole formation, too") {
    DrivenWorld driven(sixteen(), "touch");
    driven.draw(loopRound({5, 5}, {8, 8}), kStretch);
    CHECK(driven.marks().notice == "The loop holds nobody");
    driven.draw(loopRound({-4, -4}, {4, 4}), kStretch);
    CHECK(driven.marks().notice.find("one whole formation") != std::string::npos);
    CHECK(driven.world.groupCount() == 1);
}

TEST_CASE("A stroke that does not come back within a quarter of its length is no loop") {
    DrivenWorld driven(twoNines(), "touch");
    // 32 m long, and 9 m short of its beginning.
    driven.draw({{-6, -5}, {6, -5}, {6, 4}, {-5, 4}}, kStretch);
    CHECK(driven.world.groupCount() == 2);
    // 35 m long, and 6 m short of it.
    driven.draw({{-6, -5}, {6, -5}, {6, 4}, {-6, 4}, {-6, 1}}, kStretch);
    CHECK(driven.world.groupCount() == 1);
}

TEST_CASE("A loop holds people where they are, not where their places are") {
    WorldDef def = floorWith({squareOf(4, {6, 0})});
    def.groups[0].starts = {{-6, 0}, {-6, 1}, {-5, 0}, {5, 0}};
    def.parameters.plan.mode = PlanMode::Fixed;
    DrivenWorld driven(def, "touch");
    driven.draw(loopRound({-9, -2}, {-2, 3}), 0.05);
    REQUIRE(driven.world.groupCount() == 2);
    CHECK(driven.members(1) == std::vector<std::uint32_t>{1, 2, 3});
}
