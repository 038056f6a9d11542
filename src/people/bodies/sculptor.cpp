#include "people/bodies/sculptor.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"

namespace muster::bodies {

double angleOf(std::size_t k, std::size_t corners) {
    return 2.0 * kPi * static_cast<double>(k) / static_cast<double>(corners);
}

float widening(std::size_t corners) {
    const double step = angleOf(1, corners);
    return static_cast<float>(std::sqrt(step / sine(step)));
}

BodyMesh Sculptor::make() {
    makePelvis();
    makeShirt();
    makeNeckAndHead();
    makeHair();
    for (const bool right : {false, true}) {
        mirrored_ = right;
        mesh_.setMirrored(right);
        makeLeg();
        makeSleeve();
        makeArm();
        makeShoe();
    }
    return mesh_.finish();
}

Vec3 Sculptor::levelPoint(const Section& cut, double angle, float widen) {
    const float c = static_cast<float>(cosine(angle)), s = static_cast<float>(sine(angle));
    // A chin hardly extends behind x = 0, so its vertices are spread about a point further ahead.
    const float ahead = std::max(0.0f, 0.5f * (0.06f - cut.back));
    const float reach = c > 0.0f ? cut.front - ahead : cut.back + ahead;
    return {ahead + reach * c * widen, cut.middle + cut.side * s * widen, cut.along};
}

std::vector<Vec3> Sculptor::levelRing(const Section& cut, std::size_t corners, double first) const {
    std::vector<Vec3> points;
    for (std::size_t k = 0; k < corners; ++k)
        points.push_back(levelPoint(cut, first + angleOf(k, corners), widening(corners)));
    return points;
}

std::vector<Vec3> Sculptor::armRing(const Section& cut, std::size_t corners) const {
    std::vector<Vec3> points;
    const float widen = widening(corners);
    for (std::size_t k = 0; k < corners; ++k) {
        const float c = static_cast<float>(cosine(angleOf(k, corners)));
        const float s = static_cast<float>(sine(angleOf(k, corners)));
        points.push_back(
            {(s > 0.0f ? cut.front : cut.back) * s * widen, cut.along, cut.middle + cut.side * c * widen});
    }
    return points;
}

void Sculptor::turnIn(const Ring& edge, const Stuff& stuff, float scale, Vec3 shift, bool left) {
    if (!detail_.fine) return;
    const Vec3 middle = mesh_.middle(edge);
    std::vector<Vec3> outer, inner;
    for (std::uint32_t v : edge) {
        outer.push_back(mesh_.at(v));
        inner.push_back(middle + shift + (mesh_.at(v) - middle) * scale);
    }
    const Ring from = mesh_.add(outer, stuff), to = mesh_.add(inner, stuff);
    left ? mesh_.bridge(from, to) : mesh_.bridge(to, from);
}

void Sculptor::tube(std::span<const Vec3> path, std::span<const float> radii, Vec3 tip, std::size_t corners,
                    const Stuff& stuff, float flat) {
    Ring before;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Vec3 next = i + 1 < path.size() ? path[i + 1] : tip;
        const Vec3 direction = normalized(next - path[i == 0 ? 0 : i - 1]);
        const Vec3 u = normalized(cross({0.0f, 1.0f, 0.0f}, direction), {1.0f, 0.0f, 0.0f});
        const Vec3 v = cross(direction, u);
        std::vector<Vec3> points;
        for (std::size_t k = 0; k < corners; ++k) {
            const float c = static_cast<float>(cosine(angleOf(k, corners)));
            const float s = static_cast<float>(sine(angleOf(k, corners)));
            points.push_back(path[i] + (u * c + v * (s * flat)) * radii[i]);
        }
        const Ring ring = mesh_.add(points, stuff);
        if (!before.empty()) mesh_.bridge(before, ring);
        before = ring;
    }
    mesh_.cap(before, tip, stuff);
}

std::uint32_t Sculptor::column(const Ring& ring, std::size_t k) const {
    return ring[mirrored_ ? (ring.size() - k) % ring.size() : k];
}

}  // namespace muster::bodies
