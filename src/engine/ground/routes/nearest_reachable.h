// The nearest ground that a group can reach, remembered for all characters in one cell.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/ground/routes/route_graph.h"

namespace muster {

/// Answers of RouteGraph::nearestReachable() for the centres of cells. A cache: it changes no answer.
class NearestReachable {
public:
    /// The stand point of the cell of a region that is nearest to the centre of the cell of `p`; `p` where
    /// the region has none.
    Vec2 find(const RouteGraph& graph, Vec2 p, std::int32_t region);

private:
    struct Entry {
        std::int32_t cell = -1;
        std::int32_t region = -1;
        Vec2 point;
    };

    std::vector<Entry> entries_;  // Entries by cell; the last one of the cells that share an entry.
    std::uint64_t instance_ = 0, version_ = 0;
    double radius_ = 0.0;
};

}  // namespace muster
