// A search for free points that never gives up: a flood over the ground of a region, from where a place would
// stand outward, shared by all places that find no point near theirs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/maths.h"
#include "engine/ground/routes/route_graph.h"

namespace muster {

/// Hands out points in the order in which a flood over cells comes to them. Its memory is reused; it has no
/// state.
class SiteFlood {
public:
    /// Begins a search on the ground of a region (of all, for -1), for points about `spacing` [m] apart.
    void begin(const RouteGraph& routes, std::int32_t region, double spacing);
    /// Adds a place that wants a point near `p`, which lies in the region.
    void add(std::int32_t place, Vec2 p);
    bool empty() const { return seekers_.empty(); }  ///< True where no place wants a point.

    /// Floods from the first place that was added, and goes on from the next one that no flood has met,
    /// `most` times in all. `accept(place, point)` takes a point for a place, or refuses it; a point is
    /// offered only once, so its answer must not depend on the place. A flood ends once all places that it
    /// has met are served, or the region is at its end. True where all places met are served.
    template <class Accept>
    bool run(std::int32_t most, const Accept& accept) {
        bool served = true;
        sortSeekers();
        for (const Seeker& seeker : first_) {
            if (most == 0) break;
            const auto at = std::lower_bound(seekers_.begin(), seekers_.end(), seeker);
            if (met_[at - seekers_.begin()] != 0) continue;
            --most;
            served = flood(seeker.cell, accept) && served;
        }
        return served;
    }

    /// Lists the places that were added in the order in which the ground joins them, from one end of their
    /// ground to the other: the order of a flood from the last place that a first flood comes to. False where
    /// they would cover more than `most` cells, or the flood does not come to all.
    bool order(std::int32_t most, std::vector<std::int32_t>& places);

private:
    struct Seeker {
        std::int32_t cell;  // Cell where its flood would begin.
        std::int32_t place;

        bool operator<(const Seeker& other) const {
            return cell != other.cell ? cell < other.cell : place < other.place;
        }
    };

    template <class Accept>
    bool flood(std::int32_t start, const Accept& accept) {
        forgetVisits();
        waiting_.clear();
        std::size_t served = 0;
        visit(start);
        for (std::size_t head = 0; head < queue_.size(); ++head) {
            const std::int32_t cell = queue_[head];
            meet(cell);
            listSites(cell);
            for (std::size_t k = 0; k < sites_.size() && served < waiting_.size(); ++k)
                if (accept(waiting_[served], sites_[k])) ++served;
            if (served == waiting_.size()) return true;
            visitNeighbours(cell);
        }
        return false;
    }
    void sortSeekers();
    bool meetAll(std::int32_t start, std::int32_t most);
    void meet(std::int32_t cell);
    void listSites(std::int32_t cell);
    void visit(std::int32_t cell);
    void visitNeighbours(std::int32_t cell);
    void forgetVisits();
    bool inRegion(Cell c) const;

    const RouteGraph* routes_ = nullptr;
    Grid grid_;
    std::int32_t region_ = -1;
    double spacing_ = 1.0;                 // Distance between points [m].
    std::vector<Seeker> seekers_, first_;  // Places by cell, and in the order in which they came.
    std::vector<std::uint8_t> met_;        // By place: 1 if the flood has met it.
    std::vector<std::int32_t> waiting_;    // Places that the flood has met.
    std::vector<std::int32_t> queue_;      // Cells, in the order of the flood.
    std::int32_t last_ = 0;                // The last cell that meetAll() looked at.
    std::vector<Vec2> sites_;              // Points of a cell [m].
    // Visited cells: a bit each, in the tiles that the flood has come to.
    std::vector<std::int32_t> rowsOfTile_;  // Index of a tile's first row; -1 for none.
    std::vector<std::int32_t> tiles_;       // Tiles with rows.
    std::vector<std::uint32_t> rows_;
};

}  // namespace muster
