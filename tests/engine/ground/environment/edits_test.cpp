// Edits update only what they touch; the result is that of an environment made from scratch, bit for bit.
#include <doctest.h>

#include "base/archive.h"
#include "engine/ground/environment/environment_scene.h"

using namespace muster;
using namespace muster::test;

namespace {

Environment rebuilt(const Environment& environment) {
    Writer writer;
    environment.save(writer);
    Environment fresh;
    Reader reader(writer.bytes());
    REQUIRE(fresh.load(reader));
    return fresh;
}

void checkPieces(const Environment& a, const Environment& b) {
    REQUIRE(a.pieces().size() == b.pieces().size());
    for (std::size_t k = 0; k < a.pieces().size(); ++k) {
        const ObstaclePiece &one = a.pieces()[k], &other = b.pieces()[k];
        REQUIRE(one.obstacle == other.obstacle);
        REQUIRE(one.corners == other.corners);
        REQUIRE(one.centre == other.centre);
        REQUIRE(one.radius == other.radius);
        REQUIRE(one.range == other.range);
        REQUIRE(one.velocity == other.velocity);
        REQUIRE(one.moving == other.moving);
    }
}

void checkSame(const Environment& a, Random& random) {
    const Environment b = rebuilt(a);
    checkPieces(a, b);
    const auto same = [](std::span<const float> one, std::span<const float> other) {
        return std::equal(one.begin(), one.end(), other.begin(), other.end());
    };
    REQUIRE(same(a.clearance(), b.clearance()));
    REQUIRE(same(a.staticClearance(), b.staticClearance()));
    REQUIRE(valuesOf(a.travelSpeed(), a.grid()) == valuesOf(b.travelSpeed(), b.grid()));
    REQUIRE(valuesOf(a.staticPatchSpeed(), a.grid()) == valuesOf(b.staticPatchSpeed(), b.grid()));
    for (int k = 0; k < 30; ++k) {
        const Vec2 p{random.uniform(-16, 16), random.uniform(-16, 16)};
        const Vec2 q{random.uniform(-16, 16), random.uniform(-16, 16)};
        REQUIRE(a.potentialField(p) == b.potentialField(p));
        REQUIRE(a.distanceToObstacle(p) == b.distanceToObstacle(p));
        REQUIRE(a.clearLine(p, q, 0.25) == b.clearLine(p, q, 0.25));
        REQUIRE(a.projectToFreeSpace(p, 0.25) == b.projectToFreeSpace(p, 0.25));
        REQUIRE(a.ground(p).patch == b.ground(p).patch);
        REQUIRE(a.stepIsFree(p, p + Vec2{0.2, 0.1}, 0.25) == b.stepIsFree(p, p + Vec2{0.2, 0.1}, 0.25));
    }
}

PatchDef farPatch(Random& random, bool moves) {
    PatchDef patch;
    patch.polygon = randomStar(random, {random.uniform(-12, 12), random.uniform(-12, 12)}, 0.5, 3.0);
    patch.speed = random.uniform(0.2, 2.0);
    if (moves) patch.path = randomPath(random);
    return patch;
}

template <class Id>
Id anyOf(std::span<const Id> ids, Random& random) {
    return ids[random.below(static_cast<std::uint32_t>(ids.size()))];
}

void editObstacles(Environment& environment, Random& random) {
    const bool moves = random.below(4) == 0;
    const auto ids = environment.obstacleIds();
    switch (ids.size() < 3 ? 0 : random.below(3)) {
        case 0:
            REQUIRE(environment.addObstacle(randomObstacle(random, 14.0, moves)).ok());
            break;
        case 1:
            REQUIRE(environment.removeObstacle(anyOf(ids, random)).ok());
            break;
        default:
            REQUIRE(environment.changeObstacle(anyOf(ids, random), randomObstacle(random, 14.0, moves)).ok());
    }
}

void editPatches(Environment& environment, Random& random) {
    const bool moves = random.below(4) == 0;
    const auto ids = environment.patchIds();
    switch (ids.empty() ? 0 : random.below(3)) {
        case 0:
            REQUIRE(environment.addPatch(farPatch(random, moves)).ok());
            break;
        case 1:
            REQUIRE(environment.removePatch(anyOf(ids, random)).ok());
            break;
        default:
            REQUIRE(environment.changePatch(anyOf(ids, random), farPatch(random, moves)).ok());
    }
}

}  // namespace

TEST_CASE("after random edits all caches are those of a new environment") {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        Random random(seed);
        Environment environment = emptyWorld(32.0, 0.25);
        double time = 0.0;
        for (int step = 0; step < 25; ++step) {
            CAPTURE(seed);
            CAPTURE(step);
            for (auto edits = random.below(4); edits > 0; --edits)
                random.below(3) == 0 ? editPatches(environment, random) : editObstacles(environment, random);
            if (random.below(3) != 0) environment.setTime(time += random.uniform(0.0, 0.5));
            if (random.below(8) == 0) environment.setFieldDefaults(random.uniform(0.5, 4.0), 1.0);
            checkSame(environment, random);
        }
    }
}

TEST_CASE("what the log of edits names is all that has changed") {
    Random random(77);
    Environment environment = emptyWorld(32.0, 0.25);
    for (int step = 0; step < 60; ++step) {
        const std::uint64_t version = environment.staticVersion();
        const std::vector<float> clearance(environment.staticClearance().begin(),
                                           environment.staticClearance().end());
        const std::vector<float> speed = valuesOf(environment.staticPatchSpeed(), environment.grid());
        editObstacles(environment, random);
        if (step % 3 == 0) editPatches(environment, random);
        std::vector<CellRect> areas;
        REQUIRE(environment.staticChangesSince(version, areas));
        for (std::int32_t i = 0; i < environment.grid().count(); ++i) {
            if (environment.staticClearance()[i] == clearance[i] &&
                environment.staticPatchSpeed()[i] == speed[i])
                continue;
            const Cell c = environment.grid().at(i);
            bool named = false;
            for (const CellRect& area : areas) named = named || !area.common({c, c}).empty();
            REQUIRE(named);
        }
    }
}

TEST_CASE("rasters of open ground without moving things take no memory beyond the clearance") {
    Environment environment = emptyWorld(32.0, 0.25);
    CHECK(environment.travelSpeed().isConstant());
    CHECK(environment.staticPatchSpeed().isConstant());
    CHECK(environment.clearance().data() == environment.staticClearance().data());
    Random random(5);
    const auto car = environment.addObstacle(randomObstacle(random, 8.0, true));
    const auto mud = environment.addPatch(farPatch(random, false));
    CHECK(environment.clearance().data() != environment.staticClearance().data());
    CHECK_FALSE(environment.travelSpeed().isConstant());
    REQUIRE(environment.removeObstacle(*car).ok());
    REQUIRE(environment.removePatch(*mud).ok());
    CHECK(environment.clearance().data() == environment.staticClearance().data());
    CHECK(environment.travelSpeed().isConstant());
}
