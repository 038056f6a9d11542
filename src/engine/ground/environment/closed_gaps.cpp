// Gaps that are too narrow to pass, and steps between points that must not lead through one.
//
// A disc cannot pass between two convex parts exactly where their distance is less than its diameter: every
// point of the shortest segment between them is then nearer than a radius to one of them.
#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/ground/environment/environment_impl.h"

namespace muster {
namespace {

/// The shorter of `gap` and the segment from `p`, a corner or the centre of a disc of one part, to another.
void shorten(ClosedGap& gap, double& least, Vec2 p, double radius, const ObstaclePiece& other) {
    const SurfacePoint nearest = closestSurfacePoint(other, p);
    const double width = nearest.distance - radius;
    if (!(width < least)) return;
    least = width;
    gap = {p + normalized(nearest.point - p) * radius, nearest.point};
}

/// The shortest segment between two parts where it is shorter than `width` and they do not touch.
std::optional<ClosedGap> gapBetween(const ObstaclePiece& one, const ObstaclePiece& other, double width) {
    ClosedGap gap;
    double least = width;
    if (one.corners.empty()) shorten(gap, least, one.centre, one.radius, other);
    for (const Vec2 p : one.corners) shorten(gap, least, p, 0.0, other);
    if (!one.corners.empty() && !other.corners.empty())
        for (const Vec2 p : other.corners) shorten(gap, least, p, 0.0, one);
    if (!one.corners.empty() && other.corners.empty()) shorten(gap, least, other.centre, other.radius, one);
    if (!(least < width) || least <= kTouching) return {};
    for (std::size_t i = 0, j = one.corners.size() - 1; i < one.corners.size(); j = i++)
        if (other.segmentDistance(one.corners[j], one.corners[i]) <= kTouching) return {};
    return gap;
}

/// Calls `visit(gap)` for the segments from a part to sides of the box that are shorter than `width`.
template <class Visit>
void forSides(const ObstaclePiece& piece, const Box& bounds, const Box& box, double width,
              const Visit& visit) {
    const auto tip = [&](Vec2 outward) {
        if (piece.corners.empty()) return piece.centre + outward * piece.radius;
        return *std::max_element(piece.corners.begin(), piece.corners.end(),
                                 [&](Vec2 a, Vec2 b) { return dot(a, outward) < dot(b, outward); });
    };
    const auto look = [&](double space, Vec2 outward) {
        if (!(space < width) || space <= kTouching) return;
        const Vec2 p = tip(outward);
        visit(ClosedGap{p, p + outward * space});
    };
    look(bounds.min.x - box.min.x, {-1.0, 0.0});
    look(box.max.x - bounds.max.x, {1.0, 0.0});
    look(bounds.min.y - box.min.y, {0.0, -1.0});
    look(box.max.y - bounds.max.y, {0.0, 1.0});
}

}  // namespace

bool crosses(const ClosedGap& gap, Vec2 a, Vec2 b) {
    const Vec2 along = gap.b - gap.a;
    const Vec2 step = b - a;
    const double atA = cross(along, a - gap.a), atB = cross(along, b - gap.a);
    const double from = cross(step, gap.a - a), to = cross(step, gap.b - a);
    return ((atA <= 0.0 && atB >= 0.0) || (atA >= 0.0 && atB <= 0.0)) &&
           ((from <= 0.0 && to >= 0.0) || (from >= 0.0 && to <= 0.0)) && !(atA == 0.0 && atB == 0.0);
}

// Finds gaps between static pieces that act in a box, by the sweep of narrowGaps().
void Environment::closedGaps(const Box& area, double width, std::vector<ClosedGap>& gaps) const {
    impl_->ensure();
    const Impl& s = *impl_;
    const std::vector<Box>& bounds = s.index.bounds;
    std::vector<std::int32_t> order;
    for (const std::int32_t number : s.index.fixed)
        if (boxesMeet(bounds[number].grown(width), area)) order.push_back(number);
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        const double x = bounds[a].min.x, y = bounds[b].min.x;
        return x != y ? x < y : a < b;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Box around = bounds[order[i]].grown(width);
        for (std::size_t k = i + 1; k < order.size() && bounds[order[k]].min.x <= around.max.x; ++k) {
            if (!boxesMeet(around, bounds[order[k]])) continue;
            // The order of the two decides about bits, so it must not depend on `area`.
            const auto gap = gapBetween(s.pieces[std::min(order[i], order[k])],
                                        s.pieces[std::max(order[i], order[k])], width);
            if (gap) gaps.push_back(*gap);
        }
        forSides(s.pieces[order[i]], bounds[order[i]], s.def.sides(), width,
                 [&](const ClosedGap& gap) { gaps.push_back(gap); });
    }
}

bool Environment::stepIsFree(Vec2 a, Vec2 b, double radius) const {
    impl_->ensure();
    const Impl& s = *impl_;
    const double half = 0.5 * distance(a, b);
    const Vec2 middle = 0.5 * (a + b);
    const double diameter = 2.0 * (radius - Impl::kContactTolerance);
    // Where no surface is near, nothing can lie between the points.
    if (s.stillDistanceLowerBound(a) >= radius + half && s.stillDistanceLowerBound(b) >= radius + half)
        return true;
    // One side of a gap that the step crosses is nearer than a diameter to the step.
    constexpr std::size_t kMostNearPieces = 32;
    std::int32_t near[kMostNearPieces];
    std::size_t count = 0;
    bool free = true;
    const auto look = [&](std::int32_t number) {
        if (!free || s.pieces[number].moving) return;
        if (squaredDistance(s.index.bounds[number], middle) > (half + diameter) * (half + diameter)) return;
        const ObstaclePiece& piece = s.pieces[number];
        const double away = piece.segmentDistance(a, b);
        if (away <= 0.0) free = false;
        if (!(away < diameter)) return;
        forSides(piece, s.index.bounds[number], s.def.sides(), diameter,
                 [&](const ClosedGap& gap) { free = free && !crosses(gap, a, b); });
        for (std::size_t k = 0; k < count && free; ++k) {
            const auto gap = gapBetween(s.pieces[near[k]], piece, diameter);
            free = !gap || !crosses(*gap, a, b);
        }
        if (count < kMostNearPieces) near[count++] = number;
    };
    if (half + diameter <= Impl::kReach && s.inBox(middle)) {
        s.index.forPiecesAt(middle, look);
    } else {
        for (const std::int32_t number : s.index.fixed) look(number);
    }
    return free;
}

}  // namespace muster
