// Local fields: reserved memory is used, and changes no field.
#include <doctest.h>

#include "counting_new.h"
#include "engine/fields/cost/ground_scene.h"
#include "engine/fields/geodesics/local_fields.h"

using namespace muster;
using namespace muster::test;

namespace {

// A wood: one tree per nine square metres, off the lattice.
Environment wood() {
    Environment environment = squareWorld(24.0);
    Random random(8);
    for (double y = -21.0; y <= 21.0; y += 3.0)
        for (double x = -21.0; x <= 21.0; x += 3.0) {
            ObstacleDef tree{.centre = {x + random.uniform(-0.6, 0.6), y + random.uniform(-0.6, 0.6)},
                             .radius = random.uniform(0.3, 0.5)};
            REQUIRE(environment.addObstacle(tree).ok());
        }
    environment.setTime(0.0);
    return environment;
}

// Solves the fields of some landmarks along a row of the ground, two in a step. Returns the number of
// allocations.
long solveAlong(LocalFields& fields, const StaticGround& ground, ThreadPool& pool, double y,
                std::int32_t count) {
    const Grid& grid = ground.grid();
    const std::int32_t known = fields.count();
    const long before = allocations;
    for (std::int32_t k = 0; fields.count() < known + count; ++k) {
        fields.beginStep(ground.fineLevel());
        for (const double x : {-20.0 + 0.5 * (2 * k), -20.0 + 0.5 * (2 * k + 1)}) {
            const std::int32_t landmark = grid.index(grid.nearestCell({x, y}));
            if (!ground.fineLevel().blocked(landmark)) fields.retain(landmark);
        }
        fields.solveRequested(2, pool);
        REQUIRE(k < 80);
    }
    return allocations - before;
}

}  // namespace

TEST_CASE("local fields allocate nothing where memory was reserved") {
    const Environment environment = wood();
    const StaticGround ground = groundOf(environment);
    ThreadPool pool(1);
    LocalFields fields({512, 16});
    fields.beginStep(ground.fineLevel());
    fields.reserve(600);
    // The solver's own memory grows to the size of a local field.
    for (const double y : {-18.5, -15.2, -12.4, -9.6, -6.5, 14.8, 18.2, 7.1})
        solveAlong(fields, ground, pool, y, 20);
    const long first = fields.count();
    // Where trees stand closest the solver's own lists may still grow; three lists per field would be 225.
    long grown = 0;
    for (const double y : {1.7, 10.3, 10.9}) grown += solveAlong(fields, ground, pool, y, 25);
    CHECK(grown <= 8);
    CHECK(fields.count() >= first + 75);
    // Without reserved memory every field allocates its own.
    LocalFields bare({512, 16});
    bare.beginStep(ground.fineLevel());
    solveAlong(bare, ground, pool, -18.5, 20);
    CHECK(solveAlong(bare, ground, pool, 1.7, 25) >= 50);
}

TEST_CASE("reserved memory changes no field") {
    const Environment environment = wood();
    const StaticGround ground = groundOf(environment);
    ThreadPool pool(2);
    LocalFields reserved({64, 16});
    LocalFields bare({64, 16});
    reserved.beginStep(ground.fineLevel());
    reserved.reserve(1000);  // Beyond the capacity, which limits it.
    solveAlong(reserved, ground, pool, 4.4, 24);
    solveAlong(bare, ground, pool, 4.4, 24);
    REQUIRE(reserved.count() == bare.count());
    Random random(2);
    for (std::int32_t slot = 0; slot < reserved.count(); ++slot) {
        REQUIRE(reserved.field(slot).source() == bare.field(slot).source());
        for (int k = 0; k < 40; ++k) {
            const Vec2 p = reserved.field(slot).source() +
                           Vec2{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)};
            REQUIRE(reserved.field(slot).cost(p) == bare.field(slot).cost(p));
        }
    }
}

TEST_CASE("after an edit the fields that it does not touch stay, and all are those of the new ground") {
    Environment environment = wood();
    StaticGround ground = groundOf(environment);
    ThreadPool pool(1);
    LocalFields fields({512, 16});
    solveAlong(fields, ground, pool, 1.7, 40);
    const std::int32_t before = fields.count();
    REQUIRE(environment.addObstacle({.centre = {-18.0, 3.0}, .radius = 0.8}).ok());
    ground.update(environment, 1.0, 0.25);
    fields.beginStep(ground.fineLevel());
    CHECK(fields.count() < before);
    CHECK(fields.count() > before / 3);
    LocalFields fresh({512, 16});
    fresh.beginStep(ground.fineLevel());
    Random random(3);
    const Grid& grid = ground.grid();
    for (std::int32_t slot = 0; slot < fields.count(); ++slot) {
        const CostField& field = fields.field(slot);
        const std::int32_t landmark = grid.index(grid.nearestCell(field.source()));
        fresh.retain(landmark);
        fresh.solveRequested(1, pool);
        const CostField& expected = fresh.field(fresh.find(landmark));
        for (int k = 0; k < 40; ++k) {
            const Vec2 p = field.source() + Vec2{random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0)};
            REQUIRE(field.squaredCost(p) == expected.squaredCost(p));
        }
    }
}
