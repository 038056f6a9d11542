#include "engine/ground/routes/route_ground.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// Length by which tested radii are smaller, because paths touch walls [m],
constexpr double kRadiusSlack = 1e-3;
constexpr double kRadiusShare = 0.01;       // and the same as a share of the radius.
constexpr double kRoundingError = 1e-5;     // Rounding error of clearances, which are kept as floats [m].
constexpr double kContactTolerance = 1e-7;  // Tolerance of the distance of a point to obstacles [m].
constexpr int kPushes = 12;                 // Number of pushes of a blocked centre out of obstacles.
// Room of the centre of a cell beyond the radius from which on a disc stands there [cells].
constexpr double kRoomCells = 0.25;
constexpr double kRoomShare = 0.25;  // That room as a share of the radius; the smaller counts.
// Greatest distance of a stand point from the centre of its cell, along each axis [cells].
constexpr double kCellReach = 0.65;

// True where two segments meet. Most are far from each other: boxes first. Collinear segments meet where
// their boxes do.
bool segmentsMeet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
        std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
        return false;
    const double c1 = cross(b - a, c - a), c2 = cross(b - a, d - a);
    const double c3 = cross(d - c, a - c), c4 = cross(d - c, b - c);
    return !((c1 > 0.0 && c2 > 0.0) || (c1 < 0.0 && c2 < 0.0) || (c3 > 0.0 && c4 > 0.0) ||
             (c3 < 0.0 && c4 < 0.0));
}

}  // namespace

RouteGround::RouteGround(const Environment& environment, double radius, std::span<const ClosedLine> closed,
                         bool moving)
    : environment_(&environment),
      grid_(environment.grid()),
      radius_(radius - std::fmin(kRadiusSlack, kRadiusShare * radius)),
      halfDiagonal_(kCellReach * std::sqrt(2.0) * grid_.cell + kRoundingError),
      freeClearance_(radius_ + std::fmin(kRoomCells * grid_.cell, kRoomShare * radius_)),
      straightSum_(2.0 * (radius_ + kRoundingError) + grid_.cell),
      diagonalSum_(2.0 * (radius_ + kRoundingError) + std::sqrt(2.0) * grid_.cell),
      closed_(closed),
      moving_(moving),
      clearance_(moving ? environment.clearance() : environment.staticClearance()) {}

bool RouteGround::isOpen(const CellRect& cells) const {
    const auto least = static_cast<float>(radius_ + halfDiagonal_ + kRoundingError);
    for (std::int32_t y = cells.low.y; y <= cells.high.y; ++y) {
        const std::span<const float> row = clearance_.subspan(grid_.index({cells.low.x, y}),
                                                              cells.high.x - cells.low.x + 1);
        float lowest = row[0];
        for (const float value : row) lowest = value < lowest ? value : lowest;
        if (lowest < least) return false;
    }
    return closed_.empty();
}

// Moves a point away from all surfaces nearer than `wanted`, by `share` of the missing distance. Returns the
// clearance that it had.
double RouteGround::pushOut(Vec2& p, const Box& inner, double wanted, double share) const {
    p = inner.clamp(p);
    double nearest = wanted;
    Vec2 sum;
    const auto look = [&](const ObstaclePiece& piece) {
        if (piece.moving && !moving_) return;
        const SurfacePoint surface = closestSurfacePoint(piece, p);
        if (surface.distance >= wanted - kContactTolerance) return;
        nearest = std::min(nearest, surface.distance);
        const Vec2 out = surface.distance < 0.0 ? surface.point - p : p - surface.point;
        sum += normalized(out, {1.0, 0.0}) * (wanted - surface.distance);
    };
    environment_->forPiecesNear(p, wanted, look);
    p += share * sum;
    return nearest;
}

// The point with most room among those to which obstacles push a start, within `reach` of the middle along
// each axis.
std::optional<Vec2> RouteGround::roomiest(Vec2 start, Vec2 middle, double reach) const {
    const Box inner = environment_->def().box.grown(-radius_);
    if (inner.min.x > inner.max.x || inner.min.y > inner.max.y) return {};
    std::optional<Vec2> best;
    double most = radius_ - kContactTolerance;
    Vec2 p = start;
    for (int push = 0; push < kPushes; ++push) {
        const Vec2 at = inner.clamp(p);
        // Pushed by halves after the first time, so that it ends in the middle of a narrow passage.
        const double clear = pushOut(p, inner, freeClearance_, push == 0 ? 1.0 : 0.5);
        if (clear > most && std::fabs(at.x - middle.x) <= reach && std::fabs(at.y - middle.y) <= reach) {
            most = clear;
            best = at;
        }
        if (clear >= freeClearance_) break;
    }
    return best;
}

std::optional<Vec2> RouteGround::standPoint(Cell c) const {
    const std::int32_t index = grid_.index(c);
    if (isFree(index)) return grid_.centre(c);
    if (!mayHoldPoint(index)) return {};
    return roomiest(c, grid_.centre(c));
}

std::optional<Vec2> RouteGround::roomiest(Cell c, Vec2 start) const {
    return roomiest(start, grid_.centre(c), kCellReach * grid_.cell);
}

std::optional<Vec2> RouteGround::roomiest(Vec2 start) const {
    return roomiest(start, start, grid_.cell);
}

bool RouteGround::lineClear(Vec2 a, Vec2 b) const {
    if (crossesClosed(a, b)) return false;
    return moving_ ? environment_->clearLine(a, b, radius_) : environment_->clearStaticLine(a, b, radius_);
}

std::optional<Vec2> RouteGround::stepPoint(Cell a, Vec2 pointA, Cell b, Vec2 pointB) const {
    const std::int32_t i = grid_.index(a), j = grid_.index(b);
    const Vec2 middle = 0.5 * (pointA + pointB);
    const bool free = isFree(i) && isFree(j);
    if (free && isClearByRaster(i, j, a.x != b.x && a.y != b.y)) {
        if (crossesClosed(pointA, pointB)) return {};
        return middle;
    }
    if (lineClear(pointA, pointB)) return middle;
    if (free) return {};
    const std::optional<Vec2> beside = roomiest(middle);
    if (beside && lineClear(pointA, *beside) && lineClear(*beside, pointB)) return beside;
    return {};
}

bool RouteGround::crossesClosed(Vec2 a, Vec2 b) const {
    return std::any_of(closed_.begin(), closed_.end(),
                       [&](const ClosedLine& line) { return segmentsMeet(a, b, line.a, line.b); });
}

}  // namespace muster
