// The ground as an operator sees it: blocks, and shortest ways round them.
#pragma once

#include <span>
#include <vector>

#include "muster/vec2.h"

namespace muster {

/// Shortest ways of a crowd's middle among boxes. They keep a margin, and go straight where they can.
class SeenGround {
public:
    /// `margin`: how far ways stay off blocks [m].
    SeenGround(std::span<const Box> blocks, const Box& border, double margin);

    /// True where the straight line keeps off all blocks; a point within the margin counts as outside it.
    bool clear(Vec2 a, Vec2 b) const;
    /// Length of the shortest way [m].
    double distance(Vec2 a, Vec2 b) const;
    /// The narrowest part of the way of a front from `a` to `b`.
    struct Narrow {
        double least = 0.0;  ///< Width of the way at its narrowest point [m].
        /// Distance from `a` at which it is narrow for the last time, above 0; 0 for never [m].
        double end = 0.0;
    };
    /// Looks along the way of a front.
    Narrow narrowest(Vec2 a, Vec2 b, double width) const;
    /// Appends the corners of the shortest way behind `a`, `b` included.
    void appendWay(Vec2 a, Vec2 b, std::vector<Vec2>& way) const;

private:
    struct Best {
        double length = 0.0;
        std::ptrdiff_t first = -1;  // Corner behind `a`, and the one before `b`; -1 for a straight line.
        std::ptrdiff_t last = -1;
    };
    Best best(Vec2 a, Vec2 b) const;
    void joinCorners();

    Box border_;
    std::vector<Box> blocks_;           // Blocks grown by a little less than the margin.
    std::vector<Vec2> corners_;         // Corners of blocks grown by the margin, inside the border.
    std::vector<double> lengths_;       // Lengths of the shortest ways between all corners, in rows [m].
    std::vector<std::ptrdiff_t> next_;  // The corner after the row's on the way to the column's.
};

}  // namespace muster
