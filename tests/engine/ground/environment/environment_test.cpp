#include "engine/ground/environment/environment.h"

#include <doctest.h>

#include <cmath>

#include "base/archive.h"
#include "base/maths.h"
#include "base/random.h"
#include "engine/ground/environment/environment_scene.h"

using namespace muster;
using namespace muster::test;

namespace {

// Distance to the nearest surface or box edge without bins or rasters: dense sampling of nothing, but
// plain polygons and discs.
double bruteDistance(const Environment& environment, Vec2 p) {
    double d = 1e9;
    for (ObstacleId id : environment.obstacleIds()) {
        const ObstacleDef& def = *environment.obstacle(id);
        const Waypoint now = def.path.at(environment.time());
        if (def.polygon.empty()) {
            d = std::min(d, distance(p, def.centre + now.position) - def.radius);
            continue;
        }
        Polygon moved = def.polygon;
        const Vec2 pivot = centroid(def.polygon);
        const Rotation turn{cosine(now.angle), sine(now.angle)};
        for (Vec2& q : moved) q = pivot + turn.apply(q - pivot) + now.position;
        d = std::min(d, signedDistance(moved, p));
    }
    return d;
}

void checkRasters(const Environment& environment) {
    const Grid& grid = environment.grid();
    const Box box = environment.def().box;
    int wrong = 0;
    for (std::int32_t i = 0; i < grid.count(); ++i) {
        const Vec2 p = grid.centre(grid.at(i));
        const double edge = std::min(std::min(p.x - box.min.x, box.max.x - p.x),
                                     std::min(p.y - box.min.y, box.max.y - p.y));
        const double expected = std::min({bruteDistance(environment, p), edge, Environment::kClearanceLimit});
        const double found = environment.clearance()[i];
        // Inside concave obstacles the depth counts to the nearest part's surface only.
        if (expected > 0.0 ? std::fabs(found - expected) > 1e-5 : found > 1e-5) ++wrong;
    }
    CHECK(wrong == 0);
}

bool sameRasters(const Environment& a, const Environment& b) {
    return std::equal(a.clearance().begin(), a.clearance().end(), b.clearance().begin(),
                      b.clearance().end()) &&
           valuesOf(a.travelSpeed(), a.grid()) == valuesOf(b.travelSpeed(), b.grid());
}

}  // namespace

TEST_CASE("clearance equals brute force, with and without moving obstacles, after any edit") {
    Random random(1);
    for (int round = 0; round < 6; ++round) {
        Environment environment = emptyWorld(20.0, 0.25);
        for (int i = 0; i < 8; ++i)
            REQUIRE(environment.addObstacle(randomObstacle(random, 9.0, i % 2 == 0)).ok());
        checkRasters(environment);
        for (const double time : {0.0, 1.7, 4.0, 12.3, 3.1}) {
            environment.setTime(time);
            checkRasters(environment);
        }
        REQUIRE(environment.removeObstacle(environment.obstacleIds()[1]).ok());
        checkRasters(environment);
        REQUIRE(
            environment.changeObstacle(environment.obstacleIds()[2], randomObstacle(random, 9.0, true)).ok());
        REQUIRE(environment.changeObstacle(environment.obstacleIds()[3], randomObstacle(random, 9.0, false))
                    .ok());
        checkRasters(environment);
    }
}

TEST_CASE("rasters depend on the definitions and the clock, not on the order of edits") {
    Random random(2);
    Environment tried = emptyWorld(20.0, 0.25);
    std::vector<ObstacleDef> kept;
    std::vector<PatchDef> keptPatches;
    for (int i = 0; i < 30; ++i) {
        const ObstacleDef def = randomObstacle(random, 9.0, i % 3 == 0);
        const PatchDef patch = randomPatch(random, 9.0, i % 3 == 1);
        const auto id = tried.addObstacle(def);
        const auto patchId = tried.addPatch(patch);
        REQUIRE(id.ok());
        REQUIRE(patchId.ok());
        tried.setTime(0.37 * i);
        if (i % 2 == 0) {
            REQUIRE(tried.removeObstacle(*id).ok());
            REQUIRE(tried.removePatch(*patchId).ok());
        } else {
            kept.push_back(def);
            keptPatches.push_back(patch);
        }
    }
    tried.setTime(5.5);
    Environment fresh = emptyWorld(20.0, 0.25);
    for (const ObstacleDef& def : kept) REQUIRE(fresh.addObstacle(def).ok());
    for (const PatchDef& def : keptPatches) REQUIRE(fresh.addPatch(def).ok());
    fresh.setTime(5.5);
    CHECK(sameRasters(tried, fresh));
}

TEST_CASE("an environment that is saved and loaded gives the same answers") {
    Random random(3);
    Environment environment = emptyWorld(20.0, 0.25);
    for (int i = 0; i < 10; ++i)
        REQUIRE(environment.addObstacle(randomObstacle(random, 9.0, i % 3 == 0)).ok());
    for (int i = 0; i < 5; ++i) REQUIRE(environment.addPatch(randomPatch(random, 9.0, i % 2 == 0)).ok());
    REQUIRE(environment.removeObstacle(environment.obstacleIds()[9]).ok());
    environment.setTime(2.25);
    Writer writer;
    environment.save(writer);
    Environment loaded;
    const std::uint64_t before = loaded.groundVersion();
    Reader reader(writer.bytes());
    REQUIRE(loaded.load(reader));
    CHECK(reader.remaining() == 0);
    CHECK(loaded.groundVersion() > before);
    CHECK(sameRasters(environment, loaded));
    Hasher a, b;
    environment.hash(a);
    loaded.hash(b);
    CHECK(a.value() == b.value());
    for (int i = 0; i < 200; ++i) {
        const Vec2 p{random.uniform(-10, 10), random.uniform(-10, 10)},
            q{random.uniform(-10, 10), random.uniform(-10, 10)};
        CHECK(environment.potentialField(p) == loaded.potentialField(p));
        CHECK(environment.projectToFreeSpace(p, 0.3) == loaded.projectToFreeSpace(p, 0.3));
        CHECK(environment.distanceToObstacle(p) == loaded.distanceToObstacle(p));
        CHECK(environment.stepIsFree(p, p + Vec2{0.3, 0.2}, 0.3) ==
              loaded.stepIsFree(p, p + Vec2{0.3, 0.2}, 0.3));
        CHECK(environment.clearLine(p, q, 0.3) == loaded.clearLine(p, q, 0.3));
        CHECK(environment.ground(p).patch == loaded.ground(p).patch);
    }
    // Ids are never used again.
    CHECK(*loaded.addObstacle(disc({0, 0}, 1.0)) == ObstacleId{11});
    // The hash sees the clock and the definitions.
    loaded.setTime(2.5);
    Hasher c;
    loaded.hash(c);
    CHECK(c.value() != a.value());
}

TEST_CASE("broken archives are refused and change nothing") {
    Environment environment = emptyWorld(20.0, 0.5);
    REQUIRE(environment.addObstacle(disc({1, 1}, 1.0)).ok());
    Writer writer;
    environment.save(writer);
    for (std::size_t cut = 0; cut < writer.bytes().size(); ++cut) {
        Reader reader(std::span(writer.bytes()).first(cut));
        CHECK(!environment.load(reader));
    }
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        std::vector<std::uint8_t> bytes = writer.bytes();
        bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] = static_cast<std::uint8_t>(
            random.next());
        Reader reader(bytes);
        Environment other;
        // Whatever loads must answer.
        if (other.load(reader) && other.grid().count() < 100000)
            CHECK(isFinite(other.projectToFreeSpace({1, 1}, 0.25)));
    }
    CHECK(environment.obstacleIds().size() == 1);
}

TEST_CASE("versions count edits and movement") {
    Environment environment = emptyWorld(20.0, 0.5);
    ObstacleDef mover = disc({0, 0}, 1.0);
    mover.path.waypoints = {{1.0, {0, 0}, 0.0}, {2.0, {3, 0}, 0.0}};
    const auto id = environment.addObstacle(mover);
    REQUIRE(id.ok());
    CHECK(environment.groundVersion() == 1);
    CHECK(environment.staticVersion() == 0);
    environment.setTime(0.5);
    CHECK(environment.groundVersion() == 1);
    environment.setTime(1.5);
    CHECK(environment.groundVersion() == 2);
    REQUIRE(environment.addObstacle(disc({5, 5}, 1.0)).ok());
    CHECK(environment.groundVersion() == 3);
    CHECK(environment.staticVersion() == 1);
    CHECK(!environment.removeObstacle(ObstacleId{77}).ok());
    CHECK(environment.groundVersion() == 3);
    REQUIRE(environment.removeObstacle(*id).ok());
    CHECK(environment.staticVersion() == 1);
}

TEST_CASE("bad definitions are refused with their reason and add nothing") {
    EnvironmentDef def;
    const auto refused = [](EnvironmentDef d) { return Environment::create(d).status().message(); };
    def.cell = 0.0;
    CHECK(refused(def) == "the ground cell must be positive");
    def = {};
    def.box = {{0, 0}, {0, 5}};
    CHECK(refused(def) == "the world's box is empty or not finite");
    def = {};
    def.cell = 1e-4;
    CHECK(refused(def) == "the world would have more than 16 million ground cells");
    def = {};
    def.box.max.x = NAN;
    CHECK(refused(def) != "");
    Environment environment = emptyWorld(20.0, 0.5);
    const auto bad = [&](const ObstacleDef& d) { return environment.addObstacle(d).status().message(); };
    CHECK(bad({}) == "the obstacle has neither a polygon nor a positive radius");
    CHECK(bad(disc({0, NAN}, 1.0)) == "the obstacle's centre is not finite or too far away");
    CHECK(bad(disc({0, 0}, INFINITY)) != "");
    CHECK(bad(block({{0, 0}, {1, 1}, {1, 0}, {0, 1}})).find("edges 0 and 2") != std::string::npos);
    ObstacleDef both = block({{0, 0}, {1, 0}, {1, 1}});
    both.radius = 1.0;
    CHECK(bad(both) == "the obstacle is given both as polygon and as disc");
    ObstacleDef late = disc({0, 0}, 1.0);
    late.path.waypoints = {{1.0, {0, 0}, 0.0}, {1.0, {3, 0}, 0.0}};
    CHECK(bad(late).find("waypoint 1") != std::string::npos);
    late = disc({0, 0}, 1.0);
    late.strength = NAN;
    CHECK(bad(late) != "");
    PatchDef patch{.polygon = {{0, 0}, {1, 0}, {1, 1}}, .motion = 99};
    CHECK(environment.addPatch(patch).status().message() == "the patch plays motion 99, which no clip bears");
    patch.motion = 1;
    patch.speed = 0.0;
    CHECK(environment.addPatch(patch).status().message() == "the patch's speed must be positive");
    patch.speed = 1e-60;
    CHECK(!environment.addPatch(patch).ok());
    CHECK(environment.obstacleIds().empty());
    CHECK(environment.patchIds().empty());
    CHECK(environment.groundVersion() == 0);
    CHECK(environment.changePatch(PatchId{1}, {}).code() == StatusCode::NotFound);
}

TEST_CASE("timed paths interpolate, loop and stop") {
    TimedPath path{{{1.0, {0, 0}, 0.0}, {3.0, {4, 0}, 1.0}, {4.0, {4, 2}, 1.0}}, false};
    CHECK(path.at(0.0).position == Vec2{0, 0});
    CHECK(path.at(2.0).position == Vec2{2, 0});
    CHECK(path.at(2.0).angle == 0.5);
    CHECK(path.at(9.0).position == Vec2{4, 2});
    CHECK(path.velocity(2.0) == Vec2{2, 0});
    CHECK(path.velocity(3.5) == Vec2{0, 2});
    CHECK(path.velocity(0.5) == Vec2{0, 0});
    CHECK(path.velocity(9.0) == Vec2{0, 0});
    CHECK(path.angularVelocity(2.0) == 0.5);
    path.loop = true;
    CHECK(path.at(5.0).position.x == doctest::Approx(2.0));
    CHECK(path.at(3000002.0).position.x == doctest::Approx(2.0));
    CHECK(path.velocity(5.0) == Vec2{2, 0});
    CHECK(TimedPath{}.at(3.0).position == Vec2{});
    const TimedPath one{{{1.0, {2, 3}, 0.5}}, true};
    CHECK(one.at(-5.0).position == Vec2{2, 3});
    CHECK(one.at(5.0).position == Vec2{2, 3});
    CHECK(one.velocity(5.0) == Vec2{});
}

TEST_CASE("parts of rotating obstacles have the velocity of their centres") {
    Environment environment = emptyWorld(20.0, 0.5);
    ObstacleDef bar = block({{-2, -0.5}, {2, -0.5}, {2, 0.5}, {1, 0.6}, {-1, 0.55}, {-2, 0.5}});
    bar.polygon = {{-3, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {-3, 1}};
    bar.path.waypoints = {{0.0, {0, 0}, 0.0}, {10.0, {10, 5}, 20.0}};
    REQUIRE(environment.addObstacle(bar).ok());
    environment.setTime(1.3);
    std::vector<Vec2> before;
    for (const ObstaclePiece& piece : environment.pieces()) before.push_back(piece.centre);
    std::vector<Vec2> velocity;
    for (const ObstaclePiece& piece : environment.pieces()) velocity.push_back(piece.velocity);
    environment.setTime(1.3 + 1e-6);
    REQUIRE(before.size() >= 2);
    for (std::size_t i = 0; i < before.size(); ++i)
        CHECK(distance((environment.pieces()[i].centre - before[i]) / 1e-6, velocity[i]) < 1e-4);
}
