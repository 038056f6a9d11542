#include "base/grid_search.h"

#include <doctest.h>

#include <numeric>

#include "base/random.h"

using namespace muster;

namespace {

Grid smallGrid(Random& random) {
    return {{random.uniform(-5, 5), random.uniform(-5, 5)},
            random.uniform(0.1, 2.0),
            static_cast<std::int32_t>(1 + random.below(25)),
            static_cast<std::int32_t>(1 + random.below(25))};
}

/// Disjoint sets of cells (Tarjan 1975), with path halving.
class DisjointSets {
public:
    explicit DisjointSets(std::int32_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }
    std::int32_t find(std::int32_t k) {
        while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
        return k;
    }
    void join(std::int32_t a, std::int32_t b) {
        const std::int32_t x = find(a), y = find(b);
        parent_[std::max(x, y)] = std::min(x, y);
    }

private:
    std::vector<std::int32_t> parent_;
};

}  // namespace

TEST_CASE("the nearest cell with a property is that of brute force, from inside and outside the grid") {
    Random random(41);
    for (int round = 0; round < 400; ++round) {
        const Grid grid = smallGrid(random);
        std::vector<char> good(grid.count());
        const double share = random.below(4) == 0 ? 0.0 : random.uniform(0.0, 0.2);
        for (char& g : good) g = random.uniform() < share ? 1 : 0;
        const Box wide = grid.box().grown(random.below(2) == 0 ? 0.0 : 5.0);
        const Vec2 p{random.uniform(wide.min.x, wide.max.x), random.uniform(wide.min.y, wide.max.y)};
        std::int32_t best = -1;
        double nearest = INFINITY;
        for (std::int32_t k = 0; k < grid.count(); ++k) {
            const double d = lengthSquared(grid.centre(grid.at(k)) - p);
            if (good[k] == 0 || d >= nearest) continue;
            nearest = d;
            best = k;
        }
        const auto found = nearestCellWhere(grid, p, [&](std::int32_t k) { return good[k] != 0; });
        REQUIRE(found.has_value() == (best >= 0));
        if (found) CHECK(grid.index(*found) == best);
    }
}

TEST_CASE("of equally near cells the one of the lowest index is found") {
    const Grid grid{{0, 0}, 1.0, 9, 9};
    // Four cells at the same distance from the centre of the middle cell.
    for (const std::int32_t reach : {1, 2, 4}) {
        const auto accept = [&](std::int32_t k) {
            const Cell c = grid.at(k);
            return std::abs(c.x - 4) + std::abs(c.y - 4) == reach && (c.x == 4 || c.y == 4);
        };
        CHECK(nearestCellWhere(grid, {4.5, 4.5}, accept) == Cell{4, 4 - reach});
    }
    CHECK(nearestCellWhere(grid, {4.0, 4.0}, [](std::int32_t) { return true; }) == Cell{3, 3});
}

TEST_CASE("components are those of disjoint sets, numbered by their first cells") {
    Random random(43);
    std::vector<std::int32_t> stack;
    for (int round = 0; round < 200; ++round) {
        const Grid grid = smallGrid(random);
        std::vector<std::int32_t> before(grid.count());
        const double share = random.uniform();
        for (std::int32_t& label : before)
            label = random.uniform() < share ? kUnlabelled : (random.below(2) == 0 ? -1 : -7);
        DisjointSets sets(grid.count());
        const auto joined = [&](std::int32_t a, std::int32_t b) {
            if (before[a] == kUnlabelled && before[b] == kUnlabelled) sets.join(a, b);
        };
        for (std::int32_t k = 0; k < grid.count(); ++k) {
            if (grid.at(k).x > 0) joined(k, k - 1);
            if (grid.at(k).y > 0) joined(k, k - grid.width);
        }
        auto labels = before;
        const std::int32_t count = labelRegions(grid, labels, stack);
        std::int32_t next = 0;
        std::vector<std::int32_t> number(grid.count(), -1);
        for (std::int32_t k = 0; k < grid.count(); ++k) {
            if (before[k] != kUnlabelled) {
                CHECK(labels[k] == before[k]);
                continue;
            }
            std::int32_t& expected = number[sets.find(k)];
            if (expected < 0) expected = next++;
            CHECK(labels[k] == expected);
        }
        CHECK(count == next);
    }
}
