// Every edge of a polygon is cut by all other polygons (Cyrus and Beck 1978); the rest of it outside of them
// is a piece of the boundary of the free area, which lies to its right. The pieces are joined to rings.
#include "engine/geometry/free_area.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "base/bounds.h"
#include "base/maths.h"

namespace muster {
namespace {

constexpr double kTouching = 1e-9;  // Distance from a line within which a point lies on it [m].
constexpr double kJoined = 1e-7;    // Distance within which two ends of pieces are one corner [m].
constexpr double kFrame = 1.0;      // Width of the frame around the box [m].

/// A directed piece of the boundary; the free area lies to its right.
struct Piece {
    Vec2 from, to;
    bool used = false;
};

using Interval = std::pair<double, double>;

bool before(Vec2 a, Vec2 b) {
    return std::tie(a.x, a.y) < std::tie(b.x, b.y);
}

/// The part of the edge from `a` to `b` that another polygon takes away, as shares of its length. Of two
/// edges that coincide and face the same side the edge of the polygon that comes first stays.
std::optional<Interval> takenBy(const Polygon& other, bool otherIsFirst, Vec2 a, Vec2 b) {
    double low = 0.0, high = 1.0;
    for (std::size_t k = 0; k < other.size(); ++k) {
        const Vec2 p = other[k], along = normalized(other[(k + 1) % other.size()] - p);
        const double atA = cross(along, a - p), atB = cross(along, b - p);
        if (std::fabs(atA) <= kTouching && std::fabs(atB) <= kTouching) {
            if (dot(along, b - a) > 0.0 && !otherIsFirst) return std::nullopt;
            continue;
        }
        if (atA <= kTouching && atB <= kTouching) return std::nullopt;
        if (atA < 0.0) low = std::max(low, atA / (atA - atB));
        if (atB < 0.0) high = std::min(high, atA / (atA - atB));
    }
    if ((high - low) * distance(a, b) <= kTouching) return std::nullopt;
    return Interval{low, high};
}

/// All pieces of the boundary of the free area.
class Boundary {
public:
    Boundary(const Box& box, std::span<const Polygon> convex) : inner_(box.grown(0.5 * kFrame)) {
        const Box outer = box.grown(kFrame);
        addPolygon(
            {outer.min, {outer.max.x, outer.min.y}, {outer.max.x, box.min.y}, {outer.min.x, box.min.y}});
        addPolygon(
            {{outer.min.x, box.max.y}, {outer.max.x, box.max.y}, outer.max, {outer.min.x, outer.max.y}});
        addPolygon(
            {outer.min, {box.min.x, outer.min.y}, {box.min.x, outer.max.y}, {outer.min.x, outer.max.y}});
        addPolygon(
            {{box.max.x, outer.min.y}, {outer.max.x, outer.min.y}, outer.max, {box.max.x, outer.max.y}});
        for (const Polygon& polygon : convex)
            if (polygon.size() >= 3) addPolygon(polygon);
    }

    std::vector<Piece> pieces() {
        std::vector<Piece> pieces;
        for (std::size_t i = 0; i < polygons_.size(); ++i)
            for (std::size_t k = 0; k < polygons_[i].size(); ++k)
                cut(i, polygons_[i][k], polygons_[i][(k + 1) % polygons_[i].size()], pieces);
        return pieces;
    }

private:
    void addPolygon(Polygon polygon) {
        bounds_.push_back(boundsOf(polygon).grown(kTouching));
        polygons_.push_back(std::move(polygon));
    }

    // Adds the remaining parts of the edge of a polygon.
    void cut(std::size_t polygon, Vec2 a, Vec2 b, std::vector<Piece>& pieces) {
        taken_.clear();
        const Box edge = boundsOf(std::array{a, b});
        for (std::size_t j = 0; j < polygons_.size(); ++j) {
            if (j == polygon || !overlap(bounds_[j], edge)) continue;
            if (const auto taken = takenBy(polygons_[j], j < polygon, a, b)) taken_.push_back(*taken);
        }
        taken_.emplace_back(1.0, 1.0);
        std::sort(taken_.begin(), taken_.end());
        double done = 0.0;
        for (const auto& [low, high] : taken_) {
            if ((low - done) * distance(a, b) > kJoined) add(pointAt(a, b, done), pointAt(a, b, low), pieces);
            done = std::max(done, high);
        }
    }

    void add(Vec2 from, Vec2 to, std::vector<Piece>& pieces) const {
        if (inner_.contains(0.5 * (from + to))) pieces.push_back({from, to});
    }
    static Vec2 pointAt(Vec2 a, Vec2 b, double share) { return share == 1.0 ? b : a + (b - a) * share; }
    static bool overlap(const Box& a, const Box& b) {
        return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
    }

    Box inner_;  // Box beyond which the far sides of the frame lie.
    std::vector<Polygon> polygons_;
    std::vector<Box> bounds_;
    std::vector<Interval> taken_;
};

/// Joins pieces to rings. Where several pieces leave a corner the rightmost is taken, so that a ring keeps to
/// the part of the free area that it began with.
class RingJoiner {
public:
    explicit RingJoiner(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {
        std::sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) {
            return std::tie(a.from.x, a.from.y, a.to.x, a.to.y) <
                   std::tie(b.from.x, b.from.y, b.to.x, b.to.y);
        });
    }

    std::vector<Polygon> rings() {
        std::vector<Polygon> rings;
        for (Piece& first : pieces_) {
            if (first.used) continue;
            Polygon ring;
            for (Piece* piece = &first; piece != nullptr && !piece->used; piece = next(*piece)) {
                piece->used = true;
                ring.push_back(piece->from);
            }
            tidy(ring);
            if (ring.size() >= 3) rings.push_back(std::move(ring));
        }
        return rings;
    }

private:
    Piece* next(const Piece& piece) {
        Piece* best = nullptr;
        double leastTurn = 0.0;
        const Vec2 along = piece.to - piece.from;
        auto at = std::lower_bound(pieces_.begin(), pieces_.end(), piece.to.x - kJoined,
                                   [](const Piece& other, double x) { return other.from.x < x; });
        for (; at != pieces_.end() && at->from.x <= piece.to.x + kJoined; ++at) {
            if (distance(at->from, piece.to) > kJoined) continue;
            const Vec2 onward = at->to - at->from;
            const double turn = arcTangent2(cross(along, onward), dot(along, onward));
            if (best != nullptr && turn >= leastTurn) continue;
            best = &*at;
            leastTurn = turn;
        }
        return best;
    }

    // Leaves out corners on straight lines, and begins at the leftmost corner.
    static void tidy(Polygon& ring) {
        for (std::size_t k = 0; k < ring.size() && ring.size() >= 3;) {
            const Vec2 last = ring[(k + ring.size() - 1) % ring.size()], next = ring[(k + 1) % ring.size()];
            const double across = std::fabs(cross(ring[k] - last, next - last));
            const bool between = dot(ring[k] - last, next - ring[k]) > 0.0;
            if (between && across <= kTouching * distance(last, next))
                ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(k));
            else
                ++k;
        }
        std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), before), ring.end());
    }

    std::vector<Piece> pieces_;
};

/// A point of the free area beside the first edge of a ring.
Vec2 beside(const Polygon& ring) {
    const Vec2 along = normalized(ring[1] - ring[0]);
    return 0.5 * (ring[0] + ring[1]) - 2.0 * kJoined * perpendicular(along);
}

}  // namespace

std::vector<PolygonWithHoles> freeArea(const Box& box, std::span<const Polygon> convex) {
    std::vector<Polygon> rings = RingJoiner(Boundary(box, convex).pieces()).rings();
    std::sort(rings.begin(), rings.end(),
              [](const Polygon& a, const Polygon& b) { return before(a[0], b[0]); });
    std::vector<PolygonWithHoles> parts;
    for (Polygon& ring : rings) {
        if (signedArea(ring) >= 0.0) continue;
        std::reverse(ring.begin() + 1, ring.end());
        parts.push_back({std::move(ring), {}});
    }
    for (Polygon& ring : rings) {
        if (ring.empty()) continue;
        PolygonWithHoles* around = nullptr;
        for (PolygonWithHoles& part : parts)
            if (containsPoint(part.outline, beside(ring)) &&
                (around == nullptr || signedArea(part.outline) < signedArea(around->outline)))
                around = &part;
        if (around == nullptr) continue;
        std::reverse(ring.begin() + 1, ring.end());
        around->holes.push_back(std::move(ring));
    }
    return parts;
}

}  // namespace muster
