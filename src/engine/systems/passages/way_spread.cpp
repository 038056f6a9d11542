#include "engine/systems/passages/way_spread.h"

#include <algorithm>

#include "base/infinite_cost.h"
#include "engine/geometry/polygon.h"
#include "engine/passages/specific_flow.h"
#include "engine/passages/way_number.h"
#include "engine/systems/passages/goals.h"

namespace muster {
namespace {

constexpr int kWidths = 16;  // Number of widths that are compared.

}  // namespace

// The share of a passage that its crossers use side by side: the one by which the last of them arrives
// soonest, since more room means less waiting but a longer walk at its ends.
double WaySpread::usedShare(const WorldState& state, const Passage& passage, const Approach& approach) {
    const double walking = state.parameters.character.maxSpeed;
    const double flow = specificFlow(state.parameters.character);
    const auto walk = [&](double share) {
        const Vec2 via = lerp(passage.a, passage.b, share);
        return (distance(approach.from, via) + distance(via, approach.to)) / walking;
    };
    std::sort(approaching_.begin(), approaching_.end());
    double best = 1.0, least = kInfiniteCost;
    for (int step = 1; step <= kWidths; ++step) {
        const double part = static_cast<double>(step) / kWidths;
        const double service = 1.0 / (part * passage.capacity(flow));
        double free = 0.0;
        for (const double arrival : approaching_) free = std::max(arrival, free) + service;
        const double low = std::clamp(approach.share - 0.5 * part, 0.0, 1.0 - part);
        const double last = free + std::max(walk(low), walk(low + part));
        if (!(last < least)) continue;
        least = last;
        best = part;
    }
    return best;
}

WaySpread::Approach WaySpread::gather(const WorldState& state, std::span<const std::int32_t> crossers,
                                      std::int32_t way) {
    const Passage& passage = state.passages[passageOf(way)];
    const Vec2 along = (passage.b - passage.a) / passage.width();
    order_.clear();
    approaching_.clear();
    Approach sum;
    for (const std::int32_t i : crossers) {
        if (state.characters.chosen[i].way != way) continue;
        const Vec2 from = state.characters.position[i];
        const Vec2 to = goalOf(state.groups[state.characters.group[i]], state.characters.place[i]);
        order_.push_back({dot(normalized(from - passage.middle()), along), i});
        const double away = distance(from, closestOnSegment(passage.a, passage.b, from));
        approaching_.push_back(away / state.parameters.character.maxSpeed);
        const double here = passage.leftOf(from), there = passage.leftOf(to);
        const double part = here * there < 0.0 ? here / (here - there) : 0.5;
        sum.share += std::clamp(dot(lerp(from, to, part) - passage.a, along) / passage.width(), 0.0, 1.0);
        sum.from += from;
        sum.to += to;
    }
    const auto count = static_cast<double>(std::max<std::size_t>(1, order_.size()));
    return {sum.from / count, sum.to / count, sum.share / count};
}

void WaySpread::spread(WorldState& state, std::span<const std::int32_t> crossers, std::int32_t way) {
    const Approach mean = gather(state, crossers, way);
    if (order_.empty()) return;
    const Passage& passage = state.passages[passageOf(way)];
    const bool singleFile = passage.width() < 4.0 * state.parameters.character.radius;
    const double part = singleFile ? 0.0 : usedShare(state, passage, mean);
    const double low = singleFile ? 0.5 : std::clamp(mean.share - 0.5 * part, 0.0, 1.0 - part);
    std::sort(order_.begin(), order_.end());
    const auto count = static_cast<double>(order_.size());
    for (std::size_t k = 0; k < order_.size(); ++k)
        state.characters.chosen[order_[k].second].share = low + part * (static_cast<double>(k) + 0.5) / count;
}

}  // namespace muster
