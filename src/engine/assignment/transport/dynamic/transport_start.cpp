#include "engine/assignment/transport/dynamic/transport_start.h"

#include <algorithm>
#include <utility>

#include "engine/assignment/transport/dynamic/kd_partition.h"

namespace muster {
namespace {

constexpr std::int32_t kTransportClasses = 256;

void sortAlong(std::span<const Vec2> points, std::span<std::int32_t> indices, bool alongX) {
    std::sort(indices.begin(), indices.end(), [&](std::int32_t a, std::int32_t b) {
        const double u = alongX ? points[a].x : points[a].y;
        const double v = alongX ? points[b].x : points[b].y;
        return u != v ? u < v : a < b;
    });
}

double sumOf(std::span<const std::int64_t> amounts, std::span<const std::int32_t> indices) {
    double sum = 0.0;
    for (const std::int32_t k : indices) sum += static_cast<double>(amounts[k]);
    return sum;
}

}  // namespace

void TransportStart::run(const AssignmentInput& input, const AssignmentClasses& classes,
                         std::span<const std::int64_t> supply, std::span<const std::int64_t> demand,
                         TransportTree& tree) {
    supply_ = supply;
    demand_ = demand;
    fromCharacter_.clear();
    toPlace_.clear();
    hook_.clear();
    const bool classed = !classes.character.empty();
    for (std::int32_t c = 0; c < (classed ? kTransportClasses : 1); ++c) {
        characters_.clear();
        places_.clear();
        for (std::int32_t i = 0; std::cmp_less(i, supply.size()); ++i)
            if (supply[i] > 0 && (!classed || classes.character[i] == c)) characters_.push_back(i);
        for (std::int32_t j = 0; std::cmp_less(j, demand.size()); ++j)
            if (demand[j] > 0 && (!classed || classes.place[j] == c)) places_.push_back(j);
        order(input, characters_, places_);
        fill(characters_, places_, tree);
    }
    tree.plant(fromCharacter_, toPlace_, hook_);
}

// A place that is not full hangs on the root, else on its last character, some of whose supply may be left.
void TransportStart::keep(std::span<const std::int32_t> incumbent, std::span<const std::int64_t> supply,
                          std::span<const std::int64_t> demand, TransportTree& tree) {
    open_.assign(demand.begin(), demand.end());
    last_.assign(demand.size(), -1);
    fromCharacter_.clear();
    toPlace_.clear();
    hook_.clear();
    for (std::int32_t i = 0; std::cmp_less(i, incumbent.size()); ++i) {
        const std::int32_t j = incumbent[i];
        if (j < 0 || std::cmp_greater_equal(j, demand.size()) || supply[i] == 0 || open_[j] == 0) continue;
        open_[j] -= std::min(open_[j], supply[i]);
        last_[j] = i;
        fromCharacter_.push_back(i);
        toPlace_.push_back(j);
    }
    for (std::int32_t j = 0; std::cmp_less(j, demand.size()); ++j)
        if (last_[j] >= 0) hook_.push_back(open_[j] > 0 ? tree.nodeOfPlace(j) : last_[j]);
    tree.plant(fromCharacter_, toPlace_, hook_);
}

// Halves both: each half of the places' demand and the same share of the supply lie in the same half.
void TransportStart::order(const AssignmentInput& input, std::span<std::int32_t> characters,
                           std::span<std::int32_t> places) {
    if (characters.size() <= 1 || places.size() <= 1) return;
    const bool alongX = isWide(input.places, places);
    sortAlong(input.characters, characters, alongX);
    sortAlong(input.places, places, alongX);
    const std::size_t half = places.size() / 2;
    const double share = sumOf(demand_, places.first(half)) / sumOf(demand_, places);
    const double wanted = share * sumOf(supply_, characters);
    std::size_t count = 0;
    for (double sum = 0.0; count < characters.size(); ++count) {
        sum += static_cast<double>(supply_[characters[count]]);
        if (sum > wanted) break;
    }
    order(input, characters.first(count), places.first(half));
    order(input, characters.subspan(count), places.subspan(half));
}

// A part of the forest ends where a character and a place are used up together; it hangs on its middle then,
// else on the character or place that is left over.
void TransportStart::fill(std::span<const std::int32_t> characters, std::span<const std::int32_t> places,
                          const TransportTree& tree) {
    std::size_t a = 0, b = 0, first = fromCharacter_.size();
    std::int64_t sent = 0, filled = 0;  // Amounts sent from this character, and filled into this place.
    while (a < characters.size() && b < places.size()) {
        const std::int64_t left = supply_[characters[a]] - sent, open = demand_[places[b]] - filled;
        const std::int64_t amount = std::min(left, open);
        fromCharacter_.push_back(characters[a]);
        toPlace_.push_back(places[b]);
        sent += amount;
        filled += amount;
        if (left == amount) {
            ++a;
            sent = 0;
        }
        if (open == amount) {
            ++b;
            filled = 0;
        }
        if (left != open) continue;
        hook_.push_back(fromCharacter_[(first + fromCharacter_.size() - 1) / 2]);
        first = fromCharacter_.size();
    }
    if (sent > 0) hook_.push_back(characters[a]);
    if (filled > 0) hook_.push_back(tree.nodeOfPlace(places[b]));
}

}  // namespace muster
