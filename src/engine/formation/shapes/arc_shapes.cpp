// Shapes made of concentric arcs: ring and crescent.
#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "engine/formation/shapes/formation_shape.h"

namespace muster {
namespace {

constexpr double kFullAngle = 2.0 * kPi;

Vec2 onCircle(double radius, double angle) {
    return {radius * cosine(angle), radius * sine(angle)};
}

// Rounds quotas to whole numbers with the sum `count` (largest remainder method).
std::vector<std::int32_t> apportion(const std::vector<double>& quotas, std::int32_t count) {
    std::vector<std::int32_t> counts;
    // Remainders, negative, so that the largest comes first.
    std::vector<std::pair<double, std::size_t>> remainders;
    std::int32_t left = count;
    for (std::size_t k = 0; k < quotas.size(); ++k) {
        counts.push_back(static_cast<std::int32_t>(std::floor(quotas[k])));
        remainders.emplace_back(counts[k] - quotas[k], k);
        left -= counts[k];
    }
    std::sort(remainders.begin(), remainders.end());
    for (std::size_t k = 0; left > 0; --left, ++k) ++counts[remainders[k % remainders.size()].second];
    for (std::size_t k = 0; left < 0; ++left, ++k)
        --counts[remainders[remainders.size() - 1 - k % remainders.size()].second];
    return counts;
}

// Adds the corners of an arc from angle `from` to `to` [rad].
void addArc(Polygon& polygon, double radius, double from, double to, bool closed) {
    const double parts = std::clamp(std::ceil(std::fabs(to - from) / kFullAngle * 48.0), 3.0, 48.0);
    for (double k = 0.0; k < parts + (closed ? 0.0 : 0.5); k += 1.0)
        polygon.push_back(onCircle(radius, from + (to - from) * (k / parts)));
}

// Factor by which the corners of a 48-sided polygon lie outside the circle that its sides touch.
const double kSag = 1.0 / 0.9978589232386035;

// Concentric arcs, a spacing apart.
struct Arcs {
    double first = 0.0;                // Radius of the innermost arc [spacings].
    double angle = kFullAngle;         // Angle of each arc [rad]; circles are closed.
    std::vector<std::int32_t> counts;  // Places on each arc, from the inside out.

    double last() const { return first + static_cast<double>(counts.size()) - 1.0; }
};

void addPlaces(FormationShape& shape, const Arcs& arcs, double spacing) {
    const bool closed = arcs.angle >= kFullAngle;
    for (std::size_t a = 0; a < arcs.counts.size(); ++a) {
        const std::int32_t n = arcs.counts[a];
        for (std::int32_t k = 0; k < n; ++k) {
            const double t = closed  ? static_cast<double>(k) / n
                             : n > 1 ? static_cast<double>(k) / (n - 1)
                                     : 0.5;
            const double angle = kPi - 0.5 * arcs.angle + arcs.angle * t + (closed ? kPi : 0.0);
            shape.places.push_back(onCircle((arcs.first + static_cast<double>(a)) * spacing, angle));
        }
    }
}

// Circles until the open middle would be narrower than three fifths of the whole.
Arcs ringArcs(std::int32_t count) {
    Arcs best;
    best.counts = {count};
    best.first = count > 1 ? 0.5 / sine(kPi / count) : 0.0;
    for (std::int32_t n = 2;; ++n) {
        const double first = (count / kFullAngle - 0.5 * n * (n - 1)) / n;
        if (first < 1.5 * (n - 1)) return best;
        std::vector<double> quotas;
        for (std::int32_t k = 0; k < n; ++k) quotas.push_back(kFullAngle * (first + k));
        best.first = first;
        best.counts = apportion(quotas, count);
    }
}

// The angle of the arcs; the ends of the innermost are at least a spacing apart.
double openAngle(double first, double opening) {
    return std::min(kFullAngle - opening, kFullAngle - 1.1 / std::max(first, 0.3));
}

// The innermost radius at which `n` open arcs hold `count` places, or a negative number.
double crescentRadius(std::int32_t count, std::int32_t n, double opening) {
    double low = 0.0;
    double high = static_cast<double>(count) * 40.0 + 40.0;
    const auto holds = [&](double first) {
        return n * (openAngle(first, opening) * (first + 0.5 * (n - 1)) + 1.0) >= count;
    };
    if (holds(low)) return -1.0;
    for (int k = 0; k < 80; ++k) {
        const double middle = 0.5 * (low + high);
        (holds(middle) ? high : low) = middle;
    }
    return high;
}

Arcs crescentArcs(std::int32_t count, double opening) {
    Arcs best;
    best.counts = {count};
    best.angle = std::min(kFullAngle - opening, kPi);
    // Few places lie on one arc of at most half a circle, neighbours exactly a spacing apart.
    if (count < 8) {
        best.first = count > 1 ? 0.5 / sine(0.5 * best.angle / (count - 1)) : 0.0;
        return best;
    }
    for (std::int32_t n = 1;; ++n) {
        const double first = crescentRadius(count, n, opening);
        // The innermost arc holds at least three places.
        const bool good = first >= std::max(1.0, static_cast<double>(n - 1)) &&
                          openAngle(first, opening) * first >= 2.0;
        if (!good && n > 1) return best;
        best.first = first;
        best.angle = openAngle(first, opening);
        std::vector<double> quotas;
        for (std::int32_t k = 0; k < n; ++k) quotas.push_back(best.angle * (first + k) + 1.0);
        best.counts = apportion(quotas, count);
    }
}

}  // namespace

FormationShape ringShape(std::int32_t count, double spacing) {
    const Arcs arcs = ringArcs(count);
    FormationShape shape;
    addPlaces(shape, arcs, spacing);
    addArc(shape.outline.outline, (arcs.last() + 0.5) * spacing * kSag, 0.0, kFullAngle, true);
    if (arcs.first > 0.8) {
        Polygon hole;
        addArc(hole, (arcs.first - 0.5) * spacing, 0.0, -kFullAngle, true);
        shape.outline.holes.push_back(std::move(hole));
    }
    return shape;
}

FormationShape crescentShape(std::int32_t count, double spacing, double opening) {
    const Arcs arcs = crescentArcs(count, opening);
    FormationShape shape;
    addPlaces(shape, arcs, spacing);
    const double gap = kFullAngle - arcs.angle;
    // A crescent that hardly bends is meshed by its hull.
    if (arcs.first < 0.8 || gap > kPi) {
        shape.outline.outline = grownHull(shape.places, 0.5 * spacing);
        return shape;
    }
    // The outline is half a spacing larger than the places, but never closes the gap.
    const double half = std::max(0.3 * gap, 0.5 * gap - 0.5 / arcs.first);
    addArc(shape.outline.outline, (arcs.last() + 0.5) * spacing * kSag, half, kFullAngle - half, false);
    addArc(shape.outline.outline, (arcs.first - 0.5) * spacing, kFullAngle - half, half, false);
    return shape;
}

}  // namespace muster
