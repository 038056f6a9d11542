#include "environment/connected_components.h"

#include <doctest.h>

#include <atomic>
#include <deque>
#include <thread>

#include "base/random.h"

using namespace muster;

namespace {

struct Ground {
    Grid grid;
    std::vector<float> clearance;  // [m]
};

Ground randomGround(Random& random) {
    Ground ground;
    ground.grid = {{0, 0},
                   0.5,
                   static_cast<std::int32_t>(1 + random.below(24)),
                   static_cast<std::int32_t>(1 + random.below(24))};
    ground.clearance.resize(ground.grid.count());
    for (float& c : ground.clearance) c = static_cast<float>(random.below(9)) * 0.125f;
    return ground;
}

/// Labels by a breadth-first flood fill from every cell that has no label yet.
std::vector<std::int32_t> floodFill(const Ground& ground, double radius) {
    const Grid& grid = ground.grid;
    std::vector<std::int32_t> label(grid.count(), -1);
    std::int32_t next = 0;
    for (std::int32_t first = 0; first < grid.count(); ++first) {
        if (label[first] >= 0 || ground.clearance[first] < radius) continue;
        std::deque<Cell> queue{grid.at(first)};
        label[first] = next;
        while (!queue.empty()) {
            const Cell c = queue.front();
            queue.pop_front();
            for (const Cell n : {Cell{c.x + 1, c.y}, {c.x - 1, c.y}, {c.x, c.y + 1}, {c.x, c.y - 1}}) {
                if (!grid.contains(n) || label[grid.index(n)] >= 0) continue;
                if (ground.clearance[grid.index(n)] < radius) continue;
                label[grid.index(n)] = next;
                queue.push_back(n);
            }
        }
        ++next;
    }
    return label;
}

}  // namespace

TEST_CASE("labels are those of a flood fill; a larger radius never joins regions") {
    Random random(51);
    for (int round = 0; round < 100; ++round) {
        const Ground ground = randomGround(random);
        ConnectedComponents components;
        std::vector<std::int32_t> before(ground.grid.count(), 0);
        for (const double radius : {0.0, 0.25, 0.375, 0.5, 0.8, 5.0}) {
            const RegionLabels& labels = components.labels(ground.grid, ground.clearance, radius);
            const auto expected = floodFill(ground, radius);
            CHECK(labels.radius == radius);
            CHECK(labels.label == expected);
            CHECK(labels.count == *std::max_element(expected.begin(), expected.end()) + 1);
            for (std::int32_t k = 0; k + 1 < ground.grid.count(); ++k) {
                if (expected[k] < 0 || expected[k] != expected[k + 1]) continue;
                CHECK(before[k] >= 0);
                CHECK(before[k] == before[k + 1]);
            }
            before = expected;
        }
    }
}

TEST_CASE("a radius as large as the clearance fits, and corners do not join") {
    const Grid grid{{0, 0}, 1.0, 2, 2};
    ConnectedComponents components;
    const std::vector<float> diagonal{0.5f, 0.0f, 0.0f, 0.5f};
    CHECK(components.labels(grid, diagonal, 0.5).label == std::vector<std::int32_t>{0, -1, -1, 1});
    CHECK(components.labels(grid, diagonal, std::nextafter(0.5, 1.0)).count == 0);
    CHECK(components.labels(grid, diagonal, 0.0).count == 1);
}

TEST_CASE("cached labels stay in place until as many other radii were queried, and clear() drops them") {
    Random random(52);
    Ground ground = randomGround(random);
    ConnectedComponents components;
    constexpr auto kRadii = ConnectedComponents::kCachedRadii;
    std::vector<const RegionLabels*> first;
    for (std::size_t i = 0; i < kRadii; ++i)
        first.push_back(&components.labels(ground.grid, ground.clearance, 0.05 * i));
    for (int round = 0; round < 3; ++round) {
        for (std::size_t i = 0; i < kRadii; ++i)
            CHECK(&components.labels(ground.grid, ground.clearance, 0.05 * i) == first[i]);
    }
    // One radius more takes the place of the oldest, which is labelled again when it is queried again.
    components.labels(ground.grid, ground.clearance, 0.99);
    CHECK(components.labels(ground.grid, ground.clearance, 0.0).label == floodFill(ground, 0.0));
    CHECK(components.labels(ground.grid, ground.clearance, 0.99).label == floodFill(ground, 0.99));

    for (float& c : ground.clearance) c = 1.0f;
    components.clear();
    CHECK(components.labels(ground.grid, ground.clearance, 0.99).count == 1);
}

TEST_CASE("many threads get the same labels at once") {
    Random random(53);
    const Ground ground = randomGround(random);
    ConnectedComponents components;
    const std::array<double, 4> radii{0.1, 0.3, 0.5, 0.7};
    std::array<std::vector<std::int32_t>, 4> expected;
    for (int r = 0; r < 4; ++r) expected[r] = floodFill(ground, radii[r]);
    std::atomic<int> wrong{0};
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
        threads.emplace_back([&, t] {
            for (int i = 0; i < 300; ++i) {
                const int r = (i + t) % 4;
                if (components.labels(ground.grid, ground.clearance, radii[r]).label != expected[r]) ++wrong;
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    CHECK(wrong == 0);
}
