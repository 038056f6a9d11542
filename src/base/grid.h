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

/// Square cells covering a box, row-major from the lower left. Values sit at cell centres.
struct Grid {
    Vec2 origin;              ///< Lower left corner of cell (0, 0) [m].
    double cell = 0.25;       ///< Edge of a cell [m] > 0.
    std::int32_t width = 0;   ///< Columns.
    std::int32_t height = 0;  ///< Rows.

    /// The smallest grid of cells of edge `cell` [m] that covers `box`.
    static Grid covering(const Box& box, double cell);

    std::int32_t count() const { return width * height; }  ///< Number of cells.
    /// Index of a cell that lies inside.
    std::int32_t index(Cell c) const { return c.y * width + c.x; }
    /// The cell with that index.
    Cell at(std::int32_t index) const { return {index % width, index / width}; }
    /// True where the cell exists.
    bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < width && c.y < height; }
    /// The cell that holds `p`; may lie outside. Coordinates beyond 1e9 cells are clamped.
    Cell cellOf(Vec2 p) const { return {floorOf((p.x - origin.x) / cell), floorOf((p.y - origin.y) / cell)}; }
    /// The existing cell nearest to `p`.
    Cell nearestCell(Vec2 p) const {
        return {static_cast<std::int32_t>(bounded((p.x - origin.x) / cell, 0.0, width - 1.0)),
                static_cast<std::int32_t>(bounded((p.y - origin.y) / cell, 0.0, height - 1.0))};
    }
    /// As std::clamp(), but by value: what it gives stays in a register.
    static double bounded(double value, double low, double high) {
        const double raised = value < low ? low : value;
        return high < raised ? high : raised;
    }
    /// Centre of a cell [m].
    Vec2 centre(Cell c) const { return {origin.x + (c.x + 0.5) * cell, origin.y + (c.y + 0.5) * cell}; }
    /// The box covered.
    Box box() const { return {origin, {origin.x + width * cell, origin.y + height * cell}}; }

    /// Lets an archive read or write the grid.
    template <class Archive>
    void visit(Archive& archive) {
        archive(origin, cell, width, height);
    }
    friend bool operator==(const Grid&, const Grid&) = default;

private:
    // floor() is a call on plain x86-64; a truncation and a correction are not.
    static std::int32_t floorOf(double coordinate) {
        const double held = bounded(coordinate, -1e9, 1e9);
        const auto whole = static_cast<std::int32_t>(held);
        return whole - (static_cast<double>(whole) > held ? 1 : 0);
    }
};

}  // namespace muster
