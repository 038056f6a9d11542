#include "engine/fields/cost/chamfer_distance.h"

#include <doctest.h>

#include <cmath>

#include "base/random.h"

using namespace muster;

TEST_CASE("chamfer distances bound Euclidean ones from above, by 8 % at most") {
    Random random(9);
    for (int round = 0; round < 20; ++round) {
        const auto width = static_cast<std::int32_t>(1 + random.below(30));
        const auto height = static_cast<std::int32_t>(1 + random.below(30));
        std::vector<float> values(static_cast<std::size_t>(width) * height, 1e6f);
        std::vector<std::int32_t> zeros;
        for (std::uint32_t k = 0; k <= random.below(4); ++k) {
            zeros.push_back(
                static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(values.size()))));
            values[zeros.back()] = 0.0f;
        }
        chamferDistance(width, height, values);
        for (std::int32_t k = 0; k < width * height; ++k) {
            double exact = 1e6;
            for (const std::int32_t zero : zeros)
                exact = std::min(exact, std::hypot(k % width - zero % width, k / width - zero / width));
            REQUIRE(values[k] >= exact - 1e-4);
            REQUIRE(kChamferLowerBound * values[k] <= exact + 1e-4);
        }
    }
}
