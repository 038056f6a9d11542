// Exact geodesics among obstacles grown by a character's radius: a visibility graph, independent of any grid.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/maths.h"
#include "muster/vec2.h"

namespace muster::test {

/// Convex polygons (counter-clockwise) and discs (one corner, grown further by `extra`).
struct Shape {
    std::vector<Vec2> corners;
    double extra = 0.0;

    /// Distance from `p` to the surface, negative inside.
    double signedDistance(Vec2 p) const {
        if (corners.size() == 1) return distance(p, corners[0]) - extra;
        double best = std::numeric_limits<double>::infinity();
        bool inside = true;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec2 a = corners[k];
            const Vec2 b = corners[(k + 1) % corners.size()];
            best = std::min(best, pointSegment(p, a, b));
            if (cross(b - a, p - a) < 0.0) inside = false;
        }
        return inside ? -best : best;
    }
    /// Least distance from the segment to the surface; 0 or less where it enters.
    double segmentDistance(Vec2 p, Vec2 q) const {
        if (corners.size() == 1) return pointSegment(corners[0], p, q) - extra;
        double best = std::min(signedDistance(p), signedDistance(q));
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec2 a = corners[k];
            const Vec2 b = corners[(k + 1) % corners.size()];
            const bool apart = cross(b - a, p - a) * cross(b - a, q - a) > 0.0 ||
                               cross(q - p, a - p) * cross(q - p, b - p) > 0.0;
            best = std::min(best, apart ? pointSegment(a, p, q) : 0.0);
        }
        return best;
    }
    static double pointSegment(Vec2 p, Vec2 a, Vec2 b) {
        const double l2 = lengthSquared(b - a);
        const double t = l2 > 0.0 ? std::clamp(dot(p - a, b - a) / l2, 0.0, 1.0) : 0.0;
        return distance(p, lerp(a, b, t));
    }
};

/// Shortest paths of a disc of `radius` among shapes.
class GeodesicOracle {
public:
    GeodesicOracle(std::vector<Shape> shapes, double radius, Vec2 source)
        : shapes_(std::move(shapes)), radius_(radius) {
        nodes_.push_back(source);
        for (const Shape& shape : shapes_) addArcs(shape);
        solve();
    }
    /// Distance to the nearest surface.
    double clearance(Vec2 p) const {
        double best = std::numeric_limits<double>::infinity();
        for (const Shape& shape : shapes_) best = std::min(best, shape.signedDistance(p));
        return best;
    }
    /// Length of the shortest path from the source.
    double cost(Vec2 p) const {
        double best = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < nodes_.size(); ++k) {
            const double path = costs_[k] + distance(nodes_[k], p);
            if (path < best && sees(nodes_[k], p)) best = path;
        }
        return best;
    }

private:
    static constexpr double kSlack = 1e-3;  // Chords of the arcs lie this much inside.

    bool sees(Vec2 a, Vec2 b) const {
        return std::all_of(shapes_.begin(), shapes_.end(),
                           [&](const Shape& s) { return s.segmentDistance(a, b) >= radius_ - kSlack; });
    }
    void addArcs(const Shape& shape) {
        constexpr int kAround = 120;
        for (std::size_t k = 0; k < shape.corners.size(); ++k) {
            const std::size_t n = shape.corners.size();
            const Vec2 corner = shape.corners[k];
            for (int i = 0; i < kAround; ++i) {
                const double angle = 2.0 * kPi * i / kAround;
                const double r = radius_ + shape.extra;
                const Vec2 out{std::cos(angle), std::sin(angle)};
                const bool outside = n == 1 || (dot(out, corner - shape.corners[(k + 1) % n]) >= -1e-9 &&
                                                dot(out, corner - shape.corners[(k + n - 1) % n]) >= -1e-9);
                const Vec2 p = corner + out * r;
                if (outside && clearance(p) >= radius_ - 1e-9) nodes_.push_back(p);
            }
        }
    }
    void solve() {
        costs_.assign(nodes_.size(), std::numeric_limits<double>::infinity());
        std::vector<bool> done(nodes_.size(), false);
        costs_[0] = 0.0;
        for (std::size_t round = 0; round < nodes_.size(); ++round) {
            std::size_t best = nodes_.size();
            for (std::size_t k = 0; k < nodes_.size(); ++k) {
                if (!done[k] && (best == nodes_.size() || costs_[k] < costs_[best])) best = k;
            }
            done[best] = true;
            for (std::size_t k = 0; k < nodes_.size(); ++k) {
                const double path = costs_[best] + distance(nodes_[best], nodes_[k]);
                if (!done[k] && path < costs_[k] && sees(nodes_[best], nodes_[k])) costs_[k] = path;
            }
        }
    }

    std::vector<Shape> shapes_;
    double radius_;
    std::vector<Vec2> nodes_;
    std::vector<double> costs_;
};

}  // namespace muster::test
