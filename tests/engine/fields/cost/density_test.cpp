// Density and average velocity of the crowd.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/random.h"
#include "engine/fields/cost/density.h"

using namespace muster;

namespace {

const Box kBox{{-4, -3}, {4, 3}};

double mass(const DensityField& field) {
    double sum = 0.0;
    for (const float d : field.density()) sum += d;
    return sum * field.grid().cell * field.grid().cell;
}

}  // namespace

TEST_CASE("a crowd's mass is its number, wherever it stands in the box") {
    Random random(3);
    for (const double lambda : {0.5, 1.0, 2.0, 2.7}) {
        for (const double cell : {0.5, 1.0, 1.3}) {
            DensityField field(kBox, {.cell = cell, .lambda = lambda});
            std::vector<Vec2> positions;
            std::vector<Vec2> velocities;
            for (int k = 0; k < 200; ++k) {
                positions.push_back({random.uniform(-4, 4), random.uniform(-3, 3)});
                velocities.push_back({random.uniform(-2, 2), random.uniform(-2, 2)});
            }
            field.splat(positions, velocities);
            CHECK(mass(field) == doctest::Approx(200).epsilon(1e-5));
            // Momentum is preserved as well.
            Vec2 momentum;
            Vec2 expected;
            for (std::int32_t k = 0; k < field.grid().count(); ++k)
                momentum += Vec2{field.velocityX()[k], field.velocityY()[k]} *
                            (field.density()[k] * cell * cell);
            for (const Vec2 v : velocities) expected += v;
            CHECK(distance(momentum, expected) < 1e-2);
        }
    }
}

TEST_CASE("shares follow the offset from the lower left cell centre") {
    DensityField field({{0, 0}, {4, 4}}, {.cell = 1.0, .lambda = 2.0});
    const Vec2 p{1.5 + 0.3, 1.5 + 0.4};
    field.splat(std::vector<Vec2>{p}, std::vector<Vec2>{{1.0, -0.5}});
    const double raw[4] = {0.6 * 0.6, 0.3 * 0.3, 0.3 * 0.3, 0.4 * 0.4};
    const double sum = raw[0] + raw[1] + raw[2] + raw[3];
    const Cell cells[4] = {{1, 1}, {2, 1}, {2, 2}, {1, 2}};
    for (int k = 0; k < 4; ++k) {
        const std::int32_t index = field.grid().index(cells[k]);
        CHECK(field.density()[index] == doctest::Approx(raw[k] / sum));
        CHECK(field.velocityX()[index] == doctest::Approx(1.0));
        CHECK(field.velocityY()[index] == doctest::Approx(-0.5));
    }
    CHECK(field.occupied().size() == 4);
}

TEST_CASE("a lone walker stays below one per cell and moves without a jump") {
    DensityField field(kBox, {.cell = 1.0, .lambda = 1.0});
    float before = -1.0f;
    for (int k = 0; k < 400; ++k) {
        const Vec2 p{-3.0 + 0.01 * k, 0.37};
        field.splat(std::vector<Vec2>{p}, std::vector<Vec2>{{0.6, 0}});
        for (const float d : field.density()) CHECK(d <= 1.0f + 1e-6f);
        const float here = field.densityAt({0.5, 0.5});
        if (before >= 0.0f) CHECK(std::fabs(here - before) < 0.05f);
        before = here;
        CHECK(field.velocityAt(p).x == doctest::Approx(0.6));
    }
}

TEST_CASE("a second splat leaves nothing of the first") {
    Random random(11);
    DensityField used(kBox, {.cell = 0.7, .lambda = 1.0});
    for (int round = 0; round < 20; ++round) {
        std::vector<Vec2> positions(random.below(60));
        for (Vec2& p : positions) p = {random.uniform(-5, 5), random.uniform(-4, 4)};
        const std::vector<Vec2> velocities(positions.size(), Vec2{1, 2});
        DensityField fresh(kBox, {.cell = 0.7, .lambda = 1.0});
        used.splat(positions, velocities);
        fresh.splat(positions, velocities);
        CHECK(used.density() == fresh.density());
        CHECK(used.velocityX() == fresh.velocityX());
        CHECK(used.velocityY() == fresh.velocityY());
        CHECK(used.occupied() == fresh.occupied());
        for (std::size_t k = 0; k < used.density().size(); ++k) {
            const bool listed = std::binary_search(used.occupied().begin(), used.occupied().end(), k);
            CHECK(listed == (used.density()[k] > 0.0f));
        }
    }
}

TEST_CASE("the average velocity weighs characters equally at one spot") {
    DensityField field(kBox, {});
    const std::vector<Vec2> both{{0.2, 0.2}, {0.2, 0.2}};
    field.splat(both, std::vector<Vec2>{{2, 0}, {0, 1}});
    const Vec2 v = field.velocityAt({0.2, 0.2});
    CHECK(v.x == doctest::Approx(1.0));
    CHECK(v.y == doctest::Approx(0.5));
    CHECK(field.velocityAt({3.5, -2.5}) == Vec2{});
}

TEST_CASE("characters outside the box or without a finite place count for nothing") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    DensityField field(kBox, {});
    field.splat(std::vector<Vec2>{{9, 0}, {nan, 0}, {0, 1e300}, {0, 0}},
                std::vector<Vec2>{{0, 0}, {0, 0}, {0, 0}, {nan, 0}});
    CHECK(mass(field) == 0.0);
    CHECK(field.occupied().empty());
    CHECK(field.densityAt({nan, 0}) == 0.0f);
    CHECK(DensityField().densityAt({0, 0}) == 0.0f);
}
