// Shapes made of concentric arcs: ring and crescent.
#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "formation/shapes/formation_shape.h"

namespace muster {
namespace {

constexpr double kTurn = 2.0 * kPi;

Vec2 onCircle(double radius, double angle) {
    return {radius * cosine(angle), radius * sine(angle)};
}

// Turns wishes into whole numbers with the right sum: the largest remainders are rounded up.
std::vector<std::int32_t> share(const std::vector<double>& wishes, std::int32_t count) {
    std::vector<std::int32_t> counts;
    std::vector<std::pair<double, std::size_t>> rest;
    std::int32_t left = count;
    for (std::size_t k = 0; k < wishes.size(); ++k) {
        counts.push_back(static_cast<std::int32_t>(std::floor(wishes[k])));
        rest.emplace_back(counts[k] - wishes[k], k);
        left -= counts[k];
    }
    std::sort(rest.begin(), rest.end());
    for (std::size_t k = 0; left > 0; --left, ++k) ++counts[rest[k % rest.size()].second];
    for (std::size_t k = 0; left < 0; ++left, ++k) --counts[rest[rest.size() - 1 - k % rest.size()].second];
    return counts;
}

// Corners of a circle's or arc's outline from angle `from` to `to`, drawn outside it by the chord's sag.
void addArc(Polygon& polygon, double radius, double from, double to, bool closed) {
    const double parts = std::clamp(std::ceil(std::fabs(to - from) / kTurn * 48.0), 3.0, 48.0);
    for (double k = 0.0; k < parts + (closed ? 0.0 : 0.5); k += 1.0)
        polygon.push_back(onCircle(radius, from + (to - from) * (k / parts)));
}

// The farthest that a 48-sided outline cuts inside its circle.
const double kSag = 1.0 / 0.9978589232386035;

// Arcs in units of the spacing: radius first, first + 1...; angle is the full turn for closed circles.
struct Arcs {
    double first = 0.0;
    double angle = kTurn;
    std::vector<std::int32_t> counts;

    double last() const { return first + static_cast<double>(counts.size()) - 1.0; }
};

void addPlaces(Layout& layout, const Arcs& arcs, double spacing) {
    const bool closed = arcs.angle >= kTurn;
    for (std::size_t a = 0; a < arcs.counts.size(); ++a) {
        const std::int32_t n = arcs.counts[a];
        for (std::int32_t k = 0; k < n; ++k) {
            const double t = closed  ? static_cast<double>(k) / n
                             : n > 1 ? static_cast<double>(k) / (n - 1)
                                     : 0.5;
            const double angle = kPi - 0.5 * arcs.angle + arcs.angle * t + (closed ? kPi : 0.0);
            layout.places.push_back(onCircle((arcs.first + static_cast<double>(a)) * spacing, angle));
        }
    }
}

// Circles until the open middle would be narrower than three fifths of the whole.
Arcs ringArcs(std::int32_t count) {
    Arcs best;
    best.counts = {count};
    best.first = count > 1 ? 0.5 / sine(kPi / count) : 0.0;
    for (std::int32_t n = 2;; ++n) {
        const double first = (count / kTurn - 0.5 * n * (n - 1)) / n;
        if (first < 1.5 * (n - 1)) return best;
        std::vector<double> wishes;
        for (std::int32_t k = 0; k < n; ++k) wishes.push_back(kTurn * (first + k));
        best.first = first;
        best.counts = share(wishes, count);
    }
}

// The arc's angle, so that its ends stay a spacing apart on the innermost arc.
double openAngle(double first, double opening) {
    return std::min(kTurn - opening, kTurn - 1.1 / std::max(first, 0.3));
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
    best.angle = std::min(kTurn - opening, kPi);
    if (count < 8) {  // Too few to bend far: at most half a circle, neighbours exactly a spacing apart.
        best.first = count > 1 ? 0.5 / sine(0.5 * best.angle / (count - 1)) : 0.0;
        return best;
    }
    for (std::int32_t n = 1;; ++n) {
        const double first = crescentRadius(count, n, opening);
        // At least three places on the innermost arc, or the horns would be stubs.
        const bool good = first >= std::max(1.0, static_cast<double>(n - 1)) &&
                          openAngle(first, opening) * first >= 2.0;
        if (!good && n > 1) return best;
        best.first = first;
        best.angle = openAngle(first, opening);
        std::vector<double> wishes;
        for (std::int32_t k = 0; k < n; ++k) wishes.push_back(best.angle * (first + k) + 1.0);
        best.counts = share(wishes, count);
    }
}

}  // namespace

Layout ringLayout(std::int32_t count, double spacing) {
    const Arcs arcs = ringArcs(count);
    Layout layout;
    addPlaces(layout, arcs, spacing);
    addArc(layout.outline.outline, (arcs.last() + 0.5) * spacing * kSag, 0.0, kTurn, true);
    if (arcs.first > 0.8) {
        Polygon hole;
        addArc(hole, (arcs.first - 0.5) * spacing, 0.0, -kTurn, true);
        layout.outline.holes.push_back(std::move(hole));
    }
    return layout;
}

Layout crescentLayout(std::int32_t count, double spacing, double opening) {
    const Arcs arcs = crescentArcs(count, opening);
    Layout layout;
    addPlaces(layout, arcs, spacing);
    const double gap = kTurn - arcs.angle;
    if (arcs.first < 0.8 || gap > kPi) {  // Hardly bent: the hull serves as well.
        layout.outline.outline = grownHull(layout.places, 0.5 * spacing);
        return layout;
    }
    // Half a spacing beyond the end places, but never closing the gap.
    const double half = std::max(0.3 * gap, 0.5 * gap - 0.5 / arcs.first);
    addArc(layout.outline.outline, (arcs.last() + 0.5) * spacing * kSag, half, kTurn - half, false);
    addArc(layout.outline.outline, (arcs.first - 0.5) * spacing, kTurn - half, half, false);
    return layout;
}

}  // namespace muster
