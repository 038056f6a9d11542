#include "engine/ground/environment/rectangle_partition.h"

#include <algorithm>

namespace muster {
namespace {

using Blocks = std::vector<CellBlock>;

// Runs of marked cells in each row, merged with an equal run of the row before.
Blocks mergeRuns(std::span<const char> marked, std::int32_t width, std::int32_t height) {
    Blocks blocks;
    std::vector<std::size_t> above, here;  // Indices of blocks that end at the former and at this row.
    for (std::int32_t y = 0; y < height; ++y) {
        here.clear();
        std::size_t next = 0;
        for (std::int32_t x = 0; x < width;) {
            const std::int32_t left = x;
            while (x < width && marked[y * width + x]) ++x;
            if (x == left) {
                ++x;
                continue;
            }
            while (next < above.size() && blocks[above[next]].left < left) ++next;
            if (next < above.size() && blocks[above[next]].left == left && blocks[above[next]].right == x) {
                blocks[above[next]].bottom = y + 1;
                here.push_back(above[next]);
            } else {
                here.push_back(blocks.size());
                blocks.push_back({left, y, x, y + 1});
            }
        }
        above.swap(here);
    }
    return blocks;
}

Blocks mergeColumnRuns(std::span<const char> marked, std::int32_t width, std::int32_t height) {
    std::vector<char> transposed(marked.size());
    for (std::int32_t y = 0; y < height; ++y) {
        for (std::int32_t x = 0; x < width; ++x) transposed[x * height + y] = marked[y * width + x];
    }
    Blocks blocks = mergeRuns(transposed, height, width);
    for (CellBlock& b : blocks) b = {b.top, b.left, b.bottom, b.right};
    return blocks;
}

}  // namespace

std::vector<CellBlock> partitionIntoRectangles(std::span<const char> marked, std::int32_t width,
                                               std::int32_t height) {
    Blocks best = mergeRuns(marked, width, height);
    Blocks other = mergeColumnRuns(marked, width, height);
    if (other.size() < best.size()) best.swap(other);
    std::sort(best.begin(), best.end(), [](const CellBlock& a, const CellBlock& b) {
        return a.top != b.top ? a.top < b.top : a.left < b.left;
    });
    return best;
}

}  // namespace muster
