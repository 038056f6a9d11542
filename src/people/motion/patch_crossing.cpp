#include "people/motion/patch_crossing.h"

#include <algorithm>
#include <limits>

namespace muster {
namespace {

// Share of the length spread evenly over time, so that shares rise strictly.
constexpr float kEvenShare = 0.1f;
// Cosine of the angle, 50 degrees, within which a heading counts as straight on.
constexpr double kStraightOn = 0.6427876;
constexpr double kFit = 0.15;  // Largest relative difference of lengths at which a clip is stretched.

Vec2 narrowest(const Polygon& polygon) {
    Vec2 best{1.0, 0.0};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 edge = polygon[(k + 1) % polygon.size()] - polygon[k];
        const Vec2 normal = normalized(perpendicular(edge));
        if (normal == Vec2{}) continue;
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Vec2 p : polygon) {
            low = std::min(low, dot(p, normal));
            high = std::max(high, dot(p, normal));
        }
        if (high - low < least) {
            least = high - low;
            best = normal;
        }
    }
    return best;
}

/// The interval of a straight line inside a polygon, along its direction [m].
struct Chord {
    double from = 0.0;
    double to = 0.0;
};

// The interval nearest to `p` in which the line through p is inside the polygon.
Chord chordThrough(const Polygon& polygon, Vec2 p, Vec2 along) {
    const double here = dot(p, along);
    Chord chord{here, here};
    double before = std::numeric_limits<double>::infinity(), after = before;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 a = polygon[k] - p, b = polygon[(k + 1) % polygon.size()] - p;
        const double sideA = cross(along, a), sideB = cross(along, b);
        if ((sideA > 0.0) == (sideB > 0.0)) continue;
        const double at = dot(along, a + (b - a) * (sideA / (sideA - sideB)));
        // The entry is at most 0.1 m ahead of p, which is about one step.
        if (at <= 0.1 && -at < before) {
            before = -at;
            chord.from = here + at;
        } else if (at > 0.1 && at < after) {
            after = at;
            chord.to = here + at;
        }
    }
    chord.to = std::max(chord.to, chord.from);
    return chord;
}

}  // namespace

TravelTimes::TravelTimes(const Clip& clip) : rate_(static_cast<float>(clip.rate)) {
    const auto total = static_cast<float>(clip.length());
    const auto intervals = static_cast<float>(std::max<std::size_t>(clip.travel.size(), 2) - 1);
    float highest = 0.0f;
    for (std::size_t f = 0; f < clip.travel.size(); ++f) {
        const float even = static_cast<float>(f) / intervals;
        const float gone = total > 0.0f ? (clip.travel[f].x - clip.travel[0].x) / total : even;
        highest = std::max(highest, std::clamp(gone, 0.0f, 1.0f));
        shares_.push_back((1.0f - kEvenShare) * highest + kEvenShare * even);
    }
}

float TravelTimes::time(float share) const {
    const auto after = std::upper_bound(shares_.begin(), shares_.end(), share);
    if (after == shares_.begin()) return 0.0f;
    if (after == shares_.end()) return static_cast<float>(shares_.size() - 1) / rate_;
    const auto f = static_cast<std::size_t>(after - shares_.begin()) - 1;
    return (static_cast<float>(f) + (share - shares_[f]) / (shares_[f + 1] - shares_[f])) / rate_;
}

PatchCrossing crossPatch(const Environment& environment, std::uint32_t patch, Vec2 position, Vec2 heading,
                         double clipLength) {
    PatchCrossing path;
    path.patch = patch;
    path.normal = heading;
    path.begin = dot(position, heading);
    path.length = std::max(clipLength, 0.1);
    const PatchDef* def = environment.patch(PatchId{patch});
    if (def == nullptr) return path;
    path.timed = !def->path.still();
    if (path.timed) return path;
    const Polygon& polygon = def->polygon;
    Vec2 normal = narrowest(polygon);
    if (dot(normal, heading) < 0.0) normal = -normal;
    if (dot(normal, heading) < kStraightOn) normal = heading;
    const Chord chord = chordThrough(polygon, position, normal);
    const double across = chord.to - chord.from;
    path.normal = normal;
    path.length = std::clamp(across, (1.0 - kFit) * path.length, (1.0 + kFit) * path.length);
    path.begin = chord.from + std::max(0.0, 0.5 * (across - path.length));
    return path;
}

double shareCrossed(PatchCrossing& path, Vec2 position) {
    const double share = (dot(position, path.normal) - path.begin) / path.length;
    if (share < 0.0 && path.farthest <= 0.0) return share;
    path.farthest = std::clamp(share, path.farthest, 1.0);
    return path.farthest;
}

}  // namespace muster
