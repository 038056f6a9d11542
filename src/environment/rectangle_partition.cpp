#include "environment/rectangle_partition.h"

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

// Greedy partition: takes the largest rectangle of unused marked cells until none is left. Each cell stands
// for the largest rectangle whose top left cell it is. Taking other rectangles can only shrink it, so an old
// area is an upper bound, and a heap whose top is re-evaluated (lazy greedy, Minoux 1978) finds the largest.
class GreedyPartition {
public:
    GreedyPartition(std::span<const char> marked, std::int32_t width, std::int32_t height)
        : width_(width), height_(height), unused_(marked.begin(), marked.end()), run_(marked.size()) {
        for (std::int32_t y = 0; y < height_; ++y) countRuns(y, width_ - 1);
    }

    Blocks partition() {
        for (std::int32_t i = 0; i < width_ * height_; ++i) {
            if (unused_[i]) heap_.push_back({areaOf(largestAt(i)), i});
        }
        std::make_heap(heap_.begin(), heap_.end(), smaller);
        Blocks blocks;
        while (!heap_.empty()) {
            std::pop_heap(heap_.begin(), heap_.end(), smaller);
            Candidate& candidate = heap_.back();
            const CellBlock block = unused_[candidate.cell] ? largestAt(candidate.cell) : CellBlock{};
            const std::int32_t area = areaOf(block);
            if (area == candidate.area) {
                heap_.pop_back();
                take(block);
                blocks.push_back(block);
            } else if (area > 0) {
                candidate.area = area;
                std::push_heap(heap_.begin(), heap_.end(), smaller);
            } else {
                heap_.pop_back();
            }
        }
        return blocks;
    }

private:
    struct Candidate {
        std::int32_t area;
        std::int32_t cell;
    };

    static bool smaller(const Candidate& a, const Candidate& b) {
        return a.area != b.area ? a.area < b.area : a.cell > b.cell;
    }
    static std::int32_t areaOf(const CellBlock& b) { return (b.right - b.left) * (b.bottom - b.top); }

    // Updates run_ of row y, columns 0 to `last`.
    void countRuns(std::int32_t y, std::int32_t last) {
        for (std::int32_t x = last; x >= 0; --x) {
            const std::int32_t i = y * width_ + x;
            if (!unused_[i]) {
                run_[i] = 0;
            } else {
                run_[i] = x + 1 < width_ ? run_[i + 1] + 1 : 1;
            }
        }
    }

    CellBlock largestAt(std::int32_t cell) const {
        const std::int32_t x = cell % width_, y = cell / width_;
        CellBlock best;
        std::int32_t breadth = run_[cell];
        for (std::int32_t row = y; row < height_ && run_[row * width_ + x] > 0; ++row) {
            breadth = std::min(breadth, run_[row * width_ + x]);
            const CellBlock block{x, y, x + breadth, row + 1};
            if (areaOf(block) > areaOf(best)) best = block;
        }
        return best;
    }

    void take(const CellBlock& block) {
        for (std::int32_t y = block.top; y < block.bottom; ++y) {
            std::fill(unused_.begin() + y * width_ + block.left, unused_.begin() + y * width_ + block.right,
                      0);
            countRuns(y, block.right - 1);
        }
    }

    std::int32_t width_;
    std::int32_t height_;
    std::vector<char> unused_;       // Per cell, 1 where it is marked and not taken.
    std::vector<std::int32_t> run_;  // Per cell, unused cells in its row from it on to the right.
    std::vector<Candidate> heap_;
};

}  // namespace

std::vector<CellBlock> partitionIntoRectangles(std::span<const char> marked, std::int32_t width,
                                               std::int32_t height) {
    Blocks best = mergeRuns(marked, width, height);
    for (Blocks& other : std::vector<Blocks>{mergeColumnRuns(marked, width, height),
                                             GreedyPartition(marked, width, height).partition()}) {
        if (other.size() < best.size()) best.swap(other);
    }
    std::sort(best.begin(), best.end(), [](const CellBlock& a, const CellBlock& b) {
        return a.top != b.top ? a.top < b.top : a.left < b.left;
    });
    return best;
}

}  // namespace muster
