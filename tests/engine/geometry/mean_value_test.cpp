#include "engine/geometry/polygon.h"

#include <doctest.h>

#include <cmath>

#include "base/random.h"

using namespace muster;

namespace {

// Largest error of "weights sum to one" and "weights times corners give the point".
double errorAt(const Polygon& polygon, Vec2 p) {
    std::vector<double> weights(polygon.size());
    meanValueCoordinates(polygon, p, weights);
    double sum = 0.0;
    Vec2 where;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        sum += weights[i];
        where += polygon[i] * weights[i];
    }
    return std::max(std::fabs(sum - 1.0), distance(where, p));
}

const Polygon kHookWithRoom{{0, 0}, {4, 0}, {4, 3}, {2, 3}, {2, 1}, {0, 1}};
const Polygon kKite{{0, 0}, {3, -1}, {5, 0}, {3, 1}};

}  // namespace

TEST_CASE("the centre of a regular polygon weighs all corners alike") {
    const Polygon square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    std::vector<double> weights(4);
    meanValueCoordinates(square, {1, 1}, weights);
    for (double w : weights) CHECK(w == doctest::Approx(0.25));
}

TEST_CASE("in a triangle they are the barycentric coordinates") {
    const Polygon triangle{{0, 0}, {3, 0}, {1, 2}};
    std::vector<double> weights(3);
    const Vec2 p = triangle[0] * 0.2 + triangle[1] * 0.3 + triangle[2] * 0.5;
    meanValueCoordinates(triangle, p, weights);
    CHECK(weights[0] == doctest::Approx(0.2));
    CHECK(weights[1] == doctest::Approx(0.3));
    CHECK(weights[2] == doctest::Approx(0.5));
}

TEST_CASE("linear precision and partition of unity, inside and outside") {
    Random random(4);
    for (const Polygon& polygon : {kHookWithRoom, kKite}) {
        for (int i = 0; i < 500; ++i)
            CHECK(errorAt(polygon, {random.uniform(-1, 6), random.uniform(-2, 4)}) < 1e-9);
    }
}

TEST_CASE("inside convex polygons no weight is negative") {
    Random random(6);
    std::vector<double> weights(4);
    for (int i = 0; i < 500; ++i) {
        const Vec2 p{random.uniform(0, 5), random.uniform(-1, 1)};
        if (!containsPoint(kKite, p)) continue;
        meanValueCoordinates(kKite, p, weights);
        for (double w : weights) CHECK(w >= 0.0);
    }
}

TEST_CASE("corners and edges are exact, and their neighbourhood is smooth") {
    std::vector<double> weights(kHookWithRoom.size());
    std::vector<double> near(kHookWithRoom.size());
    for (std::size_t i = 0; i < kHookWithRoom.size(); ++i) {
        const std::size_t j = (i + 1) % kHookWithRoom.size();
        meanValueCoordinates(kHookWithRoom, kHookWithRoom[i], weights);
        for (std::size_t k = 0; k < kHookWithRoom.size(); ++k) CHECK(weights[k] == (k == i ? 1.0 : 0.0));
        const Vec2 onEdge = lerp(kHookWithRoom[i], kHookWithRoom[j], 0.3);
        meanValueCoordinates(kHookWithRoom, onEdge, weights);
        for (std::size_t k = 0; k < kHookWithRoom.size(); ++k)
            CHECK(weights[k] == doctest::Approx(k == i ? 0.7 : (k == j ? 0.3 : 0.0)));
        for (const double off : {1e-3, 1e-6, 1e-9, 1e-12, 1e-14, 1e-15, 1e-17}) {
            for (const double side : {1.0, -1.0}) {
                const Vec2 p = onEdge +
                               normalized(perpendicular(kHookWithRoom[j] - kHookWithRoom[i])) * (off * side);
                CHECK(errorAt(kHookWithRoom, p) < 1e-9);
                CHECK(errorAt(kHookWithRoom, kHookWithRoom[i] + Vec2{off, side * off}) < 1e-9);
                meanValueCoordinates(kHookWithRoom, p, near);
                for (std::size_t k = 0; k < kHookWithRoom.size(); ++k)
                    CHECK(std::fabs(near[k] - weights[k]) < 10 * off + 1e-9);
            }
        }
    }
}
