// Searches for the ways of formations that may be asked for again.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/orders/way_search.h"

namespace muster {

/// One search at a time, of which the results of the last ones are known. What is known counts as if it were
/// searched for, so that a world which was rewound goes on as it did. All of it is a cache.
class WaySearches {
public:
    /// Goes on with a search of which `searched` cells are done, for at most `cells` more. The ground must
    /// stay as it is until the search has ended.
    WayStatus advance(const WayGround& ground, const WayQuery& query, std::int32_t searched,
                      std::int32_t cells);

    std::int32_t searched() const { return searched_; }       ///< Cells, after the last advance().
    const std::vector<Vec2>& path() const { return *path_; }  ///< Once found, both ends included [m].

private:
    /// What a search came to.
    struct Known {
        WayQuery query;
        GroundVersion ground;
        WayStatus status = WayStatus::Searching;
        std::int32_t cells = 0;
        std::vector<Vec2> path;  // [m]
    };

    const Known* find(const WayGround& ground, const WayQuery& query) const;
    const Known* search(const WayGround& ground, const WayQuery& query, std::int32_t until);

    WaySearch search_;      // It may be further than the world that asks.
    GroundVersion ground_;  // Of the search.
    std::int32_t searched_ = 0;
    const std::vector<Vec2>* path_ = nullptr;
    std::array<Known, 16> known_;
    std::size_t next_ = 0;  // Of known_, the one to be forgotten.
};

}  // namespace muster
