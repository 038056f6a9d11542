// Prints what steps and queries cost, and checks that none of them allocates after warm-up.
#include <doctest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "base/stopwatch.h"
#include "counting_new.h"
#include "engine/ground/environment/environment_scene.h"
#include "muster/ground.h"
#include "test_folders.h"

using namespace muster;
using namespace muster::test;

namespace {

// Berlin where it is at hand, else a town of blocks.
Environment town() {
    auto made = Environment::create({.box = {{0, 0}, {256, 256}}, .cell = 0.5});
    REQUIRE(made.ok());
    std::ifstream file(sourceFolder() + "/../shared/maps/Berlin_0_256.map", std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    const auto map = parseMap(text.str());
    if (map.ok()) {
        for (const ObstacleDef& obstacle : mapObstacles(*map, {})) REQUIRE(made->addObstacle(obstacle).ok());
    } else {
        MESSAGE("Berlin_0_256.map is not here; a chequered town stands in");
        for (int i = 0; i < 900; ++i) {
            const Vec2 low{8.0 * (i % 30) + 4.0, 8.0 * (i / 30) + 4.0};
            REQUIRE(made->addObstacle(rectangle(low, low + Vec2{5, 5})).ok());
        }
    }
    return std::move(*made);
}

// Calls `work(i)` `count` times twice: warming up, then measured. Returns microseconds per call.
template <class Work>
double microsecondsEach(int count, const Work& work) {
    for (int i = 0; i < count; ++i) work(i);
    const long before = allocations;
    Stopwatch watch;
    for (int i = 0; i < count; ++i) work(i);
    const double result = 1000.0 * watch.milliseconds() / count;
    CHECK(allocations == before);
    return result;
}

}  // namespace

TEST_CASE("steps with moving discs allocate nothing") {
    Environment environment = emptyWorld(64.0, 0.25);
    Random random(1);
    for (int i = 0; i < 10; ++i) {
        ObstacleDef def = disc({random.uniform(-20, 20), random.uniform(-20, 20)}, 1.0);
        def.path.waypoints = {{0.0, {0, 0}, 0.0}, {5.0, {10, 0}, 0.0}, {10.0, {0, 0}, 0.0}};
        def.path.loop = true;
        REQUIRE(environment.addObstacle(def).ok());
    }
    const double each = microsecondsEach(600, [&](int i) { environment.setTime(i / 60.0); });
    MESSAGE("setTime, 10 moving discs of 1 m on 256 x 256 cells: ", each, " us");
}

TEST_CASE("queries in a town allocate nothing") {
    Stopwatch building;
    Environment environment = town();
    const double adding = building.milliseconds();
    building.restart();
    environment.setTime(0.0);
    MESSAGE(environment.pieces().size(), " pieces: adding ", adding, " ms, caches ", building.milliseconds(),
            " ms");
    Random random(2);
    std::vector<Vec2> points;
    for (int i = 0; i < 10000; ++i) {
        const Vec2 p{random.uniform(1, 255), random.uniform(1, 255)};
        points.push_back(environment.projectToFreeSpace(p, 0.25) +
                         Vec2{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)});
    }
    const int count = static_cast<int>(points.size());
    double sum = 0.0;
    const double distances = microsecondsEach(
        count, [&](int i) { sum += environment.distanceToObstacle(points[i]); });
    const double visits = microsecondsEach(count, [&](int i) {
        environment.forPiecesNear(points[i], 1.0, [&](const ObstaclePiece& piece) { sum += piece.radius; });
    });
    const double pushes = microsecondsEach(
        count, [&](int i) { sum += environment.projectToFreeSpace(points[i], 0.25).x; });
    const double fields = microsecondsEach(count,
                                           [&](int i) { sum += environment.potentialField(points[i]).x; });
    const double grounds = microsecondsEach(count,
                                            [&](int i) { sum += environment.ground(points[i]).travelSpeed; });
    const double lines = microsecondsEach(count, [&](int i) {
        sum += environment.clearLine(points[i], points[i] + Vec2{6.0, 3.0}, 0.25) ? 1.0 : 0.0;
    });
    MESSAGE("us per call: distanceToObstacle ", distances, ", forPiecesNear 1 m ", visits,
            ", projectToFreeSpace ", pushes, ", potentialField ", fields, ", ground ", grounds,
            ", clearLine 6.7 m ", lines);
    CHECK(std::isfinite(sum));
    Stopwatch watch;
    const std::size_t gaps = environment.narrowGaps(0.5).size();
    MESSAGE("narrowGaps: ", watch.milliseconds(), " ms, ", gaps, " found");
    // One edit while it runs.
    watch.restart();
    REQUIRE(environment.addObstacle(disc({128, 128}, 1.0)).ok());
    environment.setTime(0.0);
    MESSAGE("one more disc: ", watch.milliseconds(), " ms");
}
