#include "lab/reproduce/experiments/mouth.h"

#include <cmath>

#include "base/maths.h"

namespace muster {

Mouth::Mouth(const TriangleMesh& rest) {
    constexpr double kAxisTolerance = 1e-6;  // Distance to the axis below which a vertex lies on it [m].
    double hingeAt = -1e300, upperAt = -1e300, lowerAt = -1e300;
    for (std::size_t v = 0; v < rest.vertices.size(); ++v) {
        const Vec2 p = rest.vertices[v];
        double& best = p.y > kAxisTolerance ? upperAt : p.y < -kAxisTolerance ? lowerAt : hingeAt;
        if (p.x <= best) continue;
        best = p.x;
        (p.y > kAxisTolerance ? upper : p.y < -kAxisTolerance ? lower : hinge) = static_cast<std::int32_t>(v);
    }
}

double Mouth::angle(std::span<const Vec2> vertices) const {
    const Vec2 at = vertices[hinge];
    const Vec2 u = vertices[upper] - at;
    const Vec2 l = vertices[lower] - at;
    const double angle = std::atan2(cross(l, u), dot(l, u));
    return angle < 0.0 ? angle + 2.0 * kPi : angle;
}

void OpeningCounter::observe(double angle) {
    if (angle < shut_) wasShut_ = true;
    if (angle <= open_ || !wasShut_) return;
    wasShut_ = false;
    ++openings_;
}

}  // namespace muster
