// The ground as routes see it: the point where a disc can stand in a cell, and the straight steps that it can
// take.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/cell_rect.h"
#include "engine/ground/environment/environment.h"

namespace muster {

/// A segment that a route may not cross.
struct ClosedLine {
    Vec2 a;  ///< One end [m].
    Vec2 b;  ///< The other end [m].
};

/// Answers by exact geometry wherever the raster of clearances does not decide.
class RouteGround {
public:
    RouteGround() = default;
    /// The ground for discs of `radius` [m]. Moving obstacles count, at their present positions, only if
    /// `moving`. The environment and the lines must outlive it; an edit makes it invalid.
    RouteGround(const Environment& environment, double radius, std::span<const ClosedLine> closed = {},
                bool moving = false);

    const Environment& environment() const { return *environment_; }  ///< The given environment.
    const Grid& grid() const { return grid_; }                        ///< The ground cells.
    /// Radius used for lines [m]: slightly below that of the discs.
    double radius() const { return radius_; }

    /// True where the centre of the cell is free, with some room: a disc stands at the centre then.
    bool isFree(std::int32_t cell) const { return clearance_[cell] >= freeClearance_; }
    /// True where a disc may stand somewhere in the cell, by the raster.
    bool mayHoldPoint(std::int32_t cell) const { return clearance_[cell] >= radius_ - halfDiagonal_; }
    /// True where all lines between points of the cells are clear, by the raster.
    bool isOpen(const CellRect& cells) const;
    /// A point of the cell, or just beside it, at which a disc can stand: its centre, or, where that has
    /// little room, the point near by with most room.
    std::optional<Vec2> standPoint(Cell c) const;
    /// The point of the cell, or just beside it, with most room among those to which obstacles push `start`.
    std::optional<Vec2> roomiest(Cell c, Vec2 start) const;
    /// The point with most room within a cell's edge of `start` along each axis.
    std::optional<Vec2> roomiest(Vec2 start) const;
    /// True where a disc can walk straight from `a` to `b`.
    bool lineClear(Vec2 a, Vec2 b) const;
    /// The point over which a disc steps from the stand point of a cell to that of a neighbour: half way, or
    /// a point beside that from which both are in sight. None where there is no such step.
    std::optional<Vec2> stepPoint(Cell a, Vec2 pointA, Cell b, Vec2 pointB) const;
    /// True where there is such a point.
    bool stepClear(Cell a, Vec2 pointA, Cell b, Vec2 pointB) const {
        return stepPoint(a, pointA, b, pointB).has_value();
    }
    /// True where the raster tells that a step between the centres of neighbouring cells is clear.
    bool stepClearByRaster(std::int32_t a, std::int32_t b, bool diagonal) const {
        return closed_.empty() && isClearByRaster(a, b, diagonal);
    }
    /// True where the line crosses or touches a closed line.
    bool crossesClosed(Vec2 a, Vec2 b) const;

private:
    // At any point of the step the clearance is at least half of the rest of the sum.
    bool isClearByRaster(std::int32_t a, std::int32_t b, bool diagonal) const {
        return clearance_[a] + clearance_[b] >= (diagonal ? diagonalSum_ : straightSum_);
    }
    std::optional<Vec2> roomiest(Vec2 start, Vec2 middle, double reach) const;
    double pushOut(Vec2& p, const Box& inner, double wanted, double share) const;

    const Environment* environment_ = nullptr;
    Grid grid_;
    double radius_ = 0.0;
    double
        // Greatest distance from the centre of a cell to a stand point along its diagonal [m].
        halfDiagonal_ = 0.0;
    double freeClearance_ = 0.0;  // Least clearance of free centres [m].
    double straightSum_ = 0.0, diagonalSum_ = 0.0;
    std::span<const ClosedLine> closed_;
    bool moving_ = false;
    std::span<const float> clearance_;
};

/// Makes a path shorter: each corner is joined to the last of the following points up to which the line is
/// clear, and remaining corners are cut. `points` holds both ends; neighbours see each other. `memory` is
/// working memory.
void pullTaut(const RouteGround& ground, std::vector<Vec2>& points, std::vector<Vec2>& memory);
/// The first half of pullTaut(): leaves points out.
void skipCorners(const RouteGround& ground, std::vector<Vec2>& points);
/// Length of a polyline [m].
double pathLength(std::span<const Vec2> points);

}  // namespace muster
