#include "lab/reproduce/experiments/distortion.h"

#include <cmath>

namespace muster {
namespace {

struct Corners {
    Vec2 a, b, c;

    Corners(const Triangle& t, std::span<const Vec2> vertices)
        : a(vertices[t[0]]), b(vertices[t[1]]), c(vertices[t[2]]) {}
    double area() const { return 0.5 * cross(b - a, c - a); }
    Vec2 centroid() const { return (a + b + c) / 3.0; }
};

/// |F - R| of one triangle: with singular values s1, s2 (s2 < 0 for an inverted triangle) it is the distance
/// of (s1, s2) from (1, 1).
double deviation(const Corners& rest, const Corners& now) {
    const Vec2 u = rest.b - rest.a, v = rest.c - rest.a;
    const Vec2 p = now.b - now.a, q = now.c - now.a;
    const double det = cross(u, v);
    // F maps u to p and v to q.
    const double xx = (p.x * v.y - q.x * u.y) / det, xy = (q.x * u.x - p.x * v.x) / det;
    const double yx = (p.y * v.y - q.y * u.y) / det, yy = (q.y * u.x - p.y * v.x) / det;
    // Rotation and reflection parts: s1 + s2 and s1 - s2.
    const double sum = std::sqrt((xx + yy) * (xx + yy) + (yx - xy) * (yx - xy));
    const double difference = std::sqrt((xx - yy) * (xx - yy) + (yx + xy) * (yx + xy));
    const double s1 = 0.5 * (sum + difference), s2 = 0.5 * (sum - difference);
    return std::sqrt((s1 - 1.0) * (s1 - 1.0) + (s2 - 1.0) * (s2 - 1.0));
}

}  // namespace

std::vector<double> triangleDistortion(const TriangleMesh& rest, std::span<const Vec2> deformed) {
    std::vector<double> values;
    for (const Triangle& t : rest.triangles) values.push_back(deviation({t, rest.vertices}, {t, deformed}));
    return values;
}

double arapEnergy(const TriangleMesh& rest, std::span<const Vec2> deformed) {
    const std::vector<double> values = triangleDistortion(rest, deformed);
    double sum = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k)
        sum += Corners(rest.triangles[k], rest.vertices).area() * values[k] * values[k];
    return sum;
}

double meanDistortion(const TriangleMesh& rest, std::span<const Vec2> deformed, bool left) {
    const std::vector<double> values = triangleDistortion(rest, deformed);
    double sum = 0.0;
    double area = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const Corners corners(rest.triangles[k], rest.vertices);
        if ((corners.centroid().x < 0.0) != left) continue;
        sum += values[k] * corners.area();
        area += corners.area();
    }
    return area > 0.0 ? sum / area : 0.0;
}

}  // namespace muster
