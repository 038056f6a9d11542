// Queries of Environment about points, lines and paths.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/grid_search.h"
#include "environment/a_star.h"
#include "environment/environment_impl.h"

namespace muster {
namespace {

// Separation tests must pass by this margin, so that rounding cannot make them wrong [m].
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
    Box inner = def.box.grown(-radius);
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

double Environment::Impl::exactDistance(Vec2 p, double limit) const {
    double nearest = limit;
    double radius = std::max(limit, 0.0);
    forNear(p, radius, [&](std::int32_t number) {
        nearest = std::min(nearest, pieces[number].signedDistance(p));
        radius = std::max(std::min(nearest, limit), 0.0);
    });
    return nearest;
}

bool Environment::Impl::blockedLine(Vec2 a, Vec2 b, double radius) const {
    const double least = std::max(radius - kContactTolerance, 1e-3 * kContactTolerance);
    const auto meets = [&](std::int32_t number) {
        const ObstaclePiece& piece = pieces[number];
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
        if (s.patchSpeed.combined()[s.grid.index(s.grid.nearestCell(p))] == Impl::kNoPatch) return {};
        s.patchIndex.forPiecesAt(p, look);
    } else {
        for (std::size_t i = 0; i < s.patchPieces.size(); ++i) look(static_cast<std::int32_t>(i));
    }
    if (slowest < 0) return {};
    return {s.patchIds[slowest], s.patches[slowest].def.motion, s.patches[slowest].speed};
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
    const Box inner = s.def.box.grown(-reach);
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

void Environment::forPiecesNear(Vec2 p, double radius,
                                const std::function<void(const ObstaclePiece&)>& visit) const {
    impl_->ensure();
    impl_->forNear(p, radius, [&](std::int32_t number) { visit(impl_->pieces[number]); });
}

bool Environment::clearLine(Vec2 a, Vec2 b, double radius) const {
    impl_->ensure();
    if (!isFinite(a) || !isFinite(b)) return false;
    const Box inner = impl_->def.box.grown(Impl::kContactTolerance - radius);
    if (!inner.contains(a) || !inner.contains(b)) return false;
    return !impl_->blockedLine(a, b, radius);
}

Vec2 Environment::potentialField(Vec2 p) const {
    impl_->ensure();
    const Impl& s = *impl_;
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

std::int32_t Environment::region(Vec2 p, double radius) const {
    impl_->ensure();
    Impl& s = *impl_;
    const Cell c = s.grid.cellOf(p);
    if (!s.grid.contains(c)) return -1;
    const std::int32_t i = s.grid.index(c);
    const RegionLabels& regions = s.components.labels(s.grid, s.clearance.fixed(), radius);
    // The clearance is mostly in the processor's cache already, the label is not.
    if (regions.count == 1) return s.clearance.fixed()[i] >= radius ? 0 : -1;
    return regions.label[i];
}

std::int32_t Environment::regionCount(double radius) const {
    impl_->ensure();
    Impl& s = *impl_;
    return s.components.labels(s.grid, s.clearance.fixed(), radius).count;
}

Vec2 Environment::nearestInRegion(Vec2 p, double radius, std::int32_t label) const {
    impl_->ensure();
    Impl& s = *impl_;
    const std::span<const std::int32_t> labels = s.components.labels(s.grid, s.clearance.fixed(), radius)
                                                     .label;
    const auto fits = [&](std::int32_t i) { return label < 0 ? labels[i] >= 0 : labels[i] == label; };
    const Cell c = s.grid.cellOf(p);
    if (s.grid.contains(c) && fits(s.grid.index(c))) return p;
    const std::optional<Cell> found = nearestCellWhere(s.grid, p, fits);
    return found ? s.grid.centre(*found) : p;
}

std::optional<Cell> Environment::Impl::nearestFreeCell(Vec2 p, double radius) const {
    const std::span<const float> values = clearance.combined();
    return nearestCellWhere(grid, p, [&](std::int32_t i) { return values[i] >= radius; });
}

std::vector<Vec2> Environment::findPath(Vec2 a, Vec2 b, double radius, std::int32_t maxCells) const {
    std::vector<Vec2> path;
    findPath(a, b, radius, path, maxCells);
    return path;
}

void Environment::findPath(Vec2 a, Vec2 b, double radius, std::vector<Vec2>& path,
                           std::int32_t maxCells) const {
    impl_->ensure();
    const Impl& s = *impl_;
    path.clear();
    if (!isFinite(a) || !isFinite(b)) return;
    if (clearLine(a, b, radius)) {
        path.assign({a, b});
        return;
    }
    const std::optional<Cell> start = s.nearestFreeCell(a, radius);
    const std::optional<Cell> goal = s.nearestFreeCell(b, radius);
    if (!start || !goal) return;
    // One search per thread, because queries may come from several threads at once.
    static thread_local AStar search;
    static thread_local std::vector<Vec2> full;
    const std::span<const std::int32_t> cells = search.run(
        s.grid, s.clearance.combined(), radius, s.grid.index(*start), s.grid.index(*goal), maxCells);
    if (cells.empty()) return;
    full.assign(1, a);
    for (std::int32_t cell : cells) full.push_back(s.grid.centre(s.grid.at(cell)));
    if (s.centreBox(radius).contains(b) && s.distanceTo(b, radius) >= radius - Impl::kContactTolerance)
        full.push_back(b);
    // Greedy path smoothing: each corner is joined to the last of the following points up to which the line
    // is clear.
    path.push_back(a);
    for (std::size_t at = 0; at + 1 < full.size();) {
        std::size_t next = at + 1;
        while (next + 1 < full.size() && clearLine(full[at], full[next + 1], radius)) ++next;
        path.push_back(full[next]);
        at = next;
    }
}

}  // namespace muster
