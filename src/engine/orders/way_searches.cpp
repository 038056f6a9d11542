#include "engine/orders/way_searches.h"

#include <algorithm>

namespace muster {

const WaySearches::Known* WaySearches::find(const WayGround& ground, const WayQuery& query) const {
    const auto same = [&](const Known& known) {
        return known.status != WayStatus::Searching && known.ground == ground.version() &&
               known.query == query;
    };
    const auto at = std::find_if(known_.begin(), known_.end(), same);
    return at == known_.end() ? nullptr : &*at;
}

// Searches until `until` cells are done; null where that does not end the search.
const WaySearches::Known* WaySearches::search(const WayGround& ground, const WayQuery& query,
                                              std::int32_t until) {
    if (!(search_.query() == query) || ground_ != ground.version()) search_.start(ground, query);
    ground_ = ground.version();
    if (search_.expanded() < until) search_.advance(ground, until - search_.expanded());
    if (search_.status() == WayStatus::Searching) return nullptr;
    Known& known = known_[next_];
    next_ = (next_ + 1) % known_.size();
    known.query = query;
    known.ground = ground_;
    known.status = search_.status();
    known.cells = search_.expanded();
    known.path = search_.path();
    return &known;
}

WayStatus WaySearches::advance(const WayGround& ground, const WayQuery& query, std::int32_t searched,
                               std::int32_t cells) {
    const Known* known = find(ground, query);
    if (known == nullptr) known = search(ground, query, searched + cells);
    if (known == nullptr || searched + cells <= known->cells) {
        searched_ = searched + cells;
        return WayStatus::Searching;
    }
    searched_ = known->cells;
    path_ = &known->path;
    return known->status;
}

}  // namespace muster
