#include "engine/passages/passage_survey.h"

#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"
#include "engine/passages/passage.h"

namespace muster {
namespace {

constexpr double kLeastWait = 2.0;          // Time of waiting below which people need no other route [s].
constexpr double kLeastDetour = 12.0;       // Detour up to which a route belongs to the choice [m].
constexpr std::uint32_t kMostTogether = 6;  // Greatest number of passages in one choice.
// Distance between gaps along a path within which they may be one passage [m].
constexpr double kSameNarrows = 3.0;
constexpr double kGapCosine = 0.9;           // Least cosine of the angle between gaps of one passage.
constexpr double kSingleFile = 0.75;         // Share of the flow where two bodies do not fit side by side.
constexpr std::int64_t kSearchCells = 1000;  // Solved cells for which the beginning of a search counts...
constexpr std::int64_t kPointCells = 5;  // ... and for which a look for a gap at a point of a path counts.

// True for two gaps of one passage, such as the two ends of a corridor.
bool isSame(const Passage& one, const Passage& other) {
    const Vec2 along = (one.b - one.a) / one.width();
    const Vec2 apart = other.middle() - one.middle();
    return std::fabs(dot(apart, along)) < 0.5 * std::min(one.width(), other.width()) &&
           std::fabs(cross(apart, along)) < kSameNarrows &&
           std::fabs(dot(along, other.b - other.a)) > kGapCosine * other.width();
}

/// The greatest detour of a route that belongs to the choice [m].
double mostDetour(const SurveyState& state) {
    const SurveyDef& def = state.orders.front();
    return state.capacity > 0.0
               ? std::max({kLeastDetour, state.shortest, def.people / state.capacity * def.speed})
               : kInfiniteCost;
}

/// The cost from which on a walk is much longer than one of `cost`.
double muchLonger(double cost) {
    return cost + std::max(kLeastDetour, cost);
}

}  // namespace

bool PassageSurvey::advance(const Environment& environment, const StaticGround& ground, SurveyState& state,
                            std::int64_t& cells) {
    while (!state.orders.empty()) {
        // Open and very large ground has no coarse copy.
        if (!ground.hasCoarse() || ground.coarse().cells.empty() || state.passages.size() >= most_) {
            finishOrder(state, Verdict::TooMany);
            continue;
        }
        if (!begun_) begin(ground, state);
        const std::int64_t before = cells;
        const bool ended = solver_.advance(ground.coarse(), field_, cells);
        state.cells += before - cells;
        if (!ended) return false;
        const Verdict verdict = conclude(environment, ground, state);
        cells -= kSearchCells + kPointCells * std::ssize(way_);
        begun_ = false;
        state.cells = 0;
        if (verdict != Verdict::GoOn) finishOrder(state, verdict);
    }
    return true;
}

// Begins the present search, or repeats it up to where it was.
void PassageSurvey::begin(const StaticGround& ground, const SurveyState& state) {
    const SurveyDef& def = state.orders.front();
    edges_.open(ground.coarse());
    for (const Passage& passage : state.passages) edges_.close(passage);
    solver_.begin(ground.coarse(), edges_, def.to, field_);
    solver_.stopAt(def.from, field_);
    for (const Vec2 p : state.presentCrowd()) solver_.stopAt(p, field_);
    solver_.stopBeyond(costliest(state) + 2.0 * ground.coarse().grid.cell);
    std::int64_t again = state.cells;
    if (again > 0) solver_.advance(ground.coarse(), field_, again);
    begun_ = true;
}

// The greatest cost that matters: costlier walks count as none.
double PassageSurvey::costliest(const SurveyState& state) const {
    double most = state.shortest + mostDetour(state);
    for (const double cost : state.openCost)
        if (cost < kInfiniteCost) most = std::max(most, muchLonger(cost));
    return most;
}

// The verdict of the search that has ended.
PassageSurvey::Verdict PassageSurvey::conclude(const Environment& environment, const StaticGround& ground,
                                               SurveyState& state) {
    const SurveyDef& def = state.orders.front();
    field_.trace(def.from, static_cast<std::size_t>(ground.coarse().grid.count()), way_);
    if (state.searches == 0) readCosts(state, state.openCost);
    if (way_.empty()) return Verdict::Enough;
    const Verdict verdict = addGap(environment, ground, state);
    ++state.searches;
    if (verdict != Verdict::GoOn) return verdict;
    return state.searches > kMostTogether || state.passages.size() >= most_ ? Verdict::TooMany
                                                                            : Verdict::GoOn;
}

// Adds the narrowest gap of the path found. TooMany: more passages may help than people can choose among, as
// in a wood.
PassageSurvey::Verdict PassageSurvey::addGap(const Environment& environment, const StaticGround& ground,
                                             SurveyState& state) {
    const double cost = field_.at(state.orders.front().from).cost, flow = state.orders.front().flow;
    if (state.capacity == 0.0) state.shortest = cost;
    const double detour = cost - state.shortest;
    if (state.capacity > 0.0 && detour > mostDetour(state)) return Verdict::Enough;
    auto gap = narrowestPassage(environment, way_);
    if (gap && gap->width() < 4.0 * ground.coarse().radius) gap->pace = kSingleFile;
    if (!gap || (state.capacity == 0.0 && state.orders.front().people / gap->capacity(flow) < kLeastWait))
        return Verdict::TooMany;
    // Between cells a path may lead past the end of a closed passage, round all others.
    for (const Passage& known : state.passages)
        if (isSame(known, *gap))
            return detour > std::max(kLeastDetour, state.shortest) ? Verdict::Enough : Verdict::TooMany;
    state.capacity += gap->capacity(flow);
    state.passages.push_back(*gap);
    return Verdict::GoOn;
}

void PassageSurvey::finishOrder(SurveyState& state, Verdict verdict) {
    // With one passage there is no choice.
    if (verdict != Verdict::Enough || state.passages.size() < 2 || !partsCrowd(state))
        state.passages.resize(state.known);
    state.crowd.erase(state.crowd.begin(), state.crowd.begin() + state.orders.front().crowd);
    state.orders.erase(state.orders.begin());
    state.known = static_cast<std::uint32_t>(state.passages.size());
    state.searches = 0;
    state.shortest = state.capacity = 0.0;
    state.openCost.clear();
}

void PassageSurvey::readCosts(const SurveyState& state, std::vector<double>& costs) const {
    costs.clear();
    for (const Vec2 p : state.presentCrowd()) costs.push_back(field_.at(p).cost);
}

// True where most of the crowd has to go through the passages: with these closed, its routes are much longer.
bool PassageSurvey::partsCrowd(const SurveyState& state) {
    readCosts(state, closedCost_);
    std::size_t parted = 0;
    for (std::size_t k = 0; k < closedCost_.size(); ++k)
        if (!(closedCost_[k] < muchLonger(state.openCost[k]))) ++parted;
    return parted * 4 >= closedCost_.size() * 3;
}

}  // namespace muster
