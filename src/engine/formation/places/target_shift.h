// Where the targets of a group settle that stands on the spot of others: beside them.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/cell_list.h"
#include "muster/vec2.h"

namespace muster {

/// Finds the shift that takes the points of one group out of those of others.
class TargetShift {
public:
    /// Starts with the points of a group [m], which must outlive the queries, and no others. Keeps its
    /// memory.
    void begin(std::span<const Vec2> points) {
        points_ = points;
        others_.clear();
    }
    /// Adds the points of another group [m], which must outlive the queries.
    void add(std::span<const Vec2> others) { others_.push_back(others); }

    /// True where a shifted point is nearer than `distance` [m] to a point of another group.
    bool clashes(Vec2 shift, double distance);
    /// The least shift of all points, in one of 16 directions, after which all are at least `distance` [m]
    /// from the other groups: beyond the line that holds up each of them (its support line), `gap` [m] apart.
    /// Directions in which fewer than nine points in ten are free come last.
    Vec2 find(double distance, double gap, const std::function<bool(Vec2)>& isFree);

private:
    struct Candidate {
        Vec2 shift;
        double length;
        bool free;
    };

    bool clashes(std::span<const Vec2> others, Vec2 shift, double distance);
    double clearLength(Vec2 direction, double distance, double gap);
    bool mostlyFree(Vec2 shift, const std::function<bool(Vec2)>& isFree) const;

    std::span<const Vec2> points_;
    std::vector<std::span<const Vec2>> others_;
    std::vector<Vec2> together_;  // Shifted points, then those of another group [m].
    CellList cells_;
};

}  // namespace muster
