#include "engine/steering/hand_over.h"

#include <doctest.h>

#include "engine/steering/characters.h"

using namespace muster;

namespace {

/// Two of one group: one on its way along +x, and one that stands on its place half a metre ahead of it.
struct Pair {
    Characters now;
    std::vector<PlaceWait> waits = std::vector<PlaceWait>(2);
    NeighbourList neighbours;
    CrowdBodies bodies;

    Pair() {
        now.id = {1, 2};
        now.group = {0, 0};
        now.position = {{0, 0}, {0.5, 0}};
        now.velocity = {{0, 0}, {0, 0}};
        now.place = {0, 1};
        now.direction = {{1, 0}, {0, 0}};
        now.cost = {0.9, 0.0};
        now.claim.resize(2);
    }
    void run(double seconds) {
        neighbours.build(now.position, 0.65);
        for (int s = 0; s < 60 * seconds; ++s)
            updateWaits({0.15, 2.0}, now, bodies, neighbours, 1.0 / 60, waits);
    }
};

}  // namespace

TEST_CASE("a wait counts like a walk, once the way has been barred for a second") {
    Pair pair;
    pair.run(0.9);
    CHECK(pair.waits[0].place == -1);
    pair.run(0.6);
    CHECK(pair.waits[0].place == 0);
    CHECK(pair.waits[0].cost == doctest::Approx(1.0).epsilon(0.1));
    CHECK(pair.waits[1].place == -1);  // Who stands on its place waits for nothing.
    pair.run(60.0);
    CHECK(pair.waits[0].cost <= 10.0f);
}

TEST_CASE("nobody waits who gets on, whose way is free, or who is behind others on their way") {
    Pair moving;
    for (int s = 0; s < 240; ++s) {
        moving.now.position[0].x -= 0.01;
        moving.now.position[1].x -= 0.01;
        moving.run(1.0 / 60);
    }
    CHECK(moving.waits[0].place == -1);
    Pair aside;
    aside.now.position[1] = {0, 0.5};
    aside.run(4.0);
    CHECK(aside.waits[0].place == -1);
    Pair queue;
    queue.now.cost[1] = 0.8;
    queue.run(4.0);
    CHECK(queue.waits[0].place == -1);
    Pair others;
    others.now.group[1] = 1;
    others.run(4.0);
    CHECK(others.waits[0].place == -1);
}

TEST_CASE("a barred place stays costly for a while after the character has another") {
    Pair pair;
    pair.run(2.0);
    const float cost = pair.waits[0].cost;
    REQUIRE(cost > 1.0f);
    pair.now.place = {1, 0};
    pair.now.cost = {0.5, 0.6};
    pair.run(2.0);
    CHECK(pair.waits[0].place == 0);
    CHECK(pair.waits[0].cost == doctest::Approx(cost - 0.2f).epsilon(0.05));
    pair.run(60.0);
    CHECK(pair.waits[0].place == -1);
}
