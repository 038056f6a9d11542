// Searches, prices and starts of the sparse matching, against looks at everything.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "assignment/dynamic/assignment_scene.h"
#include "assignment/dynamic/cycle_cancelling.h"
#include "assignment/dynamic/initial_assignment.h"
#include "assignment/dynamic/initial_duals.h"
#include "base/archive.h"

using namespace muster;
using muster_test::AssignmentScene;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::int32_t kLanes = ExchangeArcs::kLanes;

// A matching in the middle of its work: everybody seated, arcs asked for, prices as given.
struct Bench {
    AssignmentScene scene;
    ThreadPool pool{1};
    DynamicAssignmentDef def = muster_test::lowThresholds();
    AssignmentInput input;
    AssignmentStep context;
    ExchangeGraph state;

    Bench(std::int32_t count, std::uint64_t seed, double away = 2.0)
        : scene(count, count, seed, away),
          input(scene.input()),
          context{def, input, scene.costs, pool, CostPower(2.0), {}, {}, 0.1} {
        state.reset(count, count);
    }
    void sit(const std::vector<std::int32_t>& placeOf) {
        state.seats.warmStart(placeOf);
        std::vector<std::int32_t> flipped;
        state.seats.follow(input, flipped);
    }
    void ask() {
        std::vector<std::int32_t> rows(static_cast<std::size_t>(state.seats.count()));
        std::iota(rows.begin(), rows.end(), 0);
        for (const std::int32_t s : rows)
            state.setOwn(s, state.seats.matched(s) ? scene.costs.cost(state.seats.holder(s), s) : 0.0f,
                         context.power);
        state.arcs.look(context, state.seats, state.price, state.own);
        for (const std::int32_t s : rows) state.arcs.chooseTargets(context, state.seats, s);
        state.arcs.refresh(context, state.seats, state.ownPower, rows, {});
        state.arcs.sortByTarget();
    }
    // The optimum, by a dense solver.
    std::vector<std::int32_t> best() const {
        const std::int32_t n = state.seats.count();
        std::vector<double> matrix;
        for (std::int32_t i = 0; i < n; ++i)
            for (std::int32_t j = 0; j < n; ++j) {
                const double c = scene.costs.exact(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
                matrix.push_back(c * c);
            }
        JonkerVolgenantSolver dense;
        dense.solve(n, n, matrix.data());
        return {dense.columnOf().begin(), dense.columnOf().end()};
    }
    // Everybody to the place of the same number, or to the best one, prices at random.
    void disturb(std::uint64_t seed, double most, bool optimal) {
        std::vector<std::int32_t> placeOf(static_cast<std::size_t>(state.seats.count()));
        std::iota(placeOf.begin(), placeOf.end(), 0);
        sit(optimal ? best() : placeOf);
        Random random(seed);
        for (double& price : state.price) price = random.uniform(-most, most);
        ask();
    }
    std::vector<double> reduced() const {
        std::vector<double> all;
        for (std::int32_t arc = 0; arc < state.seats.count() * kLanes; ++arc)
            all.push_back(state.arcs.target(arc) == arc / kLanes ? kInfinite : state.reduced(arc));
        return all;
    }
    double violations() const {
        double sum = 0.0;
        for (std::int32_t s = 0; s < state.seats.count(); ++s) {
            double least = 0.0;
            for (std::int32_t arc = s * kLanes; arc < (s + 1) * kLanes; ++arc)
                least = std::min(least, state.reduced(arc));
            sum -= least;
        }
        return sum;
    }
    // Lengths of the shortest ways from a seat, by sweeps over all arcs until nothing changes.
    std::vector<double> distancesFrom(std::int32_t seat) const {
        std::vector<double> distance(static_cast<std::size_t>(state.seats.count()), kInfinite);
        distance[seat] = 0.0;
        for (bool changed = true; changed;) {
            changed = false;
            for (std::int32_t arc = 0; arc < state.seats.count() * kLanes; ++arc) {
                const std::int32_t to = state.arcs.target(arc);
                if (to == arc / kLanes) continue;
                const double there = distance[arc / kLanes] + std::max(state.reduced(arc), 0.0);
                if (!(there < distance[to])) continue;
                distance[to] = there;
                changed = true;
            }
        }
        return distance;
    }
    double lengthOf(std::span<const std::int32_t> cycle) const {
        double sum = 0.0;
        for (std::size_t k = 0; k + 1 < cycle.size(); ++k) {
            const std::int32_t arc = state.arcs.find(cycle[k], cycle[k + 1]);
            REQUIRE(arc >= 0);
            sum += std::max(state.reduced(arc), 0.0);
        }
        return sum;
    }
};

}  // namespace

TEST_CASE("a search finds the shortest way back, or shows that there is none shorter than the violation") {
    int cycles = 0, settled = 0;
    for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
        Bench bench(90, seed);
        bench.disturb(seed + 40, 1.5, seed > 3);
        BidirectionalDijkstra search;
        search.reset(90, 100000);
        for (std::int32_t arc = 0; arc < 90 * kLanes; arc += 7) {
            const std::int32_t from = arc / kLanes;
            const std::int32_t to = bench.state.arcs.target(arc);
            const double violation = -bench.state.reduced(arc);
            if (to == from || !(violation > 0.0)) continue;
            const double shortest = bench.distancesFrom(to)[from];
            const SearchEnd end = search.run(bench.state.arcs, bench.state.price, from, to, violation,
                                             kInfinite, 100000);
            if (shortest < violation) {
                REQUIRE(end == SearchEnd::Cycle);
                CHECK(search.cycle().front() == to);
                CHECK(search.cycle().back() == from);
                CHECK(bench.lengthOf(search.cycle()) == doctest::Approx(shortest).epsilon(1e-9));
                ++cycles;
            } else {
                REQUIRE(end == SearchEnd::Settled);
                ++settled;
            }
        }
    }
    CHECK(cycles > 30);
    CHECK(settled > 30);
}

TEST_CASE(
    "moving prices makes nothing negative that was not, lets nothing negative sink, and mends the arc where "
    "it can") {
    for (const std::uint64_t seed : {7, 8, 9}) {
        Bench bench(90, seed);
        bench.disturb(seed + 40, 0.8, true);
        BidirectionalDijkstra search;
        search.reset(90, 40);
        Random random(seed);
        int mended = 0, capped = 0;
        for (int look = 0; look < 400; ++look) {
            const auto arc = static_cast<std::int32_t>(random.below(90 * kLanes));
            const std::int32_t to = bench.state.arcs.target(arc);
            const double violation = -bench.state.reduced(arc);
            if (to == arc / kLanes || !(violation > 1e-6)) continue;
            const std::vector<double> before = bench.reduced();
            const std::int32_t limit = look % 2 == 0 ? 12 : 40;
            const SearchEnd end = search.run(bench.state.arcs, bench.state.price, arc / kLanes, to, violation,
                                             kInfinite, limit);
            search.movePrices(bench.state.price);
            const std::vector<double> after = bench.reduced();
            for (std::size_t k = 0; k < before.size(); ++k)
                if (before[k] < kInfinite) REQUIRE(after[k] >= std::min(before[k], 0.0) - 1e-9);
            if (end == SearchEnd::Settled) {
                CHECK(bench.state.reduced(arc) >= -1e-9);
                ++mended;
            }
            capped += end == SearchEnd::Capped ? 1 : 0;
            CHECK(search.settled() <= limit + 1);
        }
        CHECK(mended > 10);
        CHECK(capped > 0);
    }
}

TEST_CASE("a direct way back counts as known") {
    Bench bench(60, 12);
    bench.disturb(13, 1.0, false);
    BidirectionalDijkstra search;
    search.reset(60, 1000);
    for (std::int32_t arc = 0; arc < 60 * kLanes; arc += 11) {
        const std::int32_t to = bench.state.arcs.target(arc);
        const double violation = -bench.state.reduced(arc);
        if (to == arc / kLanes || !(violation > 0.0)) continue;
        const SearchEnd end = search.run(bench.state.arcs, bench.state.price, arc / kLanes, to, violation,
                                         0.0, 1000);
        REQUIRE(end == SearchEnd::Cycle);
        REQUIRE(search.cycle().size() == 2);
        CHECK(search.cycle()[0] == to);
        CHECK(search.cycle()[1] == arc / kLanes);
    }
}

TEST_CASE("the least reduced cost of a row is that of its worst arc, to the bit") {
    Bench bench(120, 16);
    bench.disturb(17, 3.0, false);
    for (std::int32_t s = 0; s < bench.state.seats.count(); ++s) {
        double least = kInfinite;
        for (std::int32_t arc = s * kLanes; arc < (s + 1) * kLanes; ++arc)
            least = std::min(least, bench.state.reduced(arc));
        REQUIRE(bench.state.leastFrom(s) == least);
    }
}

TEST_CASE("an arc is found in whatever lane it lies, and none where none leads") {
    Bench bench(120, 18);
    bench.disturb(19, 1.0, false);
    for (std::int32_t from = 0; from < 120; ++from)
        for (std::int32_t to = 0; to < 120; ++to) {
            std::int32_t first = -1;
            for (std::int32_t arc = (from + 1) * kLanes; arc-- > from * kLanes;)
                if (bench.state.arcs.target(arc) == to) first = arc;
            REQUIRE(bench.state.arcs.find(from, to) == first);
        }
}

TEST_CASE("tight arcs only are asked for, and the others keep their weights") {
    Bench bench(120, 20);
    bench.disturb(21, 3.0, false);
    const std::vector<float> before = bench.state.arcs.weights();
    const std::vector<double> reduced = bench.reduced();
    for (Vec2& p : bench.scene.costs.characters) p += Vec2{0.3, -0.2};
    const std::vector<double> margin(120, 1.0);
    std::vector<std::int32_t> rows(120);
    std::iota(rows.begin(), rows.end(), 0);
    bench.state.arcs.refresh(bench.context, bench.state.seats, bench.state.ownPower, rows,
                             {bench.state.price, margin});
    int renewed = 0;
    for (std::int32_t arc = 0; arc < 120 * kLanes; ++arc) {
        const std::int32_t to = bench.state.arcs.target(arc);
        if (to == arc / kLanes) continue;
        const double there = bench.context.power(
            bench.scene.costs.cost(bench.state.seats.holder(arc / kLanes), to));
        const float now = bench.state.arcs.weightBy(bench.context, bench.state.seats, bench.state.ownPower,
                                                    arc, there);
        const bool tight = reduced[arc] < 1.0;
        REQUIRE(bench.state.arcs.weight(arc) == (tight ? now : before[arc]));
        renewed += tight ? 1 : 0;
    }
    CHECK(renewed > 100);
    CHECK(renewed < 120 * 12);
}

TEST_CASE("repairs only ever lower the objective, within their budget, and end where nothing gains enough") {
    for (const std::uint64_t seed : {14, 15}) {
        Bench bench(200, seed);
        std::vector<std::int32_t> shuffled(200);
        std::iota(shuffled.begin(), shuffled.end(), 0);
        for (std::int32_t i = 199; i > 0; --i)
            std::swap(shuffled[i], shuffled[bench.scene.random.below(static_cast<std::uint32_t>(i + 1))]);
        bench.sit(shuffled);
        bench.ask();
        const auto objective = [&] {
            return std::accumulate(bench.state.ownPower.begin(), bench.state.ownPower.end(), 0.0);
        };
        CycleCancelling repair;
        repair.reset(200, bench.def.searchLimit);
        double before = objective();
        const double first = before;
        for (int round = 0; round < 300; ++round) {
            repair.run(bench.context, bench.state, 600, 16);
            CHECK(repair.settled() <= 600 + 3);
            const double now = objective();
            CHECK(now <= before + 1e-9);
            before = now;
            bench.ask();
        }
        CHECK(before < 0.1 * first);
        CHECK(before < 1.05 * bench.scene.optimum(2.0) + 1.0);
        // Nobody lost a place, and no two have one.
        std::vector<int> taken(200, 0);
        for (std::int32_t i = 0; i < 200; ++i) ++taken[bench.state.seats.seatOf(i)];
        CHECK(std::all_of(taken.begin(), taken.end(), [](int n) { return n == 1; }));
    }
}

TEST_CASE("a start seats as many as can be, the few by nearness, the many near the optimum") {
    Bench few(12, 16);
    std::vector<std::int32_t> flipped;
    few.state.seats.follow(few.input, flipped);
    InitialAssignment start;
    start.seat(few.context, few.state);
    double shortest = kInfinite;
    std::int32_t who = -1, where = -1;
    for (std::int32_t i = 0; i < 12; ++i)
        for (std::int32_t j = 0; j < 12; ++j)
            if (few.scene.costs.exact(i, j) < shortest)
                shortest = few.scene.costs.exact(i, j), who = i, where = j;
    CHECK(few.state.seats.seatOf(who) == where);
    for (std::int32_t i = 0; i < 12; ++i) CHECK(few.state.seats.seatOf(i) >= 0);

    for (const double away : {40.0, 8.0}) {
        Bench many(700, 17, away);
        flipped.clear();
        many.state.seats.follow(many.input, flipped);
        InitialAssignment parts;
        parts.seat(many.context, many.state);
        double sum = 0.0;
        for (std::int32_t i = 0; i < 700; ++i) {
            REQUIRE(many.state.seats.seatOf(i) >= 0);
            const double c = many.scene.costs.exact(i, many.state.seats.seatOf(i));
            sum += c * c;
        }
        CHECK(sum < (away > 20.0 ? 1.01 : 1.1) * many.scene.optimum(2.0));
    }
}

TEST_CASE("fitted prices leave little violated where the matching is the optimum") {
    for (const std::uint64_t seed : {18, 19}) {
        Bench bench(400, seed, 12.0);
        // The crowd stands as the formation does, but half as large again: everybody's best place is his own.
        for (std::size_t i = 0; i < 400; ++i)
            bench.scene.costs.characters[i] = Vec2{-14.0, 3.0} + bench.scene.costs.places[i] * 1.5;
        bench.input = bench.scene.input();
        std::vector<std::int32_t> same(400);
        std::iota(same.begin(), same.end(), 0);
        bench.sit(same);
        bench.ask();
        const double without = bench.violations();
        InitialDuals().run(bench.context, bench.state);
        const double fitted = bench.violations();
        CHECK(without > 0.0);
        CHECK(fitted < 0.05 * without);
    }
}

TEST_CASE("saved in the middle of a round a matching goes on bit for bit") {
    DynamicAssignmentDef def = muster_test::lowThresholds();
    def.stepsPerRound = 6;
    AssignmentScene scene(150, 150, 20);
    ThreadPool pool(1);
    DynamicAssignment matching;
    matching.coldStart(def, scene.input(), scene.costs, pool);
    for (int k = 0; k < 9; ++k) {
        scene.step({1.0, 0.2}, 0.03, matching.placeOf());
        scene.usable.assign(150, 1);
        if (k % 2 == 1) scene.usable[15 * k] = 0;
        matching.update(def, scene.input(), scene.costs, pool);
        Writer writer;
        matching.visit(writer);
        DynamicAssignment copy;
        Reader reader(writer.bytes());
        copy.visit(reader);
        REQUIRE(reader.ok());
        AssignmentScene twin = scene;
        DynamicAssignment original = matching;
        for (int n = 0; n < 14; ++n) {
            // Places that come and go change what is asked for next.
            twin.usable.assign(150, 1);
            if (n % 3 == 1) twin.usable[10 * n] = 0;
            twin.step({1.0, 0.2}, 0.03, original.placeOf());
            original.update(def, twin.input(), twin.costs, pool);
            copy.update(def, twin.input(), twin.costs, pool);
            REQUIRE(std::equal(copy.placeOf().begin(), copy.placeOf().end(), original.placeOf().begin()));
            REQUIRE(copy.dualityGap() == original.dualityGap());
        }
    }
}
