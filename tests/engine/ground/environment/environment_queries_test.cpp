#include <doctest.h>

#include <cmath>
#include <set>

#include "engine/ground/environment/environment_scene.h"

using namespace muster;
using namespace muster::test;

namespace {

Environment randomWorld(Random& random, int obstacles, double time = 1.1) {
    Environment environment = emptyWorld(20.0, 0.25);
    for (int i = 0; i < obstacles; ++i)
        REQUIRE(environment.addObstacle(randomObstacle(random, 9.0, i % 3 == 0)).ok());
    environment.setTime(time);
    return environment;
}

Vec2 randomPoint(Random& random, double reach = 10.0) {
    return {random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

// Over all pieces, without bins or rasters.
double bruteDistance(const Environment& environment, Vec2 p, double limit) {
    double d = limit;
    for (const ObstaclePiece& piece : environment.pieces()) d = std::min(d, piece.signedDistance(p));
    return d;
}

}  // namespace

TEST_CASE("distances, near pieces and fields equal sums over all pieces") {
    Random random(4);
    for (int round = 0; round < 10; ++round) {
        const Environment environment = randomWorld(random, 12);
        std::vector<std::int32_t> found;
        for (int i = 0; i < 300; ++i) {
            const Vec2 p = randomPoint(random, 12.0);
            const double limit = random.uniform(0.1, 6.0);
            CHECK(environment.distanceToObstacle(p, limit) == bruteDistance(environment, p, limit));
            found.clear();
            environment.forPiecesNear(p, limit, [&](const ObstaclePiece& piece) {
                found.push_back(static_cast<std::int32_t>(&piece - environment.pieces().data()));
            });
            CHECK(std::is_sorted(found.begin(), found.end()));
            const std::set<std::int32_t> near(found.begin(), found.end());
            CHECK(near.size() == found.size());
            Vec2 field;
            for (std::size_t k = 0; k < environment.pieces().size(); ++k) {
                const ObstaclePiece& piece = environment.pieces()[k];
                const double d = piece.signedDistance(p);
                if (d <= limit) CHECK(near.count(static_cast<std::int32_t>(k)) == 1);
                if (d < 1.5) field += normalized(p - piece.centre) * (1.0 - std::max(d, 0.0) / 1.5);
            }
            CHECK(distance(environment.potentialField(p), field) < 1e-12);
        }
    }
}

TEST_CASE("points near an obstacle or the edge are marked as a search over all pieces marks them") {
    Random random(6);
    for (int round = 0; round < 10; ++round) {
        const Environment environment = randomWorld(random, 12);
        const double reach = round == 0 ? 0.0 : random.uniform(0.05, 4.0);
        const Box inner = environment.def().box.grown(-reach);
        std::vector<Vec2> points(300);
        for (Vec2& p : points) p = randomPoint(random, 11.0);
        points.push_back(inner.min);
        points.push_back(inner.max);
        std::vector<std::uint8_t> near(points.size(), 2);
        environment.markNearObstacles(points, reach, near);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool expected = !inner.contains(points[i]) ||
                                  bruteDistance(environment, points[i], reach) < reach;
            CHECK(near[i] == (expected ? 1 : 0));
        }
    }
}

TEST_CASE("the potential field follows the paper's equation 1") {
    Environment environment = emptyWorld(20.0, 0.5);
    ObstacleDef def = rectangle({-2, -1}, {2, 1});
    def.range = 5.0;
    def.strength = 2.0;
    REQUIRE(environment.addObstacle(def).ok());
    // 3 m above the wall: 1 - 2/5, away from the centre, not from the wall.
    const Vec2 field = environment.potentialField({1.5, 3.0});
    const Vec2 away = normalized({1.5, 3.0});
    CHECK(field.x == doctest::Approx(away.x * 2.0 * 0.6));
    CHECK(field.y == doctest::Approx(away.y * 2.0 * 0.6));
    CHECK(length(environment.potentialField({0.5, 0.5})) == doctest::Approx(2.0));
    CHECK(length(environment.potentialField({0.0, 0.0})) == doctest::Approx(2.0));
    CHECK(environment.potentialField({0, 6.0}) == Vec2{0, 0});
    CHECK(environment.potentialField({0, 60.0}) == Vec2{0, 0});
}

TEST_CASE("clear lines keep the disc off every obstacle and in the box") {
    Random random(6);
    int clear = 0;
    for (int round = 0; round < 10; ++round) {
        const Environment environment = randomWorld(random, 6);
        for (int i = 0; i < 300; ++i) {
            const Vec2 a = randomPoint(random), b = randomPoint(random);
            const double radius = random.uniform(0.0, 0.6);
            double nearest = 1e9;
            for (const ObstaclePiece& piece : environment.pieces())
                nearest = std::min(nearest, piece.segmentDistance(a, b));
            const Box inner = environment.def().box.grown(-radius);
            const bool expected = nearest > radius && inner.contains(a) && inner.contains(b);
            CHECK(environment.clearLine(a, b, radius) == expected);
            clear += expected ? 1 : 0;
        }
    }
    CHECK(clear > 300);
    const Environment open = emptyWorld(20.0, 0.5);
    CHECK(open.clearLine({-9.5, 0}, {9.5, 0}, 0.5));
    CHECK(!open.clearLine({-9.6, 0}, {9.5, 0}, 0.5));
    CHECK(!open.clearLine({NAN, 0}, {9.5, 0}, 0.5));
}

TEST_CASE("projection frees discs, by the shortest displacement where one surface is near") {
    Environment environment = emptyWorld(20.0, 0.25);
    REQUIRE(environment.addObstacle(rectangle({-2, -2}, {2, 2})).ok());
    CHECK(distance(environment.projectToFreeSpace({2.1, 0.3}, 0.5), {2.5, 0.3}) < 1e-6);
    CHECK(distance(environment.projectToFreeSpace({1.5, 0.3}, 0.5), {2.5, 0.3}) < 1e-6);
    CHECK(distance(environment.projectToFreeSpace({2.3, 2.4}, 0.6), Vec2{2, 2} + Vec2{0.3, 0.4} * 1.2) <
          1e-6);
    CHECK(environment.projectToFreeSpace({5, 5}, 0.5) == Vec2{5, 5});
    CHECK(distance(environment.projectToFreeSpace({50, -70}, 0.5), {9.5, -9.5}) < 1e-9);
    CHECK(isFinite(environment.projectToFreeSpace({NAN, 0}, 0.5)));
    // Into the corner between two walls, and between wall and border.
    REQUIRE(environment.addObstacle(rectangle({2, -6}, {6, -2})).ok());
    CHECK(distance(environment.projectToFreeSpace({2.1, -1.9}, 0.5), {2.5, -1.5}) < 1e-6);
    REQUIRE(environment.addObstacle(rectangle({4, 8}, {10, 10})).ok());
    CHECK(distance(environment.projectToFreeSpace({9.9, 7.9}, 0.5), {9.5, 7.5}) < 1e-6);
}

TEST_CASE("projection ends free wherever free space exists") {
    Random random(8);
    for (int round = 0; round < 15; ++round) {
        const Environment environment = randomWorld(random, 14);
        for (int i = 0; i < 300; ++i) {
            const Vec2 p = randomPoint(random, 11.0);
            const double radius = random.uniform(0.05, 0.7);
            const Vec2 free = environment.projectToFreeSpace(p, radius);
            CHECK(bruteDistance(environment, free, 3.0) > radius - 1e-6);
            CHECK(environment.def().box.grown(1e-9 - radius).contains(free));
            // Already free: it stays.
            CHECK(distance(environment.projectToFreeSpace(free, radius), free) < 1e-7);
            CHECK(environment.clearLine(free, free, radius));
        }
    }
    // A world with no free space at all still answers.
    Environment full = emptyWorld(4.0, 0.5);
    REQUIRE(full.addObstacle(rectangle({-5, -5}, {5, 5})).ok());
    CHECK(isFinite(full.projectToFreeSpace({0, 0}, 0.3)));
}

TEST_CASE(
    "the ground has the speed of the slowest patch; in the raster, of every patch that touches the cell") {
    Random random(10);
    for (int round = 0; round < 8; ++round) {
        Environment environment = emptyWorld(20.0, 0.5);
        for (int i = 0; i < 6; ++i) REQUIRE(environment.addPatch(randomPatch(random, 8.0, i % 2 == 0)).ok());
        environment.setTime(2.3);
        std::vector<Polygon> polygons;
        std::vector<double> speeds;
        for (PatchId id : environment.patchIds()) {
            const PatchDef& def = *environment.patch(id);
            polygons.push_back(environment.patchPolygon(id));
            speeds.push_back(def.speed < 0 ? environment.def().clips[def.motion].speed : def.speed);
        }
        const Grid& grid = environment.grid();
        std::vector<float> least(grid.count(), 1e9f);
        for (int i = 0; i < 60000; ++i) {
            const Vec2 p = randomPoint(random);
            double slowest = 1e9;
            for (std::size_t k = 0; k < polygons.size(); ++k) {
                if (containsPoint(polygons[k], p)) slowest = std::min(slowest, speeds[k]);
            }
            const GroundSample sample = environment.ground(p);
            CHECK(static_cast<bool>(sample.patch) == (slowest < 1e9));
            CHECK(sample.travelSpeed == (slowest < 1e9 ? slowest : 1.0));
            if (sample.patch) CHECK(sample.motion == environment.patch(sample.patch)->motion);
            const std::int32_t cell = grid.index(grid.cellOf(p));
            least[cell] = std::min(least[cell], static_cast<float>(slowest));
        }
        // Sampled points give what a cell must have at most; cells away from patches stay open.
        for (std::int32_t i = 0; i < grid.count(); ++i) {
            const float found = environment.travelSpeed()[i];
            if (least[i] < 1e8f) CHECK(found <= least[i]);
            const Vec2 c = grid.centre(grid.at(i));
            bool near = false;
            for (const Polygon& polygon : polygons)
                near = near || signedDistance(polygon, c) < 0.5 * 1.4143 * grid.cell;
            if (!near) CHECK(found == 1.0f);
        }
    }
}

TEST_CASE("patches touch cells that share area, not those that share an edge") {
    Environment environment = emptyWorld(8.0, 1.0);
    PatchDef patch{.polygon = {{0, 0}, {2, 0}, {2, 1.1}, {0, 1.1}}, .motion = 3};
    REQUIRE(environment.addPatch(patch).ok());
    int slow = 0;
    for (float speed : valuesOf(environment.travelSpeed(), environment.grid())) slow += speed < 1.0f ? 1 : 0;
    CHECK(slow == 4);
    patch.speed = 2.0;
    REQUIRE(environment.changePatch(environment.patchIds()[0], patch).ok());
    CHECK(environment.ground({1, 1}).travelSpeed == 2.0);
    CHECK(environment.travelSpeed()[environment.grid().index({4, 4})] == 2.0f);
}

TEST_CASE("narrow gaps between obstacles are found by width") {
    Environment environment = emptyWorld(20.0, 0.5);
    REQUIRE(environment.addObstacle(rectangle({0, 0}, {2, 2})).ok());
    REQUIRE(environment.addObstacle(rectangle({2.3, 0}, {4, 2})).ok());
    REQUIRE(environment.addObstacle(disc({1, 3.4}, 1.0)).ok());
    REQUIRE(environment.addObstacle(rectangle({4, 0}, {6, 2})).ok());  // touches the second
    REQUIRE(environment.addObstacle(disc({-5, -5}, 1.0)).ok());
    REQUIRE(environment.addObstacle(disc({-5, -2.6}, 1.0)).ok());
    const auto gaps = environment.narrowGaps(0.5);
    REQUIRE(gaps.size() == 3);
    CHECK(gaps[0].a == ObstacleId{1});
    CHECK(gaps[0].b == ObstacleId{2});
    CHECK(gaps[0].width == doctest::Approx(0.3));
    CHECK(gaps[0].where.x == doctest::Approx(2.15));
    CHECK(gaps[1].b == ObstacleId{3});
    CHECK(gaps[1].width == doctest::Approx(0.4));
    CHECK(distance(gaps[1].where, {1.0, 2.2}) < 1e-9);
    CHECK(gaps[2].a == ObstacleId{5});
    CHECK(gaps[2].where.y == doctest::Approx(-3.8));
    CHECK(environment.narrowGaps(0.35).size() == 1);
    CHECK(environment.narrowGaps(0.5, 2).size() == 2);
    // A third obstacle that fills the gap.
    REQUIRE(environment.addObstacle(rectangle({1.5, -1}, {2.5, 3})).ok());
    for (const NarrowGap& gap : environment.narrowGaps(0.35))
        CHECK(!(gap.a == ObstacleId{1} && gap.b == ObstacleId{2}));
}

TEST_CASE("narrow gaps within one obstacle, to the edge of the world, and beside where two touch") {
    Environment slot = emptyWorld(8.0, 0.5);
    ObstacleDef fork{
        .polygon = {{-2, -2}, {2, -2}, {2, 2}, {0.15, 2}, {0.15, -1}, {-0.15, -1}, {-0.15, 2}, {-2, 2}}};
    REQUIRE(slot.addObstacle(fork).ok());
    auto gaps = slot.narrowGaps(0.5);
    REQUIRE(gaps.size() == 1);
    CHECK(gaps[0].a == gaps[0].b);
    CHECK(gaps[0].width == doctest::Approx(0.3));
    CHECK(gaps[0].where.x == doctest::Approx(0.0));
    CHECK(slot.narrowGaps(0.29).empty());

    Environment edge = emptyWorld(8.0, 0.5);
    const Box box = edge.def().box;
    REQUIRE(edge.addObstacle(rectangle({box.min.x + 0.3, 0}, {box.min.x + 2, 1})).ok());
    REQUIRE(edge.addObstacle(disc({0, box.max.y - 1.2}, 1.0)).ok());
    REQUIRE(edge.addObstacle(rectangle({1, box.min.y}, {2, box.min.y + 1})).ok());      // Touches it.
    REQUIRE(edge.addObstacle(rectangle({box.max.x - 1, 0}, {box.max.x + 1, 1})).ok());  // Lies across it.
    gaps = edge.narrowGaps(0.5);
    REQUIRE(gaps.size() == 2);
    CHECK(gaps[0].a == ObstacleId{1});
    CHECK(!gaps[0].b);
    CHECK(gaps[0].width == doctest::Approx(0.3));
    CHECK(gaps[0].where.x == doctest::Approx(box.min.x + 0.15));
    CHECK(gaps[1].a == ObstacleId{2});
    CHECK(gaps[1].width == doctest::Approx(0.2));
    CHECK(distance(gaps[1].where, {0, box.max.y - 0.1}) < 1e-9);

    Environment slit = emptyWorld(10.0, 0.5);
    REQUIRE(slit.addObstacle(rectangle({0, 0}, {4, 1})).ok());
    REQUIRE(slit.addObstacle({.polygon = {{0, 1}, {0.5, 1}, {0.5, 1.3}, {4, 1.3}, {4, 3}, {0, 3}}}).ok());
    gaps = slit.narrowGaps(0.5);
    REQUIRE(gaps.size() == 1);
    CHECK(gaps[0].a == ObstacleId{1});
    CHECK(gaps[0].b == ObstacleId{2});
    CHECK(gaps[0].width == doctest::Approx(0.3));
    CHECK(gaps[0].where.y == doctest::Approx(1.15));
}

TEST_CASE("an obstacle without a slot has no gap within, however many parts it has") {
    Environment environment = emptyWorld(10.0, 0.5);
    ObstacleDef star;
    for (int k = 0; k < 24; ++k) {
        const double angle = k * 0.2617993877991494;
        star.polygon.push_back(Vec2{std::cos(angle), std::sin(angle)} * (k % 2 == 0 ? 3.0 : 2.4));
    }
    REQUIRE(environment.addObstacle(star).ok());
    CHECK(environment.narrowGaps(0.2).empty());
}
