#include "transport/sparse_matching_swaps.h"

#include <algorithm>

namespace muster {
namespace {

constexpr std::int32_t kLanes = MatchingArcs::kLanes;

// Somebody (or nobody) with the arcs from its seat and the cost of it to the power.
struct Sitter {
    MatchingArcs::Row row;
    std::int32_t holder;
    double power;
};

Sitter sitterOf(const MatchingState& state, std::int32_t seat) {
    return {state.arcs.row(seat), state.seats.holder(seat), state.ownPower[static_cast<std::size_t>(seat)]};
}

void sit(const MatchingContext& context, MatchingState& state, Sitter& sitter, std::int32_t from, std::int32_t to) {
    const std::int32_t lane = sitter.row.find(to);
    const float weight = sitter.row.weight[static_cast<std::size_t>(lane)];
    const double frame = dot(context.slope, state.seats.at(to, context) - state.seats.at(from, context));
    sitter.row.turn(to, from, lane, weight);
    state.arcs.setRow(to, sitter.row);
    state.seats.put(to, sitter.holder);
    state.ownPower[static_cast<std::size_t>(to)] =
        state.seats.matched(to) ? std::max(sitter.power + weight + frame, 0.0) : 0.0;
    state.changed[static_cast<std::size_t>(to)] = 1;
}

// The best exchange for a seat, as an arc; -1 where none gains enough.
std::int32_t bestExchange(const MatchingState& state, std::int32_t seat, double threshold) {
    double least = -threshold;
    std::int32_t best = -1;
    for (std::int32_t arc = seat * kLanes; arc < (seat + 1) * kLanes; ++arc) {
        // Most of what gains by an exchange is wanted by the prices on one side at least.
        if (state.reduced(arc) >= 0.0) continue;
        const std::int32_t back = state.arcs.find(state.arcs.target(arc), seat);
        if (back < 0 || state.arcs.target(arc) == seat) continue;
        const double sum = static_cast<double>(state.arcs.weight(arc)) + state.arcs.weight(back);
        if (!(sum < least)) continue;
        least = sum;
        best = arc;
    }
    return best;
}

}  // namespace

std::int32_t swapPairs(const MatchingContext& context, MatchingState& state, std::int32_t rounds) {
    std::int32_t exchanges = 0;
    for (std::int32_t round = 0; round < rounds; ++round) {
        const std::int32_t before = exchanges;
        for (std::int32_t a = 0; a < state.seats.count(); ++a) {
            const std::int32_t arc = bestExchange(state, a, context.threshold);
            if (arc < 0) continue;
            const std::int32_t b = state.arcs.target(arc);
            Sitter one = sitterOf(state, a);
            Sitter other = sitterOf(state, b);
            sit(context, state, one, a, b);
            sit(context, state, other, b, a);
            ++exchanges;
        }
        if (exchanges == before) break;
    }
    return exchanges;
}

}  // namespace muster
