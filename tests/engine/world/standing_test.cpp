// Who is in place, and what keeps the others from theirs: one scene for each cause.
#include "engine/world/standings.h"

#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

std::uint32_t numberOf(const World& world, Standing standing, std::size_t group = 0) {
    return countStandings(world)[group][static_cast<std::size_t>(standing)];
}

std::string sentenceOf(const World& world) {
    return standingSentence(countStandings(world)[0]);
}

/// A world of which the group goes to a pose, and so many seconds pass.
World gone(const WorldDef& def, Vec2 to, double seconds = 20.0) {
    World world = World::create(def).value();
    REQUIRE(give(world, SetPose{world.group(0).id, to, 0.0}).ok());
    run(world, seconds);
    return world;
}

}  // namespace

TEST_CASE("everybody is in place where all stand in their places, and on the way while they run") {
    World world = World::create(openFloor(25)).value();
    run(world, 1.5);
    CHECK(numberOf(world, Standing::InPlace) == 25);
    CHECK(sentenceOf(world) == "everybody is in place.");
    REQUIRE(give(world, SetPose{world.group(0).id, {6, 0}, 0.0}).ok());
    run(world, 2.0);
    CHECK(numberOf(world, Standing::InPlace) == 0);
    CHECK(sentenceOf(world) == "nobody is in place. 25 are on the way.");
    run(world, 12.0);
    CHECK(numberOf(world, Standing::InPlace) == 25);
    const std::vector<Standing> each = world.standings();
    REQUIRE(each.size() == 25);
    for (const Standing one : each) CHECK(one == Standing::InPlace);
}

TEST_CASE("a place outside the ground is nobody's, and who makes room for those from there says so") {
    const World world = gone(openFloor(25), {12, 0});
    CHECK(numberOf(world, Standing::OnTheWay) == 0);
    CHECK(numberOf(world, Standing::Outside) == 15);  // Three of five ranks lie on the edge or beyond.
    CHECK(numberOf(world, Standing::InPlace) + barredOf(countStandings(world)[0]) == 25);
    CHECK(sentenceOf(world).find("outside the ground") != std::string::npos);
}

TEST_CASE("a march that ends beside a wall leaves everybody in place") {
    WorldDef def = openFloor(36);
    def.box = {{-18, -12}, {18, 12}};
    def.obstacles = {block(-2.5, -4.5, 2.5, 4.5)};
    def.groups[0].position = {-11, 0};
    for (const Vec2 to : {Vec2{-6, 0}, Vec2{6, 0}, Vec2{8, -5}}) {
        World world = World::create(def).value();
        tell(world, {.target = to});
        run(world, 30.0);
        CHECK(sentenceOf(world) == "everybody is in place.");
    }
}

TEST_CASE("places in an obstacle") {
    WorldDef def = openFloor(16);
    def.obstacles = {block(3, -3, 8, 3)};
    const World world = gone(def, {3.0, 0});
    CHECK(numberOf(world, Standing::Obstacle) > 0);
    CHECK(numberOf(world, Standing::Outside) == 0);
    CHECK(numberOf(world, Standing::NoWay) == 0);
    CHECK(numberOf(world, Standing::InPlace) < 16);
}

TEST_CASE("places between walls that are nearer than a body is wide") {
    WorldDef def = openFloor(1);
    def.obstacles = {block(2, 0.1, 9, 4), block(2, -4, 9, -0.1)};
    const World world = gone(def, {6, 0});
    CHECK(numberOf(world, Standing::Narrow) == 1);
    CHECK(sentenceOf(world) == "nobody is in place. 1 cannot be: its place is too narrow.");
}

TEST_CASE("places to which no way leads, and people whom a wall cuts off") {
    WorldDef def = openFloor(16);
    def.obstacles = {block(-0.5, -12, 0.5, 12)};
    World world = gone(def, {6, 0});
    CHECK(numberOf(world, Standing::NoWay) == 16);
    CHECK(sentenceOf(world) == "nobody is in place. 16 cannot be: no way leads to their places.");
    WorldDef open = openFloor(16);
    World cut = World::create(open).value();
    run(cut, 1.5);
    REQUIRE(give(cut, AddObstacle{block(-6.1, -12, -5.9, 12)}).ok());
    run(cut, 8.0);
    CHECK(numberOf(cut, Standing::NoWay) >= 4);
}

TEST_CASE("who has no room since others stand there") {
    WorldDef def = openFloor(60);
    def.box = {{-12, -2}, {-8, 2}};  // Room for fewer bodies than places.
    def.groups[0].position = {-10, 0};
    def.groups[0].formation.spacing = 0.4;
    World world = World::create(def).value();
    run(world, 20.0);
    CHECK(numberOf(world, Standing::InPlace) < 60);
    CHECK(barredOf(countStandings(world)[0]) > 0);
}

TEST_CASE("who was told to hold waits") {
    World world = World::create(openFloor(9)).value();
    tell(world, {.target = {8, 0}});
    run(world, 2.0);
    REQUIRE(give(world, EditQueue{world.group(0).id, QueueEdit::Hold}).ok());
    run(world, 4.0);
    CHECK(numberOf(world, Standing::Held) == 9);
    CHECK(sentenceOf(world) == "nobody is in place. 9 wait.");
    REQUIRE(give(world, EditQueue{world.group(0).id, QueueEdit::Resume}).ok());
    run(world, 15.0);
    CHECK(numberOf(world, Standing::InPlace) == 9);
}

TEST_CASE("who does not get on since others stand in the only way") {
    WorldDef def = openFloor(1);
    def.obstacles = {block(-0.5, -12, 0.5, -0.4), block(-0.5, 0.4, 0.5, 12)};
    def.groups.push_back({.count = 1, .position = {0, 0}});
    World world = World::create(def).value();
    const std::uint32_t plug = world.characters().id[1];
    REQUIRE(give(world, ChangeCharacters{{plug}, {}, Driver::Outside}).ok());
    REQUIRE(give(world, SetPose{world.group(0).id, {6, 0}, 0.0}).ok());
    run(world, 25.0);
    CHECK(numberOf(world, Standing::Stuck) == 1);
    CHECK(sentenceOf(world) == "nobody is in place. 1 cannot be: it does not get on.");
}

TEST_CASE("a snapshot judges as the world does") {
    World world = gone(openFloor(25), {12, 0}, 10.0);
    World copy = World::restore(world.snapshot()).value();
    CHECK(copy.standings() == world.standings());
}

TEST_CASE("the sentence counts each cause") {
    StandingCounts counts{};
    const auto set = [&](Standing standing, std::uint32_t number) {
        counts[static_cast<std::size_t>(standing)] = number;
    };
    set(Standing::InPlace, 37);
    set(Standing::Outside, 12);
    CHECK(standingSentence(counts) ==
          "37 of 49 are in place. 12 cannot be: their places lie outside the ground.");
    set(Standing::Obstacle, 3);
    set(Standing::OnTheWay, 1);
    set(Standing::Held, 1);
    CHECK(standingSentence(counts) ==
          "37 of 54 are in place. 1 is on the way. 1 waits. 15 cannot be: 12 have "
          "their places outside the ground, 3 have their places in obstacles.");
}
