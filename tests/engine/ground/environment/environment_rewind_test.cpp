// Rasters that are taken over from a later state equal those made from nothing.
#include <doctest.h>

#include <algorithm>

#include "base/archive.h"
#include "base/random.h"
#include "engine/ground/environment/environment.h"

using namespace muster;

namespace {

ObstacleDef someObstacle(Random& random) {
    ObstacleDef def;
    const Vec2 at{random.uniform(-10, 10), random.uniform(-10, 10)};
    if (random.below(2) == 0) {
        def.centre = at;
        def.radius = random.uniform(0.3, 1.5);
    } else {
        def.polygon = {at, at + Vec2{random.uniform(0.5, 3), 0}, at + Vec2{0, random.uniform(0.5, 3)}};
    }
    if (random.below(4) == 0) def.path.waypoints = {{0, {0, 0}, 0}, {10, {random.uniform(-4, 4), 3}, 1.0}};
    return def;
}

PatchDef somePatch(Random& random) {
    PatchDef def;
    const Vec2 at{random.uniform(-10, 8), random.uniform(-10, 8)};
    def.polygon = {at, at + Vec2{2, 0}, at + Vec2{2, 2}, at + Vec2{0, 2}};
    def.motion = 3;
    if (random.below(4) == 0) def.path.waypoints = {{0, {0, 0}, 0}, {10, {2, 2}, 0}};
    return def;
}

void edit(Environment& environment, Random& random) {
    switch (random.below(5)) {
        case 0:
            REQUIRE(environment.addObstacle(someObstacle(random)).ok());
            break;
        case 1:
            if (!environment.obstacleIds().empty())
                REQUIRE(environment.removeObstacle(environment.obstacleIds()[0]).ok());
            break;
        case 2:
            if (!environment.obstacleIds().empty())
                REQUIRE(
                    environment.changeObstacle(environment.obstacleIds().back(), someObstacle(random)).ok());
            break;
        case 3:
            REQUIRE(environment.addPatch(somePatch(random)).ok());
            break;
        default:
            if (!environment.patchIds().empty())
                REQUIRE(environment.removePatch(environment.patchIds().back()).ok());
    }
}

std::vector<std::uint8_t> bytesOf(const Environment& environment) {
    Writer writer;
    environment.save(writer);
    return writer.take();
}

Environment loaded(const std::vector<std::uint8_t>& bytes) {
    Environment environment;
    Reader reader(bytes);
    REQUIRE(environment.load(reader));
    return environment;
}

template <class Values>
std::vector<float> clearancesOf(const Environment& environment, const Values& values) {
    std::vector<float> all;
    for (std::int32_t k = 0; k < environment.grid().count(); ++k) all.push_back(values[k]);
    return all;
}

void checkEqual(const Environment& a, const Environment& b) {
    CHECK(bytesOf(a) == bytesOf(b));
    CHECK(clearancesOf(a, a.clearance()) == clearancesOf(b, b.clearance()));
    CHECK(clearancesOf(a, a.staticClearance()) == clearancesOf(b, b.staticClearance()));
    CHECK(clearancesOf(a, a.travelSpeed()) == clearancesOf(b, b.travelSpeed()));
    CHECK(clearancesOf(a, a.staticPatchSpeed()) == clearancesOf(b, b.staticPatchSpeed()));
    Random random(1);
    for (int k = 0; k < 60; ++k) {
        const Vec2 p{random.uniform(-12, 12), random.uniform(-12, 12)};
        CHECK(a.distanceToObstacle(p) == b.distanceToObstacle(p));
        CHECK(a.potentialField(p) == b.potentialField(p));
        CHECK(a.ground(p).patch == b.ground(p).patch);
    }
}

}  // namespace

TEST_CASE(
    "an environment that goes back keeps its rasters, edited where things differ, and equals a fresh one") {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Environment environment = Environment::create({.box = {{-12, -12}, {12, 12}}}).value();
        for (int k = 0; k < 8; ++k) edit(environment, random);
        environment.setTime(1.0);
        const auto bytes = bytesOf(environment);
        const std::uint64_t instance = environment.instance(), version = environment.staticVersion();
        const std::uint32_t edits = random.below(6);
        for (std::uint32_t k = 0; k < edits; ++k) {
            edit(environment, random);
            environment.setTime(1.0 + 0.5 * k);
        }
        environment.setTime(random.uniform(1, 9));
        const std::uint64_t later = environment.staticVersion();
        Environment back = loaded(bytes);
        back.keepCachesOf(environment);
        checkEqual(back, loaded(bytes));
        CHECK(back.instance() == instance);
        // Whoever knows the later version must see that the ground changed, where it did.
        if (edits == 0) CHECK(back.staticVersion() == version);
        CHECK(back.staticVersion() >= later);
        // And it goes on like the fresh one.
        Environment fresh = loaded(bytes);
        Random more(seed + 50), same(seed + 50);
        for (int k = 0; k < 4; ++k) {
            edit(back, more);
            edit(fresh, same);
            back.setTime(2.0 + k);
            fresh.setTime(2.0 + k);
        }
        checkEqual(back, fresh);
    }
}

TEST_CASE("of another box nothing is kept, but versions go on") {
    EnvironmentDef def;
    Environment before = Environment::create(def).value();
    REQUIRE(before.addObstacle({.name = "", .polygon = {}, .centre = {1, 1}, .radius = 1.0}).ok());
    before.setTime(0.0);
    def.box.max = {20, 20};
    Environment other = Environment::create(def).value();
    other.setTime(0.0);
    const auto bytes = bytesOf(other);
    Environment back = loaded(bytes);
    const std::uint64_t version = before.staticVersion();
    back.keepCachesOf(before);
    CHECK(back.staticVersion() > version);
    std::vector<CellRect> areas;
    CHECK_FALSE(back.staticChangesSince(version, areas));
    checkEqual(back, other);
}
