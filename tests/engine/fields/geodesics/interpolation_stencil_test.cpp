// Interpolation of squared costs between landmarks: exact on uniform ground.
#include <doctest.h>

#include <cmath>

#include "base/random.h"
#include "engine/fields/geodesics/interpolation_stencil.h"

using namespace muster;

namespace {

double squareBy(const InterpolationStencil& stencil, std::span<const Landmark> landmarks, Vec2 from,
                double unit) {
    double sum = stencil.offset;
    for (std::int32_t k = 0; k < stencil.count; ++k)
        sum += static_cast<double>(stencil.weight[k]) * unit * unit *
               lengthSquared(from - landmarks[stencil.slot[k]].position);
    return sum;
}

}  // namespace

TEST_CASE("four corners of a square give exact squared costs on uniform ground") {
    const Landmark corners[] = {{0, {2, 3}}, {1, {6, 3}}, {2, {2, 7}}, {3, {6, 7}}};
    Random random(1);
    for (int k = 0; k < 200; ++k) {
        const Vec2 place{random.uniform(2, 6), random.uniform(3, 7)};
        const Vec2 from{random.uniform(-40, 40), random.uniform(-40, 40)};
        const InterpolationStencil stencil = makeStencil(corners, true, place, 2.0f);
        CHECK(squareBy(stencil, corners, from, 2.0) ==
              doctest::Approx(4.0 * lengthSquared(from - place)).epsilon(1e-4));
    }
}

TEST_CASE("three landmarks in any position are nearly exact, two on their line, one at itself") {
    const Landmark three[] = {{0, {0, 0}}, {1, {4, 1}}, {2, {1, 5}}};
    Random random(2);
    for (int k = 0; k < 200; ++k) {
        const Vec2 place{random.uniform(0, 3), random.uniform(0, 3)};
        const Vec2 from{random.uniform(-20, 20), random.uniform(-20, 20)};
        const InterpolationStencil stencil = makeStencil(three, false, place, 1.0f);
        // The ridge moves the weighted mean by a few percent of its distance from the centre.
        CHECK(std::fabs(std::sqrt(squareBy(stencil, three, from, 1.0)) - distance(from, place)) < 0.15);
    }
    const Landmark two[] = {{0, {0, 0}}, {1, {4, 0}}};
    const InterpolationStencil line = makeStencil(two, false, {1, 0}, 1.0f);
    CHECK(line.weight[0] == doctest::Approx(0.75).epsilon(0.05));
    CHECK(line.weight[0] + line.weight[1] == doctest::Approx(1.0));
    const Landmark one[] = {{7, {3, 3}}};
    const InterpolationStencil single = makeStencil(one, false, {5, 5}, 1.0f);
    CHECK(single.count == 1);
    CHECK(single.nearest == 7);
    CHECK(single.weight[0] == 1.0f);
    CHECK(makeStencil({}, false, {0, 0}, 1.0f).count == 0);
}
