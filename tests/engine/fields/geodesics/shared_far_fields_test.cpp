// Far fields that groups share: they are those that each would have solved, and follow the ground.
#include "engine/fields/geodesics/shared_far_fields.h"

#include <doctest.h>

#include "engine/fields/cost/ground_scene.h"
#include "engine/fields/geodesics/far_fields.h"

using namespace muster;
using namespace muster::test;

namespace {

/// What a group of places in a corner of the ground is told from another corner.
double costBy(FarFields& fields, const StaticGround& ground, ThreadPool& pool, SharedFarFields* shared,
              std::int32_t& solved) {
    const Vec2 place{150, 140};
    fields.beginStep(ground, 40);
    (void)fields.stencil(place);
    solved = fields.solveRequested(100, pool, shared);
    return fields.squaredCost(fields.stencil(place), {110, 120});
}

}  // namespace

TEST_CASE("far fields of another group are taken where the ground is as it was, and count as solved") {
    // So large that fields cover boxes.
    Environment environment = squareWorld(200.0);
    REQUIRE(environment.addObstacle(rectangle(120, 110, 130, 150)).ok());
    environment.setTime(0.0);
    StaticGround ground = groundOf(environment);
    REQUIRE(ground.hasWideCoarse());
    ThreadPool pool{2};
    SharedFarFields shared;
    FarFields first, second, alone;
    std::int32_t solved = 0, again = 0;
    const auto check = [&] {
        shared.beginStep();
        shared.update(ground);
        const double cost = costBy(first, ground, pool, &shared, solved);
        CHECK(costBy(second, ground, pool, &shared, again) == cost);
        CHECK(again == solved);
        CHECK(costBy(alone, ground, pool, nullptr, again) == cost);
        CHECK(again == solved);
        return cost;
    };
    const double before = check();
    CHECK(solved > 0);
    const std::int32_t landmark = ground.coarse().grid.index(ground.coarse().grid.nearestCell({150, 140}));
    CHECK(shared.find(landmark + 1000) == nullptr);
    // A building that no box meets changes nothing; one in the way does.
    REQUIRE(environment.addObstacle(rectangle(-190, -190, -180, -180)).ok());
    environment.setTime(0.0);
    ground.update(environment, 1.0, 0.25);
    CHECK(check() == before);
    CHECK(solved == 0);
    REQUIRE(environment.addObstacle(rectangle(112, 60, 119, 199)).ok());
    environment.setTime(0.0);
    ground.update(environment, 1.0, 0.25);
    CHECK(check() != before);
    CHECK(solved > 0);
}
