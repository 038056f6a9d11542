#include "formation/place_spacing.h"

#include <algorithm>
#include <cmath>

#include "muster/base/maths.h"

namespace muster {
namespace {

// Calls visit(point) for the points in the cells of row `y` from column `left` to `right`.
template <class Visit>
void forRow(const CellList& cells, std::int32_t left, std::int32_t right, std::int32_t y, Visit visit) {
    const Grid& grid = cells.grid();
    left = std::max(left, 0);
    right = std::min(right, grid.width - 1);
    if (y < 0 || y >= grid.height || left > right) return;
    for (const std::int32_t k : cells.within(grid.index({left, y}), grid.index({right, y}))) visit(static_cast<std::size_t>(k));
}

// Calls visit(low, high) for every pair nearer than `apart` of which one point passes `looksAt`, each
// once, in a fixed order.
template <class LooksAt, class Visit>
void forClosePairs(const std::vector<Vec2>& points, double apart, SpacingMemory& memory, LooksAt looksAt, Visit visit) {
    memory.cells.sort(points, apart);
    for (std::size_t one = 0; one < points.size(); ++one) {
        if (!looksAt(one)) continue;
        const Cell cell = memory.cells.grid().at(memory.cells.cellOf(one));
        for (std::int32_t r = cell.y - 1; r <= cell.y + 1; ++r) {
            forRow(memory.cells, cell.x - 1, cell.x + 1, r, [&](std::size_t other) {
                // Of a pair that both look, the higher one visits.
                if (other == one || (other > one && looksAt(other))) return;
                if (lengthSquared(points[one] - points[other]) < apart * apart)
                    visit(std::min(one, other), std::max(one, other));
            });
        }
    }
}

}  // namespace

bool partClosePairs(std::vector<Vec2>& points, double apart, SpacingMemory& memory, std::vector<std::uint8_t>& moved) {
    memory.push.assign(points.size(), {});
    bool any = false;
    // A little more than asked, or the last gap would close only in the limit.
    const double wanted = apart * 1.02;
    const auto looksAt = [&](std::size_t k) { return moved[k] != 0; };
    forClosePairs(points, apart, memory, looksAt, [&](std::size_t low, std::size_t high) {
        const Vec2 way = points[high] - points[low];
        const double gap = length(way);
        const double angle = 2.399963229728653 * static_cast<double>(high);
        const Vec2 direction = gap > 1e-9 * apart ? way / gap : Vec2{cosine(angle), sine(angle)};
        const Vec2 half = direction * (0.5 * (wanted - gap));
        memory.push[low] -= half;
        memory.push[high] += half;
        any = true;
    });
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

void markUnfit(const std::vector<Vec2>& points, double apart, SpacingMemory& memory, std::vector<std::uint8_t>& fit) {
    const auto all = [](std::size_t) { return true; };
    forClosePairs(points, apart, memory, all, [&](std::size_t low, std::size_t high) {
        if (fit[low] != 0) fit[high] = 0;
    });
}

NearSearch::NearSearch(const std::vector<Vec2>& points, double apart, SpacingMemory& memory)
    : apart_(apart), memory_(memory) {
    memory.cells.sort(points, apart);
    memory_.push.clear();
}

bool NearSearch::occupied(Vec2 spot, const std::vector<std::uint8_t>& fit, const std::vector<Vec2>& points) const {
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
