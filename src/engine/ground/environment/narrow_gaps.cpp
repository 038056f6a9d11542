// Gaps between obstacles that are too narrow (paper section 5: at least a character's diameter), found by
// sweep and prune over the boxes of convex pieces.
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/ground/environment/environment_impl.h"

namespace muster {
namespace {

// The narrowest gap between two pieces. Where parallel sides face each other it has a length: `first` and
// `last` are midpoints at its ends.
struct Span {
    Vec2 first, last;
    double width = std::numeric_limits<double>::infinity();

    Vec2 middle() const { return 0.5 * (first + last); }
};

void offer(Span& span, Vec2 a, Vec2 b, double width) {
    const Vec2 middle = 0.5 * (a + b);
    if (width < span.width - kTouching)
        span = {middle, middle, width};
    else if (width <= span.width + kTouching)
        span.last = middle;
}

// Offers distances from the disc or the corners of `one` to the surface of `other`; `swapped` keeps a and b
// apart.
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
    // A disc needs only its centre; two polygons are nearest at a corner of one of them.
    if (!b.corners.empty() || a.corners.empty()) offerCorners(span, a, b, false);
    if (!a.corners.empty()) offerCorners(span, b, a, true);
    for (std::size_t i = 0, j = a.corners.size() - 1; i < a.corners.size() && !b.corners.empty(); j = i++) {
        if (b.segmentDistance(a.corners[j], a.corners[i]) == 0.0) span.width = 0.0;
    }
    return span;
}

// The gap between a piece and one side of the box; infinitely wide where the piece lies across or beyond it.
Span spanToSide(const ObstaclePiece& piece, const Box& bounds, const Box& box, int side) {
    const bool alongX = side < 2;
    const double edge = side == 0 ? box.min.x : side == 1 ? box.max.x : side == 2 ? box.min.y : box.max.y;
    const double outward = side % 2 == 0 ? -1.0 : 1.0;
    const double reached = side == 0   ? bounds.min.x
                           : side == 1 ? bounds.max.x
                           : side == 2 ? bounds.min.y
                                       : bounds.max.y;
    Span span;
    const double width = (edge - reached) * outward;
    const auto tip = [&](Vec2 p) { offer(span, p, alongX ? Vec2{edge, p.y} : Vec2{p.x, edge}, width); };
    if (width <= 0.0) return span;
    if (piece.corners.empty())
        tip(piece.centre + (alongX ? Vec2{outward, 0.0} : Vec2{0.0, outward}) * piece.radius);
    for (const Vec2 p : piece.corners)
        if ((alongX ? p.x : p.y) == reached) tip(p);
    return span;
}

// Orders gaps by obstacles, edges last, the narrowest first.
bool comesFirst(const NarrowGap& x, const NarrowGap& y) {
    if (!x.b != !y.b) return static_cast<bool>(x.b);
    if (x.a != y.a) return x.a < y.a;
    if (x.b != y.b) return x.b < y.b;
    if (x.width != y.width) return x.width < y.width;
    return x.where.x != y.where.x ? x.where.x < y.where.x : x.where.y < y.where.y;
}

// Collects gaps of an environment.
class GapSearch {
public:
    GapSearch(const Environment& environment, const PieceIndex& index, double width)
        : environment_(environment), pieces_(environment.pieces()), bounds_(index.bounds), width_(width) {}

    void look(std::int32_t one, std::int32_t other) {
        const ObstaclePiece& a = pieces_[std::min(one, other)];
        const ObstaclePiece& b = pieces_[std::max(one, other)];
        add(a.obstacle, b.obstacle, spanBetween(a, b));
    }
    void lookAtSides(std::int32_t one) {
        const ObstaclePiece& piece = pieces_[one];
        for (int side = 0; side < 4; ++side)
            add(piece.obstacle, {}, spanToSide(piece, bounds_[one], environment_.def().sides(), side));
    }
    // One gap per pair of obstacles.
    std::vector<NarrowGap> take(std::int32_t most) {
        std::sort(gaps_.begin(), gaps_.end(), comesFirst);
        const auto samePair = [](const NarrowGap& x, const NarrowGap& y) { return x.a == y.a && x.b == y.b; };
        gaps_.erase(std::unique(gaps_.begin(), gaps_.end(), samePair), gaps_.end());
        if (static_cast<std::int64_t>(gaps_.size()) > most) gaps_.resize(std::max(most, 0));
        return std::move(gaps_);
    }

private:
    void add(ObstacleId a, ObstacleId b, const Span& span) {
        if (!(span.width < width_) || span.width <= kTouching) return;
        const Vec2 middle = span.middle();
        // There is no gap where something else fills the space between.
        if (!environment_.def().box.contains(middle) ||
            environment_.distanceToObstacle(middle, width_) <= kTouching)
            return;
        gaps_.push_back({a, b, middle, span.width});
    }

    const Environment& environment_;
    std::span<const ObstaclePiece> pieces_;
    const std::vector<Box>& bounds_;
    double width_;
    std::vector<NarrowGap> gaps_;
};

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
    GapSearch search(*this, s.index, width);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Box around = s.index.bounds[order[i]].grown(width);
        for (std::size_t k = i + 1; k < order.size() && s.index.bounds[order[k]].min.x <= around.max.x; ++k)
            if (boxesMeet(around, s.index.bounds[order[k]])) search.look(order[i], order[k]);
        search.lookAtSides(order[i]);
    }
    return search.take(most);
}

}  // namespace muster
