#include "assignment/dynamic/cycle_cancelling.h"

#include <algorithm>
#include <limits>

namespace muster {
namespace {

// Steps, after a search that was cut short, so that others get a turn.
constexpr std::uint8_t kRestCapped = 3;
constexpr std::int32_t kTries = 3;  // Arcs of one seat in one step.
// Smaller violations, in thresholds, are let be: of two that gain enough one is larger...
constexpr double kTolerance = 0.5;
constexpr double kToleranceOfShare = 0.25;  // ... or than this in shares of the mean.
// Times what was asked: seemed to gain so much by stale weights only.
constexpr double kStale = 2.0;
constexpr std::int32_t kLanes = ExchangeArcs::kLanes;

}  // namespace

double CycleCancelling::tolerance(const AssignmentStep& context, const ExchangeGraph& state) {
    double sum = 0.0;
    for (const double c : state.ownPower) sum += c;
    const double mean = sum / std::max(1.0, static_cast<double>(state.ownPower.size()));
    return std::max({kTolerance * context.threshold, kToleranceOfShare * context.def.thresholdShare * mean,
                     1e-9 * mean, 1e-30});
}

void CycleCancelling::reset(std::int32_t seats, std::int32_t searchLimit) {
    search_.reset(seats, searchLimit);
    violations_.reserve(seats);
    costs_.reserve(static_cast<std::size_t>(seats) + 1);
    holders_.reserve(static_cast<std::size_t>(seats) + 1);
}

std::int32_t CycleCancelling::worstArc(const ExchangeGraph& state, std::int32_t seat) const {
    const std::int32_t first = seat * kLanes;
    const std::int32_t* target = state.arcs.targets().data() + first;
    const float* weight = state.arcs.weights().data() + first;
    double least = std::numeric_limits<double>::infinity();
    std::int32_t worst = -1;
    for (std::int32_t k = 0; k < kLanes; ++k) {
        const double reduced = state.reduced(seat, target[k], weight[k]);
        if (!(reduced < least)) continue;
        least = reduced;
        worst = first + k;
    }
    return worst;
}

void CycleCancelling::collect(const ExchangeGraph& state, double tolerance, std::int32_t most) {
    violations_.clear();
    for (std::int32_t s = 0; s < state.seats.count(); ++s) {
        if (state.resting[s] > 0) continue;
        const double size = -state.leastFrom(s);
        if (size > tolerance) violations_.push_back({size, worstArc(state, s)});
    }
    violated_ = static_cast<std::int32_t>(violations_.size());
    const auto worse = [](const Violation& a, const Violation& b) {
        return a.size != b.size ? a.size > b.size : a.arc < b.arc;
    };
    if (violations_.size() > static_cast<std::size_t>(most)) {
        std::nth_element(violations_.begin(), violations_.begin() + most, violations_.end(), worse);
        violations_.resize(most);
    }
    std::sort(violations_.begin(), violations_.end(), worse);
}

void CycleCancelling::run(const AssignmentStep& context, ExchangeGraph& state, std::int64_t budget,
                          std::int32_t rest) {
    rest_ = static_cast<std::uint8_t>(rest);
    exchanges_ = 0;
    settled_ = 0;
    for (std::uint8_t& steps : state.resting)
        if (steps > 0) --steps;
    const double least = tolerance(context, state);
    // One that takes a single node is the least there can be.
    collect(state, least, static_cast<std::int32_t>(std::min<std::int64_t>(budget, state.seats.count())));
    for (const Violation& violation : violations_) {
        if (settled_ >= budget) break;
        repairSeat(context, state, violation.arc / kLanes, least, budget);
    }
}

// How much more it costs in reduced costs to let the holder of `to` go straight to `from`.
double CycleCancelling::backAgain(const AssignmentStep& context, ExchangeGraph& state, std::int32_t from,
                                  std::int32_t to) {
    const auto a = static_cast<std::size_t>(to);
    const auto b = static_cast<std::size_t>(from);
    const std::int32_t known = state.arcs.find(to, from);
    if (known >= 0) return std::max(state.reduced(known), 0.0);
    const std::int32_t holder = state.seats.holder(to);
    // Nobody waits there any more: whoever went there would leave a place empty.
    if (holder < 0 && !state.seats.live(to)) return std::numeric_limits<double>::infinity();
    const double there = holder >= 0 && state.seats.live(from)
                             ? context.power(context.costs.cost(holder, from))
                             : 0.0;
    const double frame = dot(context.slope, state.seats.at(from, context) - state.seats.at(to, context));
    return std::max(there - state.ownPower[a] - frame - state.price[b] + state.price[a], 0.0);
}

void CycleCancelling::repairSeat(const AssignmentStep& context, ExchangeGraph& state, std::int32_t seat,
                                 double tolerance, std::int64_t budget) {
    for (std::int32_t k = 0; k < kTries && settled_ < budget; ++k) {
        const std::int32_t arc = worstArc(state, seat);
        const double violation = -state.reduced(arc);
        if (!(violation > tolerance)) return;
        const std::int32_t to = state.arcs.target(arc);
        const auto limit = static_cast<std::int32_t>(
            std::min<std::int64_t>(context.def.searchLimit, budget - settled_));
        const SearchEnd end = search_.run(state.arcs, state.price, seat, to, violation,
                                          backAgain(context, state, seat, to), limit);
        settled_ += search_.settled() + 1;
        search_.movePrices(state.price);
        if (end == SearchEnd::Capped) {
            state.resting[seat] = kRestCapped;
            return;
        }
        if (end != SearchEnd::Cycle || commit(context, state)) continue;
        // Where much is left the weights were out of date, and another search may help; else it is the
        // threshold.
        const double left = -state.reduced(arc);
        if (left > tolerance && left < kStale * asked_) {
            state.resting[seat] = rest_;
            return;
        }
    }
}

void CycleCancelling::askCycle(const AssignmentStep& context, const ExchangeGraph& state) {
    const auto cycle = search_.cycle();
    costs_.clear();
    for (std::size_t k = 0; k < cycle.size(); ++k) {
        const std::int32_t holder = state.seats.holder(cycle[k]);
        const std::int32_t to = cycle[(k + 1) % cycle.size()];
        costs_.push_back(holder >= 0 && state.seats.live(to) ? context.costs.cost(holder, to) : 0.0f);
    }
}

// Exchanges along the cycle found where today's costs say that it gains enough.
bool CycleCancelling::commit(const AssignmentStep& context, ExchangeGraph& state) {
    askCycle(context, state);
    const auto cycle = search_.cycle();
    double before = 0.0;
    double after = 0.0;
    for (std::size_t k = 0; k < cycle.size(); ++k) {
        const std::int32_t to = cycle[(k + 1) % cycle.size()];
        before += state.ownPower[cycle[k]];
        if (state.seats.live(to) && state.seats.holder(cycle[k]) >= 0) after += context.power(costs_[k]);
    }
    asked_ = std::max(context.threshold, context.def.thresholdShare * before);
    if (!(before - after > asked_)) {
        noteWeights(context, state);
        return false;
    }
    rotate(context, state);
    ++exchanges_;
    return true;
}

// Weights along a cycle that was not worth it become today's.
void CycleCancelling::noteWeights(const AssignmentStep& context, ExchangeGraph& state) {
    const auto cycle = search_.cycle();
    for (std::size_t k = 0; k < cycle.size(); ++k) {
        const std::int32_t to = cycle[(k + 1) % cycle.size()];
        const std::int32_t arc = state.arcs.find(cycle[k], to);
        if (arc < 0) continue;
        const bool paid = state.seats.live(to) && state.seats.holder(cycle[k]) >= 0;
        const double there = paid ? context.power(costs_[k]) : 0.0;
        state.arcs.setWeight(arc, state.arcs.weightBy(context, state.seats, state.ownPower, arc, there));
    }
}

void CycleCancelling::rotate(const AssignmentStep& context, ExchangeGraph& state) {
    const auto cycle = search_.cycle();
    holders_.clear();
    for (const std::int32_t s : cycle) holders_.push_back(state.seats.holder(s));
    for (std::size_t k = 0; k < cycle.size(); ++k) {
        const std::int32_t to = cycle[(k + 1) % cycle.size()];
        state.seats.put(to, holders_[k]);
        state.setOwn(to, costs_[k], context.power);
        state.changed[to] = 1;
        state.resting[to] = 0;
    }
    state.arcs.refresh(context, state.seats, state.ownPower, cycle, {});
}

}  // namespace muster
