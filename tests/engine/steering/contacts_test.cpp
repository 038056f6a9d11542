#include "engine/steering/contacts.h"

#include <doctest.h>

#include "base/random.h"

using namespace muster;

namespace {

Environment emptyFloor(double half) {
    return Environment::create({.box = {{-half, -half}, {half, half}}}).value();
}

}  // namespace

TEST_CASE("coincident characters are separated to a diameter, symmetrically") {
    Environment environment = emptyFloor(10);
    environment.setTime(0.0);
    std::vector<Vec2> positions{{1, 1}, {1, 1}};
    Contacts contacts;
    const ContactReport report = contacts.resolve({16}, {}, environment, positions);
    CHECK(distance(positions[0], positions[1]) == doctest::Approx(0.5).epsilon(1e-3));
    CHECK(distance(lerp(positions[0], positions[1], 0.5), {1, 1}) < 1e-9);
    CHECK(report.overlapPairs == 0);
}

TEST_CASE("characters that do not touch stay where they are, bit for bit") {
    Environment environment = emptyFloor(10);
    environment.setTime(0.0);
    std::vector<Vec2> positions{{0, 0}, {0.51, 0}, {3, 3}};
    const std::vector<Vec2> before = positions;
    Contacts contacts;
    contacts.resolve({8}, {}, environment, positions);
    CHECK(positions == before);
}

TEST_CASE("a crowd dropped at random ends without overlap and outside obstacles") {
    Random random(6);
    Environment environment = emptyFloor(12);
    REQUIRE(environment.addObstacle({.polygon = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}}).ok());
    REQUIRE(environment.addObstacle({.centre = {5, 5}, .radius = 1.5}).ok());
    environment.setTime(0.0);
    Contacts contacts;
    for (int scene = 0; scene < 20; ++scene) {
        std::vector<Vec2> positions(150);
        for (Vec2& p : positions) p = {random.uniform(-7, 7), random.uniform(-7, 7)};
        ContactReport report;
        for (int step = 0; step < 30; ++step) report = contacts.resolve({16}, {}, environment, positions);
        CHECK(report.overlapPairs == 0);
        CHECK(report.worstPenetration < 0.1);
        for (const Vec2 p : positions) CHECK(environment.distanceToObstacle(p) > 0.25 - 1e-6);
    }
}

TEST_CASE("overlaps that cannot be resolved are reported") {
    Environment environment = emptyFloor(0.6);
    environment.setTime(0.0);
    std::vector<Vec2> positions(12, Vec2{0, 0});
    for (std::size_t i = 0; i < positions.size(); ++i) positions[i].x = 0.01 * static_cast<double>(i);
    Contacts contacts;
    const ContactReport report = contacts.resolve({8}, {}, environment, positions);
    CHECK(report.overlapPairs > 0);
    CHECK(report.worstPenetration > 0.1);
    for (const Vec2 p : positions) CHECK(isFinite(p));
}

TEST_CASE("overlaps caused by corrections are resolved, and reported where they remain") {
    Environment environment = emptyFloor(10);
    ObstacleDef wall{.polygon = {{-3, -3}, {0.15, -3}, {0.15, 3}, {-3, 3}}};
    REQUIRE(environment.addObstacle(wall).ok());
    environment.setTime(0.0);
    std::vector<Vec2> positions{{0.05, 0}, {0.72, 0}};  // The wall pushes the one 0.35 m towards the other.
    Contacts contacts;
    const ContactReport parted = contacts.resolve({8}, {}, environment, positions);
    CHECK(distance(positions[0], positions[1]) > 0.495);
    CHECK(parted.overlapPairs == 0);
    positions = {{0.05, 0}, {0.72, 0}};
    // One iteration does not separate them.
    const ContactReport seen = contacts.resolve({1}, {}, environment, positions);
    const double share = 1.0 - distance(positions[0], positions[1]) / 0.5;
    REQUIRE(share > 0.1);
    CHECK(seen.overlapPairs == 1);
    CHECK(seen.worstPenetration == doctest::Approx(share));
}

TEST_CASE("contacts are the same for any number of threads") {
    Environment environment = emptyFloor(40);
    Random random(9);
    for (int k = 0; k < 30; ++k) {
        ObstacleDef tree{.centre = {random.uniform(-35, 35), random.uniform(-35, 35)},
                         .radius = random.uniform(0.3, 1.5)};
        REQUIRE(environment.addObstacle(tree).ok());
    }
    environment.setTime(0.0);
    std::vector<Vec2> start(5000);
    for (Vec2& p : start) p = {random.uniform(-40, 40), random.uniform(-40, 40)};
    std::vector<Vec2> expected = start;
    Contacts alone;
    const ContactReport report = alone.resolve({8}, {}, environment, expected);
    for (const int threads : {1, 2, 3, 8}) {
        ThreadPool pool(threads);
        Contacts contacts;
        std::vector<Vec2> positions = start;
        const ContactReport same = contacts.resolve({8}, {}, environment, positions, nullptr, &pool);
        CHECK(positions == expected);
        CHECK(same.overlapPairs == report.overlapPairs);
        CHECK(same.worstPenetration == report.worstPenetration);
    }
}

TEST_CASE("contacts move nobody out of its reach, and a crowd that presses stays apart") {
    Random random(11);
    Environment environment = emptyFloor(12);
    ObstacleDef block{.polygon = {{-1, -2}, {1, -2}, {1, 2}, {-1, 2}}};
    REQUIRE(environment.addObstacle(block).ok());
    environment.setTime(0.0);
    Contacts contacts;
    std::vector<Vec2> positions;
    for (int i = 0; i < 200; ++i) positions.push_back({0.55 * (i % 20) - 5.2, 3.0 + 0.55 * (i / 20)});
    const double step = 2.0 / 60.0;
    for (int k = 0; k < 240; ++k) {
        // All walk towards one point beyond the block at top speed.
        const std::vector<Vec2> before = positions;
        const std::vector<double> reach(before.size(), step);
        for (Vec2& p : positions) p += clampLength(Vec2{0, -4} - p, step);
        const ContactReport report = contacts.resolve({8}, {}, environment, positions, nullptr, nullptr,
                                                      {before, reach});
        CHECK(report.overlapPairs == 0);
        for (std::size_t i = 0; i < positions.size(); ++i) {
            CHECK(distance(positions[i], before[i]) < step * 1.0001);
            CHECK(environment.distanceToObstacle(positions[i]) > 0.25 - 1e-6);
        }
    }
}

TEST_CASE("pairs that cannot come to touch make no difference, bit for bit") {
    Random random(17);
    Environment environment = emptyFloor(12);
    ObstacleDef cart{.polygon = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}},
                     .path = {.waypoints = {{0.0, {-6, 0}, 0.0}, {4.0, {6, 0}, 0.0}}}};
    REQUIRE(environment.addObstacle(cart).ok());
    std::vector<Vec2> positions;
    for (int i = 0; i < 300; ++i) positions.push_back({0.52 * (i % 20) - 5.0, 0.52 * (i / 20) - 3.5});
    Contacts contacts, other;
    const double step = 2.0 / 60.0;
    const std::vector<double> reach(positions.size(), 1.04 * step);
    for (int k = 0; k < 120; ++k) {
        environment.setTime(k / 30.0);
        const std::vector<Vec2> before = positions;
        NeighbourList wide, close;
        wide.build(before, 2.0);
        close.build(before, 2.0);
        close.dropPairs(
            [&](NeighbourPair pair) { return distance(before[pair.low], before[pair.high]) > 1.2; });
        for (Vec2& p : positions) p += clampLength({random.uniform(-1, 1), random.uniform(-1, 1)}, step);
        std::vector<Vec2> same = positions;
        const ContactReport report = contacts.resolve({8}, {}, environment, positions, &wide, nullptr,
                                                      {before, reach});
        const ContactReport again = other.resolve({8}, {}, environment, same, &close, nullptr,
                                                  {before, reach});
        CHECK(positions == same);
        CHECK(report.worstPenetration == again.worstPenetration);
        CHECK(report.overlapPairs == again.overlapPairs);
    }
}

TEST_CASE("an obstacle put on a character lets it walk out, a moving one pushes it") {
    Environment environment = emptyFloor(10);
    ObstacleDef block{.polygon = {{-1, -3}, {1, -3}, {1, 3}, {-1, 3}}};
    const ObstacleId id = environment.addObstacle(block).value();
    environment.setTime(0.0);
    Contacts contacts;
    std::vector<Vec2> positions{{0.5, 0}};
    int steps = 0;
    for (; environment.distanceToObstacle(positions[0]) < 0.25 - 1e-6; ++steps) {
        const std::vector<Vec2> before = positions;
        const std::vector<double> reach{0.05};
        contacts.resolve({8}, {}, environment, positions, nullptr, nullptr, {before, reach});
        REQUIRE(distance(positions[0], before[0]) < 0.05 + 1e-9);
        REQUIRE(steps < 20);
    }
    CHECK(steps == 15);  // 0.75 m.
    block.path.waypoints = {{0, {0, 0}, 0}, {1, {0.5, 0}, 0}};
    REQUIRE(environment.changeObstacle(id, block).ok());
    environment.setTime(0.2);
    const std::vector<Vec2> before = positions;
    const std::vector<double> reach{0.05};
    contacts.resolve({8}, {}, environment, positions, nullptr, nullptr, {before, reach});
    CHECK(positions[0].x == doctest::Approx(1.35));
}

TEST_CASE("a body passes a gap that is a hair narrower than itself, and no narrower one") {
    for (const double width : {0.4985, 0.495}) {
        Environment environment = emptyFloor(10);
        for (const double side : {-1.0, 1.0})
            REQUIRE(
                environment.addObstacle({.centre = {0.0, side * (1.0 + 0.5 * width)}, .radius = 1.0}).ok());
        environment.setTime(0.0);
        Contacts contacts;
        std::vector<Vec2> positions{{-1.0, 0.02}};
        const std::vector<double> reach{2.0 / 60};
        for (int step = 0; step < 120; ++step) {
            const std::vector<Vec2> from = positions;
            positions[0].x += 2.0 / 60;
            contacts.resolve({8}, {}, environment, positions, nullptr, nullptr, {from, reach});
            CHECK(environment.distanceToObstacle(positions[0]) > 0.25 - 1e-3);
            CHECK(distance(from[0], positions[0]) <= 1.006 * reach[0]);
        }
        CHECK((positions[0].x > 1.0) == (width > 0.498));
    }
}
