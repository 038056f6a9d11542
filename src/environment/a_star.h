// A* on the eight-connected ground cells (Hart, Nilsson and Raphael 1968) with the octile distance as
// heuristic.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/grid.h"

namespace muster {

/// Owns the working memory, so repeated searches do not allocate.
class AStar {
public:
    /// Cells from `start` to `goal`, both included, through cells with a clearance of at least `radius` [m];
    /// empty where there is no path or more than `maxCells` cells would be expanded. Diagonal steps need both
    /// orthogonal neighbours free. Ties go to the lower index, so the answer is always the same.
    std::span<const std::int32_t> run(const Grid& grid, std::span<const float> clearance, double radius,
                                      std::int32_t start, std::int32_t goal, std::int32_t maxCells);

private:
    struct Open {
        double estimate;  // Cost so far plus heuristic [cells].
        std::int32_t cell;
    };
    struct ComesLater {
        bool operator()(const Open& a, const Open& b) const {
            return a.estimate != b.estimate ? a.estimate > b.estimate : a.cell > b.cell;
        }
    };
    void relax(std::int32_t cell, std::int32_t from, double cost, double heuristic);
    void traceBack(std::int32_t start, std::int32_t goal);

    std::vector<double> cost_;           // Per cell, from the start [cells].
    std::vector<std::int32_t> parent_;   // Per cell, the one before it on the path.
    std::vector<std::uint32_t> seen_;    // Per cell, equal to run_ where cost_ and parent_ are set.
    std::vector<std::uint32_t> closed_;  // Per cell, equal to run_ where it is expanded.
    std::uint32_t run_ = 0;              // Number of the search.
    std::vector<Open> open_;             // A heap.
    std::vector<std::int32_t> path_;
};

}  // namespace muster
