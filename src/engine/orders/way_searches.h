// Searches for the routes of formations that may be asked for again.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/orders/way_search.h"

namespace muster {

/// One search at a time; the results of the last ones are known. A known result counts as if it were searched
/// for, so that a rewound world goes on as it did. All of it is a cache.
class WaySearches {
public:
    /// Goes on with a search of which `searched` cells are done, for at most `cells` more. The ground must
    /// stay as it is until the search has ended.
    WayStatus advance(const WayGround& ground, const WayQuery& query, std::int32_t searched,
                      std::int32_t cells);

    std::int32_t searched() const { return searched_; }  ///< Number of cells, after the last advance().
    /// The route once found, both ends included [m].
    const std::vector<Vec2>& path() const { return *path_; }

private:
    /// Result of a search.
    struct Known {
        WayQuery query;
        GroundVersion ground;
        WayStatus status = WayStatus::Searching;
        std::int32_t cells = 0;
        std::vector<Vec2> path;  // [m]
    };

    const Known* find(const WayGround& ground, const WayQuery& query) const;
    const Known* search(const WayGround& ground, const WayQuery& query, std::int32_t until);

    WaySearch search_;      // The search; it may be ahead of the world that asks.
    GroundVersion ground_;  // Ground of the search.
    std::int32_t searched_ = 0;
    const std::vector<Vec2>* path_ = nullptr;
    std::array<Known, 16> known_;
    std::size_t next_ = 0;  // Index in known_ of the entry that is replaced next.
};

}  // namespace muster
