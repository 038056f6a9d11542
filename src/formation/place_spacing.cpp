#include "formation/place_spacing.h"

#include <algorithm>
#include <cmath>

#include "muster/base/maths.h"

namespace muster {
namespace {

// Cell key: rows first, so that the three cells of a row next to each other form one run.
std::uint64_t cellKey(double column, double row) {
    const auto clamp = [](double v) { return static_cast<std::uint64_t>(std::clamp(v, -1e9, 1e9) + 2e9); };
    return clamp(row) << 32 | clamp(column);
}

void sortIntoCells(const std::vector<Vec2>& points, double cell, SpacingMemory& memory) {
    memory.order.resize(points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
        memory.order[k] = {cellKey(std::floor(points[k].x / cell), std::floor(points[k].y / cell)),
                           static_cast<std::int32_t>(k)};
    std::sort(memory.order.begin(), memory.order.end());
}

// Calls visit(i, j) for every pair nearer than `apart`: i in the order of cells, each pair once.
template <class Visit>
void forClosePairs(const std::vector<Vec2>& points, double apart, SpacingMemory& memory, Visit visit) {
    sortIntoCells(points, apart, memory);
    const auto& order = memory.order;
    std::size_t above = 0;  // First entry at or beyond the next row's left neighbour.
    for (std::size_t k = 0; k < order.size(); ++k) {
        const auto i = static_cast<std::size_t>(order[k].second);
        const auto test = [&](std::size_t other) {
            const auto j = static_cast<std::size_t>(order[other].second);
            if (lengthSquared(points[i] - points[j]) < apart * apart) visit(i, j);
        };
        const std::uint64_t key = order[k].first;
        for (std::size_t n = k + 1; n < order.size() && order[n].first <= key + 1; ++n) test(n);
        const std::uint64_t left = key + (std::uint64_t{1} << 32) - 1;
        while (above < order.size() && order[above].first < left) ++above;
        for (std::size_t n = above; n < order.size() && order[n].first <= left + 2; ++n) test(n);
    }
}

}  // namespace

bool partClosePairs(std::vector<Vec2>& points, double apart, SpacingMemory& memory, std::vector<std::uint8_t>& moved) {
    memory.push.assign(points.size(), {});
    bool any = false;
    // A little more than asked, or the last gap would close only in the limit.
    const double wanted = apart * 1.02;
    forClosePairs(points, apart, memory, [&](std::size_t i, std::size_t j) {
        const std::size_t low = std::min(i, j);
        const std::size_t high = std::max(i, j);
        const Vec2 way = points[high] - points[low];
        const double gap = length(way);
        const double angle = 2.399963229728653 * static_cast<double>(high);
        const Vec2 direction = gap > 1e-9 * apart ? way / gap : Vec2{cosine(angle), sine(angle)};
        const Vec2 half = direction * (0.5 * (wanted - gap));
        memory.push[low] -= half;
        memory.push[high] += half;
        any = true;
    });
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
    // Pairs are rare here; those of one point must be looked at after those of lower ones.
    memory.push.clear();
    forClosePairs(points, apart, memory, [&](std::size_t i, std::size_t j) {
        memory.push.push_back({static_cast<double>(std::max(i, j)), static_cast<double>(std::min(i, j))});
    });
    std::sort(memory.push.begin(), memory.push.end(),
              [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    for (const Vec2 pair : memory.push)
        if (fit[static_cast<std::size_t>(pair.y)] != 0) fit[static_cast<std::size_t>(pair.x)] = 0;
}

}  // namespace muster
