// Halls: walls round free rectangles, places of people, and one short run.
#include "lab/verify/scenes/hall.h"

#include <doctest.h>

using namespace muster;

TEST_CASE("what is outside of all rooms is wall, and the ground has the rooms' area") {
    const Hall hall({boxOf(0, 0, 10, 10), boxOf(10, 4.5, 15, 5.5), boxOf(15, 0, 25, 10)});
    CHECK(hall.def.box.width() == 25.0);
    CHECK(hall.def.obstacles.size() == 2);
    CHECK(hall.ground().area() == doctest::Approx(205.0));
    CHECK(hall.ground().contains({12, 5}));
    CHECK_FALSE(hall.ground().contains({12, 4}));
    const Hall corner({boxOf(0, 0, 12, 2), boxOf(10, 0, 12, 12)});
    CHECK(corner.ground().area() == doctest::Approx(44.0));
    CHECK(Hall({boxOf(0, 0, 5, 2)}).def.obstacles.empty());
}

TEST_CASE("people are spread over a box, apart from each other and from its sides") {
    for (const std::int32_t count : {1, 10, 150, 1000}) {
        const Box box = boxOf(2, 2, 22, 18);
        const auto places = scattered(box, count, 3);
        REQUIRE(places.size() == static_cast<std::size_t>(count));
        double least = 1e9;
        for (std::size_t i = 0; i < places.size(); ++i) {
            CHECK(box.grown(-0.29).contains(places[i]));
            for (std::size_t k = 0; k < i; ++k) least = std::min(least, distance(places[i], places[k]));
        }
        CHECK(least > 0.4);
        CHECK(scattered(box, count, 3) == places);
    }
    CHECK(scattered(boxOf(0, 0, 5, 5), 20, 1) != scattered(boxOf(0, 0, 5, 5), 20, 2));
}

TEST_CASE("lines have their directions") {
    const auto all = Trajectories::create(1.0,
                                          {{0, 1, {0, 0}}, {1, 1, {2, 0}}, {0, 2, {5, 0}}, {1, 2, {5, 2}}});
    CHECK(crossings(*all, uprightLine(1, -1, 1))[0].direction == 1);
    CHECK(crossings(*all, levelLine(1, 4, 6))[0].direction == 1);
    CHECK(wordIn("up 1.0 10", 2) == "10");
    CHECK(wordIn("up", 1).empty());
}

TEST_CASE("one walks through a corridor and leaves") {
    Hall hall({boxOf(0, 0, 10, 2)});
    hall.exit(boxOf(8, 0, 10, 2));
    hall.crowd({.starts = {{1.0, 1.0}}, .order = Order::leave()});
    auto run = HallRun::start(hall, 1);
    REQUIRE_MESSAGE(run.ok(), run.status().message());
    run->runUntil(20.0);
    CHECK(run->leavings().size() == 1);
    CHECK(run->lastLeaving() == doctest::Approx(7.0 / 1.34).epsilon(0.1));
    CHECK(run->outside() == 0.0);
    VerifySample sample;
    run->report(sample, {"", 1, true});
    CHECK(sample.picture.find("<polyline") != std::string::npos);
    CHECK(sample.hash != 0);
}
