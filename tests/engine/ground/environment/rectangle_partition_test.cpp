#include "engine/ground/environment/rectangle_partition.h"

#include <doctest.h>

#include "base/random.h"

using namespace muster;

TEST_CASE("rectangles partition random masks") {
    Random random(9);
    for (int round = 0; round < 200; ++round) {
        const auto width = static_cast<std::int32_t>(1 + random.below(20)),
                   height = static_cast<std::int32_t>(1 + random.below(20));
        std::vector<char> marked(width * height);
        const double share = random.uniform();
        for (char& m : marked) m = random.uniform() < share ? 1 : 0;
        std::vector<int> count(marked.size(), 0);
        for (const CellBlock& b : partitionIntoRectangles(marked, width, height)) {
            for (std::int32_t y = b.top; y < b.bottom; ++y) {
                for (std::int32_t x = b.left; x < b.right; ++x) ++count[y * width + x];
            }
        }
        for (std::size_t i = 0; i < count.size(); ++i) CHECK(count[i] == (marked[i] ? 1 : 0));
    }
    CHECK(partitionIntoRectangles(std::vector<char>(12, 1), 4, 3).size() == 1);
}
