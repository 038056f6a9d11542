#include "engine/orders/pairing.h"

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/random.h"

using namespace muster;

namespace {

std::vector<Vec2> latticeOf(int columns, int rows, double spacing, Vec2 corner) {
    std::vector<Vec2> points;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) points.push_back(corner + Vec2{x * spacing, y * spacing});
    return points;
}

double squares(const std::vector<Vec2>& from, const std::vector<Vec2>& to,
               std::span<const std::int32_t> pairs) {
    double sum = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) sum += lengthSquared(to[pairs[i]] - from[i]);
    return sum;
}

/// The least sum of squares over all pairings, of at most eight points.
double leastSquares(const std::vector<Vec2>& from, const std::vector<Vec2>& to) {
    std::vector<std::int32_t> pairs(from.size());
    std::iota(pairs.begin(), pairs.end(), 0);
    double least = 1e300;
    do least = std::min(least, squares(from, to, pairs));
    while (std::next_permutation(pairs.begin(), pairs.end()));
    return least;
}

}  // namespace

TEST_CASE("a block that is only moved is paired place by place") {
    const std::vector<Vec2> from = latticeOf(9, 7, 0.9, {-3, 2}), to = latticeOf(9, 7, 0.9, {40.03, -17.1});
    Pairing pairing;
    const auto pairs = pairing.pair(from, to);
    for (std::size_t i = 0; i < from.size(); ++i) CHECK(pairs[i] == static_cast<std::int32_t>(i));
}

TEST_CASE("of many that turn a little no neighbours cross") {
    const std::vector<Vec2> from = latticeOf(20, 25, 1.0, {-10, -12});
    std::vector<Vec2> to;
    for (const Vec2 p : from) to.push_back(Vec2{0.985 * p.x - 0.174 * p.y, 0.174 * p.x + 0.985 * p.y});
    Pairing pairing;
    const auto pairs = pairing.pair(from, to);
    for (std::size_t i = 0; i < from.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (distance(from[i], from[j]) < 2.0)
                CHECK(dot(from[i] - from[j], to[pairs[i]] - to[pairs[j]]) >= 0.0);
}

TEST_CASE("after half a turn everybody walks the same way") {
    const std::vector<Vec2> from = latticeOf(60, 1, 1.0, {0, 0});
    std::vector<Vec2> to;
    for (const Vec2 p : from) to.push_back(Vec2{59.0 - p.x, 40.0});
    Pairing pairing;
    const auto pairs = pairing.pair(from, to);
    for (std::size_t i = 0; i < from.size(); ++i) CHECK(distance(to[pairs[i]], from[i] + Vec2{0, 40}) < 1e-9);
}

TEST_CASE("small sets are paired by the least squares of all pairings, one to one") {
    Random random(3);
    Pairing pairing;
    for (int scene = 0; scene < 200; ++scene) {
        std::vector<Vec2> from, to;
        for (int k = 0; k < 7; ++k) {
            from.push_back({random.uniform(0, 10), random.uniform(0, 10)});
            to.push_back({random.uniform(0, 10), random.uniform(0, 10)});
        }
        const auto pairs = pairing.pair(from, to);
        std::vector<std::int32_t> sorted(pairs.begin(), pairs.end());
        std::sort(sorted.begin(), sorted.end());
        for (std::int32_t k = 0; k < 7; ++k) CHECK(sorted[k] == k);
        CHECK(squares(from, to, pairs) == doctest::Approx(leastSquares(from, to)).epsilon(1e-3));
    }
}

TEST_CASE("large sets come near the least squares") {
    Random random(9);
    Pairing pairing;
    JonkerVolgenantSolver solver;
    double worst = 1.0;
    for (int scene = 0; scene < 10; ++scene) {
        std::vector<Vec2> from, to;
        std::vector<double> cost;
        for (int k = 0; k < 200; ++k) {
            from.push_back({random.uniform(0, 20), random.uniform(0, 20)});
            to.push_back({random.uniform(0, 40), random.uniform(0, 10)});
        }
        for (const Vec2 a : from)
            for (const Vec2 b : to) cost.push_back(lengthSquared(a - b));
        REQUIRE(solver.solve(200, 200, cost.data()));
        const double least = squares(from, to, solver.columnOf());
        worst = std::max(worst, squares(from, to, pairing.pair(from, to)) / least);
    }
    MESSAGE("worst ratio of 200 points to the least squares " << worst);
    CHECK(worst < 1.15);
}

TEST_CASE("classes stay among themselves") {
    const std::vector<Vec2> from = latticeOf(4, 2, 1.0, {0, 0}), to = latticeOf(4, 2, 1.0, {10, 0});
    const std::vector<std::uint8_t> fromClass{0, 0, 0, 0, 2, 2, 2, 2}, toClass{2, 2, 2, 2, 0, 0, 0, 0};
    Pairing pairing;
    const auto pairs = pairing.pair(from, to, fromClass, toClass);
    for (std::size_t i = 0; i < from.size(); ++i) CHECK(toClass[pairs[i]] == fromClass[i]);
}

TEST_CASE("two that go straight at the same time keep most of their distance") {
    Pairing pairing;
    Random random(5);
    for (int scene = 0; scene < 30; ++scene) {
        const std::vector<Vec2> from = latticeOf(10, 10, 1.0, {0, 0});
        const double c = random.uniform(-1, 1), s = std::sqrt(1 - c * c);
        std::vector<Vec2> to;
        for (const Vec2 p : from) to.push_back(Vec2{40, 10} + Rotation{c, s}.apply(p - Vec2{4.5, 4.5}));
        const auto pairs = pairing.pair(from, to);
        double nearest = 1e9;
        for (std::size_t i = 0; i < 100; ++i)
            for (std::size_t j = 0; j < i; ++j)
                for (int k = 0; k <= 20; ++k)
                    nearest = std::min(nearest, distance(lerp(from[i], to[pairs[i]], k / 20.0),
                                                         lerp(from[j], to[pairs[j]], k / 20.0)));
        CHECK(nearest > 0.5);
    }
}
