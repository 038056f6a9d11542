#include "engine/systems/passages/way_stage.h"

#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"
#include "engine/geometry/polygon.h"
#include "engine/passages/specific_flow.h"
#include "engine/passages/way_number.h"
#include "engine/systems/passages/goals.h"

namespace muster {
namespace {

constexpr std::uint32_t kMostWayPeriod = 30;   // Most steps between two choices.
constexpr std::uint32_t kLeastWayPeriod = 10;  // Least steps between two choices.
constexpr double kGoalsMoved = 1.5;            // Distance that goals move before another choice is made [m].
constexpr std::int64_t kMostSurveyCells = 60000;  // Cells that surveys and walks may solve in a step,
constexpr std::int64_t kCellsLess = 30;           // less this number for each character,
constexpr std::int64_t kLeastCells = 12000;       // but at least this number,
constexpr std::int64_t kFirstPlansShare = 4;      // divided by this while a first plan is made.
constexpr double kDetourWait = 1.0;               // Longest wait below which nobody is sent round [s].
constexpr double kWaitOver = 0.1;                 // Longest wait below which nobody goes round any more [s].
// Time without movement after which a character gives its passage up [s].
constexpr double kPassagePatience = 4.0;
constexpr double kCommittedTime = 1.0;  // Time to its passage below which a character does not turn back [s].
constexpr std::uint32_t kMostTurns = 1;   // Most changes of the passage without a command.
constexpr double kThroughDistance = 0.3;  // Distance behind a gap at which a character is through [m].

// Cells that may be solved in a step: more with a small crowd, fewer while first plans are made.
std::int64_t cellsPerStep(const WorldState& state) {
    const std::int64_t people = std::ssize(state.characters.position);
    const std::int64_t cells = std::max(kLeastCells, kMostSurveyCells - kCellsLess * people);
    const bool first = std::any_of(state.groups.begin(), state.groups.end(),
                                   [](const Group& group) { return group.planNow || group.provisional; });
    return first ? cells / kFirstPlansShare : cells;
}

}  // namespace

// True where the static ground or the size of bodies has changed since the last call.
bool WayStage::groundChanged(const WorldState& state) {
    const std::uint64_t version = state.environment.staticVersion();
    const double radius = state.parameters.character.radius;
    const double openCost = state.parameters.cost.alpha + state.parameters.cost.beta;
    const bool changed = version != staticVersion_ || radius != radius_ || openCost != openCost_;
    staticVersion_ = version;
    radius_ = radius;
    openCost_ = openCost;
    return changed;
}

void WayStage::reset(const WorldState& state) {
    (void)groundChanged(state);
    survey_.forget();
    fields_.forget();
    groups_.clear();
}

void WayStage::clear(WorldState& state) {
    if (state.passages.empty() && state.survey.phase == SurveyPhase::None) return;
    state.passages.clear();
    state.survey = {};
    for (ChosenWay& chosen : state.characters.chosen) chosen = {};
    for (Group& group : state.groups) group.surveyFrom = group.surveyTo = {};
}

bool WayStage::due(const WorldState& state) {
    const std::uint32_t since = state.stepCount - state.waysLookedAt;
    if (since >= kMostWayPeriod) return true;
    return since >= kLeastWayPeriod &&
           std::any_of(state.groups.begin(), state.groups.end(),
                       [](const Group& g) { return distance(meanGoal(g), g.waysFor) > kGoalsMoved; });
}

// Looks for characters that have to go through a passage, and orders surveys where goals are hidden by
// something else.
void WayStage::look(WorldState& state) {
    SurveyState& survey = state.survey;
    survey.crossing = false;
    for (Group& group : state.groups) {
        foresee(state, group);
        if (group.groundClass != 0) continue;  // Passages are those of bodies of the usual size.
        survey.crossing = trigger_.look(state, fields_, group, survey) || survey.crossing;
    }
    state.waysLookedAt = state.stepCount;
    survey.phase = SurveyPhase::Search;
    survey.passages = state.passages;
    survey.known = static_cast<std::uint32_t>(state.passages.size());
    survey_.forget();
}

// Goes on with the surveys. True when all are done; then the passages that they found are known.
bool WayStage::survey(WorldState& state) {
    SurveyState& survey = state.survey;
    std::int64_t cells = cellsPerStep(state);
    if (survey.phase == SurveyPhase::Search) {
        if (!survey_.advance(state.environment, fields_.ground(), survey, cells)) return false;
        survey.phase = SurveyPhase::Fields;
        fields_.forget();
    }
    if (survey.passages.size() > state.passages.size()) {
        if (!fields_.prepare(fields_.ground(), survey.passages, survey.cells, cells)) return false;
        state.passages = survey.passages;
        fields_.update(fields_.ground(), state.passages);
        survey.crossing = true;
    }
    survey.phase = SurveyPhase::None;
    survey.cells = 0;
    survey.passages.clear();
    return true;
}

// Ends the way of a character that has gone through, or whose goal lies in the mouth behind the gap. A
// character that gets nowhere goes without a passage until the next command; the mouth itself has no room to
// walk to and fro.
void WayStage::dropIfPassed(WorldState& state, std::size_t i, bool behind) {
    const Characters& now = state.characters;
    ChosenWay& chosen = state.characters.chosen[i];
    const Passage& passage = state.passages[passageOf(chosen.way)];
    const auto away = [&](Vec2 p) { return distance(closestOnSegment(passage.a, passage.b, p), p); };
    // A character far from the gap has come through another one.
    const double end = (fromLeft(chosen.way) ? passage.right : passage.left) + kThroughDistance;
    const bool goalInMouth = now.place[i] >= 0 &&
                             away(goalOf(state.groups[now.group[i]], now.place[i])) <= end;
    if (behind && (goalInMouth || away(now.position[i]) > end)) {
        chosen.way = -1;
        return;
    }
    const std::uint32_t since = behind ? std::min(now.walk[i].movedAt, now.walk[i].campedAt)
                                       : now.walk[i].movedAt;
    const double still = (state.stepCount - since) * state.parameters.stepTime;
    if (still * passage.speed > kPassagePatience) chosen = {-1, kGaveUp};
}

void WayStage::dropPassed(WorldState& state, ThreadPool& pool) {
    const Characters& now = state.characters;
    reach_.resize(now.size());
    forChunks(&pool, now.size(), kPerTask, [&](std::size_t i) {
        const std::int32_t way = now.chosen[i].way;
        if (way < 0) return;
        const Walk walk = fields_.walk(passageOf(way), now.position[i]);
        reach_[i] = static_cast<float>(walk.cost);
        dropIfPassed(state, i, walk.side == sideBehind(way));
    });
}

// Ends the ways of characters whose passage is held, whose route leads past it, or that are beyond and need
// no passage; true where any way is left. A character whose place is on its own side for now keeps its way,
// which it may need again when places are exchanged.
bool WayStage::keepCrossers(WorldState& state) {
    std::vector<ChosenWay>& chosen = state.characters.chosen;
    marked_.assign(chosen.size(), 0);
    for (const std::int32_t i : crossers_.characters()) marked_[i] = 1;
    for (const std::int32_t i : crossers_.past()) chosen[i].way = -1;
    bool anyWay = false;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const Vec2 at = state.characters.position[i];
        const std::int32_t way = chosen[i].way;
        if (way >= 0 && crossers_.isHeld(state.characters.group[i], passageOf(way)) &&
            !fields_.isInside(way, at))
            chosen[i].way = -1;
        if (marked_[i] == 0 && !fields_.isInside(chosen[i].way, at) && !fields_.isBefore(chosen[i].way, at))
            chosen[i].way = -1;
        anyWay = anyWay || chosen[i].way >= 0;
    }
    return anyWay;
}

// Reads the present passages of the crossers.
void WayStage::readChosen(const WorldState& state) {
    const std::vector<std::int32_t>& used = crossers_.used();
    const std::size_t count = crossers_.characters().size();
    const double flow = specificFlow(state.parameters.character);
    capacity_.clear();
    for (const std::int32_t p : used) capacity_.push_back(state.passages[p].capacity(flow));
    way_.assign(count, -1);
    slot_.assign(count, 0.0);
    movable_.assign(count, 1);
    for (std::size_t k = 0; k < count; ++k) {
        const ChosenWay& now = state.characters.chosen[crossers_.characters()[k]];
        const auto at = now.way < 0 ? used.end() : std::find(used.begin(), used.end(), passageOf(now.way));
        if (at != used.end()) way_[k] = static_cast<std::int32_t>(at - used.begin());
        // A character that is about to go through does not turn back.
        const bool there = way_[k] >= 0 && now.passAt - state.time() < kCommittedTime;
        movable_[k] = now.turns == 0 && !there ? 1 : 0;
    }
}

void WayStage::choose(WorldState& state) {
    crossers_.gather(state, fields_);
    if (state.lastCommandStep >= state.waysChosenAt)
        for (ChosenWay& way : state.characters.chosen) way.turns = 0;
    const bool anyWay = keepCrossers(state);
    if (crossers_.characters().empty()) return;
    readChosen(state);
    crossers_.shutPast(state, fields_, way_);
    const WayChoiceInput input{crossers_.arrival(), crossers_.onward(), crossers_.pool(), movable_,
                               capacity_};
    choice_.read(input);
    const double wait = choice_.longestWait();
    if (wait < kWaitOver) dropUnneeded(state);
    if (wait < (anyWay ? kWaitOver : kDetourWait)) return;
    choice_.choose(way_, slot_);
    commit(state);
}

// Where nobody would wait any more, only characters in their passage keep their ways.
void WayStage::dropUnneeded(WorldState& state) const {
    std::vector<ChosenWay>& chosen = state.characters.chosen;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (!fields_.isInside(chosen[i].way, state.characters.position[i])) chosen[i].way = -1;
}

void WayStage::commit(WorldState& state) {
    const double now = state.time();
    const std::vector<std::int32_t>& crossers = crossers_.characters();
    for (std::size_t k = 0; k < crossers.size(); ++k) {
        ChosenWay& chosen = state.characters.chosen[crossers[k]];
        const std::int32_t way = crossers_.wayOf(k, way_[k]);
        if (chosen.way >= 0 && passageOf(chosen.way) != passageOf(way)) ++chosen.turns;
        // A character whose place moves to and fro behind several passages goes on without a way until the
        // next command.
        if (chosen.turns > kMostTurns) {
            chosen = {-1, kGaveUp};
            continue;
        }
        chosen.way = way;
        chosen.passAt = now + slot_[k];
    }
    for (std::size_t way = 0; way < wayCount(state.passages.size()); ++way)
        spread_.spread(state, crossers, static_cast<std::int32_t>(way));
}

// Looks, searches and chooses when that is due. A choice waits for the passages that are being surveyed.
void WayStage::decide(WorldState& state, ThreadPool& pool) {
    if (state.survey.phase == SurveyPhase::None) {
        if (!due(state)) return;
        look(state);
    }
    if (!survey(state)) return;
    if (state.survey.crossing) {
        choose(state);
        dropPassed(state, pool);
    }
    state.waysChosenAt = state.stepCount;
}

void WayStage::leavePassages(WorldState& state, PlanCosts& costs, ThreadPool& pool) {
    for (GroupWays& ways : groups_) ways.clear();
    waits_ = false;
    if (groundChanged(state) || !state.parameters.plan.waits) clear(state);
    if (!state.parameters.plan.waits || state.environment.obstacleIds().empty()) return;
    const StaticGround& ground = costs.staticGround();
    if (ground.open()) return;
    waits_ = true;
    fields_.update(ground, state.passages);
    if (!state.passages.empty()) dropPassed(state, pool);
}

void WayStage::chooseWays(WorldState& state, ThreadPool& pool) {
    if (waits_) decide(state, pool);
}

void WayStage::prepareWays(const WorldState& state, ThreadPool& pool) {
    if (!waits_ || state.passages.empty()) return;
    groups_.resize(state.groups.size());
    for (std::size_t g = 0; g < groups_.size(); ++g)
        groups_[g].prepare(state, fields_, state.groups[g], reach_, pool);
}

PlannedWays WayStage::waysOf(std::size_t group) const {
    return group < groups_.size() ? groups_[group].planned() : PlannedWays{};
}

bool WayStage::guide(const WorldState& state, std::size_t group, std::size_t member, std::int32_t place,
                     Vec2& direction, double& cost) const {
    const PlannedWays ways = waysOf(group);
    if (place < 0 || ways.way.empty()) return false;
    const double byWay = ways.cost(member, place, state.groups[group].places.positions().size());
    if (!(byWay < kInfiniteCost)) return false;
    cost = byWay;
    direction = guide_.direction(state, fields_, state.groups[group].members[member]);
    return true;
}

}  // namespace muster
