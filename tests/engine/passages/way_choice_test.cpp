// Who goes through which passage, against all possible choices and against hand-made cases.
#include <doctest.h>

#include <algorithm>

#include "base/random.h"
#include "engine/passages/way_choice.h"

using namespace muster;

namespace {

struct Case {
    std::vector<double> arrival, onward, capacity;
    std::vector<std::int32_t> pool;
    std::vector<std::uint8_t> movable;

    std::size_t people() const { return pool.size(); }
    WayChoiceInput input() const { return {arrival, onward, pool, movable, capacity}; }
};

Case randomCase(Random& random, std::size_t people, std::size_t passages) {
    Case c;
    for (std::size_t p = 0; p < passages; ++p) c.capacity.push_back(random.uniform(0.5, 3.0));
    for (std::size_t k = 0; k < people * passages; ++k) {
        c.arrival.push_back(random.uniform(1.0, 6.0));
        c.onward.push_back(random.uniform(1.0, 6.0));
    }
    c.pool.assign(people, 0);
    c.movable.assign(people, 1);
    return c;
}

/// The last arrival where `way` and `goalWay` are given: first come, first served, the first to the farthest.
double lastArrival(const Case& c, const std::vector<int>& way, const std::vector<int>& goalWay) {
    double last = 0.0;
    const std::size_t passages = c.capacity.size();
    for (std::size_t p = 0; p < passages; ++p) {
        std::vector<double> arrivals, walks;
        for (std::size_t i = 0; i < c.people(); ++i) {
            if (way[i] == static_cast<int>(p)) arrivals.push_back(c.arrival[i * passages + p]);
            if (goalWay[i] == static_cast<int>(p)) walks.push_back(c.onward[i * passages + p]);
        }
        if (arrivals.size() != walks.size()) return 1e9;
        std::sort(arrivals.begin(), arrivals.end());
        std::sort(walks.rbegin(), walks.rend());
        double free = 0.0;
        for (std::size_t k = 0; k < arrivals.size(); ++k) {
            const double served = std::max(free, arrivals[k]);
            free = served + 1.0 / c.capacity[p];
            last = std::max(last, served + walks[k]);
        }
    }
    return last;
}

/// The least last arrival of all choices, for two passages.
double bestOfAll(const Case& c) {
    double best = 1e9;
    const unsigned all = 1u << c.people();
    for (unsigned ways = 0; ways < all; ++ways)
        for (unsigned goals = 0; goals < all; ++goals) {
            std::vector<int> way, goalWay;
            for (std::size_t i = 0; i < c.people(); ++i) {
                way.push_back(static_cast<int>(ways >> i & 1u));
                goalWay.push_back(static_cast<int>(goals >> i & 1u));
            }
            best = std::min(best, lastArrival(c, way, goalWay));
        }
    return best;
}

/// Chooses, and returns the time of the last arrival [s].
double chosen(const WayChoiceInput& input, std::span<std::int32_t> way, std::span<double> slot,
              WayChoice choice = {}) {
    choice.read(input);
    return choice.choose(way, slot);
}

}  // namespace

TEST_CASE("choices come near the best of all choices") {
    Random random(11);
    double sum = 0.0, worst = 0.0;
    constexpr int kCases = 60;
    for (int k = 0; k < kCases; ++k) {
        const Case c = randomCase(random, 6, 2);
        std::vector<std::int32_t> way(c.people(), -1);
        std::vector<double> slot(c.people());
        WayChoice choice;
        const double last = chosen(c.input(), way, slot, choice);
        const double ratio = last / bestOfAll(c);
        CHECK(ratio >= 1.0 - 1e-9);
        sum += ratio;
        worst = std::max(worst, ratio);
    }
    MESSAGE("mean ", sum / kCases, ", worst ", worst);
    CHECK(sum / kCases < 1.06);
    CHECK(worst < 1.35);
}

TEST_CASE("equal walks: passages are loaded in proportion to their capacity") {
    Case c{.capacity = {2.0, 4.0, 6.0}};
    for (int i = 0; i < 120; ++i)
        for (int p = 0; p < 3; ++p) {
            c.arrival.push_back(3.0);
            c.onward.push_back(2.0);
        }
    c.pool.assign(120, 0);
    c.movable.assign(120, 1);
    std::vector<std::int32_t> way(120, -1);
    std::vector<double> slot(120);
    const double last = chosen(c.input(), way, slot);
    CHECK(last == doctest::Approx(5.0 + 119.0 / 12.0).epsilon(0.05));
    CHECK(std::count(way.begin(), way.end(), 0) == doctest::Approx(20).epsilon(0.1));
    CHECK(std::count(way.begin(), way.end(), 2) == doctest::Approx(60).epsilon(0.1));
    for (std::size_t i = 0; i < 120; ++i) CHECK(slot[i] >= 3.0);
}

TEST_CASE(
    "a further passage never makes the last one later; who may not move stays; little gain moves nobody") {
    Random random(5);
    for (int k = 0; k < 40; ++k) {
        Case two = randomCase(random, 40, 2);
        Case one = two;
        one.capacity.resize(1);
        one.arrival.clear();
        one.onward.clear();
        for (std::size_t i = 0; i < two.people(); ++i) {
            one.arrival.push_back(two.arrival[2 * i]);
            one.onward.push_back(two.onward[2 * i]);
        }
        std::vector<std::int32_t> way(40, -1), all(40, 0);
        std::vector<double> slot(40);
        const double alone = chosen(one.input(), all, slot);
        const double last = chosen(two.input(), way, slot);
        CHECK(last <= alone * 1.03);
        // Chosen again, nothing changes.
        std::vector<std::int32_t> again = way;
        chosen(two.input(), again, slot);
        CHECK(again == way);
        // Locked, nobody turns, even where everybody has been sent the same way.
        std::vector<std::int32_t> same(40, 0);
        two.movable.assign(40, 0);
        chosen(two.input(), same, slot);
        CHECK(same == std::vector<std::int32_t>(40, 0));
    }
}

TEST_CASE("goals in a row behind a queue: who goes round comes late and takes the near ones") {
    // Thirty before an alley; round it is a walk of 3 s more, and 2 s more behind it, a little less to far
    // goals.
    constexpr int kPeople = 30;
    Case c{.capacity = {2.5, 2.5}};
    c.pool.assign(kPeople, 0);
    c.movable.assign(kPeople, 1);
    for (int i = 0; i < kPeople; ++i) {
        const double behind = 0.2 * i;
        c.arrival.insert(c.arrival.end(), {0.0, 3.0});
        c.onward.insert(c.onward.end(), {behind, 0.98 * behind + 2.0});
    }
    std::vector<std::int32_t> way(kPeople, 0);
    std::vector<double> slot(kPeople);
    const double last = chosen(c.input(), way, slot);
    // All by the alley: 29 / 2.5 = 11.6 s. With n round, those on both sides end about together at (29 - n)
    // / 2.5 and 5 + (n - 1) / 2.5 s.
    const auto round = std::count(way.begin(), way.end(), 1);
    CHECK(round >= 5);
    CHECK(round <= 12);
    CHECK(last <= 9.6);
    CHECK(last >= 8.0);
}

TEST_CASE("pools share a passage but not their goals") {
    Case c{.capacity = {1.0, 1.0}};
    for (int i = 0; i < 20; ++i) {
        c.pool.push_back(i % 2);
        c.movable.push_back(1);
        c.arrival.insert(c.arrival.end(), {1.0, 1.0});
        // Goals of pool 0 are behind passage 0, those of pool 1 behind passage 1.
        const double near = 1.0, far = 8.0;
        c.onward.insert(c.onward.end(), {i % 2 == 0 ? near : far, i % 2 == 0 ? far : near});
    }
    std::vector<std::int32_t> way(20, -1);
    std::vector<double> slot(20);
    const double last = chosen(c.input(), way, slot);
    CHECK(last == doctest::Approx(1.0 + 9.0 + 1.0).epsilon(0.1));
    for (int i = 0; i < 20; ++i) CHECK(way[i] == i % 2);
}

TEST_CASE(
    "with several pools: when each is let through, and the last arrival, are those of the passages told") {
    Random random(23);
    for (int k = 0; k < 20; ++k) {
        Case c = randomCase(random, 300, 4);
        for (std::size_t i = 0; i < c.people(); ++i) c.pool[i] = static_cast<std::int32_t>(i % 3);
        std::vector<std::int32_t> way(c.people(), -1);
        std::vector<double> slot(c.people());
        const double last = chosen(c.input(), way, slot);
        for (std::size_t p = 0; p < 4; ++p) {
            // Served one after another, in the order of arrival.
            std::vector<std::pair<double, double>> served;
            for (std::size_t i = 0; i < c.people(); ++i)
                if (way[i] == static_cast<int>(p)) served.push_back({c.arrival[i * 4 + p], slot[i]});
            std::sort(served.begin(), served.end());
            double free = 0.0;
            for (const auto& [arrival, at] : served) {
                CHECK(at == doctest::Approx(std::max(arrival, free)));
                free = at + 1.0 / c.capacity[p];
                CHECK(at < last);
            }
        }
        // At least half of the flow of all passages is used.
        double capacity = 0.0;
        for (const double rate : c.capacity) capacity += rate;
        CHECK(last < 2.0 * (300.0 / capacity + 12.0));
    }
}
