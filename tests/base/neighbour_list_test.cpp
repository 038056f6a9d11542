#include "base/neighbour_list.h"

#include <doctest.h>

#include <algorithm>
#include <set>

#include "base/random.h"

using namespace muster;

namespace {

using IndexPair = std::pair<std::int32_t, std::int32_t>;

constexpr double kReach = 0.5;
constexpr double kSkin = 0.8;

std::set<IndexPair> listedPairs(const NeighbourList& list) {
    std::set<IndexPair> pairs;
    for (const NeighbourPair pair : list.pairs()) pairs.insert({pair.low, pair.high});
    return pairs;
}

std::set<IndexPair> bruteForcePairs(const std::vector<Vec2>& points, double reach) {
    std::set<IndexPair> pairs;
    for (std::int32_t i = 0; i < std::ssize(points); ++i)
        for (std::int32_t j = i + 1; j < std::ssize(points); ++j)
            if (lengthSquared(points[j] - points[i]) < reach * reach) pairs.insert({i, j});
    return pairs;
}

// Points that move alike, some of which jump, become inactive or active from time to time.
struct Swarm {
    Random random{7};
    std::vector<Vec2> now;
    std::vector<Vec2> next;
    std::vector<std::uint8_t> active;

    explicit Swarm(std::size_t count) : now(count), active(count, 1) {
        for (Vec2& p : now) p = anywhere();
        next = now;
    }
    Vec2 anywhere() { return {random.uniform(-6.0, 6.0), random.uniform(-6.0, 6.0)}; }
    void move(double jumps) {
        const double most = 0.3 * kReach / 2.0;
        for (std::size_t k = 0; k < now.size(); ++k) {
            now[k] = next[k] + Vec2{0.03, 0.01};
            if (random.uniform() < jumps) now[k] = anywhere();
            if (random.uniform() < jumps) active[k] = active[k] != 0 ? 0 : 1;
            next[k] = now[k] + Vec2{random.uniform(-most, most), random.uniform(-most, most)};
        }
    }
    bool close(const std::vector<Vec2>& at, std::size_t a, std::size_t b) const {
        return active[a] != 0 && active[b] != 0 && lengthSquared(at[a] - at[b]) < kReach * kReach;
    }
    bool isNear(Vec2 p, std::int32_t k) const {
        return active[k] != 0 && lengthSquared(now[k] - p) < kReach * kReach;
    }
};

// Every pair of active points that is close now or next must be listed, and be in the rows of both points.
void checkRows(const Swarm& s, const NeighbourList& list) {
    const std::set<IndexPair> pairs = listedPairs(list);
    std::set<IndexPair> rows;
    for (std::int32_t k = 0; k < std::ssize(s.now); ++k)
        list.forRow(k, [&](std::int32_t other) { rows.insert({k, other}); });
    for (std::int32_t a = 0; a < std::ssize(s.now); ++a) {
        for (std::int32_t b = a + 1; b < std::ssize(s.now); ++b) {
            if (!s.close(s.now, a, b) && !s.close(s.next, a, b)) continue;
            CHECK(pairs.contains({a, b}));
            CHECK((rows.contains({a, b}) && rows.contains({b, a})));
        }
    }
}

}  // namespace

TEST_CASE("a neighbour list holds all close pairs once, as brute force finds them") {
    Random random(5);
    NeighbourList list;
    for (int scene = 0; scene < 200; ++scene) {
        std::vector<Vec2> points(1 + random.below(120));
        const double size = scene % 3 == 0 ? 2.0 : 40.0;
        for (Vec2& p : points) p = {random.uniform(-size, size), random.uniform(-size, size)};
        if (scene % 5 == 0) points.push_back({1e5, -1e5});
        const double reach = random.uniform(0.05, 1.5);
        list.build(points, reach);
        CHECK(list.listedReach() == reach);
        for (const NeighbourPair pair : list.pairs()) CHECK(pair.low < pair.high);
        const std::set<IndexPair> pairs = listedPairs(list);
        CHECK(pairs.size() == list.pairs().size());
        CHECK(pairs == bruteForcePairs(points, reach));
    }
}

TEST_CASE("no point and a single point have no neighbours") {
    NeighbourList list;
    list.build(std::vector<Vec2>{{1, 1}, {1, 1}}, 1.0);
    CHECK(list.pairs().size() == 1);
    list.build(std::vector<Vec2>{{1, 1}}, 1.0);
    CHECK(list.pairs().empty());
    list.build({}, 1.0);
    CHECK(list.pairs().empty());
}

TEST_CASE("a list is kept until a point has moved half the skin, and holds all close pairs until then") {
    Random random(3);
    std::vector<Vec2> points(80);
    for (Vec2& p : points) p = {random.uniform(-3, 3), random.uniform(-3, 3)};
    NeighbourList list;
    list.update(points, kReach, kSkin);
    const std::size_t count = list.pairs().size();
    CHECK(listedPairs(list) == bruteForcePairs(points, kReach * (1.0 + kSkin)));
    const double slack = 0.5 * kSkin * kReach;
    CHECK(list.holdsFor(points, 0.0));
    for (Vec2& p : points) p += Vec2{random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6)} * slack;
    CHECK(list.holdsFor(points, slack));
    list.update(points, kReach, kSkin);
    CHECK(list.pairs().size() == count);
    for (const IndexPair pair : bruteForcePairs(points, kReach)) CHECK(listedPairs(list).contains(pair));
    points[7].x += 2.0 * slack;
    CHECK(!list.holdsFor(points, 7, slack));
    CHECK(list.holdsFor(points, 6, slack));
    CHECK(!list.holdsFor(points, slack));
    list.update(points, kReach, kSkin);
    CHECK(listedPairs(list) == bruteForcePairs(points, kReach * (1.0 + kSkin)));
    points.pop_back();
    CHECK(!list.holdsFor(points, slack));
    list.clear();
    CHECK(list.pairs().empty());
    CHECK(!list.holdsFor(points, slack));
}

TEST_CASE("a list with rows holds all close pairs and finds near points, with few strays or many") {
    for (const double jumps : {0.0, 0.004, 0.02, 0.3}) {
        Swarm s(300);
        NeighbourList list;
        for (int step = 0; step < 40; ++step) {
            s.move(jumps);
            list.updateRows(s.now, s.next, s.active, kReach, kSkin);
            checkRows(s, list);
            for (int k = 0; k < 100; ++k) {
                const Vec2 p = s.anywhere() * 1.3 + Vec2{0.03, 0.01} * step;
                bool expected = false;
                for (std::int32_t i = 0; i < std::ssize(s.now); ++i) expected = expected || s.isNear(p, i);
                CHECK(list.anyNear(p, [&](std::int32_t i) { return s.isNear(p, i); }) == expected);
            }
        }
    }
}

TEST_CASE("on a ring a list holds the pairs across the joint once, too") {
    Random random(6);
    NeighbourList list;
    for (int scene = 0; scene < 100; ++scene) {
        const Ring ring{-5.0, 10.0};
        std::vector<Vec2> points(1 + random.below(120));
        for (Vec2& p : points) p = {random.uniform(-5.0, 5.0), random.uniform(-3.0, 3.0)};
        const double reach = random.uniform(0.05, 2.0);
        list.build(points, reach, 0.0, ring);
        std::set<IndexPair> expected;
        for (std::int32_t i = 0; i < std::ssize(points); ++i)
            for (std::int32_t j = i + 1; j < std::ssize(points); ++j)
                for (const double shift : {-10.0, 0.0, 10.0})
                    if (lengthSquared(points[j] + Vec2{shift, 0.0} - points[i]) < reach * reach)
                        expected.insert({i, j});
        CHECK(listedPairs(list) == expected);
        CHECK(list.pairs().size() == expected.size());
    }
}
