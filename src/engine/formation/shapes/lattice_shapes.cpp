// Shapes filled by a triangular lattice: circle, Pacman and any outline.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/maths.h"
#include "engine/formation/shapes/formation_shape.h"

namespace muster {
namespace {

// A lattice point that a shape may use.
struct LatticePoint {
    double key = 0.0;  // Key; points with smaller keys are used first.
    Vec2 position;     // Position [spacings].

    friend bool operator<(const LatticePoint& a, const LatticePoint& b) {
        if (a.key != b.key) return a.key < b.key;
        if (a.position.x != b.position.x) return a.position.x > b.position.x;
        return a.position.y < b.position.y;
    }
};

// Distance between rows of the triangular lattice [spacings]; rows lie along x, so that ranks are staggered.
const double kRow = 0.86602540378443865;

// The `count` lattice points nearest to the origin for which `accept(p)`; in spacings.
template <class Accept>
std::vector<Vec2> nearestLatticePoints(std::int32_t count, double reach, Accept accept) {
    std::vector<LatticePoint> found;
    const auto rows = static_cast<std::int32_t>(std::ceil(reach / kRow));
    const auto columns = static_cast<std::int32_t>(std::ceil(reach)) + 1;
    for (std::int32_t j = -rows; j <= rows; ++j) {
        for (std::int32_t i = -columns; i <= columns; ++i) {
            const Vec2 p{i + (j % 2 != 0 ? 0.5 : 0.0), j * kRow};
            // The key is rounded, so that points at equal distances compare as equal on every machine.
            if (length(p) <= reach && accept(p))
                found.push_back({std::floor(lengthSquared(p) * 1024.0 + 0.5), p});
        }
    }
    std::sort(found.begin(), found.end());
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < found.size() && std::cmp_less(k, count); ++k)
        points.push_back(found[k].position);
    return points;
}

// A radius at which a sector of angle `angle` holds at least `count` lattice points.
double reachFor(std::int32_t count, double angle) {
    return std::min(std::sqrt(2.0 * count / angle) + 4.0, static_cast<double>(count) + 1.0);
}

double farthest(const std::vector<Vec2>& points) {
    double most = 0.0;
    for (const Vec2 p : points) most = std::max(most, length(p));
    return most;
}

// Intersections of a scaled outline with horizontal lines (scanline fill).
class Scanline {
public:
    explicit Scanline(const PolygonWithHoles& shape) : shape_(shape) {}

    // Crossings of the line at `y` with all edges of the shape times `scale`, in ascending order.
    void cut(double y, double scale, std::vector<double>& crossings) const {
        crossings.clear();
        add(shape_.outline, y, scale, crossings);
        for (const Polygon& hole : shape_.holes) add(hole, y, scale, crossings);
        std::sort(crossings.begin(), crossings.end());
    }

    // True where `x` lies inside, at least `margin` from the crossings.
    static bool inside(const std::vector<double>& crossings, double x, double margin) {
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
            if (x >= crossings[k] + margin && x <= crossings[k + 1] - margin) return true;
        return false;
    }

private:
    static void add(const Polygon& polygon, double y, double scale, std::vector<double>& crossings) {
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Vec2 a = polygon[k] * scale;
            const Vec2 b = polygon[(k + 1) % polygon.size()] * scale;
            if ((a.y <= y) == (b.y <= y)) continue;
            crossings.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
        }
    }

    const PolygonWithHoles& shape_;
};

constexpr double kOutlineMargin = 0.35;  // Least distance of places from the outline, in spacings.

// Lattice points inside the shape times `scale`, with a margin in the four directions of the axes.
std::vector<Vec2> latticeInside(const PolygonWithHoles& shape, double scale) {
    const Scanline scanline(shape);
    const Box box = boundsOf(shape.outline);
    std::vector<Vec2> points;
    std::array<std::vector<double>, 3> lines;
    const double rows = std::ceil(std::max(-box.min.y, box.max.y) * scale / kRow);
    for (double j = -rows; j <= rows; j += 1.0) {
        const double y = j * kRow;
        for (std::size_t k = 0; k < 3; ++k)
            scanline.cut(y + (static_cast<double>(k) - 1.0) * kOutlineMargin, scale, lines[k]);
        const double shift = std::fabs(j - 2.0 * std::floor(j / 2.0)) > 0.5 ? 0.5 : 0.0;
        for (std::size_t k = 0; k + 1 < lines[1].size(); k += 2) {
            const double last = lines[1][k + 1] - kOutlineMargin;
            for (double x = std::ceil(lines[1][k] + kOutlineMargin - shift) + shift; x <= last; x += 1.0)
                if (Scanline::inside(lines[0], x, 0.0) && Scanline::inside(lines[2], x, 0.0))
                    points.push_back({x, y});
        }
    }
    return points;
}

// The graph of neighbouring lattice points, from which points are removed.
class LatticeGraph {
public:
    // Points come row by row.
    explicit LatticeGraph(const std::vector<Vec2>& points)
        : points_(points), used_(points.size(), 1), count_(points.size()) {
        neighbours_.resize(points.size());
        for (std::size_t a = 0; a < points.size(); ++a) {
            for (std::size_t b = a + 1; b < points.size() && points[b].y - points[a].y < 1.5 * kRow; ++b) {
                if (distance(points[a], points[b]) > 1.01) continue;
                neighbours_[a].push_back(b);
                neighbours_[b].push_back(a);
            }
        }
        for (const auto& list : neighbours_) degree_.push_back(static_cast<std::int32_t>(list.size()));
    }

    std::size_t count() const { return count_; }
    bool isIsolated(std::size_t k) const { return degree_[k] == 0; }

    void remove(std::size_t k) {
        used_[k] = 0;
        --count_;
        for (const std::size_t n : neighbours_[k]) --degree_[n];
    }
    void removeIsolated() {
        for (std::size_t k = 0; k < points_.size(); ++k)
            if (used_[k] != 0 && isIsolated(k)) remove(k);
    }
    // The point with the fewest neighbours, among these the farthest from the origin, whose removal isolates
    // no other; the number of points where there is none.
    std::size_t mostExposed() const {
        std::size_t best = points_.size();
        const auto rank = [&](std::size_t k) {
            return -std::floor(lengthSquared(points_[k]) * 1024.0 + 0.5);
        };
        for (std::size_t k = 0; k < points_.size(); ++k) {
            if (used_[k] == 0) continue;
            const bool better = best == points_.size() || degree_[k] < degree_[best] ||
                                (degree_[k] == degree_[best] && rank(k) < rank(best));
            if (better && !isolates(k)) best = k;
        }
        return best;
    }
    std::vector<Vec2> used() const {
        std::vector<Vec2> points;
        for (std::size_t k = 0; k < points_.size(); ++k)
            if (used_[k] != 0) points.push_back(points_[k]);
        return points;
    }

private:
    bool isolates(std::size_t k) const {
        return std::any_of(neighbours_[k].begin(), neighbours_[k].end(),
                           [&](std::size_t n) { return used_[n] != 0 && degree_[n] == 1; });
    }

    const std::vector<Vec2>& points_;
    std::vector<std::uint8_t> used_;
    std::size_t count_;
    std::vector<std::vector<std::size_t>> neighbours_;
    std::vector<std::int32_t> degree_;
};

// Exactly `count` of the lattice points inside the scaled shape, each with a neighbour; empty where there are
// none at this scale.
std::vector<Vec2> fillShape(const PolygonWithHoles& shape, double scale, std::size_t count) {
    std::vector<Vec2> points = latticeInside(shape, scale);
    if (count == 1 || points.size() < count) {
        points.resize(std::min(points.size(), count));
        return points.size() == count ? points : std::vector<Vec2>{};
    }
    LatticeGraph graph(points);
    graph.removeIsolated();
    while (graph.count() > count) {
        const std::size_t k = graph.mostExposed();
        if (k == points.size()) return {};
        graph.remove(k);
    }
    return graph.count() == count ? graph.used() : std::vector<Vec2>{};
}

}  // namespace

FormationShape circleShape(std::int32_t count, double spacing) {
    FormationShape shape;
    shape.places = nearestLatticePoints(count, reachFor(count, 2.0 * kPi), [](Vec2) { return true; });
    // The outline is a circle about the mean of the places.
    Vec2 mean;
    for (Vec2& p : shape.places) mean += p = p * spacing;
    mean = mean / static_cast<double>(count);
    const double radius = farthest(shape.places) + length(mean) + 0.5 * spacing;
    const double sides = 36.0;
    for (double k = 0.0; k < sides; k += 1.0) {
        const double angle = 2.0 * kPi * k / sides;
        shape.outline.outline.push_back(mean +
                                        Vec2{cosine(angle), sine(angle)} * (radius / cosine(kPi / sides)));
    }
    return shape;
}

FormationShape pacmanShape(std::int32_t count, double spacing, double opening) {
    FormationShape shape;
    const Vec2 lip{cosine(0.5 * opening), sine(0.5 * opening)};
    const double angle = 2.0 * kPi - opening;
    // A place may lie in the mouth by less than a third of a spacing.
    const auto accept = [&](Vec2 p) {
        const Vec2 q{p.x, std::fabs(p.y)};
        const double along = dot(q, lip);
        const double inside = cross(lip, q);
        return inside >= 0.0 || (along > 0.0 ? -inside : length(q)) <= 0.3;
    };
    double reach = reachFor(count, angle);
    do {
        shape.places = nearestLatticePoints(count, reach, accept);
        reach *= 1.3;
    } while (std::cmp_less(shape.places.size(), count));
    for (Vec2& p : shape.places) p = p * spacing;
    const double radius = farthest(shape.places) + 0.5 * spacing;
    // The mouth of the mesh is half a spacing from the places beside it.
    const double start = opening < kPi ? 0.5 * spacing / lip.y : radius;
    if (opening >= kPi || start > 0.7 * radius) {
        shape.outline.outline = grownHull(shape.places, 0.5 * spacing);
        return shape;
    }
    const double half = 0.5 * opening - arcTangent2(0.5 * spacing, radius);
    const double parts = 40.0;
    shape.outline.outline.push_back({start, 0.0});
    for (double k = 0.0; k <= parts; k += 1.0) {
        const double a = half + (2.0 * kPi - 2.0 * half) * (k / parts);
        shape.outline.outline.push_back(Vec2{cosine(a), sine(a)} * (radius * 1.004));
    }
    return shape;
}

Result<FormationShape> outlineShape(std::int32_t count, double spacing, const PolygonWithHoles& outline) {
    const Vec2 middle = centroid(outline.outline);
    PolygonWithHoles unit;
    double area = signedArea(outline.outline);
    for (const Polygon& hole : outline.holes) area -= std::fabs(signedArea(hole));
    if (!(area > 1e-9)) return invalidArgument("the outline's holes leave no area");
    // Size of the shape in spacings, with the area of one lattice cell per place.
    const double size = std::sqrt(count * kRow / area);
    for (const Vec2 p : outline.outline) unit.outline.push_back((p - middle) * size);
    for (const Polygon& hole : outline.holes) {
        unit.holes.emplace_back();
        for (const Vec2 p : hole) unit.holes.back().push_back((p - middle) * size);
    }

    double high = 1.0;
    while (high < 60.0 && std::cmp_less(latticeInside(unit, high).size(), count)) high *= 1.25;
    if (high >= 60.0)
        return invalidArgument("the outline is too thin to hold " + std::to_string(count) + " places");
    double low = high / 1.25;
    for (int k = 0; k < 24; ++k) {
        const double scale = 0.5 * (low + high);
        (std::cmp_less(latticeInside(unit, scale).size(), count) ? low : high) = scale;
    }
    FormationShape shape;
    // At a few scales there is no such set of points.
    while ((shape.places = fillShape(unit, high, count)).empty() && high < 60.0) high *= 1.01;
    if (shape.places.empty())
        return invalidArgument("the outline is too thin to hold " + std::to_string(count) + " places");
    for (Vec2& p : shape.places) p = p * spacing;
    for (Vec2& p : unit.outline) p = p * (high * spacing);
    for (Polygon& hole : unit.holes)
        for (Vec2& p : hole) p = p * (high * spacing);
    shape.outline = std::move(unit);
    return shape;
}

}  // namespace muster
