#include "engine/passages/passage.h"

#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"
#include "engine/geometry/polygon.h"

namespace muster {
namespace {

constexpr double kNearlyEqual = 0.98;   // Share of the least capacity that another passage must undercut.
constexpr double kLeastRayStep = 1e-4;  // Least step of a ray [m].
constexpr double kMaxProjections = 64;  // Greatest number of projections between two surfaces.
// Distance from a wall of the narrows at which their depth is measured [m].
constexpr double kWallOffset = 0.2;
constexpr double kDepthStep = 0.125;  // Step of the measured depth [m].
constexpr double kMostDepth = 8.0;    // Greatest depth of narrows [m].
constexpr std::int32_t kMaxRaySteps = 400;

/// The surface of a piece, or a side of the world where there is no piece.
struct Surface {
    const ObstaclePiece* piece = nullptr;
    int side = 0;  // 0 to 3: least x, greatest x, least y, greatest y.
    Vec2 point;    // Point of the surface nearest to where the search began [m].
    double distance = kInfiniteCost;
};

Vec2 onSide(const Box& box, int side, Vec2 p) {
    return side == 0   ? Vec2{box.min.x, p.y}
           : side == 1 ? Vec2{box.max.x, p.y}
           : side == 2 ? Vec2{p.x, box.min.y}
                       : Vec2{p.x, box.max.y};
}

Vec2 nearestOn(const Environment& environment, const Surface& surface, Vec2 p) {
    return surface.piece != nullptr ? closestSurfacePoint(*surface.piece, p).point
                                    : onSide(environment.def().box, surface.side, p);
}

Surface nearestSurface(const Environment& environment, Vec2 p) {
    Surface best;
    environment.forPiecesNear(p, Environment::kClearanceLimit, [&](const ObstaclePiece& piece) {
        if (piece.moving) return;
        const SurfacePoint found = closestSurfacePoint(piece, p);
        if (found.distance < best.distance) best = {&piece, 0, found.point, found.distance};
    });
    for (int side = 0; side < 4; ++side) {
        const Vec2 q = onSide(environment.def().box, side, p);
        if (distance(p, q) < best.distance) best = {nullptr, side, q, distance(p, q)};
    }
    return best;
}

/// Sphere tracing (Hart 1996) from `p`, which lies off all surfaces, to the first surface in a direction.
Surface firstSurface(const Environment& environment, Vec2 p, Vec2 direction, Surface nearest) {
    double along = 0.0;
    for (std::int32_t k = 0; k < kMaxRaySteps; ++k) {
        along += std::max(kLeastRayStep, std::min(nearest.distance, Environment::kClearanceLimit));
        nearest = nearestSurface(environment, p + direction * along);
        if (nearest.distance <= kLeastRayStep || !environment.def().box.contains(p + direction * along))
            break;
    }
    return nearest;
}

bool crosses(std::span<const Vec2> way, Vec2 a, Vec2 b) {
    for (std::size_t k = 1; k < way.size(); ++k) {
        const Vec2 p = way[k - 1], q = way[k];
        const bool apart = (cross(b - a, p - a) > 0.0) != (cross(b - a, q - a) > 0.0);
        if (apart && (cross(q - p, a - p) > 0.0) != (cross(q - p, b - p) > 0.0)) return true;
    }
    return false;
}

/// Alternating projections find the nearest points of two convex surfaces.
void tighten(const Environment& environment, const Surface& one, const Surface& other, Passage& passage) {
    for (int k = 0; k < kMaxProjections; ++k) {
        const Vec2 b = nearestOn(environment, other, passage.a);
        const Vec2 a = nearestOn(environment, one, b);
        const double moved = distance(a, passage.a) + distance(b, passage.b);
        passage.a = a;
        passage.b = b;
        if (moved < 1e-9) return;
    }
}

// The depth of a passage in a direction: the distance before it widens.
double depth(const Environment& environment, const Passage& passage, Vec2 direction) {
    const Vec2 along = (passage.b - passage.a) / passage.width();
    const Vec2 inward = along * std::min(kWallOffset, 0.25 * passage.width());
    double reached = 0.0;
    for (double d = kDepthStep; d < kMostDepth; d += kDepthStep) {
        const Vec2 shift = direction * d;
        const double beside = std::min(environment.distanceToObstacle(passage.a + inward + shift),
                                       environment.distanceToObstacle(passage.b - inward + shift));
        if (beside > 1.5 * length(inward) || !environment.def().box.contains(passage.middle() + shift)) break;
        reached = d;
    }
    return reached;
}

// The gap to the nearest surface on the other side of the path, which a ray may miss where walls are thin.
std::optional<Passage> gapAcross(const Environment& environment, std::span<const Vec2> way, Vec2 p,
                                 const Surface& one) {
    Surface other;
    const auto look = [&](const Surface& found) {
        if (!(found.distance < other.distance) || !(dot(found.point - p, p - one.point) > 0.0)) return;
        if (crosses(way, one.point, found.point)) other = found;
    };
    environment.forPiecesNear(p, Environment::kClearanceLimit, [&](const ObstaclePiece& piece) {
        if (piece.moving || &piece == one.piece) return;
        const SurfacePoint found = closestSurfacePoint(piece, p);
        look({&piece, 0, found.point, found.distance});
    });
    for (int side = 0; side < 4; ++side) {
        if (one.piece == nullptr && side == one.side) continue;
        const Vec2 q = onSide(environment.def().box, side, p);
        look({nullptr, side, q, distance(p, q)});
    }
    if (!(other.distance < Environment::kClearanceLimit)) return {};
    Passage passage{one.point, other.point, 1.0};
    tighten(environment, one, other, passage);
    const bool valid = passage.width() > 1e-6 && environment.distanceToObstacle(passage.middle()) > 0.0 &&
                       crosses(way, passage.a, passage.b);
    if (!valid) return {};
    return passage;
}

std::optional<Passage> gapAt(const Environment& environment, std::span<const Vec2> way, Vec2 p, bool thin) {
    // The cells of a path may reach beyond the edge of the world.
    if (!environment.def().box.contains(p)) return {};
    const Surface one = nearestSurface(environment, p);
    if (!(one.distance < Environment::kClearanceLimit) || one.distance <= kLeastRayStep) return {};
    const Vec2 direction = (p - one.point) / one.distance;
    const Surface other = firstSurface(environment, p, direction, one);
    Passage passage{one.point, other.point, 1.0};
    Passage tight = passage;
    tighten(environment, one, other, tight);
    const bool valid = tight.width() > 1e-6 && environment.distanceToObstacle(tight.middle()) > 0.0 &&
                       crosses(way, tight.a, tight.b);
    if (valid) passage = tight;
    const std::optional<Passage> across = thin ? gapAcross(environment, way, p, one) : std::nullopt;
    if (across && across->width() < kNearlyEqual * passage.width()) passage = *across;
    passage.speed = std::min(environment.ground(p).travelSpeed,
                             environment.ground(passage.middle()).travelSpeed);
    return passage;
}

// The gap beside `p` where it lies in an obstacle: a path on wide cells may cut the corner of one.
std::optional<Passage> gapBeside(const Environment& environment, std::span<const Vec2> way, Vec2 p,
                                 bool thin) {
    if (!(environment.distanceToObstacle(p) < -kLeastRayStep)) return {};
    const Vec2 out = nearestSurface(environment, p).point - p;
    return gapAt(environment, way, p + out + normalized(out) * kWallOffset, thin);
}

}  // namespace

std::optional<Passage> narrowestPassage(const Environment& environment, std::span<const Vec2> way,
                                        bool thin) {
    std::optional<Passage> best;
    for (std::size_t k = 0; k < way.size(); ++k) {
        // Only the near part of the path counts: another part of it may cross the same gap.
        const std::size_t from = k > 8 ? k - 8 : 0, to = std::min(way.size(), k + 9);
        const std::optional<Passage> gap = gapAt(environment, way.subspan(from, to - from), way[k], thin);
        if (gap && (!best || gap->throughput() < kNearlyEqual * best->throughput())) best = gap;
        const std::optional<Passage> cut = k + 1 < way.size()
                                               ? gapBeside(environment, way.subspan(from, to - from),
                                                           lerp(way[k], way[k + 1], 0.5), thin)
                                               : std::nullopt;
        if (cut && (!best || cut->throughput() < kNearlyEqual * best->throughput())) best = cut;
    }
    if (best) {
        const Vec2 left = perpendicular(normalized(best->b - best->a));
        best->left = depth(environment, *best, left);
        best->right = depth(environment, *best, -left);
    }
    return best;
}

}  // namespace muster
