// Lengths of shortest paths among polygons, by a visibility graph; independent of Muster's own searches.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "muster/ground.h"

namespace muster::testing {

/// Shortest paths of points in the plane among polygons.
class VisibilityGraph {
public:
    explicit VisibilityGraph(const std::vector<ObstacleDef>& obstacles) : obstacles_(obstacles) {
        for (const ObstacleDef& obstacle : obstacles_)
            for (const Vec2 p : obstacle.polygon) corners_.push_back(p);
    }

    /// Lengths from `source` to every corner, for lengthTo() [m].
    std::vector<double> lengthsFrom(Vec2 source) const {
        constexpr double kFar = std::numeric_limits<double>::infinity();
        std::vector<double> length(corners_.size(), kFar);
        std::vector<bool> done(corners_.size(), false);
        for (std::size_t i = 0; i < corners_.size(); ++i)
            if (sees(source, corners_[i])) length[i] = distance(source, corners_[i]);
        for (;;) {
            std::size_t best = corners_.size();
            for (std::size_t i = 0; i < corners_.size(); ++i)
                if (!done[i] && length[i] < kFar && (best == corners_.size() || length[i] < length[best]))
                    best = i;
            if (best == corners_.size()) return length;
            done[best] = true;
            for (std::size_t i = 0; i < corners_.size(); ++i)
                if (!done[i] && length[best] + distance(corners_[best], corners_[i]) < length[i] &&
                    sees(corners_[best], corners_[i]))
                    length[i] = length[best] + distance(corners_[best], corners_[i]);
        }
    }

    /// Length of the shortest path to `p` from the source of `lengths` [m]; infinite where there is none.
    double lengthTo(Vec2 p, Vec2 source, const std::vector<double>& lengths) const {
        double least = sees(source, p) ? distance(source, p) : std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < corners_.size(); ++i)
            if (lengths[i] + distance(corners_[i], p) < least && sees(corners_[i], p))
                least = lengths[i] + distance(corners_[i], p);
        return least;
    }

    /// True where the segment crosses the inside of no polygon (all are convex).
    bool sees(Vec2 a, Vec2 b) const {
        for (const ObstacleDef& obstacle : obstacles_) {
            double enter = 0.0, leave = 1.0;
            const auto& polygon = obstacle.polygon;
            for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
                const Vec2 edge = polygon[i] - polygon[j];
                const double atA = cross(edge, a - polygon[j]) - kSlack;
                const double atB = cross(edge, b - polygon[j]) - kSlack;
                if (atA <= 0.0 && atB <= 0.0) {
                    leave = -1.0;
                    break;
                }
                if (atA < 0.0) enter = std::max(enter, atA / (atA - atB));
                if (atB < 0.0) leave = std::min(leave, atA / (atA - atB));
            }
            if (leave > enter) return false;
        }
        return true;
    }

private:
    static constexpr double kSlack = 1e-6;

    std::vector<ObstacleDef> obstacles_;
    std::vector<Vec2> corners_;
};

}  // namespace muster::testing
