#include "assignment/dynamic/column_generation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muster {
namespace {

constexpr std::int32_t kSeatsPerTurn = 250;   // One in so many is priced in a step...
constexpr std::int32_t kLeastTurns = 2;       // ... but no fewer...
constexpr std::int32_t kMostTurns = 8;        // ... and no more than these,
constexpr std::int32_t kMostBounds = 200000;  // and no more pairs than these are looked at.
constexpr std::size_t kMostAsked = 64;        // Costs asked for one seat, from it and to it.
constexpr double kRounded = 1.0 - 1e-12;      // Below what rounding takes off a square.
// No cost counts for more than no way at all.
constexpr double kMostSquare = 0.99 * CostOracle::kUnreachable * CostOracle::kUnreachable;

}  // namespace

void ColumnGeneration::reset(std::int32_t seats) {
    all_ = hot_ = {};
    makeRoom(seats);
}

void ColumnGeneration::makeRoom(std::int32_t seats) {
    candidates_.reserve(seats);
    leaving_.reserve(seats);
    arriving_.reserve(seats);
    pairs_.reserve(kMostAsked);
    answers_.reserve(kMostAsked);
}

void ColumnGeneration::run(const AssignmentStep& context, ExchangeGraph& state, double tolerance) {
    found_ = 0;
    const std::int32_t count = state.seats.count();
    if (count == 0) return;
    perMetre_ = context.costs.leastUnitCost();
    squareOver_ = context.power.exponent() == 2.0 ? kRounded * context.power(perMetre_) : 0.0;
    noteEnds(context, state);
    const std::int32_t most = std::min(kMostTurns, std::max(1, kMostBounds / count));
    const std::int32_t turns = std::clamp(count / kSeatsPerTurn, std::min(kLeastTurns, most), most);
    for (std::int32_t k = 0; k < turns; ++k, ++all_.next) {
        if (all_.next >= count) all_ = {0, all_.round + 1};
        price(context, state, all_.next, all_.round, tolerance);
    }
    const auto& hot = state.arcs.hot();
    for (std::int32_t k = 0; k < std::min(turns, static_cast<std::int32_t>(hot.size())); ++k) {
        auto next = std::lower_bound(hot.begin(), hot.end(), hot_.next);
        if (next == hot.end()) {
            next = hot.begin();
            ++hot_.round;
        }
        hot_.next = *next + 1;
        price(context, state, *next, hot_.round, tolerance);
    }
}

// What reduced costs have in common from each seat and to each; infinite where no way begins or ends.
void ColumnGeneration::noteEnds(const AssignmentStep& context, const ExchangeGraph& state) {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    leaving_.clear();
    arriving_.clear();
    for (std::int32_t s = 0; s < state.seats.count(); ++s) {
        leaving_.push_back(state.seats.holder(s) >= 0 ? state.leaving(context, s) : kNever);
        arriving_.push_back(state.seats.live(s) ? state.arriving(context, s) : kNever);
    }
}

void ColumnGeneration::price(const AssignmentStep& context, ExchangeGraph& state, std::int32_t seat,
                             std::uint32_t round, double tolerance) {
    if (!state.seats.matched(seat)) return;
    collectFrom(context, state, seat, tolerance);
    ask(context, state, round, tolerance);
    collectInto(context, state, seat, tolerance);
    ask(context, state, round, tolerance);
}

// `rest`, below zero, is the reduced cost less what the way costs.
inline void ColumnGeneration::consider(const AssignmentStep& context, const ExchangeGraph& state,
                                       std::int32_t from, std::int32_t to, double rest) {
    if (from == to) return;
    const std::int32_t holder = state.seats.holder(from);
    const double square = lengthSquared(context.input.places[to] - context.input.characters[holder]);
    // Most are too far, which mostly can be told without a root.
    if (std::min(square * squareOver_, kMostSquare) + rest >= 0.0) return;
    if (!(context.power(perMetre_ * std::sqrt(square)) + rest < 0.0) || state.arcs.find(from, to) >= 0)
        return;
    if (context.power(context.costs.lowerBound(holder, to)) + rest < 0.0) candidates_.push_back({holder, to});
}

// Places to which the way of a seat's holder might pay, were it straight.
void ColumnGeneration::collectFrom(const AssignmentStep& context, const ExchangeGraph& state,
                                   std::int32_t seat, double tolerance) {
    candidates_.clear();
    const double base = leaving_[seat] + tolerance;
    for (std::int32_t to = 0; to < state.seats.places(); ++to) {
        const double rest = base + arriving_[to];
        if (rest < 0.0) consider(context, state, seat, to, rest);
    }
}

// Characters whose way to a place might pay, were it straight.
void ColumnGeneration::collectInto(const AssignmentStep& context, const ExchangeGraph& state,
                                   std::int32_t seat, double tolerance) {
    candidates_.clear();
    const double base = arriving_[seat] + tolerance;
    for (std::int32_t from = 0; from < state.seats.count(); ++from) {
        const double rest = base + leaving_[from];
        if (rest < 0.0) consider(context, state, from, seat, rest);
    }
}

// Takes in the most violated of each row.
void ColumnGeneration::ask(const AssignmentStep& context, ExchangeGraph& state, std::uint32_t round,
                           double tolerance) {
    // Of very many some are asked for, others when it is the seat's turn again.
    const std::size_t stride = candidates_.size() / kMostAsked + 1;
    pairs_.clear();
    for (std::size_t k = round % stride; k < candidates_.size(); k += stride)
        pairs_.push_back(candidates_[k]);
    answers_.resize(pairs_.size());
    context.costs.evaluate(pairs_, answers_, context.pool);
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        const std::int32_t from = state.seats.seatOf(pairs_[k].character);
        const std::int32_t to = pairs_[k].place;
        const float weight = state.arcs.weightFor(context, state.seats, state.ownPower, from, to,
                                                  context.power(answers_[k]));
        const double reduced = state.reduced(from, to, weight);
        if (!(reduced < std::min(-tolerance, state.reduced(state.arcs.priced(from))))) continue;
        state.arcs.putPriced(from, to, weight);
        ++found_;
    }
}

}  // namespace muster
