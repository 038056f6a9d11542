#include "lab/reproduce/experiments/change_watch.h"

#include <doctest.h>
#include <algorithm>
#include <numeric>
#include <vector>

#include "base/random.h"

using namespace muster;

namespace {

/// All assignments one after the other.
double bruteForce(const std::vector<Vec2>& starts, const std::vector<Vec2>& places) {
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    double best = 1e300;
    do {
        double longest = 0.0;
        for (std::size_t i = 0; i < starts.size(); ++i)
            longest = std::max(longest, distance(starts[i], places[order[i]]));
        best = std::min(best, longest);
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

std::vector<Vec2> scatter(Random& random, std::size_t count) {
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < count; ++k) {
        const double x = random.uniform(-5.0, 5.0);
        const double y = random.uniform(-5.0, 5.0);
        points.push_back({x, y});
    }
    return points;
}

}  // namespace

TEST_CASE(
    "a row that shifts by one place moves everybody by one, though the least sum could move one by all") {
    std::vector<Vec2> starts, places;
    for (int k = 0; k < 10; ++k) {
        starts.push_back({static_cast<double>(k), 0.0});
        places.push_back({static_cast<double>(k + 1), 0.0});
    }
    CHECK(bottleneckWalk(starts, places) == doctest::Approx(1.0));
}

TEST_CASE("the least longest walk of crossing pairs") {
    // Straight on: 3 and 3. Crossing: 5 and 1.
    const std::vector<Vec2> starts{{0, 0}, {0, 2}};
    const std::vector<Vec2> places{{3, 0}, {0, 5}};
    CHECK(bottleneckWalk(starts, places) == doctest::Approx(3.0));
}

TEST_CASE("nobody needs to walk nowhere, and too few places are reported") {
    CHECK(bottleneckWalk({}, std::vector<Vec2>{{1, 1}}) == 0.0);
    const std::vector<Vec2> two{{0, 0}, {1, 0}};
    CHECK(bottleneckWalk(two, two) == 0.0);
    CHECK(bottleneckWalk(two, std::vector<Vec2>{{0, 0}}) == -1.0);
}

TEST_CASE("the least longest walk is that of trying all assignments") {
    Random random(7);
    for (int round = 0; round < 60; ++round) {
        const std::size_t count = 1 + static_cast<std::size_t>(round % 6);
        const auto starts = scatter(random, count);
        const auto places = scatter(random, count + static_cast<std::size_t>(round % 3 == 0 ? 1 : 0));
        CHECK(bottleneckWalk(starts, places) == bruteForce(starts, places));
    }
}
