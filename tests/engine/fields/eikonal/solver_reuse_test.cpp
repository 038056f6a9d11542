// A used solver gives the same result as a new one.
#include <doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "engine/fields/cost/unit_cost_builder.h"
#include "engine/fields/eikonal/eikonal_solver.h"

using namespace muster;

namespace {

Polygon boxAt(Random& random, double half, double least, double most) {
    const Vec2 low{random.uniform(-half, half), random.uniform(-half, half)};
    const Vec2 size{random.uniform(least, most), random.uniform(least, most)};
    return {low, {low.x + size.x, low.y}, low + size, {low.x, low.y + size.y}};
}

// Slow patches, obstacles and a crowd, each in most scenes.
UnitCost randomCost(Random& random) {
    EnvironmentDef def;
    const double half = random.below(4) == 0 ? 5.0 : 8.0;
    def.box = {{-half, -half}, {half, half}};
    Environment environment = std::move(Environment::create(def)).value();
    for (std::uint32_t k = random.below(4); k > 0; --k) {
        PatchDef patch{
            .polygon = boxAt(random, half, 0.5, 4.0), .motion = 3, .speed = random.uniform(0.1, 0.6)};
        (void)environment.addPatch(patch);
    }
    for (std::uint32_t k = random.below(4); k > 0; --k)
        (void)environment.addObstacle({.polygon = boxAt(random, half, 0.3, 5.0)});
    environment.setTime(0.0);
    DensityField density(def.box, {});
    std::vector<Vec2> crowd;
    const Vec2 middle{random.uniform(-half, half), random.uniform(-half, half)};
    for (std::uint32_t k = random.below(60); k > 0; --k)
        crowd.push_back(middle + Vec2{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)});
    const std::vector<Vec2> velocities(crowd.size(), Vec2{random.uniform(-1, 1), random.uniform(-1, 1)});
    density.splat(crowd, velocities);
    UnitCost cost;
    UnitCostBuilder().build({}, environment, density, 0.25, cost);
    return cost;
}

bool sameBits(const CostField& a, const CostField& b, Random& random) {
    const Grid& grid = a.grid();
    for (std::int32_t k = 0; k < grid.count(); ++k)
        if (!(a.value(grid.at(k)) == b.value(grid.at(k)))) return false;
    for (int k = 0; k < 20; ++k) {
        const Vec2 p{random.uniform(-8, 8), random.uniform(-8, 8)};
        if (!(a.cost(p) == b.cost(p)) || !(a.direction(p) == b.direction(p))) return false;
    }
    return a.acceptedCount() == b.acceptedCount();
}

}  // namespace

TEST_CASE("a used solver gives the same bits as a new one: patches, crowds, obstacles, bounded targets") {
    Random random(2024);
    EikonalSolver used;
    CostField again;
    int different = 0;
    for (int scene = 0; scene < 250; ++scene) {
        const UnitCost cost = randomCost(random);
        const double half = cost.grid.box().max.x;
        for (int solve = 0; solve < 16; ++solve) {
            const Vec2 source{random.uniform(-half, half), random.uniform(-half, half)};
            std::vector<Vec2> targets;
            for (std::uint32_t k = random.below(4); k > 0; --k)
                targets.push_back(source + Vec2{random.uniform(-2, 2), random.uniform(-2, 2)});
            CostField fresh;
            used.solve(cost, source, targets, again);
            EikonalSolver().solve(cost, source, targets, fresh);
            different += sameBits(again, fresh, random) ? 0 : 1;
        }
    }
    CHECK(different == 0);
}

TEST_CASE("seeds on expensive ground that a front never reached leave no traces") {
    Environment environment = std::move(Environment::create({.box = {{-16, -16}, {16, 16}}})).value();
    REQUIRE(
        environment.addPatch({.polygon = {{0.3, -4}, {4, -4}, {4, 4}, {0.3, 4}}, .motion = 3, .speed = 0.15})
            .ok());
    environment.setTime(0.0);
    UnitCost cost;
    UnitCostBuilder().build({}, environment, DensityField(), 0.25, cost);
    EikonalSolver used;
    CostField again;
    CostField fresh;
    used.solve(cost, {0, 0}, std::vector<Vec2>{{-0.3, 0}}, again);
    used.solve(cost, {0, 1}, std::vector<Vec2>{{3, 0.2}}, again);
    EikonalSolver().solve(cost, {0, 1}, std::vector<Vec2>{{3, 0.2}}, fresh);
    Random random(1);
    CHECK(sameBits(again, fresh, random));
}
