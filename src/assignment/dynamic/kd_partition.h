// Points divided into boxes of equal counts.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "muster/vec2.h"

namespace muster {

/// True where the box around these points is at least as wide as high.
inline bool isWide(std::span<const Vec2> points, std::span<const std::int32_t> some) {
    Box box{points[some[0]], points[some[0]]};
    for (const std::int32_t k : some) {
        const Vec2 p = points[k];
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
    return box.width() >= box.height();
}

/// Brings the `count` points lowest along an axis to the front, those of equal coordinate by number.
inline void divide(std::span<const Vec2> points, std::span<std::int32_t> some, std::size_t count,
                   bool alongX) {
    const auto before = [&](std::int32_t a, std::int32_t b) {
        const Vec2 p = points[a];
        const Vec2 q = points[b];
        const double u = alongX ? p.x : p.y;
        const double v = alongX ? q.x : q.y;
        return u != v ? u < v : a < b;
    };
    if (count > 0 && count < some.size())
        std::nth_element(some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count), some.end(), before);
}

/// Leaves of a k-d tree: `some` is put in order leaf by leaf (ascending within each); `ends` gets the end of
/// each leaf. Leaves are as even as can be; none is empty where there are as many points as leaves.
inline void divideIntoLeaves(std::span<const Vec2> points, std::span<std::int32_t> some, std::int32_t leaves,
                             std::int32_t offset, std::vector<std::int32_t>& ends) {
    if (leaves <= 1) {
        std::sort(some.begin(), some.end());
        ends.push_back(offset + static_cast<std::int32_t>(some.size()));
        return;
    }
    const std::int32_t low = leaves / 2;
    const std::size_t count = some.size() * static_cast<std::size_t>(low) / static_cast<std::size_t>(leaves);
    if (!some.empty()) divide(points, some, count, isWide(points, some));
    divideIntoLeaves(points, some.first(count), low, offset, ends);
    divideIntoLeaves(points, some.subspan(count), leaves - low, offset + static_cast<std::int32_t>(count),
                     ends);
}

}  // namespace muster
