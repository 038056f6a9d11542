// Queries of Environment about points, lines and paths.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/grid_search.h"
#include "engine/ground/environment/environment_impl.h"

namespace muster {
namespace {

// Margin by which separation tests must pass, so that rounding cannot make them wrong [m].
constexpr double kSeparationMargin = 1e-6;

bool insideConvex(const Polygon& corners, Vec2 p) {
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        if (cross(corners[i] - corners[j], p - corners[j]) < 0.0) return false;
    }
    return true;
}

// True where an edge line of `a` has all of `b` on its outer side (separating axis test).
bool edgeSeparates(const Polygon& a, const Polygon& b) {
    for (std::size_t i = 0, j = a.size() - 1; i < a.size(); j = i++) {
        const auto beyond = [&](Vec2 p) { return cross(a[i] - a[j], p - a[j]) < 0.0; };
        if (std::all_of(b.begin(), b.end(), beyond)) return true;
    }
    return false;
}

bool convexOverlap(const Polygon& a, const Polygon& b) {
    return !edgeSeparates(a, b) && !edgeSeparates(b, a);
}

// True where a box is farther than `far` from the bounding box of a segment.
bool boxSeparated(const Box& box, Vec2 a, Vec2 b, double far) {
    return std::max(a.x, b.x) < box.min.x - far || std::min(a.x, b.x) > box.max.x + far ||
           std::max(a.y, b.y) < box.min.y - far || std::min(a.y, b.y) > box.max.y + far;
}

// True where an edge line of a convex polygon separates it from a segment by more than `far`.
bool edgeSeparated(const Polygon& corners, Vec2 a, Vec2 b, double far) {
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Vec2 side = corners[i] - corners[j];
        // Distances times the length of the side, negative on its outer side.
        const double nearer = std::max(cross(side, a - corners[j]), cross(side, b - corners[j]));
        if (nearer < 0.0 && nearer * nearer > far * far * lengthSquared(side)) return true;
    }
    return false;
}

}  // namespace

Box Environment::Impl::centreBox(double radius) const {
    Box inner = def.sides().grown(-radius);
    if (inner.min.x > inner.max.x) inner.min.x = inner.max.x = 0.5 * (def.box.min.x + def.box.max.x);
    if (inner.min.y > inner.max.y) inner.min.y = inner.max.y = 0.5 * (def.box.min.y + def.box.max.y);
    return inner;
}

// The distance to the nearest surface is Lipschitz continuous with constant 1.
double Environment::Impl::distanceLowerBound(Vec2 p) const {
    const Cell c = grid.cellOf(p);
    if (!grid.contains(c)) return -std::numeric_limits<double>::infinity();
    return clearance.combined()[grid.index(c)] - distance(p, grid.centre(c)) - kFloatError;
}

double Environment::Impl::stillDistanceLowerBound(Vec2 p) const {
    const Cell c = grid.cellOf(p);
    if (!grid.contains(c)) return -std::numeric_limits<double>::infinity();
    return clearance.fixed()[grid.index(c)] - distance(p, grid.centre(c)) - kFloatError;
}

double Environment::Impl::exactDistance(Vec2 p, double limit) const {
    double nearest = limit;
    double radius = std::max(limit, 0.0);
    forNear(p, radius, [&](std::int32_t number) {
        nearest = std::min(nearest, pieces[number].signedDistance(p));
        radius = std::max(std::min(nearest, limit), 0.0);
    });
    return nearest;
}

bool Environment::Impl::blockedLine(Vec2 a, Vec2 b, double radius, bool fixedOnly) const {
    const double least = std::max(radius - kContactTolerance, 1e-3 * kContactTolerance);
    const auto meets = [&](std::int32_t number) {
        const ObstaclePiece& piece = pieces[number];
        if (fixedOnly && piece.moving) return false;
        if (boxSeparated(index.bounds[number], a, b, least + kSeparationMargin)) return false;
        const double far = least + piece.radius;
        if (lengthSquared(closestOnSegment(a, b, piece.centre) - piece.centre) > far * far) return false;
        return !edgeSeparated(piece.corners, a, b, least + kSeparationMargin) &&
               piece.segmentDistance(a, b) < least;
    };
    if (radius > 0.5 * kReach || !inBox(a) || !inBox(b)) {
        for (std::size_t number = 0; number < pieces.size(); ++number) {
            if (meets(static_cast<std::int32_t>(number))) return true;
        }
        return false;
    }
    // Sphere tracing (Hart 1996) along the line: the step is the lower bound of the distance where that is
    // long; else it is a step for which the cell at hand lists every piece that the line may touch.
    const double whole = distance(a, b);
    for (double at = 0.0;;) {
        const Vec2 p = at > 0.0 ? lerp(a, b, at / whole) : a;
        const double clear = distanceLowerBound(p) - radius;
        if (clear > 0.5 * grid.cell) {
            at += clear;
        } else {
            bool hit = false;
            index.forPiecesAt(p, [&](std::int32_t number) { hit = hit || meets(number); });
            if (hit) return true;
            at += kReach - radius;
        }
        if (at >= whole) return false;
    }
}

GroundSample Environment::ground(Vec2 p) const {
    impl_->ensure();
    const Impl& s = *impl_;
    std::int32_t slowest = -1;
    const auto look = [&](std::int32_t number) {
        const PatchPiece& piece = s.patchPieces[number];
        if (slowest >= 0 && s.patches[piece.patch].speed >= s.patches[slowest].speed) return;
        if (insideConvex(piece.corners, p)) slowest = piece.patch;
    };
    if (s.patchPieces.empty()) return {};
    if (s.inBox(p)) {
        // A point in a patch lies in a cell that the patch covers in part.
        if (s.patchSpeed.combinedView()[s.grid.index(s.grid.nearestCell(p))] == Impl::kNoPatch) return {};
        s.patchIndex.forPiecesAt(p, look);
    } else {
        for (std::size_t i = 0; i < s.patchPieces.size(); ++i) look(static_cast<std::int32_t>(i));
    }
    if (slowest < 0) return {};
    const PatchEntry& entry = s.patches[slowest];
    return {s.patchIds[slowest],
            entry.def.motion,
            entry.speed,
            entry.placement.rotation.apply(entry.ascent),
            entry.up,
            entry.down};
}

double GroundSample::speedAlong(Vec2 way) const {
    if (up == down) return up;
    const double along = std::clamp(dot(way, ascent), -1.0, 1.0);
    return 2.0 / ((1.0 + along) / up + (1.0 - along) / down);
}

double Environment::travelLength(Vec2 a, Vec2 b) const {
    const double length = distance(a, b);
    if (patchIds().empty()) return length;
    const auto samples = static_cast<std::int32_t>(2.0 * length / impl_->grid.cell) + 1;
    double slowness = 0.0;
    for (std::int32_t k = 0; k < samples; ++k)
        slowness += 1.0 / ground(lerp(a, b, (k + 0.5) / samples)).travelSpeed;
    return length * slowness / samples;
}

bool Environment::onePatch(PatchId a, PatchId b) const {
    impl_->ensure();
    const Impl& s = *impl_;
    const PatchDef* one = patch(a);
    const PatchDef* other = patch(b);
    if (one == nullptr || other == nullptr || one->motion != other->motion) return false;
    if (a == b) return true;
    for (const PatchPiece& p : s.patchPieces) {
        if (s.patchIds[p.patch] != a) continue;
        for (const PatchPiece& q : s.patchPieces)
            if (s.patchIds[q.patch] == b && convexOverlap(p.corners, q.corners)) return true;
    }
    return false;
}

double Environment::distanceToObstacle(Vec2 p, double limit) const {
    impl_->ensure();
    return impl_->distanceTo(p, limit);
}

void Environment::markNearObstacles(std::span<const Vec2> points, double reach,
                                    std::span<std::uint8_t> near) const {
    impl_->ensure();
    const Impl& s = *impl_;
    const Grid grid = s.grid;
    const Box inner = s.def.sides().grown(-reach);
    const std::span<const float> clearance = s.clearance.combined();
    // No point of a cell is farther from its centre than half a diagonal, so most need no exact distance.
    const double sufficient = reach + 0.7072 * grid.cell + 2.0 * Impl::kFloatError;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 p = points[i];
        if (!inner.contains(p))
            near[i] = 1;
        else if (clearance[grid.index(grid.nearestCell(p))] >= sufficient)
            near[i] = 0;
        else
            near[i] = s.distanceTo(p, reach) < reach ? 1 : 0;
    }
}

void Environment::forPiecesNear(Vec2 p, double radius, FunctionRef<void(const ObstaclePiece&)> visit) const {
    impl_->ensure();
    impl_->forNear(p, radius, [&](std::int32_t number) { visit(impl_->pieces[number]); });
}

bool Environment::clearLine(Vec2 a, Vec2 b, double radius) const {
    impl_->ensure();
    if (!isFinite(a) || !isFinite(b)) return false;
    const Box inner = impl_->def.sides().grown(Impl::kContactTolerance - radius);
    if (!inner.contains(a) || !inner.contains(b)) return false;
    return !impl_->blockedLine(a, b, radius, false);
}

bool Environment::clearStaticLine(Vec2 a, Vec2 b, double radius) const {
    impl_->ensure();
    if (!isFinite(a) || !isFinite(b)) return false;
    const Box inner = impl_->def.sides().grown(Impl::kContactTolerance - radius);
    if (!inner.contains(a) || !inner.contains(b)) return false;
    return !impl_->blockedLine(a, b, radius, true);
}

Vec2 Environment::potentialField(Vec2 p) const {
    impl_->ensure();
    const Impl& s = *impl_;
    if (s.pieces.empty()) return {};
    Vec2 sum;
    const auto add = [&](std::int32_t number) {
        const ObstaclePiece& piece = s.pieces[number];
        if (squaredDistance(s.index.bounds[number], p) >= piece.range * piece.range) return;
        const double d = std::max(piece.signedDistance(p), 0.0);
        if (d >= piece.range) return;
        sum += normalized(p - piece.centre, {1.0, 0.0}) * (piece.strength * (1.0 - d / piece.range));
    };
    if (s.inBox(p)) {
        s.index.forPiecesAt(p, add);
    } else {
        for (std::size_t i = 0; i < s.pieces.size(); ++i) add(static_cast<std::int32_t>(i));
    }
    return sum;
}

std::optional<Cell> Environment::Impl::nearestFreeCell(Vec2 p, double radius) const {
    const std::span<const float> values = clearance.combined();
    return nearestCellWhere(grid, p, [&](std::int32_t i) { return values[i] >= radius; });
}

}  // namespace muster
