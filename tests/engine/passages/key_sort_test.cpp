// Sorting by digits against sorting by comparisons.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "engine/passages/key_sort.h"

using namespace muster;

namespace {

/// Keys of all magnitudes and signs, many of them equal as a float or altogether.
std::vector<SortKey> randomKeys(Random& random, std::int32_t count) {
    std::vector<SortKey> keys;
    for (std::int32_t i = 0; i < count; ++i) {
        const std::uint32_t kind = random.below(5);
        double key = random.uniform(-20.0, 20.0);
        if (kind == 0) key = std::floor(key);
        if (kind == 1) key = 3.0 + 1e-12 * std::floor(key);
        if (kind == 2) key = key * 1e-40;
        if (kind == 3 && i % 2 == 0) key = -0.0;
        keys.push_back({key, count - i});
    }
    return keys;
}

}  // namespace

TEST_CASE("keys are sorted exactly, and equal ones by number") {
    Random random(3);
    KeySort sort;
    for (const std::int32_t count : {0, 1, 2, 100, 128, 129, 700, 3999, 4000, 20000, 300}) {
        std::vector<SortKey> keys = randomKeys(random, count), expected = keys;
        std::sort(expected.begin(), expected.end());
        sort.sort(keys);
        for (std::size_t k = 0; k < keys.size(); ++k) {
            REQUIRE(keys[k].key == expected[k].key);
            REQUIRE(keys[k].index == expected[k].index);
        }
    }
}
