#include "formation/place_spacing.h"

#include <algorithm>
#include <cmath>

#include "muster/base/maths.h"

namespace muster {
namespace {

// Chooses cells that cover the points: as small as `least`, yet not many more than there are points.
void chooseCells(const std::vector<Vec2>& points, double least, SpacingMemory& memory) {
    Box box{points.front(), points.front()};
    for (const Vec2 p : points) {
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
    const double most = 8.0 * static_cast<double>(points.size()) + 64.0;
    memory.cell = least;
    while ((box.width() / memory.cell + 1.0) * (box.height() / memory.cell + 1.0) > most) memory.cell *= 1.5;
    memory.origin = box.min;
    memory.columns = static_cast<std::int32_t>(box.width() / memory.cell) + 1;
    memory.rows = static_cast<std::int32_t>(box.height() / memory.cell) + 1;
}

std::int32_t column(const SpacingMemory& memory, double x) {
    return static_cast<std::int32_t>(std::clamp((x - memory.origin.x) / memory.cell, -1.0, memory.columns + 0.5) + 1.0) - 1;
}
std::int32_t row(const SpacingMemory& memory, double y) {
    return static_cast<std::int32_t>(std::clamp((y - memory.origin.y) / memory.cell, -1.0, memory.rows + 0.5) + 1.0) - 1;
}

// Counting sort; points of one cell stay in ascending order.
void sortIntoCells(const std::vector<Vec2>& points, double cell, SpacingMemory& memory) {
    if (points.empty()) {
        memory.columns = memory.rows = 0;
        return;
    }
    chooseCells(points, cell, memory);
    memory.start.reserve(9 * points.size() + 256);  // Whatever cells are chosen: no growth later.
    memory.start.assign(static_cast<std::size_t>(memory.columns) * static_cast<std::size_t>(memory.rows) + 1, 0);
    memory.cellOf.resize(points.size());
    memory.item.resize(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const std::int32_t x = std::min(column(memory, points[k].x), memory.columns - 1);
        const std::int32_t y = std::min(row(memory, points[k].y), memory.rows - 1);
        memory.cellOf[k] = y * memory.columns + x;
        ++memory.start[static_cast<std::size_t>(memory.cellOf[k])];
    }
    std::int32_t sum = 0;
    for (std::int32_t& s : memory.start) sum += s, s = sum;
    for (std::size_t k = points.size(); k-- > 0;)
        memory.item[static_cast<std::size_t>(--memory.start[static_cast<std::size_t>(memory.cellOf[k])])] =
            static_cast<std::int32_t>(k);
}

// Calls visit(point) for the points in the cells of row `y` from column `left` to `right`.
template <class Visit>
void forRow(const SpacingMemory& memory, std::int32_t left, std::int32_t right, std::int32_t y, Visit visit) {
    left = std::max(left, 0);
    right = std::min(right, memory.columns - 1);
    if (y < 0 || y >= memory.rows || left > right) return;
    const auto first = static_cast<std::size_t>(memory.start[static_cast<std::size_t>(y * memory.columns + left)]);
    const auto end = static_cast<std::size_t>(memory.start[static_cast<std::size_t>(y * memory.columns + right) + 1]);
    for (std::size_t n = first; n < end; ++n) visit(static_cast<std::size_t>(memory.item[n]));
}

// Calls visit(low, high) for every pair nearer than `apart` of which one point passes `looksAt`, each
// once, in a fixed order.
template <class LooksAt, class Visit>
void forClosePairs(const std::vector<Vec2>& points, double apart, SpacingMemory& memory, LooksAt looksAt, Visit visit) {
    sortIntoCells(points, apart, memory);
    for (std::size_t one = 0; one < points.size(); ++one) {
        if (!looksAt(one)) continue;
        const std::int32_t x = memory.cellOf[one] % memory.columns;
        const std::int32_t y = memory.cellOf[one] / memory.columns;
        for (std::int32_t r = y - 1; r <= y + 1; ++r) {
            forRow(memory, x - 1, x + 1, r, [&](std::size_t other) {
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
    sortIntoCells(points, apart, memory);
    memory_.push.clear();
}

bool NearSearch::occupied(Vec2 spot, const std::vector<std::uint8_t>& fit, const std::vector<Vec2>& points) const {
    const double limit = apart_ * apart_;
    for (const Vec2 p : memory_.push)
        if (lengthSquared(p - spot) < limit) return true;
    const std::int32_t x = column(memory_, spot.x);
    const std::int32_t y = row(memory_, spot.y);
    bool found = false;
    for (std::int32_t r = y - 1; r <= y + 1 && !found; ++r) {
        forRow(memory_, x - 1, x + 1, r, [&](std::size_t k) {
            found = found || (fit[k] == 1 && lengthSquared(points[k] - spot) < limit);
        });
    }
    return found;
}

}  // namespace muster
