// Crowds so large that a plan takes several steps.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

// A square of `side` times `side` people, and as many trees beside them as there are rows.
WorldDef largeFloor(std::int32_t side, double away) {
    WorldDef def;
    const double half = 0.5 * side + away + 10.0;
    def.box = {{-half, -half}, {half, half}};
    GroupDef group{.count = side * side, .formation = {.spacing = 1.0}};
    Random random(5);
    for (std::int32_t k = 0; k < group.count; ++k)
        group.starts.push_back({k % side - 0.5 * side - away + random.uniform(-0.2, 0.2),
                                k / side - 0.5 * side + random.uniform(-0.2, 0.2)});
    for (std::int32_t k = 0; k < 20; ++k)
        def.obstacles.push_back(
            tree({random.uniform(-0.5, 0.5) * side, random.uniform(-0.5, 0.5) * side}, 0.3));
    def.groups.push_back(group);
    return def;
}

double meanWay(const World& world) {
    double sum = 0.0;
    const CharactersView c = world.characters();
    const auto places = world.group(0).placePositions;
    for (std::size_t i = 0; i < c.size(); ++i)
        if (c.place[i] >= 0) sum += distance(c.position[i], places[c.place[i]]);
    return sum / static_cast<double>(c.size());
}

bool placesAreApart(const World& world) {
    std::vector<int> taken(world.characters().size(), 0);
    for (const std::int32_t place : world.characters().place)
        if (place >= 0 && ++taken[place] > 1) return false;
    return true;
}

}  // namespace

TEST_CASE("eleven thousand: two steps a plan, nobody shares a place, any number of threads") {
    const WorldDef def = largeFloor(105, 3.0);
    World alone = World::create(def, 1).value();
    World two = World::create(def, 2).value();
    World three = World::create(def, 3).value();
    double before = 1e9;
    for (int step = 0; step < 45; ++step) {
        for (World* world : {&alone, &two, &three}) world->step();
        if (step % 15 != 14) continue;
        REQUIRE(two.hash() == alone.hash());
        REQUIRE(three.hash() == alone.hash());
        CHECK(placesAreApart(alone));
        const double now = meanWay(alone);
        CHECK(now < before);
        before = now;
    }
    CHECK(before < 2.6);  // From 3 m and some more.
    const std::span place = alone.characters().place;
    CHECK(std::count(place.begin(), place.end(), -1) < 200);  // Under the trees.
    CHECK(alone.contacts().overlapPairs == 0);
}

TEST_CASE("eleven thousand, saved in the middle of a plan, go on bit for bit") {
    World world = World::create(largeFloor(105, 2.0), 2).value();
    for (int step = 0; step < 8; ++step) world.step();
    checkGoesOn(world, 7);
}

TEST_CASE("a plan of many is near the best for each of a few of them") {
    // Everybody's own place lies 3 m ahead: nobody gains by exchanging, whatever the matching has looked at
    // so far.
    World world = World::create(largeFloor(105, 3.0), 2).value();
    for (int step = 0; step < 30; ++step) world.step();
    const CharactersView c = world.characters();
    const auto places = world.group(0).placePositions;
    int gaining = 0;
    Random random(8);
    for (int look = 0; look < 20000; ++look) {
        const auto a = random.below(static_cast<std::uint32_t>(c.size()));
        const auto b = random.below(static_cast<std::uint32_t>(c.size()));
        if (a == b || c.place[a] < 0 || c.place[b] < 0 || distance(c.position[a], c.position[b]) > 4.0)
            continue;
        const auto walk = [&](std::uint32_t who, std::uint32_t whose) {
            return lengthSquared(places[c.place[whose]] - c.position[who]);
        };
        const double now = walk(a, a) + walk(b, b);
        const double exchanged = walk(a, b) + walk(b, a);
        gaining += exchanged < 0.99 * now - 0.1 ? 1 : 0;
    }
    CHECK(gaining == 0);
}
