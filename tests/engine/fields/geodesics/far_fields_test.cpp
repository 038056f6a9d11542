// Far fields by themselves: costs by a stencil, against the cost field of the place itself.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/fields/cost/ground_scene.h"
#include "engine/fields/geodesics/far_fields.h"

using namespace muster;
using namespace muster::test;

namespace {

struct Far {
    Environment environment;
    StaticGround ground;
    FarFields fields;
    ThreadPool pool{2};

    explicit Far(Environment made) : environment(std::move(made)) {
        environment.setTime(0.0);
        ground.update(environment, 1.0, 0.25);
        fields.beginStep(ground, 400);
    }
    // The stencil after all its fields were solved.
    InterpolationStencil stencil(Vec2 place) {
        (void)fields.stencil(place);
        (void)fields.solveRequested(100, pool);
        return fields.stencil(place);
    }
    double cost(const InterpolationStencil& stencil, Vec2 from) const {
        return std::sqrt(std::max(0.0, fields.squaredCost(stencil, from)));
    }
};

Environment twoPools() {
    Environment environment = squareWorld(30.0);
    REQUIRE(environment.addObstacle(rectangle(-1, -12, 1, 30)).ok());
    REQUIRE(environment.addPatch(slowBox(4, -8, 14, 8, 0.25)).ok());
    REQUIRE(environment.addPatch(slowBox(-20, 6, -8, 18, 0.5)).ok());
    return environment;
}

}  // namespace

TEST_CASE("on uniform ground a stencil is exact from anywhere") {
    Far far(squareWorld(30.0));
    // A tree far away, since open ground needs no far fields.
    REQUIRE(far.environment.addObstacle({.centre = {28, 28}, .radius = 0.4}).ok());
    far.ground.update(far.environment, 1.0, 0.25);
    far.fields.beginStep(far.ground, 400);
    Random random(3);
    for (int k = 0; k < 20; ++k) {
        const Vec2 place{random.uniform(-20, 20), random.uniform(-20, 20)};
        const InterpolationStencil stencil = far.stencil(place);
        REQUIRE(stencil.count == 4);
        double sum = 0.0;
        for (std::int32_t n = 0; n < 4; ++n) sum += stencil.weight[n];
        CHECK(sum == doctest::Approx(1.0));
        const Grid& grid = far.ground.coarse().grid;
        // At cell centres, where reading does not interpolate.
        const Vec2 from = grid.centre(grid.nearestCell({random.uniform(-28, 20), random.uniform(-28, 20)}));
        CHECK(far.cost(stencil, from) == doctest::Approx(distance(from, place)).epsilon(0.02));
    }
}

TEST_CASE("landmarks lie closer on slow ground, and bound the cost by the triangle inequality") {
    Far far(twoPools());
    const InterpolationStencil slow = far.stencil({9.0, 0.0});
    const InterpolationStencil fast = far.stencil({20.0, 0.0});
    CHECK(slow.slowUnitCost == doctest::Approx(4.0));
    CHECK(fast.slowUnitCost == 0.0f);
    const auto spacing = [&](const InterpolationStencil& stencil) {
        double least = 1e9;
        for (std::int32_t a = 0; a < stencil.count; ++a)
            for (std::int32_t b = 0; b < a; ++b)
                least = std::min(least, distance(far.fields.field(stencil.slot[a]).source(),
                                                 far.fields.field(stencil.slot[b]).source()));
        return least;
    };
    CHECK(spacing(slow) < 0.6 * spacing(fast));
    Random random(5);
    for (int k = 0; k < 40; ++k) {
        const Vec2 place = freeSpot(far.environment, random, 24.0);
        const Vec2 from = freeSpot(far.environment, random, 28.0);
        const InterpolationStencil stencil = far.stencil(place);
        if (stencil.count == 0) continue;
        const double cost = far.cost(stencil, from);
        for (std::int32_t n = 0; n < stencil.count; ++n) {
            const double there = std::sqrt(far.fields.field(stencil.slot[n]).squaredCost(from));
            CHECK(cost <= there + stencil.toPlace[n] + 1e-5);
            CHECK(cost >= std::fabs(there - stencil.toPlace[n]) - 1e-5);
        }
    }
}

TEST_CASE("costs to places on slow ground are near those of the place's own field") {
    Far far(twoPools());
    EikonalSolver solver;
    CostField field;
    Random random(7);
    std::vector<double> errors;
    for (int k = 0; k < 25; ++k) {
        const Vec2 place{random.uniform(4.5, 13.5), random.uniform(-7.5, 7.5)};
        const InterpolationStencil stencil = far.stencil(place);
        REQUIRE(stencil.count > 0);
        solver.solve(far.ground.fineLevel().unitCost(), place, {}, field);
        for (int n = 0; n < 20; ++n) {
            const Vec2 from = freeSpot(far.environment, random, 28.0);
            if (distance(from, place) < 8.0) continue;
            errors.push_back(std::fabs(far.cost(stencil, from) / field.cost(from) - 1.0));
        }
    }
    std::sort(errors.begin(), errors.end());
    MESSAGE("slow places: median " << errors[errors.size() / 2] << ", p95 "
                                   << errors[errors.size() * 95 / 100] << ", worst " << errors.back());
    CHECK(errors[errors.size() / 2] < 0.04);
    CHECK(errors[errors.size() * 95 / 100] < 0.1);
    CHECK(errors.back() < 0.2);
}

TEST_CASE("far fields restored from an archive give the same costs") {
    Far far(twoPools());
    const InterpolationStencil stencil = far.stencil({9.0, 2.0});
    const double cost = far.cost(stencil, {-15.0, -3.0});
    Writer writer;
    far.fields.visit(writer);
    Far other(twoPools());
    Reader reader(writer.bytes());
    other.fields.visit(reader);
    REQUIRE(reader.ok());
    other.fields.solveMissing(other.pool);
    CHECK(other.fields.count() == far.fields.count());
    CHECK(other.cost(other.fields.stencil({9.0, 2.0}), {-15.0, -3.0}) == cost);
}
