// Partition of points into the leaves of a k-d tree (Bentley 1975).
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "muster/vec2.h"

namespace muster {

/// True where the bounding box of the points named by `indices` is at least as wide as high. Not empty.
inline bool isWide(std::span<const Vec2> points, std::span<const std::int32_t> indices) {
    Box box{points[indices[0]], points[indices[0]]};
    for (const std::int32_t k : indices) {
        const Vec2 p = points[k];
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
    return box.width() >= box.height();
}

/// Brings the `count` points that are lowest along an axis to the front of `indices`; equal coordinates are
/// ordered by index.
inline void partitionAlong(std::span<const Vec2> points, std::span<std::int32_t> indices, std::size_t count,
                           bool alongX) {
    const auto before = [&](std::int32_t a, std::int32_t b) {
        const Vec2 p = points[a];
        const Vec2 q = points[b];
        const double u = alongX ? p.x : p.y;
        const double v = alongX ? q.x : q.y;
        return u != v ? u < v : a < b;
    };
    if (count > 0 && count < indices.size())
        std::nth_element(indices.begin(), indices.begin() + static_cast<std::ptrdiff_t>(count), indices.end(),
                         before);
}

/// Orders `indices` leaf by leaf, ascending within each, and appends to `ends` the end of each leaf, counted
/// from `offset`. The sizes of leaves differ by two at most; none is empty where there are as many points as
/// leaves.
inline void partitionIntoLeaves(std::span<const Vec2> points, std::span<std::int32_t> indices,
                                std::int32_t leaves, std::int32_t offset, std::vector<std::int32_t>& ends) {
    if (leaves <= 1) {
        std::sort(indices.begin(), indices.end());
        ends.push_back(offset + static_cast<std::int32_t>(indices.size()));
        return;
    }
    const std::int32_t low = leaves / 2;
    const std::size_t count = indices.size() * static_cast<std::size_t>(low) / leaves;
    if (!indices.empty()) partitionAlong(points, indices, count, isWide(points, indices));
    partitionIntoLeaves(points, indices.first(count), low, offset, ends);
    partitionIntoLeaves(points, indices.subspan(count), leaves - low,
                        offset + static_cast<std::int32_t>(count), ends);
}

}  // namespace muster
