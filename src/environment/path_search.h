// A* on the ground cells.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/grid.h"

namespace muster {

/// Owns the working memory, so repeated searches do not allocate.
class PathSearch {
public:
    /// Cells from `start` to `goal`, both included, through cells of enough clearance; empty where
    /// there is no way or more than `maxCells` cells would be looked at. Diagonal steps need both
    /// cells beside them free. Ties go to the lower index, so the answer is always the same.
    std::span<const std::int32_t> run(const Grid& grid, std::span<const float> clearance, double radius,
                                      std::int32_t start, std::int32_t goal, std::int32_t maxCells);

private:
    struct Open {
        double total;  // Cost so far and the least cost to come [cells].
        std::int32_t cell;
    };
    void reach(std::int32_t cell, std::int32_t from, double cost, double rest);
    void traceBack(std::int32_t start, std::int32_t goal);

    std::vector<double> cost_;
    std::vector<std::int32_t> from_;
    std::vector<std::uint32_t> seen_;    // Equal to run_ where cost_ and from_ hold.
    std::vector<std::uint32_t> closed_;  // Equal to run_ where settled.
    std::uint32_t run_ = 0;
    std::vector<Open> open_;
    std::vector<std::int32_t> path_;
};

}  // namespace muster
