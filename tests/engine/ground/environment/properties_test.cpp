// Properties over random scenes (rapidcheck).
#include <doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "base/archive.h"
#include "engine/ground/environment/environment_scene.h"

using namespace muster;
using namespace muster::test;

namespace {

Environment anyWorld(Random& random) {
    Environment environment = emptyWorld(16.0, *rc::gen::element(0.2, 0.25, 0.5));
    const int obstacles = *rc::gen::inRange(0, 20);
    for (int i = 0; i < obstacles; ++i)
        RC_ASSERT(environment.addObstacle(randomObstacle(random, 8.0, i % 2 == 0)).ok());
    for (int i = 0; i < 3; ++i) RC_ASSERT(environment.addPatch(randomPatch(random, 8.0, i % 2 == 0)).ok());
    return environment;
}

}  // namespace

TEST_CASE("property: projected discs are free, nothing is NaN") {
    CHECK(rc::check([] {
        Random random(*rc::gen::arbitrary<std::uint64_t>());
        Environment environment = anyWorld(random);
        environment.setTime(random.uniform(-1, 9));
        for (int i = 0; i < 20; ++i) {
            const Vec2 p{random.uniform(-9, 9), random.uniform(-9, 9)};
            const Vec2 free = environment.projectToFreeSpace(p, 0.25);
            RC_ASSERT(environment.distanceToObstacle(free) > 0.25 - 1e-6);
            RC_ASSERT(isFinite(environment.potentialField(p)));
            RC_ASSERT(environment.ground(p).travelSpeed > 0.0);
        }
    }));
}

TEST_CASE("property: an environment restored in the middle continues alike") {
    CHECK(rc::check([] {
        Random random(*rc::gen::arbitrary<std::uint64_t>());
        Environment a = anyWorld(random);
        a.setTime(random.uniform(0, 5));
        Writer writer;
        a.save(writer);
        Environment b;
        Reader reader(writer.bytes());
        RC_ASSERT(b.load(reader));
        for (int step = 0; step < 5; ++step) {
            const double time = random.uniform(0, 9);
            a.setTime(time);
            b.setTime(time);
            if (!a.obstacleIds().empty() && step == 2) {
                RC_ASSERT(a.removeObstacle(a.obstacleIds()[0]).ok());
                RC_ASSERT(b.removeObstacle(b.obstacleIds()[0]).ok());
            }
            RC_ASSERT(std::equal(a.clearance().begin(), a.clearance().end(), b.clearance().begin()));
            RC_ASSERT(valuesOf(a.travelSpeed(), a.grid()) == valuesOf(b.travelSpeed(), b.grid()));
            Hasher ha, hb;
            a.hash(ha);
            b.hash(hb);
            RC_ASSERT(ha.value() == hb.value());
        }
    }));
}
