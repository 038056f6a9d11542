// Moves a disc out of obstacles.
#include <array>
#include <cmath>
#include <limits>

#include "base/grid_search.h"
#include "environment/environment_state.h"
#include "environment/obstacle_piece.h"

namespace muster {
namespace {

constexpr double kExact = 1e-9;  // [m] Contacts are solved to this.
constexpr int kMostRounds = 12;  // Of sliding; two usually do.
constexpr std::size_t kMostWalls = 12;

// Where the disc's centre may be, seen from one near piece: dot(normal, x) >= offset. As pieces are
// convex, the line through the nearest surface point keeps the disc off the whole piece.
struct Wall {
    Vec2 normal;
    double offset;
    double gap(Vec2 p) const { return dot(normal, p) - offset; }
};

class Walls {
public:
    void add(const Wall& wall) {
        if (count_ < kMostWalls) walls_[count_++] = wall;
    }
    bool allow(Vec2 p) const {
        for (std::size_t i = 0; i < count_; ++i) {
            if (walls_[i].gap(p) < -kExact) return false;
        }
        return true;
    }
    // The point nearest to p that all walls allow: on one wall or where two meet. False where none does.
    bool solve(Vec2 p, Vec2& best) const {
        if (solveDeepest(p, best)) return true;
        double bestSquared = std::numeric_limits<double>::infinity();
        const auto offer = [&](Vec2 x) {
            const double squared = lengthSquared(x - p);
            if (squared >= bestSquared || !allow(x)) return;
            bestSquared = squared;
            best = x;
        };
        for (std::size_t i = 0; i < count_; ++i) {
            offer(p - walls_[i].normal * walls_[i].gap(p));
            for (std::size_t j = 0; j < i; ++j) {
                const double turn = cross(walls_[i].normal, walls_[j].normal);
                if (std::fabs(turn) < 1e-6) continue;
                const double a = walls_[i].offset / turn, b = walls_[j].offset / turn;
                offer({a * walls_[j].normal.y - b * walls_[i].normal.y,
                       b * walls_[i].normal.x - a * walls_[j].normal.x});
            }
        }
        return bestSquared < std::numeric_limits<double>::infinity();
    }

private:
    // Nothing is nearer than the wall broken most, where all others allow the point on it.
    bool solveDeepest(Vec2 p, Vec2& best) const {
        std::size_t deepest = 0;
        for (std::size_t i = 1; i < count_; ++i)
            if (walls_[i].gap(p) < walls_[deepest].gap(p)) deepest = i;
        if (count_ == 0 || walls_[deepest].gap(p) >= 0.0) return false;
        const Vec2 x = p - walls_[deepest].normal * walls_[deepest].gap(p);
        if (!allow(x)) return false;
        best = x;
        return true;
    }

    std::array<Wall, kMostWalls> walls_;
    std::size_t count_ = 0;
};

Wall wallOf(const ObstaclePiece& piece, const SurfacePoint& nearest, Vec2 p, double radius) {
    const Vec2 away = nearest.distance < 0.0 ? nearest.point - p : p - nearest.point;
    const Vec2 normal = normalized(away, normalized(nearest.point - piece.centre, {1.0, 0.0}));
    return {normal, dot(normal, nearest.point) + radius};
}

// Sides of the box as walls.
void addSides(Walls& walls, const Box& room) {
    walls.add({{1.0, 0.0}, room.min.x});
    walls.add({{-1.0, 0.0}, -room.max.x});
    walls.add({{0.0, 1.0}, room.min.y});
    walls.add({{0.0, -1.0}, -room.max.y});
}

}  // namespace

// The nearest free spot straight out of one of the surfaces around: for discs deep inside obstacles
// whose parts hide each other's surfaces.
bool Environment::Impl::jumpOut(Vec2 p, double radius, Vec2& best) const {
    const Box room = roomFor(radius);
    double bestDistance = kReach;
    bool found = false;
    const auto offer = [&](Vec2 x) {
        const double d = distance(x, p);
        if (d >= bestDistance || !room.contains(x) || distanceTo(x, radius) < radius - kTouch) return;
        bestDistance = d;
        best = x;
        found = true;
    };
    forNear(p, kReach, [&](std::int32_t number) {
        const ObstaclePiece& piece = pieces[number];
        if (piece.corners.empty()) {
            offer(piece.centre + normalized(p - piece.centre, {1.0, 0.0}) * (piece.radius + radius + kExact));
        }
        for (std::size_t i = 0, j = piece.corners.size() - 1; i < piece.corners.size(); j = i++) {
            const Vec2 a = piece.corners[j], b = piece.corners[i];
            offer(closestOnSegment(a, b, p) - normalized(perpendicular(b - a)) * (radius + kExact));
        }
    });
    return found;
}

Vec2 Environment::pushOut(Vec2 p, double radius) const {
    impl_->ensure();
    const Impl& s = *impl_;
    const Box room = s.roomFor(radius);
    if (!isFinite(p)) p = 0.5 * (room.min + room.max);
    p = room.clamp(p);
    if (s.roughDistance(p) >= radius) return p;
    const Vec2 start = p;
    for (int round = 0; round < kMostRounds; ++round) {
        Walls walls;
        addSides(walls, room);
        bool free = true;
        s.forNear(p, radius, [&](std::int32_t number) {
            const ObstaclePiece& piece = s.pieces[number];
            const SurfacePoint nearest = closestSurfacePoint(piece, p);
            if (nearest.distance >= radius) return;
            free = free && nearest.distance >= radius - 2.0 * kExact;
            walls.add(wallOf(piece, nearest, p, radius));
        });
        if (free) return p;
        Vec2 next;
        if (!walls.solve(p, next)) break;
        p = room.clamp(next);
    }
    // A way out that slid far may have passed a nearer one, but any free spot will do.
    Vec2 out;
    if (s.jumpOut(start, radius, out)) return out;
    const std::optional<Cell> cell = s.nearestFreeCell(start, radius);
    return cell ? room.clamp(s.grid.centre(*cell)) : start;
}

}  // namespace muster
