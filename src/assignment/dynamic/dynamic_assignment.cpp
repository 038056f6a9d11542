#include "assignment/dynamic/dynamic_assignment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muster {
namespace {

constexpr std::size_t kPairsAtOnce = 4096;
constexpr std::int32_t kManyViolated = 8;  // One in so many seats.
constexpr std::int32_t kFitRests = 8;      // Repairs between two fits of prices...
constexpr std::int32_t kFarFitRests = 40;  // ... where all is far away and little changes.
// In every so many turns of a row all its arcs are asked for, else the tight ones.
constexpr std::int32_t kWholeTurns = 4;
constexpr double kShortWay = 4.0;  // Over longer ways a jump is longer in proportion [m].
// Arcs are tight that a holder's coming nearer by so much would violate [m]...
constexpr double kLoose = 0.2;
constexpr double kLeastLoose = 1.0;  // ... at this cost or its own [m].

}  // namespace

void DynamicAssignment::clear() {
    *this = {};
}

void DynamicAssignment::reserve(const DynamicAssignmentDef& def, std::size_t characters, std::size_t places) {
    prepare(def, characters, places);
    prepare(def, 0, 0);
}

// Sizes the memory.
void DynamicAssignment::prepare(const DynamicAssignmentDef& def, std::size_t characters, std::size_t places) {
    step_ = turn_ = restOfFit_ = violated_ = 0;
    far_ = near_ = false;
    flipped_.reserve(2 * std::max(characters, places));
    stale_.assign(std::max(characters, places), 0);
    state_.reset(static_cast<std::int32_t>(characters), static_cast<std::int32_t>(places));
    searchLimit_ = def.searchLimit;
    repair_.reset(state_.seats.count(), def.searchLimit);
    pricing_.reset(state_.seats.count());
    placeOf_.assign(characters, -1);
    cost_.assign(characters, 0.0f);
    pairs_.reserve(kPairsAtOnce);
    answers_.reserve(kPairsAtOnce);
    rows_.reserve(state_.seats.count());
    tightRows_.reserve(state_.seats.count());
    staleArcs_.reserve(static_cast<std::size_t>(state_.seats.count()) * ExchangeArcs::kLanes);
    margin_.assign(static_cast<std::size_t>(state_.seats.count()), 0.0);
}

AssignmentStep DynamicAssignment::contextFor(const DynamicAssignmentDef& def, const AssignmentInput& input,
                                             CostOracle& costs, ThreadPool& pool) const {
    AssignmentStep context{def, input, costs, pool, CostPower(def.exponent), {}, {}, 0.0};
    context.threshold = def.threshold / context.power.units();
    return context;
}

void DynamicAssignment::coldStart(const DynamicAssignmentDef& def, const AssignmentInput& input,
                                  CostOracle& costs, ThreadPool& pool) {
    warmStart(def, input, {}, costs, pool);
    const AssignmentStep first = contextFor(def, input, costs, pool);
    for (std::int32_t round = 0; round < def.initialRounds && state_.seats.count() > 0; ++round) {
        AssignmentStep context = first;
        frame(context);
        state_.arcs.sortByTarget();
        repair(context);
        publish(context);
    }
}

void DynamicAssignment::warmStart(const DynamicAssignmentDef& def, const AssignmentInput& input,
                                  std::span<const std::int32_t> placeOf, CostOracle& costs,
                                  ThreadPool& pool) {
    prepare(def, input.characters.size(), input.places.size());
    if (!placeOf.empty()) state_.seats.warmStart(placeOf);
    AssignmentStep context = contextFor(def, input, costs, pool);
    seatWaiting(context);
    frame(context);
    askOwn(context);
    refreshAll(context);
    state_.arcs.sortByTarget();
    fit_.run(context, state_);
    publish(context);
    measureDualityGap(context);
}

void DynamicAssignment::update(const DynamicAssignmentDef& def, const AssignmentInput& input,
                               CostOracle& costs, ThreadPool& pool) {
    if (static_cast<std::size_t>(state_.seats.characters()) != input.characters.size() ||
        static_cast<std::size_t>(state_.seats.places()) != input.places.size()) {
        coldStart(def, input, costs, pool);
        return;
    }
    if (searchLimit_ != def.searchLimit) {
        searchLimit_ = def.searchLimit;
        repair_.reset(state_.seats.count(), def.searchLimit);
    }
    if (turn_ >= def.stepsPerRound) turn_ = 0;
    if (turn_ == 0) ++step_;
    AssignmentStep context = contextFor(def, input, costs, pool);
    seatWaiting(context);
    frame(context);
    askOwn(context);
    if (turn_ < def.refreshSteps()) refreshSome(context);
    // Seats that flipped are priced by the arcs to them: as these are now.
    if (turn_ + 1 == def.refreshSteps() || (turn_ < def.refreshSteps() && !flipped_.empty()))
        state_.arcs.sortByTarget();
    repriceFlipped();
    if (turn_ >= def.stepsPerRound - def.repairSteps()) repair(context);
    publish(context);
    ++turn_;
}

void DynamicAssignment::repair(const AssignmentStep& context) {
    const DynamicAssignmentDef& def = context.def;
    // Where much is violated searches find no way: prices are fitted anew then.
    if (restOfFit_ > 0) --restOfFit_;
    if (restOfFit_ == 0 && violated_ > state_.seats.count() / kManyViolated) {
        fit_.run(context, state_);
        restOfFit_ = far_ ? kFarFitRests : kFitRests;
    }
    const double share = far_ ? std::min(def.settledPerNode, def.farSettledPerNode) : def.settledPerNode;
    repair_.run(context, state_, static_cast<std::int64_t>(share * state_.seats.count()),
                far_ ? def.farRetryDelay : def.retryDelay);
    violated_ = repair_.violated();
    measureDualityGap(context);
}

// A seat that is another thing than before has a new price: between what its holder can pay elsewhere and
// what others would pay for it.
void DynamicAssignment::repriceFlipped() {
    for (const std::int32_t s : flipped_) {
        double low = -std::numeric_limits<double>::infinity();
        double high = std::numeric_limits<double>::infinity();
        for (std::int32_t arc = s * ExchangeArcs::kLanes; arc < (s + 1) * ExchangeArcs::kLanes; ++arc) {
            const std::int32_t to = state_.arcs.target(arc);
            if (to != s) low = std::max(low, state_.price[to] - state_.arcs.weight(arc));
        }
        for (const std::int32_t arc : state_.arcs.into(s)) {
            const std::int32_t from = arc / ExchangeArcs::kLanes;
            if (from != s) high = std::min(high, state_.price[from] + state_.arcs.weight(arc));
        }
        double& price = state_.price[s];
        if (std::isfinite(low) && std::isfinite(high))
            price = low < high ? std::clamp(price, low, high) : 0.5 * (low + high);
        else if (std::isfinite(low))
            price = low;
        else if (std::isfinite(high))
            price = high;
    }
}

// Pairs those who wait with free places, and gives the rest a seat.
void DynamicAssignment::seatWaiting(const AssignmentStep& context) {
    AssignmentNodes& seats = state_.seats;
    flipped_.clear();
    seats.follow(context.input, flipped_);
    for (const std::int32_t s : flipped_) jumped(s);
    for (const std::int32_t s : seats.free()) state_.changed[s] = 1;
    for (const std::int32_t i : seats.waiting())
        if (seats.seatOf(i) >= 0) state_.changed[seats.seatOf(i)] = 1;
    start_.seat(context, state_);
    seats.seatRest();
}

// For the squares of straight distances the prices' frame makes weights and prices independent of where the
// formation as a whole is; for other costs and powers it takes away most of the change.
void DynamicAssignment::frame(AssignmentStep& context) const {
    const AssignmentNodes& seats = state_.seats;
    Vec2 places;
    Vec2 away;
    std::int32_t live = 0;
    std::int32_t matched = 0;
    for (std::int32_t s = 0; s < seats.count(); ++s) {
        if (!seats.live(s)) continue;
        const Vec2 place = context.input.places[s];
        places += place;
        ++live;
        if (seats.holder(s) < 0) continue;
        away += place - context.input.characters[seats.holder(s)];
        ++matched;
    }
    context.anchor = places / std::max(1, live);
    away = away / std::max(1, matched);
    const double p = context.power.exponent();
    double factor = p;
    if (p != 2.0) {
        double spread = 0.0;
        for (std::int32_t s = 0; s < seats.count(); ++s)
            if (seats.matched(s))
                spread += lengthSquared(context.input.places[s] - context.input.characters[seats.holder(s)] -
                                        away);
        const double reach = std::sqrt(lengthSquared(away) + spread / std::max(1, matched)) + 1e-3;
        factor = p * context.power(reach) / (reach * reach);
    }
    context.slope = away * factor;
}

void DynamicAssignment::askOwn(const AssignmentStep& context) {
    const AssignmentNodes& seats = state_.seats;
    std::int32_t next = 0;
    for (std::int32_t s = 0; s < seats.count();) {
        pairs_.clear();
        const std::int32_t first = s;
        for (; s < seats.count() && pairs_.size() < kPairsAtOnce; ++s)
            if (seats.matched(s)) pairs_.push_back({seats.holder(s), s});
        answers_.resize(pairs_.size());
        context.costs.evaluate(pairs_, answers_, context.pool);
        next = 0;
        for (std::int32_t t = first; t < s; ++t) {
            const float cost = seats.matched(t) ? answers_[next++] : 0.0f;
            const double jump = context.def.invalidatingChange *
                                std::max(1.0, static_cast<double>(cost) / kShortWay);
            if (std::abs(cost - state_.asked[t]) > jump) jumped(t);
            state_.setOwn(t, cost, context.power);
        }
    }
}

// A place that came to the other side of a wall, or whose cost drifted off: all arcs to it and from it are
// wrong.
void DynamicAssignment::jumped(std::int32_t seat) {
    state_.changed[seat] = 1;
    stale_[seat] = 1;
}

void DynamicAssignment::refreshAll(const AssignmentStep& context) {
    state_.arcs.look(context, state_.seats, state_.price, state_.own);
    noteHowFar(context);
    rows_.clear();
    for (std::int32_t s = 0; s < state_.seats.count(); ++s) {
        state_.arcs.chooseTargets(context, state_.seats, s);
        state_.changed[s] = 0;
        rows_.push_back(s);
    }
    askRows(context);
}

void DynamicAssignment::askRows(const AssignmentStep& context) {
    state_.arcs.refresh(context, state_.seats, state_.ownPower, rows_, {});
    for (const std::int32_t s : rows_) state_.asked[s] = state_.own[s];
}

// How much an arc may gain or lose until all arcs of its row are asked for again.
double DynamicAssignment::marginOf(const AssignmentStep& context, std::size_t seat) const {
    const double cost = std::max(static_cast<double>(state_.own[seat]), kLeastLoose);
    return context.power(cost + kLoose) - context.power(cost);
}

void DynamicAssignment::noteHowFar(const AssignmentStep& context) {
    double sum = 0.0;
    for (const float c : state_.own) sum += c;
    far_ = sum > context.def.farCost * static_cast<double>(state_.own.size());
    near_ = sum < context.def.nearCost * static_cast<double>(state_.own.size());
}

// Rounds in which all rows have had their turn.
std::int32_t DynamicAssignment::refreshPeriod(const DynamicAssignmentDef& def) const {
    return def.rounds(far_ ? def.farRefreshPeriod : near_ ? def.nearRefreshPeriod : def.refreshPeriod);
}

// Beside moving things costs change by more than people move.
bool DynamicAssignment::unsteady(const AssignmentStep& context, std::int32_t seat) const {
    return state_.seats.matched(seat) && context.costs.unsteady(state_.seats.holder(seat), seat);
}

// Rows in turn, and at once those whose holder is new.
void DynamicAssignment::refreshSome(const AssignmentStep& context) {
    state_.arcs.look(context, state_.seats, state_.price, state_.own);
    noteHowFar(context);
    const std::int32_t period = refreshPeriod(context.def);
    const std::int32_t targets = context.def.rounds(context.def.candidatePeriod);
    const std::int64_t count = state_.seats.count();
    const std::int64_t first = count * turn_ / context.def.refreshSteps();
    const std::int64_t end = count * (turn_ + 1) / context.def.refreshSteps();
    rows_.clear();
    tightRows_.clear();
    collectStale();
    for (std::int32_t s = 0; s < count; ++s) {
        const bool turn = s >= first && s < end;
        const bool anew = state_.changed[s] != 0 || (turn && (s + step_) % targets == 0);
        if (!anew && !(turn && (s + step_) % period == 0)) continue;
        if (anew) state_.arcs.chooseTargets(context, state_.seats, s);
        state_.changed[s] = 0;
        if (anew || (s + step_) / period % kWholeTurns == 0 || unsteady(context, s)) {
            rows_.push_back(s);
        } else {
            tightRows_.push_back(s);
            margin_[s] = marginOf(context, static_cast<std::size_t>(s));
        }
    }
    askRows(context);
    state_.arcs.refresh(context, state_.seats, state_.ownPower, tightRows_, {state_.price, margin_});
    state_.arcs.refreshArcs(context, state_.seats, state_.ownPower, staleArcs_);
    // Of long ways the straight line says too little, and from afar neighbours are enough.
    if (!far_) pricing_.run(context, state_, CycleCancelling::tolerance(context, state_));
}

// Arcs to seats that jumped. As they were sorted, so before any leads elsewhere.
void DynamicAssignment::collectStale() {
    staleArcs_.clear();
    if (turn_ != 0) return;
    for (std::int32_t s = 0; s < state_.seats.count(); ++s) {
        if (stale_[s] == 0) continue;
        stale_[s] = 0;
        const auto into = state_.arcs.into(s);
        staleArcs_.insert(staleArcs_.end(), into.begin(), into.end());
    }
}

// What others may read: places, costs, the objective and what may be left to gain.
void DynamicAssignment::publish(const AssignmentStep& context) {
    const AssignmentNodes& seats = state_.seats;
    const double units = context.power.units();
    double sum = 0.0;
    for (const double own : state_.ownPower) sum += own;
    for (std::size_t i = 0; i < placeOf_.size(); ++i) {
        const std::int32_t seat = seats.seatOf(static_cast<std::int32_t>(i));
        const bool placed = seat >= 0 && seats.live(seat);
        placeOf_[i] = placed ? seat : -1;
        cost_[i] = placed ? state_.own[seat] : 0.0f;
    }
    slope_ = context.slope;
    units_ = units;
    objective_ = sum * units;
}

void DynamicAssignment::measureDualityGap(const AssignmentStep& context) {
    double left = 0.0;
    for (std::int32_t s = 0; s < state_.seats.count(); ++s) left -= std::min(0.0, state_.leastFrom(s));
    dualityGap_ = left * context.power.units();
}

void DynamicAssignment::duals(const AssignmentInput& input, std::span<double> price) const {
    for (std::size_t j = 0; j < price.size(); ++j)
        price[j] = units_ * (state_.price[j] + dot(slope_, input.places[j]));
}

// Working memory for what was read; the order of arcs by target and the own costs of the last step are made
// again.
void DynamicAssignment::afterReading() {
    const auto seats = static_cast<std::size_t>(state_.seats.count());
    searchLimit_ = 0;
    pricing_.afterReading(state_.seats.count());
    rows_.reserve(seats);
    tightRows_.reserve(seats);
    margin_.assign(seats, 0.0);
    flipped_.reserve(2 * seats);
    staleArcs_.reserve(seats * ExchangeArcs::kLanes);
    pairs_.reserve(kPairsAtOnce);
    answers_.reserve(kPairsAtOnce);
    state_.arcs.afterReading();
}

}  // namespace muster
