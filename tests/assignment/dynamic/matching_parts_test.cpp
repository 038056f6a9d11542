// The parts of the sparse matching: boxes of equal counts, nearest points, seats, the arcs between them.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "assignment/dynamic/assignment_scene.h"
#include "assignment/dynamic/exchange_arcs.h"
#include "assignment/dynamic/kd_partition.h"
#include "assignment/dynamic/nearest_points.h"
#include "base/random.h"

using namespace muster;

namespace {

std::vector<Vec2> scattered(std::size_t count, std::uint64_t seed, double width, double height) {
    Random random(seed);
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < count; ++k)
        points.push_back({random.uniform(0.0, width), random.uniform(0.0, height)});
    return points;
}

std::vector<std::int32_t> numbers(std::size_t count) {
    std::vector<std::int32_t> all(count);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

// By looking at all of them.
std::vector<std::int32_t> nearestOfAll(const std::vector<Vec2>& points, Vec2 centre, std::int32_t count,
                                       bool even) {
    std::vector<std::int32_t> order = numbers(points.size());
    if (even) std::erase_if(order, [](std::int32_t p) { return p % 2 != 0; });
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        const double da = lengthSquared(points[a] - centre);
        const double db = lengthSquared(points[b] - centre);
        return da != db ? da < db : a < b;
    });
    order.resize(std::min<std::size_t>(order.size(), static_cast<std::size_t>(count)));
    return order;
}

}  // namespace

TEST_CASE(
    "leaves are as even as can be, hold every point once, and do not depend on the order they were given "
    "in") {
    for (const std::int32_t leaves : {1, 2, 3, 7, 16, 50}) {
        CAPTURE(leaves);
        const std::vector<Vec2> points = scattered(103, 5, 30.0, 10.0);
        std::vector<std::int32_t> order = numbers(points.size());
        std::vector<std::int32_t> ends;
        divideIntoLeaves(points, order, leaves, 0, ends);
        REQUIRE(ends.size() == static_cast<std::size_t>(leaves));
        CHECK(ends.back() == 103);
        std::int32_t begin = 0, least = 1000, most = 0;
        for (const std::int32_t end : ends) {
            CHECK(std::is_sorted(order.begin() + begin, order.begin() + end));
            least = std::min(least, end - begin);
            most = std::max(most, end - begin);
            begin = end;
        }
        CHECK(most - least <= 2);
        std::vector<std::int32_t> backwards = numbers(points.size());
        std::reverse(backwards.begin(), backwards.end());
        std::vector<std::int32_t> again;
        divideIntoLeaves(points, backwards, leaves, 0, again);
        CHECK(backwards == order);
        CHECK(again == ends);
        std::sort(order.begin(), order.end());
        CHECK(order == numbers(points.size()));
    }
}

TEST_CASE("a division puts the lowest along the axis in front, those of equal coordinate by number") {
    const std::vector<Vec2> points{{3, 0}, {1, 0}, {1, 5}, {2, 0}, {1, 2}};
    std::vector<std::int32_t> order{4, 3, 2, 1, 0};
    divide(points, order, 2, true);
    std::sort(order.begin(), order.begin() + 2);
    CHECK(order[0] == 1);
    CHECK(order[1] == 2);
    CHECK_FALSE(isWide(points, numbers(points.size())));  // 2 m by 5 m.
    CHECK(isWide(points, std::vector<std::int32_t>{0, 1, 3}));
    std::vector<std::int32_t> none;
    divide(points, none, 0, true);  // Nothing to divide.
    CHECK(none.empty());
}

TEST_CASE("the nearest points are those that a look at all finds") {
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
        const std::vector<Vec2> points = scattered(400, seed, 20.0, seed % 2 == 0 ? 3.0 : 25.0);
        CellList cells;
        cells.sort(points, 1.1);
        Random random(seed + 10);
        for (int look = 0; look < 60; ++look) {
            const Vec2 centre{random.uniform(-4.0, 24.0), random.uniform(-4.0, 28.0)};
            const std::int32_t count = 1 + static_cast<std::int32_t>(random.below(8));
            const bool even = look % 3 == 0;
            NearestPoints near;
            near.find(cells, points, centre, count, [&](std::int32_t p) { return !even || p % 2 == 0; });
            const std::vector<std::int32_t> expected = nearestOfAll(points, centre, count, even);
            REQUIRE(near.size() == static_cast<std::int32_t>(expected.size()));
            for (std::int32_t k = 0; k < near.size(); ++k) REQUIRE(near[k] == expected[k]);
        }
    }
    NearestPoints none;
    none.find(CellList(), {}, {0, 0}, 4, [](std::int32_t) { return true; });
    CHECK(none.size() == 0);
}

TEST_CASE("of equally near points the lower number comes first") {
    const std::vector<Vec2> points{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
    CellList cells;
    cells.sort(points, 0.5);
    NearestPoints near;
    near.find(cells, points, {0, 0}, 3, [](std::int32_t) { return true; });
    REQUIRE(near.size() == 3);
    CHECK(near[0] < near[1]);
    CHECK(near[1] < near[2]);
    near.find(cells, points, {0, 0}, 5, [](std::int32_t) { return true; });
    for (std::int32_t k = 0; k < 5; ++k) CHECK(near[k] == k);
}

TEST_CASE("seats follow places that close and characters that leave") {
    AssignmentNodes seats;
    seats.reset(4, 3);
    CHECK(seats.count() == 4);
    const std::vector<Vec2> characters(4), places(3);
    std::vector<std::uint8_t> usable{1, 1, 1};
    std::vector<std::uint8_t> present{1, 1, 1, 1};
    std::vector<std::int32_t> flipped;
    seats.warmStart(std::vector<std::int32_t>{2, 2, -1, 0});  // Two name one place: the first has it.
    seats.follow({characters, places, usable, present}, flipped);
    CHECK(flipped == std::vector<std::int32_t>{0, 1, 2});  // They have become places.
    CHECK(seats.waiting() == std::vector<std::int32_t>{1, 2});
    CHECK(seats.free() == std::vector<std::int32_t>{1});
    seats.take(2, 1);
    seats.seatRest();
    CHECK(seats.seatOf(1) == 3);
    CHECK_FALSE(seats.matched(3));
    CHECK(seats.matched(1));

    flipped.clear();
    usable[2] = 0;
    present[3] = 0;
    seats.follow({characters, places, usable, present}, flipped);
    CHECK(flipped == std::vector<std::int32_t>{2, 0});  // One closed, one lost its holder.
    CHECK(seats.waiting() == std::vector<std::int32_t>{0, 1});
    CHECK(seats.free() == std::vector<std::int32_t>{0});
    seats.take(0, 0);
    CHECK(seats.holder(2) == -1);
    CHECK(seats.holder(0) == 0);
}

TEST_CASE("arcs lead to near places and near people, once each, and weigh what a move would cost") {
    muster_test::AssignmentScene scene(120, 120, 21);
    ThreadPool pool(1);
    AssignmentNodes seats;
    seats.reset(120, 120);
    seats.warmStart(numbers(120));
    const AssignmentInput input = scene.input();
    std::vector<std::int32_t> flipped;
    seats.follow(input, flipped);
    const DynamicAssignmentDef def;
    AssignmentStep context{def, input, scene.costs, pool, CostPower(2.0), {0.3, -0.2}, {}, 0.1};
    const std::vector<double> price(120, 0.0);
    std::vector<float> own(120);
    std::vector<double> ownPower(120);
    for (std::int32_t s = 0; s < 120; ++s) {
        own[s] = scene.costs.cost(s, s);
        ownPower[s] = context.power(own[s]);
    }
    ExchangeArcs arcs;
    arcs.reset(120);
    arcs.look(context, seats, price, own);
    const std::vector<std::int32_t> rows = numbers(120);
    for (const std::int32_t s : rows) arcs.chooseTargets(context, seats, s);
    arcs.refresh(context, seats, ownPower, rows, {});
    arcs.sortByTarget();
    std::vector<std::int32_t> into(120, 0);
    for (const std::int32_t s : rows) {
        std::vector<std::int32_t> targets;
        for (std::int32_t arc = s * ExchangeArcs::kLanes; arc < (s + 1) * ExchangeArcs::kLanes; ++arc) {
            const std::int32_t to = arcs.target(arc);
            if (to == s) {
                CHECK(arcs.weight(arc) == ExchangeArcs::kNever);
                continue;
            }
            targets.push_back(to);
            ++into[to];
            const double there = context.power(scene.costs.cost(s, to));
            const double frame = dot(context.slope, input.places[to] - input.places[s]);
            CHECK(arcs.weight(arc) == doctest::Approx(there - ownPower[s] - frame).epsilon(1e-5));
            CHECK(arcs.find(s, to) == arc);
        }
        std::sort(targets.begin(), targets.end());
        CHECK(std::adjacent_find(targets.begin(), targets.end()) == targets.end());
        CHECK(targets.size() >= 8);
        const std::vector<Vec2> places(input.places.begin(), input.places.end());
        const std::int32_t nearest = nearestOfAll(places, places[s], 2, false)[1];
        CHECK(std::binary_search(targets.begin(), targets.end(), nearest));
    }
    for (const std::int32_t s : rows) {
        const auto arcsInto = arcs.into(s);
        CHECK(
            static_cast<std::int32_t>(std::count_if(arcsInto.begin(), arcsInto.end(), [&](std::int32_t arc) {
                return arc / ExchangeArcs::kLanes != s;
            })) == into[s]);
        CHECK(std::is_sorted(arcsInto.begin(), arcsInto.end()));
    }
}
