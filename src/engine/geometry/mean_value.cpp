#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>

#include "muster/assert.h"

namespace muster {
namespace {

constexpr double kOnBoundary = 1e-14;  // Distance from an edge relative to its length.

// Writes the weights of linear interpolation where p lies on a corner or an edge; false elsewhere.
bool writeBoundaryWeights(std::span<const Vec2> polygon, Vec2 p, std::span<double> weights) {
    const std::size_t count = polygon.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t j = (i + 1) % count;
        const Vec2 a = polygon[i] - p, b = polygon[j] - p;
        const Vec2 along = b - a;
        const double squared = lengthSquared(along);
        const double share = squared > 0.0 ? std::clamp(-dot(a, along) / squared, 0.0, 1.0) : 0.0;
        if (lengthSquared(a + along * share) > kOnBoundary * kOnBoundary * squared) continue;
        std::fill(weights.begin(), weights.end(), 0.0);
        weights[i] = 1.0 - share;
        weights[j] += share;
        return true;
    }
    return false;
}

// Tangent of half the angle from `a` to `b`, by the form without cancellation.
double halfTangent(Vec2 a, double lengthA, Vec2 b, double lengthB) {
    const double product = lengthA * lengthB;
    const double cosine = dot(a, b);
    const double sine = cross(a, b);
    if (cosine >= 0.0) return sine / (product + cosine);
    return sine == 0.0 ? 0.0 : (product - cosine) / sine;
}

}  // namespace

void meanValueCoordinates(std::span<const Vec2> polygon, Vec2 p, std::span<double> weights) {
    const std::size_t count = polygon.size();
    MUSTER_ASSERT(count >= 3 && weights.size() == count);
    if (writeBoundaryWeights(polygon, p, weights)) return;
    Vec2 here = polygon[count - 1] - p;
    double hereLength = length(here);
    Vec2 next = polygon[0] - p;
    double nextLength = length(next);
    double behind = halfTangent(here, hereLength, next, nextLength);
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        here = next;
        hereLength = nextLength;
        next = polygon[(i + 1) % count] - p;
        nextLength = length(next);
        const double ahead = halfTangent(here, hereLength, next, nextLength);
        weights[i] = (behind + ahead) / hereLength;
        sum += weights[i];
        behind = ahead;
    }
    for (double& weight : weights) weight /= sum;
}

}  // namespace muster
