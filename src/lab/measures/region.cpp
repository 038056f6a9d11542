#include "lab/measures/region.h"

#include <algorithm>
#include <limits>

#include "engine/geometry/free_area.h"
#include "engine/geometry/polygon.h"

namespace muster {
namespace {

// Width of a contact below which two parts do not hang together [m].
constexpr double kLeastContact = 1e-9;

double yOf(const Polygon& polygon, bool highest) {
    double y = polygon[0].y;
    for (const Vec2 p : polygon) y = highest ? std::max(y, p.y) : std::min(y, p.y);
    return y;
}

double xAt(Vec2 a, Vec2 b, double y) {
    return a.y == b.y ? a.x : a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
}

/// The chord of a convex polygon on the line y = const, from first to second; first >= second for none.
std::pair<double, double> chord(const Polygon& convex, double y) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Vec2 a = convex[i], b = convex[(i + 1) % convex.size()];
        if (std::min(a.y, b.y) > y || std::max(a.y, b.y) < y) continue;
        for (const double x : a.y == b.y ? std::array{a.x, b.x} : std::array{xAt(a, b, y), xAt(a, b, y)}) {
            low = std::min(low, x);
            high = std::max(high, x);
        }
    }
    return {low, high};
}

}  // namespace

void clipLeftOf(Polygon& convex, Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const std::size_t count = convex.size();
    thread_local Polygon kept;
    kept.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 p = convex[i], q = convex[i + 1 < count ? i + 1 : 0];
        const double sp = cross(along, p - a), sq = cross(along, q - a);
        if (sp >= 0.0) kept.push_back(p);
        if ((sp > 0.0 && sq < 0.0) || (sp < 0.0 && sq > 0.0)) kept.push_back(lerp(p, q, sp / (sp - sq)));
    }
    if (kept.size() < 3) kept.clear();
    convex.assign(kept.begin(), kept.end());
}

Result<Region> Region::create(std::span<const PolygonWithHoles> polygons) {
    Region region;
    for (const PolygonWithHoles& polygon : polygons) {
        region.rings_.push_back(polygon.outline);
        for (const Polygon& hole : polygon.holes) region.rings_.push_back(hole);
    }
    if (region.rings_.empty()) return invalidArgument("area: found no polygon");
    for (const Polygon& ring : region.rings_) {
        if (ring.size() < 3) return invalidArgument("area: found fewer than three corners");
        for (const Vec2 p : ring)
            if (!isFinite(p)) return invalidArgument("area: found a coordinate that is not finite");
    }
    region.cut();
    return region;
}

Result<Region> Region::create(const Polygon& polygon) {
    const PolygonWithHoles one{polygon, {}};
    return create(std::span(&one, 1));
}

void Region::cut() {
    box_ = {rings_[0][0], rings_[0][0]};
    for (const Polygon& ring : rings_)
        for (const Vec2 p : ring) {
            lines_.push_back(p.y);
            box_ = {{std::min(box_.min.x, p.x), std::min(box_.min.y, p.y)},
                    {std::max(box_.max.x, p.x), std::max(box_.max.y, p.y)}};
        }
    std::sort(lines_.begin(), lines_.end());
    lines_.erase(std::unique(lines_.begin(), lines_.end()), lines_.end());
    const std::size_t slabs = lines_.size() - 1;
    std::vector<std::vector<std::pair<Vec2, Vec2>>> crossing(slabs);
    for (const Polygon& ring : rings_)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
            if (a.y == b.y) continue;
            if (a.y > b.y) std::swap(a, b);
            const auto first = std::lower_bound(lines_.begin(), lines_.end(), a.y) - lines_.begin();
            for (std::size_t s = first; s < slabs && lines_[s] < b.y; ++s) crossing[s].emplace_back(a, b);
        }
    for (std::size_t s = 0; s < slabs; ++s) fillSlab(s, crossing[s]);
}

void Region::fillSlab(std::size_t slab, std::vector<std::pair<Vec2, Vec2>>& crossing) {
    const double low = lines_[slab], high = lines_[slab + 1], middle = 0.5 * (low + high);
    std::sort(crossing.begin(), crossing.end(), [middle](const auto& a, const auto& b) {
        return xAt(a.first, a.second, middle) < xAt(b.first, b.second, middle);
    });
    for (std::size_t k = 0; k + 1 < crossing.size(); k += 2) {
        const auto& [la, lb] = crossing[k];
        const auto& [ra, rb] = crossing[k + 1];
        const Trapezoid t{xAt(la, lb, low), xAt(ra, rb, low), xAt(la, lb, high), xAt(ra, rb, high)};
        trapezoids_.push_back(t);
        area_ += 0.5 * (high - low) * (t.rightLow - t.leftLow + t.rightHigh - t.leftHigh);
    }
    slabEnd_.push_back(static_cast<std::int32_t>(trapezoids_.size()));
}

std::size_t Region::slabOf(std::int32_t trapezoid) const {
    return std::upper_bound(slabEnd_.begin(), slabEnd_.end(), trapezoid) - slabEnd_.begin();
}

std::int32_t Region::find(Vec2 p) const {
    if (!box_.contains(p) || slabEnd_.empty()) return -1;
    const auto above = std::upper_bound(lines_.begin(), lines_.end(), p.y) - lines_.begin();
    const std::size_t slab = std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(lines_) - 2);
    const double share = (p.y - lines_[slab]) / (lines_[slab + 1] - lines_[slab]);
    for (std::int32_t t = slab > 0 ? slabEnd_[slab - 1] : 0; t < slabEnd_[slab]; ++t) {
        const Trapezoid& z = trapezoids_[t];
        if (p.x >= z.leftLow + (z.leftHigh - z.leftLow) * share &&
            p.x <= z.rightLow + (z.rightHigh - z.rightLow) * share)
            return t;
    }
    return -1;
}

bool Region::contains(Vec2 p) const {
    return find(p) >= 0;
}

std::pair<std::size_t, std::size_t> Region::slabsOf(const Polygon& convex) const {
    const double low = yOf(convex, false), high = yOf(convex, true);
    const auto first = std::upper_bound(lines_.begin(), lines_.end(), low) - lines_.begin();
    const auto last = std::lower_bound(lines_.begin(), lines_.end(), high) - lines_.begin();
    return {std::max<std::ptrdiff_t>(first - 1, 0), std::min<std::ptrdiff_t>(last, std::ssize(slabEnd_))};
}

Polygon Region::shared(const Polygon& convex, std::size_t slab, const Trapezoid& t) const {
    const Vec2 lowLeft{t.leftLow, lines_[slab]}, lowRight{t.rightLow, lines_[slab]};
    const Vec2 highLeft{t.leftHigh, lines_[slab + 1]}, highRight{t.rightHigh, lines_[slab + 1]};
    Polygon part = convex;
    const Vec2 east{1.0, 0.0};
    clipLeftOf(part, lowLeft, lowLeft + east);
    if (!part.empty()) clipLeftOf(part, highLeft, highLeft - east);
    if (!part.empty()) clipLeftOf(part, lowRight, highRight);
    if (!part.empty()) clipLeftOf(part, highLeft, lowLeft);
    return part;
}

double Region::sharedArea(const Polygon& convex) const {
    if (convex.size() < 3) return 0.0;
    const auto [first, end] = slabsOf(convex);
    double sum = 0.0;
    for (std::size_t s = first; s < end; ++s)
        for (std::int32_t t = s > 0 ? slabEnd_[s - 1] : 0; t < slabEnd_[s]; ++t)
            sum += signedArea(shared(convex, s, trapezoids_[t]));
    return sum;
}

std::vector<Polygon> Region::partAround(const Polygon& convex, Vec2 p) const {
    std::vector<Polygon> pieces;
    const std::int32_t home = find(p);
    if (home < 0 || convex.size() < 3) return pieces;
    std::vector<std::int32_t> todo{home}, seen{home};
    // A neighbour across the line y = const hangs together where both and the polygon share a stretch of it.
    const auto reach = [&](std::size_t slab, double left, double right, double y, bool above) {
        const auto [low, high] = chord(convex, y);
        for (std::int32_t t = slab > 0 ? slabEnd_[slab - 1] : 0; t < slabEnd_[slab]; ++t) {
            const Trapezoid& z = trapezoids_[t];
            const double from = std::max({above ? z.leftLow : z.leftHigh, left, low});
            const double to = std::min({above ? z.rightLow : z.rightHigh, right, high});
            if (to - from <= kLeastContact || std::find(seen.begin(), seen.end(), t) != seen.end()) continue;
            seen.push_back(t);
            todo.push_back(t);
        }
    };
    while (!todo.empty()) {
        const std::int32_t t = todo.back();
        todo.pop_back();
        const std::size_t slab = slabOf(t);
        const Trapezoid& z = trapezoids_[t];
        Polygon piece = shared(convex, slab, z);
        if (!piece.empty()) pieces.push_back(std::move(piece));
        if (slab > 0) reach(slab - 1, z.leftLow, z.rightLow, lines_[slab], false);
        if (slab + 1 < slabEnd_.size()) reach(slab + 1, z.leftHigh, z.rightHigh, lines_[slab + 1], true);
    }
    return pieces;
}

Result<Region> regionOutside(const Box& box, std::span<const Polygon> convex) {
    return Region::create(freeArea(box, convex));
}

}  // namespace muster
