#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/random.h"
#include "lab/study/models/tour.h"

namespace muster {
namespace {

const Box kBorder{{-20.0, -11.0}, {20.0, 11.0}};

TEST_CASE("ways go straight where they can, and round the corners of a block where they cannot") {
    const std::vector<Box> blocks{{{-4.0, -3.0}, {4.0, 3.0}}};
    const SeenGround ground(blocks, kBorder, 1.0);
    CHECK(ground.distance({-10.0, 8.0}, {10.0, 8.0}) == doctest::Approx(20.0));
    // Round the upper or the lower corners of the block grown by 1 m.
    const double side = std::hypot(5.0, 4.0);
    CHECK(ground.distance({-10.0, 0.0}, {10.0, 0.0}) == doctest::Approx(2.0 * side + 10.0));
    std::vector<Vec2> way;
    ground.appendWay({-10.0, 0.5}, {10.0, 0.5}, way);
    REQUIRE(way.size() == 3);
    CHECK(way[0] == Vec2{-5.0, 4.0});
    CHECK(way[1] == Vec2{5.0, 4.0});
    CHECK(way[2] == Vec2{10.0, 0.5});
}

// The shortest order of all.
double shortest(const TourFinder& tours, Vec2 from, std::vector<std::int32_t> order) {
    std::sort(order.begin(), order.end());
    double best = 1e9;
    do best = std::min(best, tours.length(from, order));
    while (std::next_permutation(order.begin(), order.end()));
    return best;
}

TEST_CASE(
    "tours are near the shortest of all orders, and worse than it by the detour that is asked for at most") {
    const SeenGround ground(std::span<const Box>{}, kBorder, 1.0);
    Random random(3);
    double sum = 0.0;
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<Vec2> items;
        for (int i = 0; i < 7; ++i)
            items.push_back({random.uniform(-18.0, 18.0), random.uniform(-10.0, 10.0)});
        const TourFinder tours(ground, items);
        std::vector<std::int32_t> open(items.size());
        std::iota(open.begin(), open.end(), 0);
        const Vec2 from{-15.0, 0.0};
        Chance chance(trial);
        const auto found = tours.tour(from, open, 0.0, chance);
        CHECK(std::is_permutation(found.begin(), found.end(), open.begin()));
        const double best = shortest(tours, from, open);
        sum += tours.length(from, found) / best;
        CHECK(tours.length(from, found) < 1.25 * best);
        const auto worse = tours.tour(from, open, 0.2, chance);
        CHECK(tours.length(from, worse) <= 1.2 * tours.length(from, found) + 1e-9);
    }
    CHECK(sum / 20.0 < 1.05);
}

TEST_CASE("what a crowd sweeps up on its way is left out of its stops, and nothing else") {
    const SeenGround ground(std::span<const Box>{}, kBorder, 1.0);
    Sweep sweep{.reach = 0.5};
    for (int i = -3; i <= 3; ++i) sweep.offsets.push_back({0.0, 0.5 * i});
    const std::vector<Vec2> items{{5.0, 1.0}, {10.0, 0.0}, {6.0, 6.0}};
    const TourFinder tours(ground, items);
    const std::vector<std::int32_t> order{0, 1, 2};
    CHECK(tours.thinned({0.0, 0.0}, order, sweep) == std::vector<std::int32_t>{1, 2});
    CHECK(sweep.collects({0.0, 0.0}, {10.0, 0.0}, {4.0, 1.9}));
    CHECK_FALSE(sweep.collects({0.0, 0.0}, {10.0, 0.0}, {4.0, 2.1}));
    CHECK_FALSE(sweep.collects({0.0, 0.0}, {10.0, 0.0}, {11.0, 0.0}));
}

}  // namespace
}  // namespace muster
