// Neighbour lists (Verlet 1967): pairs of points within a reach plus a skin, found once with a cell list
// (Hockney and Eastwood 1981) and valid until a point has moved by half the skin.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/cell_list.h"
#include "base/ring.h"

namespace muster {

/// Two points close to each other, `low` < `high`.
struct NeighbourPair {
    std::int32_t low = 0;   ///< Index of a point.
    std::int32_t high = 0;  ///< Index of a point.
};

/// A list of close pairs, which reuses its memory. It is kept in one of two ways:
///  - build() and update() list all pairs again whenever a point has moved too far.
///  - updateRows() is for points of which most move alike and some are inactive. It subtracts the mean
///    displacement, keeps a row of neighbours per point, and lists single points again: new entries go to
///    overflow chains, and outdated ones stay, so a pair may be visited twice.
/// The order of pairs depends on positions and indices only.
class NeighbourList {
public:
    /// Lists all pairs nearer than `reach` (1 + `skin`) [m] in the order of the cell list; `skin` is a share
    /// of the reach, 0 or more.
    /// On a `ring` pairs are listed across its joint, too.
    void build(std::span<const Vec2> points, double reach, double skin = 0.0, const Ring& ring = {});
    /// Builds the list unless it is valid for these points.
    void update(std::span<const Vec2> points, double reach, double skin);
    /// Drops listed pairs for which `drops(pair)` is true; it must hold as long as the list is valid. The
    /// outcome is as good as random, so there is no branch.
    template <class Drops>
    void dropPairs(const Drops& drops) {
        std::size_t kept = 0;
        for (const NeighbourPair pair : pairs_) {
            pairs_[kept] = pair;
            kept += drops(pair) ? 0 : 1;
        }
        pairs_.resize(kept);
    }
    /// Makes the list invalid.
    void clear() {
        listedAt_.clear();
        pairs_.clear();
    }

    /// All listed pairs.
    std::span<const NeighbourPair> pairs() const { return pairs_; }
    /// Distance below which pairs are listed, skin included [m]; 0 before the first list.
    double listedReach() const { return listedReach_; }
    /// True where the list is of as many points, and point `i` is at most `distance` [m] from where it was
    /// listed.
    bool holdsFor(std::span<const Vec2> points, std::int32_t i, double distance) const {
        return lengthSquared(points[i] - listedAt_[i]) <= distance * distance;
    }
    /// True where the list is of as many points, and all are at most `distance` [m] from where they were
    /// listed.
    bool holdsFor(std::span<const Vec2> points, double distance) const;

    /// Updates a list with rows. `active` marks points that take part. Pairs nearer than `reach` are listed
    /// for the points at `points` and at `next`, which lie within `skin` / 2 times the reach of each other
    /// [m].
    void updateRows(std::span<const Vec2> points, std::span<const Vec2> next,
                    std::span<const std::uint8_t> active, double reach, double skin);
    /// Calls `visit(other)` for all points that may be nearer than the reach to a point of the last
    /// updateRows().
    template <class Visit>
    void forRow(std::int32_t point, const Visit& visit) const {
        for (std::int32_t at = rowStart_[point]; at < rowStart_[point + 1]; ++at) visit(row_[at]);
        for (std::int32_t at = overflowOfRow_[point]; at >= 0; at = overflow_[at].next)
            visit(overflow_[at].point);
    }
    /// Calls `visit(point)` for all points of the last updateRows() that may be nearer than the reach to `p`,
    /// until it returns true; returns whether it did.
    template <class Visit>
    bool anyNear(Vec2 p, const Visit& visit) const {
        return !listed_.empty() && anyInCellsAround(p - drift_, visit);
    }

private:
    // A list element of an overflow chain.
    struct Link {
        std::int32_t point = 0;
        std::int32_t next = 0;  // Index of the next element, negative at the end.
    };

    void addPairsAcross(std::span<const Vec2> points, const Ring& ring);
    bool findStrays(std::span<const Vec2> points, std::span<const Vec2> next,
                    std::span<const std::uint8_t> active);
    void buildRows(std::span<const Vec2> points, std::span<const std::uint8_t> active);
    void fillRows();
    void relist(std::int32_t point, Vec2 at);
    void prepend(std::int32_t& chain, std::int32_t point);
    template <class Visit>
    bool anyInCellsAround(Vec2 p, const Visit& visit) const;

    double reach_ = 0.0;        // Reach without skin [m].
    double skin_ = 0.0;         // Skin as a share of the reach.
    double listedReach_ = 0.0;  // Reach with skin [m].
    CellList cells_;
    std::vector<NeighbourPair> pairs_;
    std::vector<std::int32_t> atLeft_, atRight_;  // Points near the joint of a ring, by ascending y.
    std::vector<Vec2>
        listedAt_;  // Listed position of each point [m]; far away for points that were not listed.

    // Members of lists with rows.
    Vec2 drift_;                        // Mean displacement of the listed points since buildRows() [m].
    std::vector<std::int32_t> listed_;  // Points in the order of cells_, then points that were listed later.
    std::vector<Vec2> cellPoints_;      // Positions of the points that buildRows() listed [m].
    std::vector<std::int32_t> rowStart_;  // Index of the first neighbour of each point in row_; and the end.
    std::vector<std::int32_t> row_;       // Neighbours, row by row.
    std::vector<std::int32_t> strays_;    // Points that updateRows() lists again.
    std::vector<Link> overflow_;          // Neighbours and points that relist() added.
    std::vector<std::int32_t> overflowOfRow_;   // Chain of further neighbours of each point.
    std::vector<std::int32_t> overflowOfCell_;  // Chain of further points of each cell.
};

// A point is within half the skin of its listed position, without the drift, so the nine cells around
// suffice.
template <class Visit>
bool NeighbourList::anyInCellsAround(Vec2 p, const Visit& visit) const {
    const Grid& grid = cells_.grid();
    const Cell cell = grid.nearestCell(p);
    const std::int32_t left = std::max(cell.x - 1, 0), right = std::min(cell.x + 1, grid.width - 1);
    for (std::int32_t y = std::max(cell.y - 1, 0); y <= std::min(cell.y + 1, grid.height - 1); ++y) {
        for (const std::int32_t at : cells_.within(grid.index({left, y}), grid.index({right, y})))
            if (visit(listed_[at])) return true;
        if (overflow_.empty()) continue;
        for (std::int32_t x = left; x <= right; ++x)
            for (std::int32_t at = overflowOfCell_[grid.index({x, y})]; at >= 0; at = overflow_[at].next)
                if (visit(overflow_[at].point)) return true;
    }
    return false;
}

}  // namespace muster
