// Regular grids over the ground plane.
#pragma once

#include <cstdint>

#include "muster/vec2.h"

namespace muster {

/// A cell by column and row.
struct Cell {
    std::int32_t x = 0;  ///< Column, 0 at the left.
    std::int32_t y = 0;  ///< Row, 0 at the bottom.
    friend bool operator==(const Cell&, const Cell&) = default;
};

/// Square cells in rows, row-major from the lower left. Values belong to cell centres.
struct Grid {
    Vec2 origin;              ///< Lower left corner of cell (0, 0) [m].
    double cell = 0.25;       ///< Edge of a cell [m], > 0.
    std::int32_t width = 0;   ///< Columns.
    std::int32_t height = 0;  ///< Rows.

    /// The smallest grid of cells of edge `cell` [m] that covers `box`.
    static Grid covering(const Box& box, double cell);

    std::int32_t count() const { return width * height; }  ///< Number of cells.
    /// Row-major index of a cell of the grid.
    std::int32_t index(Cell c) const { return c.y * width + c.x; }
    /// The cell of an index.
    Cell at(std::int32_t index) const { return {index % width, index / width}; }
    /// True for a cell of the grid.
    bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < width && c.y < height; }
    /// The cell that contains `p`; it may lie outside the grid. Coordinates are clamped to 1e9 cells.
    Cell cellOf(Vec2 p) const { return {floorOf((p.x - origin.x) / cell), floorOf((p.y - origin.y) / cell)}; }
    /// The cell of the grid that is nearest to `p`.
    Cell nearestCell(Vec2 p) const {
        return {static_cast<std::int32_t>(bounded((p.x - origin.x) / cell, 0.0, width - 1.0)),
                static_cast<std::int32_t>(bounded((p.y - origin.y) / cell, 0.0, height - 1.0))};
    }
    /// std::clamp() by value, so that the result stays in a register.
    static double bounded(double value, double low, double high) {
        const double raised = value < low ? low : value;
        return high < raised ? high : raised;
    }
    /// Centre of a cell [m].
    Vec2 centre(Cell c) const { return {origin.x + (c.x + 0.5) * cell, origin.y + (c.y + 0.5) * cell}; }
    /// The box that the cells cover.
    Box box() const { return {origin, {origin.x + width * cell, origin.y + height * cell}}; }

    /// Lets an archive read or write the grid.
    template <class Archive>
    void visit(Archive& archive) {
        archive(origin, cell, width, height);
    }
    friend bool operator==(const Grid&, const Grid&) = default;

private:
    // The floor by truncation and correction: std::floor() is a function call on plain x86-64.
    static std::int32_t floorOf(double coordinate) {
        const double clamped = bounded(coordinate, -1e9, 1e9);
        const auto whole = static_cast<std::int32_t>(clamped);
        return whole - (static_cast<double>(whole) > clamped ? 1 : 0);
    }
};

}  // namespace muster
