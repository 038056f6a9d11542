// Windows on new ground take the memory that was made ready for them.
#include <doctest.h>

#include "cost/ground_scene.h"
#include "counting_new.h"
#include "geodesics/windows.h"

using namespace muster;
using namespace muster::test;

namespace {

// A wood: a tree every three metres, each off its lattice.
Environment wood() {
    Environment environment = squareWorld(24.0);
    Random random(8);
    for (double y = -21.0; y <= 21.0; y += 3.0)
        for (double x = -21.0; x <= 21.0; x += 3.0) {
            ObstacleDef tree;
            tree.centre = {x + random.uniform(-0.6, 0.6), y + random.uniform(-0.6, 0.6)};
            tree.radius = random.uniform(0.3, 0.5);
            REQUIRE(environment.addObstacle(tree).ok());
        }
    environment.setTime(0.0);
    return environment;
}

// Makes the windows of some landmarks along a row of the ground, two in a step. Returns the allocations of
// that.
long makeAlong(Windows& windows, const StaticGround& ground, ThreadPool& pool, double y, std::int32_t count) {
    const Grid& grid = ground.fine().grid;
    const std::int32_t known = windows.count();
    const long before = allocations;
    for (std::int32_t k = 0; windows.count() < known + count; ++k) {
        windows.beginStep(ground.fineLevel(), ground.version());
        for (const double x : {-20.0 + 0.5 * (2 * k), -20.0 + 0.5 * (2 * k + 1)}) {
            const std::int32_t landmark = grid.index(grid.nearestCell({x, y}));
            if (!ground.fineLevel().blocked(landmark)) windows.keep(landmark);
        }
        windows.build(2, pool);
        REQUIRE(k < 80);
    }
    return allocations - before;
}

}  // namespace

TEST_CASE("windows on new ground bring no memory of their own where room was made for them") {
    const Environment environment = wood();
    const StaticGround ground = groundOf(environment);
    ThreadPool pool(1);
    Windows windows({512, 16});
    windows.beginStep(ground.fineLevel(), ground.version());
    windows.reserve(600);
    // The solver's own memory grows to what a window asks for.
    for (const double y : {-18.5, -15.2, -12.4, -9.6, -6.5, 14.8, 18.2, 7.1})
        makeAlong(windows, ground, pool, y, 20);
    const long first = windows.count();
    // Where trees stand closest the solver's own lists may still grow; three lists for each window would be
    // 225.
    long grown = 0;
    for (const double y : {1.7, 10.3, 10.9}) grown += makeAlong(windows, ground, pool, y, 25);
    CHECK(grown <= 8);
    CHECK(windows.count() >= first + 75);
    // Without room every one of them brings its own.
    Windows bare({512, 16});
    bare.beginStep(ground.fineLevel(), ground.version());
    makeAlong(bare, ground, pool, -18.5, 20);
    CHECK(makeAlong(bare, ground, pool, 1.7, 25) >= 50);
}

TEST_CASE("room made for windows changes none of them") {
    const Environment environment = wood();
    const StaticGround ground = groundOf(environment);
    ThreadPool pool(2);
    Windows roomy({64, 16});
    Windows bare({64, 16});
    roomy.beginStep(ground.fineLevel(), ground.version());
    roomy.reserve(1000);  // More than may be: the capacity holds.
    makeAlong(roomy, ground, pool, 4.4, 24);
    makeAlong(bare, ground, pool, 4.4, 24);
    REQUIRE(roomy.count() == bare.count());
    Random random(2);
    for (std::int32_t slot = 0; slot < roomy.count(); ++slot) {
        REQUIRE(roomy.field(slot).source() == bare.field(slot).source());
        for (int k = 0; k < 40; ++k) {
            const Vec2 p = roomy.field(slot).source() +
                           Vec2{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)};
            REQUIRE(roomy.field(slot).cost(p) == bare.field(slot).cost(p));
        }
    }
}
