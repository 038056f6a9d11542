// Many points located on one mesh.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "muster/geometry.h"

namespace muster {

/// Finds the triangles of points by a grid over the mesh. Its answers are those of locate().
class MeshLocator {
public:
    /// Builds the grid; both lists must outlive it.
    MeshLocator(const std::vector<Triangle>& triangles, const std::vector<Vec2>& vertices);
    /// The point of the mesh that is nearest to `p` [m]; of several triangles that hold it, the first.
    MeshPoint locate(Vec2 p) const;

private:
    static constexpr std::int32_t kCells = 16;  // Cells along each side of the grid.

    // The cells that a triangle may touch.
    struct Cells {
        std::int32_t left, right, bottom, top;
    };
    static std::int32_t cellOf(double along, double low, double size);
    Cells cellsOf(const Triangle& triangle) const;
    template <class Visit>
    static void forCells(const Cells& cells, const Visit& visit) {
        for (std::int32_t j = cells.bottom; j <= cells.top; ++j)
            for (std::int32_t i = cells.left; i <= cells.right; ++i)
                visit(static_cast<std::size_t>(j) * kCells + i);
    }

    const std::vector<Triangle>& triangles_;
    const std::vector<Vec2>& vertices_;
    Vec2 low_, size_;                    // Corner and size of the box of all vertices [m].
    std::vector<std::int32_t> inCell_;   // Triangles, cell by cell, ascending in each.
    std::vector<std::int32_t> cellEnd_;  // Per cell: its end in inCell_.
};

}  // namespace muster
