#include "scale/caves.h"

#include <vector>

#include "base/random.h"

namespace muster::scale {
namespace {

constexpr double kRock = 0.46;           // Share of the blocks that begin as rock.
constexpr std::int32_t kBlock = 8;       // Edge of a block [cells].
constexpr int kRounds = 4;               // Of the automaton.
constexpr std::int32_t kLeastRocks = 5;  // Of nine blocks: then the one in the middle is rock.

/// Blocks of cells, rock or free.
struct Blocks {
    std::int32_t width, height;
    std::vector<std::uint8_t> rock;

    bool isRock(std::int32_t x, std::int32_t y) const {
        return x < 0 || y < 0 || x >= width || y >= height || rock[y * width + x] != 0;
    }
    Blocks next() const {
        Blocks after = *this;
        for (std::int32_t y = 0; y < height; ++y)
            for (std::int32_t x = 0; x < width; ++x) {
                std::int32_t rocks = 0;
                for (std::int32_t k = 0; k < 9; ++k) rocks += isRock(x + k % 3 - 1, y + k / 3 - 1) ? 1 : 0;
                after.rock[y * width + x] = rocks >= kLeastRocks ? 1 : 0;
            }
        return after;
    }
};

}  // namespace

MapGrid madeCaves(std::int32_t width, std::int32_t height, std::uint64_t seed) {
    Random random(seed);
    Blocks blocks{(width + kBlock - 1) / kBlock, (height + kBlock - 1) / kBlock, {}};
    for (std::int32_t k = 0; k < blocks.width * blocks.height; ++k)
        blocks.rock.push_back(random.uniform(0.0, 1.0) < kRock ? 1 : 0);
    for (int round = 0; round < kRounds; ++round) blocks = blocks.next();
    MapGrid map{width, height, {}};
    map.cells.reserve(static_cast<std::size_t>(width) * height);
    for (std::int32_t y = 0; y < height; ++y)
        for (std::int32_t x = 0; x < width; ++x) {
            const bool rock = blocks.isRock(x / kBlock, y / kBlock);
            map.cells += rock || x == 0 || y == 0 || x + 1 == width || y + 1 == height ? '@' : '.';
        }
    return map;
}

}  // namespace muster::scale
