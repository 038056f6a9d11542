// The pairing of places when a formation turns or changes: it nearly minimises the sum of squared distances,
// so that no agent crosses the path of another.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/cell_list.h"
#include "engine/assignment/transport/dense/jonker_volgenant.h"
#include "muster/vec2.h"

namespace muster {

/// Pairs two sets of equal size. Memory is reused.
class Pairing {
public:
    /// Greatest number of points of a class that are paired by least squares.
    static constexpr std::size_t kMostExactPairs = 120;

    /// For each of `from` the index in `to` that it goes to. Only points of one class are paired; both
    /// classes are empty for none, else each class must be as large on both sides. Displacements are
    /// monotone, as those of least squares are: two points that go straight at the same time keep 0.707 of
    /// their least distance. Exact for up to kMostExactPairs points of a class, nearly so for more: n log n
    /// operations.
    std::span<const std::int32_t> pair(std::span<const Vec2> from, std::span<const Vec2> to,
                                       std::span<const std::uint8_t> fromClass = {},
                                       std::span<const std::uint8_t> toClass = {});

private:
    void split(std::size_t begin, std::size_t end);
    void solve();
    void improve();

    std::vector<std::int32_t> fromOrder_, toOrder_, result_;
    // In a class: the target of each point, and the point of each target.
    std::vector<std::int32_t> goes_, comes_;
    std::vector<Vec2> fromAt_, toAt_;
    CellList fromCells_, toCells_;
    JonkerVolgenantSolver solver_;
    std::vector<double> cost_;
    std::vector<Vec2> from_, to_;  // Points about their means, in whole millimetres.
};

}  // namespace muster
