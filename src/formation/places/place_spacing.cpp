#include "formation/places/place_spacing.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"

namespace muster {
namespace {

// Calls visit(point) for the points in the cells of row `y` from column `left` to `right`.
template <class Visit>
void forRow(const CellList& cells, std::int32_t left, std::int32_t right, std::int32_t y, Visit visit) {
    const Grid& grid = cells.grid();
    left = std::max(left, 0);
    right = std::min(right, grid.width - 1);
    if (y < 0 || y >= grid.height || left > right) return;
    for (const std::int32_t k : cells.within(grid.index({left, y}), grid.index({right, y})))
        visit(static_cast<std::size_t>(k));
}

// Pairs are listed up to this much farther apart than asked, and listed anew once a point moved half of that.
constexpr double kMargin = 0.8;

void listPairs(const std::vector<Vec2>& points, double apart, SpacingMemory& memory) {
    const double most = 0.5 * kMargin * apart;
    bool listed = memory.foundAt.size() == points.size();
    for (std::size_t k = 0; k < points.size() && listed; ++k)
        listed = lengthSquared(points[k] - memory.foundAt[k]) <= most * most;
    if (listed) return;
    const double reach = apart * (1.0 + kMargin);
    memory.near.clear();
    memory.foundAt = points;
    if (points.empty()) return;
    memory.cells.sort(points, reach);
    memory.cells.forPairs(reach, [&](std::int32_t low, std::int32_t high) {
        memory.near.push_back({low, high});
    });
}

}  // namespace

bool partClosePairs(std::vector<Vec2>& points, double apart, SpacingMemory& memory,
                    std::vector<std::uint8_t>& moved) {
    listPairs(points, apart, memory);
    memory.push.assign(points.size(), {});
    bool any = false;
    // A little more than asked, or the last gap would close only in the limit.
    const double wanted = apart * 1.02;
    for (const SpacingMemory::Pair pair : memory.near) {
        const auto low = static_cast<std::size_t>(pair.low), high = static_cast<std::size_t>(pair.high);
        const Vec2 way = points[high] - points[low];
        if (!(lengthSquared(way) < apart * apart) || (moved[low] == 0 && moved[high] == 0)) continue;
        const double gap = length(way);
        Vec2 direction = way / gap;
        if (!(gap > 1e-9 * apart)) {
            const double angle = 2.399963229728653 * static_cast<double>(high);
            direction = {cosine(angle), sine(angle)};
        }
        const Vec2 half = direction * (0.5 * (wanted - gap));
        memory.push[low] -= half;
        memory.push[high] += half;
        any = true;
    }
    std::fill(moved.begin(), moved.end(), std::uint8_t{0});
    if (!any) return false;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec2 push = memory.push[k];
        if (push.x == 0.0 && push.y == 0.0) continue;
        points[k] += clampLength(push, apart);
        moved[k] = 1;
    }
    return true;
}

void markUnfit(const std::vector<Vec2>& points, double apart, SpacingMemory& memory,
               std::vector<std::uint8_t>& fit) {
    listPairs(points, apart, memory);
    memory.close.clear();
    for (const SpacingMemory::Pair pair : memory.near) {
        const Vec2 way = points[pair.high] - points[pair.low];
        if (lengthSquared(way) < apart * apart) memory.close.push_back(pair);
    }
    // In the order of the higher ones, so that each learns first whether those before it stay.
    std::sort(memory.close.begin(), memory.close.end(), [](SpacingMemory::Pair a, SpacingMemory::Pair b) {
        return a.high != b.high ? a.high < b.high : a.low < b.low;
    });
    for (const SpacingMemory::Pair pair : memory.close)
        if (fit[pair.low] != 0) fit[pair.high] = 0;
}

NearSearch::NearSearch(const std::vector<Vec2>& points, double apart, SpacingMemory& memory)
    : apart_(apart), memory_(memory) {
    memory.cells.sort(points, apart);
    memory.foundAt.clear();
    memory_.push.clear();
}

bool NearSearch::occupied(Vec2 spot, const std::vector<std::uint8_t>& fit,
                          const std::vector<Vec2>& points) const {
    const double limit = apart_ * apart_;
    for (const Vec2 p : memory_.push)
        if (lengthSquared(p - spot) < limit) return true;
    const Cell cell = memory_.cells.grid().cellOf(spot);
    bool found = false;
    for (std::int32_t r = cell.y - 1; r <= cell.y + 1 && !found; ++r) {
        forRow(memory_.cells, cell.x - 1, cell.x + 1, r, [&](std::size_t k) {
            found = found || (fit[k] == 1 && lengthSquared(points[k] - spot) < limit);
        });
    }
    return found;
}

}  // namespace muster
