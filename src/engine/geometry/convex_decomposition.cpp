#include "engine/geometry/triangulation.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/polygon.h"

namespace muster {
namespace {

using Loop = std::vector<std::int32_t>;  // Corner indices, counter-clockwise.

struct Diagonal {
    std::int32_t from;
    std::int32_t to;
};

// Ear clipping of a simple polygon (Meisters 1975).
class EarClipper {
public:
    explicit EarClipper(const Polygon& corners) : corners_(corners) {
        for (std::size_t i = 0; i < corners.size(); ++i) rest_.push_back(static_cast<std::int32_t>(i));
    }

    void run() {
        while (rest_.size() >= 3) {
            if (dropStraightCorner()) continue;
            clip(rest_.size() == 3 ? 1 : bestEar());
        }
    }

    std::vector<Loop> triangles;
    std::vector<Diagonal> diagonals;

private:
    Vec2 corner(std::size_t at) const { return corners_[rest_[at % rest_.size()]]; }
    Vec2 before(std::size_t at) const { return corner(at + rest_.size() - 1); }
    Vec2 after(std::size_t at) const { return corner(at + 1); }

    // A corner on the straight line between its neighbours bounds no area.
    bool dropStraightCorner() {
        for (std::size_t i = 0; i < rest_.size(); ++i) {
            if (orientation(before(i), corner(i), after(i)) != 0) continue;
            rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(i));
            if (rest_.size() < 3) rest_.clear();
            return true;
        }
        return false;
    }

    bool isEar(std::size_t at) const {
        const Vec2 a = before(at), b = corner(at), c = after(at);
        if (orientation(a, b, c) <= 0) return false;
        const std::size_t count = rest_.size();
        for (std::size_t step = 2; step + 1 < count; ++step) {
            const Vec2 p = corner(at + step);
            if (orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0)
                return false;
        }
        return true;
    }

    // The ear with the shortest diagonal, since short diagonals keep the parts compact; the first of equal
    // ones.
    std::size_t bestEar() {
        order_.clear();
        for (std::size_t i = 0; i < rest_.size(); ++i) {
            if (orientation(before(i), corner(i), after(i)) > 0) {
                order_.push_back({lengthSquared(after(i) - before(i)), i});
            }
        }
        std::sort(order_.begin(), order_.end());
        for (const auto& [length, at] : order_) {
            if (isEar(at)) return at;
        }
        MUSTER_ASSERT(false);  // A simple polygon always has an ear (Meisters 1975).
        return order_.empty() ? 1 : order_.front().second;
    }

    void clip(std::size_t at) {
        const std::size_t count = rest_.size();
        const std::int32_t a = rest_[(at + count - 1) % count], b = rest_[at], c = rest_[(at + 1) % count];
        triangles.push_back({a, b, c});
        if (count > 3) diagonals.push_back({a, c});
        rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(at));
        if (rest_.size() < 3) rest_.clear();
    }

    const Polygon& corners_;
    Loop rest_;
    std::vector<std::pair<double, std::size_t>> order_;
};

// The position in `loop` at which the edge from -> to starts, or -1.
std::ptrdiff_t findEdge(const Loop& loop, std::int32_t from, std::int32_t to) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        if (loop[i] == from && loop[(i + 1) % loop.size()] == to) return static_cast<std::ptrdiff_t>(i);
    }
    return -1;
}

// Joins two loops at their shared edge, which starts at position `i` of `first` and, reversed, at position
// `j` of `second`.
Loop joinLoops(const Loop& first, std::size_t i, const Loop& second, std::size_t j) {
    Loop joined;
    for (std::size_t k = 1; k <= first.size(); ++k) joined.push_back(first[(i + k) % first.size()]);
    for (std::size_t k = 2; k < second.size(); ++k) joined.push_back(second[(j + k) % second.size()]);
    return joined;
}

bool loopIsConvex(const Polygon& corners, const Loop& loop) {
    const std::size_t count = loop.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (orientation(corners[loop[i]], corners[loop[(i + 1) % count]], corners[loop[(i + 2) % count]]) <
            0) {
            return false;
        }
    }
    return true;
}

// Removes a diagonal where the union of the parts on both its sides is convex (Hertel and Mehlhorn 1983).
void tryMerge(const Polygon& corners, std::vector<Loop>& parts, Diagonal diagonal) {
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const std::ptrdiff_t i = findEdge(parts[p], diagonal.from, diagonal.to);
        if (i < 0) continue;
        for (std::size_t q = 0; q < parts.size(); ++q) {
            const std::ptrdiff_t j = q == p ? -1 : findEdge(parts[q], diagonal.to, diagonal.from);
            if (j < 0) continue;
            Loop joined = joinLoops(parts[p], static_cast<std::size_t>(i), parts[q],
                                    static_cast<std::size_t>(j));
            if (!loopIsConvex(corners, joined)) return;
            parts[std::min(p, q)] = std::move(joined);
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(std::max(p, q)));
            return;
        }
    }
}

Polygon toPolygon(const Polygon& corners, const Loop& loop) {
    Polygon polygon;
    const std::size_t count = loop.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 a = corners[loop[(i + count - 1) % count]], b = corners[loop[i]],
                   c = corners[loop[(i + 1) % count]];
        if (orientation(a, b, c) != 0) polygon.push_back(b);
    }
    return polygon;
}

}  // namespace

Result<std::vector<Polygon>> decomposeConvex(std::span<const Vec2> polygon) {
    Result<Polygon> clean = cleanPolygon(polygon);
    if (!clean.ok()) return clean.status();
    const Polygon& corners = *clean;
    if (isConvex(corners)) return std::vector<Polygon>{corners};
    EarClipper clipper(corners);
    clipper.run();
    // Long diagonals go first, so that compact parts remain.
    std::stable_sort(clipper.diagonals.begin(), clipper.diagonals.end(), [&](Diagonal a, Diagonal b) {
        return lengthSquared(corners[a.to] - corners[a.from]) >
               lengthSquared(corners[b.to] - corners[b.from]);
    });
    std::vector<Loop> parts = std::move(clipper.triangles);
    for (Diagonal diagonal : clipper.diagonals) tryMerge(corners, parts, diagonal);
    std::vector<Polygon> result;
    for (const Loop& part : parts) result.push_back(toPolygon(corners, part));
    return result;
}

}  // namespace muster
