// What Environment answers about points and lines.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/grid_search.h"
#include "environment/environment_state.h"
#include "environment/path_search.h"

namespace muster {
namespace {

// So much farther than asked is certain whatever the rounding [m].
constexpr double kApart = 1e-6;

bool insideConvex(const Polygon& corners, Vec2 p) {
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        if (cross(corners[i] - corners[j], p - corners[j]) < 0.0) return false;
    }
    return true;
}

// True where an edge of `a` has all of `b` on its outer side.
bool edgeParts(const Polygon& a, const Polygon& b) {
    for (std::size_t i = 0, j = a.size() - 1; i < a.size(); j = i++) {
        const auto beyond = [&](Vec2 p) { return cross(a[i] - a[j], p - a[j]) < 0.0; };
        if (std::all_of(b.begin(), b.end(), beyond)) return true;
    }
    return false;
}

bool convexMeet(const Polygon& a, const Polygon& b) {
    return !edgeParts(a, b) && !edgeParts(b, a);
}

// True where a box keeps clear of the box of a segment by more than `far`.
bool boxApart(const Box& box, Vec2 a, Vec2 b, double far) {
    return std::max(a.x, b.x) < box.min.x - far || std::min(a.x, b.x) > box.max.x + far ||
           std::max(a.y, b.y) < box.min.y - far || std::min(a.y, b.y) > box.max.y + far;
}

// True where one side's line keeps a convex polygon clear of a segment by more than `far`.
bool sideApart(const Polygon& corners, Vec2 a, Vec2 b, double far) {
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Vec2 side = corners[i] - corners[j];
        // Both are distances times the length of the side, negative on its outer side.
        const double nearer = std::max(cross(side, a - corners[j]), cross(side, b - corners[j]));
        if (nearer < 0.0 && nearer * nearer > far * far * lengthSquared(side)) return true;
    }
    return false;
}

}  // namespace

Box Environment::Impl::roomFor(double radius) const {
    Box room = def.box.grown(-radius);
    if (room.min.x > room.max.x) room.min.x = room.max.x = 0.5 * (def.box.min.x + def.box.max.x);
    if (room.min.y > room.max.y) room.min.y = room.max.y = 0.5 * (def.box.min.y + def.box.max.y);
    return room;
}

// Distances change by no more than the way moved.
double Environment::Impl::roughDistance(Vec2 p) const {
    const Cell c = grid.cellOf(p);
    if (!grid.contains(c)) return -std::numeric_limits<double>::infinity();
    return clearance.live()[grid.index(c)] - distance(p, grid.centre(c)) - kFloatSlack;
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
    const double least = std::max(radius - kTouch, 1e-3 * kTouch);
    const auto meets = [&](std::int32_t number) {
        const ObstaclePiece& piece = pieces[number];
        if (boxApart(index.bounds[number], a, b, least + kApart)) return false;
        const double far = least + piece.radius;
        if (lengthSquared(closestOnSegment(a, b, piece.centre) - piece.centre) > far * far) return false;
        return !sideApart(piece.corners, a, b, least + kApart) && piece.segmentDistance(a, b) < least;
    };
    if (radius > 0.5 * kReach || !inBox(a) || !inBox(b)) {
        for (std::size_t number = 0; number < pieces.size(); ++number) {
            if (meets(static_cast<std::int32_t>(number))) return true;
        }
        return false;
    }
    // Walks along the line: by leaps where the raster shows room, else by steps within which every
    // piece in the way is listed in the bin at hand.
    const double whole = distance(a, b);
    for (double at = 0.0;;) {
        const Vec2 p = at > 0.0 ? lerp(a, b, at / whole) : a;
        const double leap = roughDistance(p) - radius;
        if (leap > 0.5 * grid.cell) {
            at += leap;
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
    std::int32_t ruler = -1;
    const auto look = [&](std::int32_t number) {
        const PatchPiece& piece = s.patchPieces[number];
        if (ruler >= 0 && s.patches[piece.patch].speed >= s.patches[ruler].speed) return;
        if (insideConvex(piece.corners, p)) ruler = piece.patch;
    };
    if (s.patchPieces.empty()) return {};
    if (s.inBox(p)) {
        // A patch covers at least a share of the cell of any point in it.
        if (s.slowest.live()[s.grid.index(s.grid.nearestCell(p))] == Impl::kNoPatch) return {};
        s.patchIndex.forPiecesAt(p, look);
    } else {
        for (std::size_t i = 0; i < s.patchPieces.size(); ++i) look(static_cast<std::int32_t>(i));
    }
    if (ruler < 0) return {};
    return {s.patchIds[ruler], s.patches[ruler].def.motion, s.patches[ruler].speed};
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
            if (s.patchIds[q.patch] == b && convexMeet(p.corners, q.corners)) return true;
    }
    return false;
}

double Environment::distanceToObstacle(Vec2 p, double limit) const {
    impl_->ensure();
    return impl_->distanceTo(p, limit);
}

void Environment::markClose(std::span<const Vec2> points, double reach, std::span<std::uint8_t> close) const {
    impl_->ensure();
    const Impl& s = *impl_;
    const Grid grid = s.grid;
    const Box room = s.def.box.grown(-reach);
    const std::span<const float> clearance = s.clearance.live();
    // No point of a cell is farther from its centre than half a diagonal: most need no exact look.
    const double ample = reach + 0.7072 * grid.cell + 2.0 * Impl::kFloatSlack;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 p = points[i];
        if (!room.contains(p))
            close[i] = 1;
        else if (clearance[grid.index(grid.nearestCell(p))] >= ample)
            close[i] = 0;
        else
            close[i] = s.distanceTo(p, reach) < reach ? 1 : 0;
    }
}

void Environment::forPiecesNear(Vec2 p, double radius,
                                const std::function<void(const ObstaclePiece&)>& visit) const {
    impl_->ensure();
    impl_->forNear(p, radius, [&](std::int32_t number) { visit(impl_->pieces[number]); });
}

void Environment::piecesNear(Vec2 p, double radius, std::vector<std::int32_t>& found) const {
    impl_->ensure();
    found.clear();
    impl_->forNear(p, radius, [&](std::int32_t number) { found.push_back(number); });
}

bool Environment::clearLine(Vec2 a, Vec2 b, double radius) const {
    impl_->ensure();
    if (!isFinite(a) || !isFinite(b)) return false;
    const Box room = impl_->def.box.grown(Impl::kTouch - radius);
    if (!room.contains(a) || !room.contains(b)) return false;
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
    const Regions& regions = s.regions.regions(s.grid, s.clearance.still(), radius);
    // The clearance has mostly been looked at just before.
    if (regions.count == 1) return s.clearance.still()[i] >= radius ? 0 : -1;
    return regions.label[i];
}

std::int32_t Environment::regionCount(double radius) const {
    impl_->ensure();
    Impl& s = *impl_;
    return s.regions.regions(s.grid, s.clearance.still(), radius).count;
}

Vec2 Environment::nearestInRegion(Vec2 p, double radius, std::int32_t label) const {
    impl_->ensure();
    Impl& s = *impl_;
    const std::span<const std::int32_t> labels = s.regions.regions(s.grid, s.clearance.still(), radius).label;
    const auto fits = [&](std::int32_t i) { return label < 0 ? labels[i] >= 0 : labels[i] == label; };
    const Cell c = s.grid.cellOf(p);
    if (s.grid.contains(c) && fits(s.grid.index(c))) return p;
    const std::optional<Cell> found = nearestCellWhere(s.grid, p, fits);
    return found ? s.grid.centre(*found) : p;
}

std::optional<Cell> Environment::Impl::nearestFreeCell(Vec2 p, double radius) const {
    const std::span<const float> live = clearance.live();
    return nearestCellWhere(grid, p, [&](std::int32_t i) { return live[i] >= radius; });
}

std::vector<Vec2> Environment::findPath(Vec2 a, Vec2 b, double radius, std::int32_t maxCells) const {
    std::vector<Vec2> way;
    findPath(a, b, radius, way, maxCells);
    return way;
}

void Environment::findPath(Vec2 a, Vec2 b, double radius, std::vector<Vec2>& way,
                           std::int32_t maxCells) const {
    impl_->ensure();
    const Impl& s = *impl_;
    way.clear();
    if (!isFinite(a) || !isFinite(b)) return;
    if (clearLine(a, b, radius)) {
        way.assign({a, b});
        return;
    }
    const std::optional<Cell> start = s.nearestFreeCell(a, radius);
    const std::optional<Cell> goal = s.nearestFreeCell(b, radius);
    if (!start || !goal) return;
    // One per thread: queries may come from several threads at once.
    static thread_local PathSearch search;
    static thread_local std::vector<Vec2> full;
    const std::span<const std::int32_t> cells = search.run(
        s.grid, s.clearance.live(), radius, s.grid.index(*start), s.grid.index(*goal), maxCells);
    if (cells.empty()) return;
    full.assign(1, a);
    for (std::int32_t cell : cells) full.push_back(s.grid.centre(s.grid.at(cell)));
    if (s.roomFor(radius).contains(b) && s.distanceTo(b, radius) >= radius - Impl::kTouch) full.push_back(b);
    // Pulled straight: from each corner on to the last point in a row that it sees.
    way.push_back(a);
    for (std::size_t at = 0; at + 1 < full.size();) {
        std::size_t next = at + 1;
        while (next + 1 < full.size() && clearLine(full[at], full[next + 1], radius)) ++next;
        way.push_back(full[next]);
        at = next;
    }
}

}  // namespace muster
