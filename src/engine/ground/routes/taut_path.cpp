// Shortening of paths: corners are skipped where the line past them is clear, and cut where it is not.
#include <algorithm>

#include "engine/ground/routes/route_ground.h"

namespace muster {
namespace {

constexpr int kPasses = 3;          // Number of passes that cut corners.
constexpr int kBisections = 6;      // Number of bisections of a cut.
constexpr double kLeastCut = 0.05;  // Least distance by which corners are cut [m].

// The last index from `at` on whose point is in sight, found by doubling and bisection.
std::size_t lastInSight(const RouteGround& ground, const std::vector<Vec2>& points, std::size_t at) {
    std::size_t low = at + 1, high = points.size();
    for (std::size_t stride = 2; at + stride < points.size(); stride *= 2) {
        if (!ground.lineClear(points[at], points[at + stride])) {
            high = at + stride;
            break;
        }
        low = at + stride;
    }
    if (high == points.size() && low + 1 < high && ground.lineClear(points[at], points.back()))
        return points.size() - 1;
    while (high - low > 1) {
        const std::size_t middle = low + (high - low) / 2;
        (ground.lineClear(points[at], points[middle]) ? low : high) = middle;
    }
    return low;
}

// Replaces the corner `c` between `a` and `b` by two points on its sides, as far from it as they see each
// other, and appends them; nothing where the corner is not needed.
void cutCorner(const RouteGround& ground, Vec2 a, Vec2 c, Vec2 b, std::vector<Vec2>& out) {
    if (ground.lineClear(a, b)) return;
    const double most = std::min(distance(a, c), distance(c, b));
    const Vec2 back = normalized(a - c), ahead = normalized(b - c);
    double low = 0.0, high = most;
    for (int k = 0; k < kBisections && high - low > kLeastCut; ++k) {
        const double middle = 0.5 * (low + high);
        (ground.lineClear(c + back * middle, c + ahead * middle) ? low : high) = middle;
    }
    if (low < kLeastCut) {
        out.push_back(c);
    } else {
        out.push_back(c + back * low);
        out.push_back(c + ahead * low);
    }
}

}  // namespace

double pathLength(std::span<const Vec2> points) {
    double sum = 0.0;
    for (std::size_t k = 1; k < points.size(); ++k) sum += distance(points[k - 1], points[k]);
    return sum;
}

void skipCorners(const RouteGround& ground, std::vector<Vec2>& points) {
    if (points.size() < 3) return;
    std::size_t kept = 0;
    for (std::size_t at = 0; at + 1 < points.size();) {
        at = lastInSight(ground, points, at);
        points[++kept] = points[at];
    }
    points.resize(kept + 1);
}

void pullTaut(const RouteGround& ground, std::vector<Vec2>& points, std::vector<Vec2>& cut) {
    skipCorners(ground, points);
    for (int pass = 0; pass < kPasses && points.size() > 2; ++pass) {
        cut.assign(1, points.front());
        for (std::size_t k = 1; k + 1 < points.size(); ++k)
            cutCorner(ground, cut.back(), points[k], points[k + 1], cut);
        cut.push_back(points.back());
        skipCorners(ground, cut);
        points.swap(cut);
    }
}

}  // namespace muster
