// Gaps between obstacles that are too narrow (paper section 5: at least a character's diameter).
#include <cmath>
#include <limits>

#include "environment/environment_state.h"

namespace muster {
namespace {

constexpr double kTouching = 1e-9;  // [m]

// The nearest points of two pieces.
struct Span {
    Vec2 a, b;
    double width = std::numeric_limits<double>::infinity();
};

void offer(Span& span, Vec2 a, Vec2 b, double width) {
    if (width < span.width) span = {a, b, width};
}

// From the disc or the corners of `one` to the surface of `other`; `swapped` keeps a and b apart.
void offerCorners(Span& span, const ObstaclePiece& one, const ObstaclePiece& other, bool swapped) {
    const auto look = [&](Vec2 p, double radius) {
        const double d = other.signedDistance(p) - radius;
        const Vec2 there = other.closestSurface(p);
        const Vec2 here = p + normalized(there - p) * radius;
        if (swapped) {
            offer(span, there, here, d);
        } else {
            offer(span, here, there, d);
        }
    };
    if (one.corners.empty()) look(one.centre, one.radius);
    for (Vec2 p : one.corners) look(p, 0.0);
}

Span spanBetween(const ObstaclePiece& a, const ObstaclePiece& b) {
    Span span;
    // A disc's centre says all there is to say; two polygons are nearest at a corner of one of them.
    if (!b.corners.empty() || a.corners.empty()) offerCorners(span, a, b, false);
    if (!a.corners.empty()) offerCorners(span, b, a, true);
    for (std::size_t i = 0, j = a.corners.size() - 1; i < a.corners.size() && !b.corners.empty(); j = i++) {
        if (b.segmentDistance(a.corners[j], a.corners[i]) == 0.0) span.width = 0.0;
    }
    return span;
}

bool boxesMeet(const Box& a, const Box& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

}  // namespace

std::vector<NarrowGap> Environment::narrowGaps(double width, std::int32_t most) const {
    impl_->ensure();
    const Impl& s = *impl_;
    std::vector<std::int32_t> order(s.pieces.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::int32_t>(i);
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        const double x = s.index.bounds[a].min.x, y = s.index.bounds[b].min.x;
        return x != y ? x < y : a < b;
    });
    std::vector<NarrowGap> gaps;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Box around = s.index.bounds[order[i]].grown(width);
        for (std::size_t k = i + 1; k < order.size() && s.index.bounds[order[k]].min.x <= around.max.x; ++k) {
            if (!boxesMeet(around, s.index.bounds[order[k]])) continue;
            const ObstaclePiece& a = s.pieces[std::min(order[i], order[k])];
            const ObstaclePiece& b = s.pieces[std::max(order[i], order[k])];
            if (a.obstacle == b.obstacle) continue;
            const Span span = spanBetween(a, b);
            if (span.width < width) gaps.push_back({a.obstacle, b.obstacle, 0.5 * (span.a + span.b), span.width});
        }
    }
    // One gap per pair of obstacles, the narrowest; none where any of their parts touch.
    std::sort(gaps.begin(), gaps.end(), [](const NarrowGap& x, const NarrowGap& y) {
        if (x.a != y.a) return x.a < y.a;
        if (x.b != y.b) return x.b < y.b;
        if (x.width != y.width) return x.width < y.width;
        return x.where.x != y.where.x ? x.where.x < y.where.x : x.where.y < y.where.y;
    });
    std::vector<NarrowGap> result;
    for (std::size_t i = 0; i < gaps.size() && static_cast<std::int32_t>(result.size()) < most; ++i) {
        if (i > 0 && gaps[i].a == gaps[i - 1].a && gaps[i].b == gaps[i - 1].b) continue;
        // Where a third obstacle fills the space between, there is no gap.
        if (gaps[i].width > kTouching && s.distanceTo(gaps[i].where, width) > kTouching) result.push_back(gaps[i]);
    }
    return result;
}

}  // namespace muster
