// Projection of a disc onto the free space: each near convex piece allows a half plane, and the nearest point
// of their intersection is taken, as velocities are in ORCA (van den Berg et al. 2011).
#include <array>
#include <cmath>
#include <limits>

#include "base/grid_search.h"
#include "engine/ground/environment/environment_impl.h"
#include "engine/ground/environment/obstacle_piece.h"

namespace muster {
namespace {

constexpr double kTolerance = 1e-9;  // Tolerance of distances to constraints [m].
constexpr int kMostRounds = 12;      // Greatest number of rounds of projection; two usually suffice.
constexpr std::size_t kMostHalfPlanes = 12;

// The allowed half plane of the disc's centre for one near piece: dot(normal, x) >= offset. As pieces are
// convex, the line through the nearest surface point keeps the disc off the whole piece.
struct HalfPlane {
    Vec2 normal;
    double offset;
    double signedDistance(Vec2 p) const { return dot(normal, p) - offset; }
};

class HalfPlanes {
public:
    void add(const HalfPlane& plane) {
        if (count_ < kMostHalfPlanes) planes_[count_++] = plane;
    }
    bool contain(Vec2 p) const {
        for (std::size_t i = 0; i < count_; ++i) {
            if (planes_[i].signedDistance(p) < -kTolerance) return false;
        }
        return true;
    }
    // The nearest point to `p` in all half planes: on one boundary, or where two meet. False where there is
    // none.
    bool project(Vec2 p, Vec2& best) const {
        if (projectOnMostViolated(p, best)) return true;
        double bestSquared = std::numeric_limits<double>::infinity();
        const auto offer = [&](Vec2 x) {
            const double squared = lengthSquared(x - p);
            if (squared >= bestSquared || !contain(x)) return;
            bestSquared = squared;
            best = x;
        };
        for (std::size_t i = 0; i < count_; ++i) {
            offer(p - planes_[i].normal * planes_[i].signedDistance(p));
            for (std::size_t j = 0; j < i; ++j) {
                const double sine = cross(planes_[i].normal, planes_[j].normal);
                if (std::fabs(sine) < 1e-6) continue;
                const double a = planes_[i].offset / sine, b = planes_[j].offset / sine;
                offer({a * planes_[j].normal.y - b * planes_[i].normal.y,
                       b * planes_[i].normal.x - a * planes_[j].normal.x});
            }
        }
        return bestSquared < std::numeric_limits<double>::infinity();
    }

private:
    // No allowed point is nearer than the boundary of the most violated half plane.
    bool projectOnMostViolated(Vec2 p, Vec2& best) const {
        std::size_t worst = 0;
        for (std::size_t i = 1; i < count_; ++i)
            if (planes_[i].signedDistance(p) < planes_[worst].signedDistance(p)) worst = i;
        if (count_ == 0 || planes_[worst].signedDistance(p) >= 0.0) return false;
        const Vec2 x = p - planes_[worst].normal * planes_[worst].signedDistance(p);
        if (!contain(x)) return false;
        best = x;
        return true;
    }

    std::array<HalfPlane, kMostHalfPlanes> planes_;
    std::size_t count_ = 0;
};

HalfPlane halfPlaneOf(const ObstaclePiece& piece, const SurfacePoint& nearest, Vec2 p, double radius) {
    const Vec2 away = nearest.distance < 0.0 ? nearest.point - p : p - nearest.point;
    const Vec2 normal = normalized(away, normalized(nearest.point - piece.centre, {1.0, 0.0}));
    return {normal, dot(normal, nearest.point) + radius};
}

// The sides of the box for the disc's centre.
void addSides(HalfPlanes& allowed, const Box& inner) {
    allowed.add({{1.0, 0.0}, inner.min.x});
    allowed.add({{-1.0, 0.0}, -inner.max.x});
    allowed.add({{0.0, 1.0}, inner.min.y});
    allowed.add({{0.0, -1.0}, -inner.max.y});
}

}  // namespace

// The nearest free point straight out of one of the near surfaces: for discs deep inside obstacles whose
// convex parts hide each other's surfaces.
bool Environment::Impl::projectThroughSurface(Vec2 p, double radius, Vec2& best) const {
    const Box inner = centreBox(radius);
    double bestDistance = kReach;
    bool found = false;
    const auto offer = [&](Vec2 x) {
        const double d = distance(x, p);
        if (d >= bestDistance || !inner.contains(x) || distanceTo(x, radius) < radius - kContactTolerance)
            return;
        bestDistance = d;
        best = x;
        found = true;
    };
    forNear(p, kReach, [&](std::int32_t number) {
        const ObstaclePiece& piece = pieces[number];
        if (piece.corners.empty()) {
            offer(piece.centre +
                  normalized(p - piece.centre, {1.0, 0.0}) * (piece.radius + radius + kTolerance));
        }
        for (std::size_t i = 0, j = piece.corners.size() - 1; i < piece.corners.size(); j = i++) {
            const Vec2 a = piece.corners[j], b = piece.corners[i];
            offer(closestOnSegment(a, b, p) - normalized(perpendicular(b - a)) * (radius + kTolerance));
        }
    });
    return found;
}

Vec2 Environment::projectToFreeSpace(Vec2 p, double radius) const {
    impl_->ensure();
    const Impl& s = *impl_;
    const Box inner = s.centreBox(radius);
    if (!isFinite(p)) p = 0.5 * (inner.min + inner.max);
    p = inner.clamp(p);
    if (s.distanceLowerBound(p) >= radius) return p;
    const Vec2 start = p;
    for (int round = 0; round < kMostRounds; ++round) {
        HalfPlanes allowed;
        addSides(allowed, inner);
        bool free = true;
        s.forNear(p, radius, [&](std::int32_t number) {
            const ObstaclePiece& piece = s.pieces[number];
            const SurfacePoint nearest = closestSurfacePoint(piece, p);
            if (nearest.distance >= radius) return;
            free = free && nearest.distance >= radius - 2.0 * kTolerance;
            allowed.add(halfPlaneOf(piece, nearest, p, radius));
        });
        if (free) return p;
        Vec2 next;
        if (!allowed.project(p, next)) break;
        p = inner.clamp(next);
    }
    Vec2 out;
    if (s.projectThroughSurface(start, radius, out)) return out;
    const std::optional<Cell> cell = s.nearestFreeCell(start, radius);
    return cell ? inner.clamp(s.grid.centre(*cell)) : start;
}

}  // namespace muster
