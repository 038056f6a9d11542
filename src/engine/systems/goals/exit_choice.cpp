#include "engine/systems/goals/exit_choice.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/hash.h"
#include "base/infinite_cost.h"
#include "base/maths.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/systems/events/standstill.h"
#include "engine/systems/passages/goals.h"

namespace muster {
namespace {

constexpr double kChoiceInterval = 1.0;  // Time between two choices of one agent [s].
// Steps between two rounds of choices; agents whose turn falls between wait for the next round.
constexpr std::uint32_t kChoiceSteps = 4;
constexpr double kLeastGain = 1.0;        // Least time that a change of exit must gain [s]...
constexpr double kTimeGainShare = 0.1;    // ... besides this share of the time that is left.
constexpr double kThroughputTime = 10.0;  // Time over which the throughput of an exit is averaged [s].
// Number of parts in which agents without an exit choose, one part after the other.
constexpr std::size_t kFirstRounds = 8;

// The error of a person's estimate of an exit, in deviations: a normal number from the world's seed.
double errorOf(std::uint64_t seed, std::uint32_t character, std::uint32_t area) {
    const auto share = [&](std::uint32_t which) {
        Hash hash;
        hash.add(seed);
        hash.add(character);
        hash.add(area);
        hash.add(which);
        return hash.randomShare();
    };
    return std::sqrt(-2.0 * logarithm(share(0))) * cosine(2.0 * kPi * share(1));
}

}  // namespace

std::int32_t ExitChooser::indexOf(std::uint32_t area) const {
    const auto at = std::lower_bound(ids_.begin(), ids_.end(), area);
    return at != ids_.end() && *at == area ? static_cast<std::int32_t>(at - ids_.begin()) : -1;
}

std::int32_t ExitChooser::classIndex(std::int32_t groundClass) const {
    return static_cast<std::int32_t>(std::lower_bound(classes_.begin(), classes_.end(), groundClass) -
                                     classes_.begin());
}

const Area* ExitChooser::areaOf(const Characters& characters, std::size_t i) const {
    const std::int32_t exit = indexOf(characters.goal[i]);
    return exit >= 0 ? exits_[exit] : nullptr;
}

const GoalField* ExitChooser::fieldOf(const Characters& characters, std::size_t i,
                                      std::span<const std::int32_t> groundClasses) const {
    const std::int32_t exit = indexOf(characters.goal[i]);
    return exit >= 0 ? &fieldTo(exit, classIndex(groundClasses[i])) : nullptr;
}

// Cost that an agent walks in a second [m].
double ExitChooser::speedOf(const WorldState& state, std::size_t i) const {
    const Parameters& parameters = state.parameters;
    const double open = parameters.cost.alpha + parameters.cost.beta;
    return open * maxSpeedOf(parameters.character, state.characters.body[i]);
}

// The time of a walk, and before it the time until the agent sets out.
double ExitChooser::walkTime(const WorldState& state, std::size_t i, double cost) const {
    const Characters& c = state.characters;
    const std::uint32_t stays = c.setsOutAt[i] > state.stepCount ? c.setsOutAt[i] - state.stepCount : 0;
    return cost / speedOf(state, i) + stays * state.parameters.stepTime;
}

void ExitChooser::listExits(WorldState& state, GoalFields& fields, std::span<const Leavers> leavers,
                            std::span<const std::int32_t> groundClasses) {
    classes_.clear();
    for (const Leavers& some : leavers) addClasses(*some.group, groundClasses, classes_);
    exits_.clear();
    fields_.clear();
    ids_.clear();
    for (Area& area : state.areas) {
        if (area.def.kind != AreaKind::Exit || !isOpen(area.def, state.time())) continue;
        const bool named = std::any_of(leavers.begin(), leavers.end(), [&](const Leavers& some) {
            const std::vector<AreaId>& exits = some.order->exits;
            return exits.empty() || std::find(exits.begin(), exits.end(), area.id) != exits.end();
        });
        if (!named) continue;
        for (const std::int32_t groundClass : classes_) fields_.push_back(&fields.toArea(area, groundClass));
        exits_.push_back(&area);
        ids_.push_back(area.id.value);
    }
}

void ExitChooser::listOptions(std::span<const Leavers> leavers) {
    options_.resize(leavers.size());
    for (std::size_t g = 0; g < leavers.size(); ++g) {
        const Order& order = *leavers[g].order;
        options_[g].clear();
        for (std::size_t k = 0; k < order.exits.size(); ++k)
            if (const std::int32_t exit = indexOf(order.exits[k].value); exit >= 0)
                options_[g].push_back({exit, order.attractions.empty() ? 0.0 : order.attractions[k]});
        if (!order.exits.empty()) continue;
        for (std::int32_t exit = 0; std::cmp_less(exit, exits_.size()); ++exit)
            options_[g].push_back({exit, 0.0});
    }
}

// Counts how many people are ahead of each one in its line, by which an exit with a line or a rate serves
// them.
void ExitChooser::findLines(const WorldState& state) {
    const Characters& c = state.characters;
    ahead_.clear();
    for (std::size_t e = 0; e < exits_.size(); ++e) {
        if (ahead_.empty() && !exits_[e]->exit.line.empty()) ahead_.assign(c.size(), -1);
        std::int32_t ahead = 0;
        for (const std::uint32_t id : exits_[e]->exit.line)
            if (const std::int32_t i = c.indexOf(id); i >= 0 && c.goal[i] == ids_[e]) ahead_[i] = ahead++;
    }
}

// Counts the people at each exit and door.
void ExitChooser::count(const WorldState& state, std::span<const Leavers> leavers,
                        std::span<const std::int32_t> groundClasses) {
    const Characters& c = state.characters;
    herding_ = std::any_of(leavers.begin(), leavers.end(),
                           [](const Leavers& some) { return some.order->herding > 0.0; });
    times_.begin(doors_, exits_, toExit_, metresPerSecond(state.parameters));
    if (herding_) herds_.clear(state.environment.def().box, exits_.size());
    for (std::size_t i = 0; i < c.size(); ++i) {
        if (c.goal[i] == 0 || !(c.cost[i] < kInfiniteCost)) continue;
        const std::int32_t exit = indexOf(c.goal[i]);
        if (exit < 0) continue;
        const auto e = static_cast<std::size_t>(exit);
        const double way = walkTime(state, i, c.cost[i]);
        const std::int32_t ahead = aheadOf(i);
        times_.add(e, groundClasses[i] != 0 || ahead >= 0
                          ? ExitTimes::First{-1, way, ahead}
                          : times_.first(e, c.position[i], wayOf(i), way, speedOf(state, i)));
        if (herding_) herds_.add(c.position[i], e);
    }
}

void ExitChooser::serve(const WorldState& state) {
    ownFields_.clear();
    for (std::size_t e = 0; e < exits_.size(); ++e)
        ownFields_.push_back(&fieldTo(static_cast<std::int32_t>(e), 0));
    times_.serve(state.parameters.character, ownFields_);
}

// Lists the agents that choose: those without an exit, or whose exit is closed or out of reach, at once,
// others in turn.
void ExitChooser::listChoosers(const WorldState& state, std::span<const Leavers> leavers) {
    const Characters& c = state.characters;
    const std::uint32_t turns = stepsIn(state, kChoiceInterval);
    const bool isTurn = state.stepCount % kChoiceSteps == 0;
    first_.clear();
    turn_.clear();
    for (std::size_t g = 0; g < leavers.size(); ++g) {
        allowed_.assign(exits_.size(), 0);
        for (const Option& option : options_[g]) allowed_[option.exit] = 1;
        const bool hasChoice = isTurn && (options_[g].size() > 1 || !toExit_.empty());
        for (const std::int32_t i : leavers[g].group->members) {
            const std::int32_t exit = c.goal[i] == 0 ? -1 : indexOf(c.goal[i]);
            const Chooser chooser{i, static_cast<std::int32_t>(g)};
            if (exit < 0 || allowed_[exit] == 0 || !(c.cost[i] < kInfiniteCost))
                first_.push_back(chooser);
            else if (hasChoice && (hasPassed(i) || (state.stepCount + c.id[i]) % turns < kChoiceSteps))
                turn_.push_back(chooser);
        }
    }
}

// Offers an exit by the shortest route, which takes `way` [s], and by all other doors of the room.
template <class Offer>
void ExitChooser::offerWays(const WorldState& state, std::size_t i, std::int32_t exit, bool byTime,
                            double way, bool hasDoors, const Offer& offer) const {
    const auto e = static_cast<std::size_t>(exit);
    const double speed = speedOf(state, i);
    const Vec2 p = state.characters.position[i];
    const std::uint32_t goal = state.characters.goal[i];
    const bool isOwn = goal != 0 && goal == ids_[e] && !hasPassed(static_cast<std::int32_t>(i));
    const std::int32_t ahead = isOwn ? aheadOf(i) : -1, ownWay = wayOf(i);
    const ExitTimes::First direct = hasDoors && ahead < 0 ? times_.first(e, p, -1, way, speed)
                                                          : ExitTimes::First{-1, way, ahead};
    const auto leaves = [&](const ExitTimes::First& first) {
        const bool isCounted = isOwn && first.way == (ownWay < 0 ? direct.way : ownWay);
        return times_.leaves(e, first, speed, isCounted);
    };
    if (way < kInfiniteCost) offer(Choice{exit, -1, direct}, byTime ? leaves(direct) : way, direct.way);
    // An agent in the room of the exit needs no door.
    if (!hasDoors || !byTime || direct.way < 0) return;
    for (const std::int32_t other : doors_.waysFrom(p)) {
        const double onward = toExit_[e]->onward[other];
        if (other == direct.way || !(onward < kInfiniteCost)) continue;
        const double walk = doors_.walk(other, p);
        if (!(walk < kInfiniteCost)) continue;
        const ExitTimes::First first{other, walkTime(state, i, walk)};
        offer(Choice{exit, other, first}, leaves(first), other);
    }
}

// The exit and the door by which an agent will have left soonest; its present ones unless others are clearly
// better.
ExitChooser::Choice ExitChooser::best(const WorldState& state, const Leavers& leavers, const Chooser& chooser,
                                      std::span<const std::int32_t> groundClasses) const {
    const Characters& c = state.characters;
    const auto i = static_cast<std::size_t>(chooser.character);
    const Order& order = *leavers.order;
    const std::int32_t own = c.goal[i] == 0 ? -1 : indexOf(c.goal[i]), ownWay = wayOf(i);
    const std::int32_t groundClass = classIndex(groundClasses[i]);
    const bool hasDoors = !toExit_.empty() && groundClasses[i] == 0;
    const bool byTime = order.choice != ExitChoice::Nearest;
    std::optional<Herds::Sight> sight;
    if (order.herding > 0.0 && !options_[chooser.leavers].empty())
        sight.emplace(herds_, fieldTo(0, groundClass).ground(), c.position[i], own);
    Best best;
    for (const Option& option : options_[chooser.leavers]) {
        double less = option.attraction;
        if (sight) less += order.herding * sight->share(static_cast<std::size_t>(option.exit));
        if (order.misjudgement > 0.0)
            less -= order.misjudgement * errorOf(state.seed, c.id[i], ids_[option.exit]);
        const double way = walkTime(state, i, fieldTo(option.exit, groundClass).cost(c.position[i]));
        offerWays(state, i, option.exit, byTime, way, hasDoors,
                  [&](const Choice& choice, double leaves, std::int32_t door) {
                      const double time = leaves - less;
                      const double error = byTime ? times_.error(choice.exit, choice.first) : 0.0;
                      if (choice.exit == own && (ownWay < 0 ? choice.way < 0 : door == ownWay)) {
                          best.ofOwn = time;
                          best.own = choice;
                          best.ownError = error;
                      }
                      if (!(time < best.least)) return;
                      best.least = time;
                      best.choice = choice;
                      best.error = error;
                  });
    }
    // A change must gain more than the error of the times, and each change raises what the next one must
    // gain. Only the time after the agent has set out counts as left.
    const double left = std::max(0.0, best.ofOwn - walkTime(state, i, 0.0));
    const double pays = std::max({kLeastGain, best.error, best.ownError}) + kTimeGainShare * left;
    const bool stays = best.ofOwn < kInfiniteCost &&
                       best.ofOwn - best.least < pays * (1.0 + (turns_.empty() ? 0.0 : turns_[i]));
    if (stays) return best.own;
    best.choice.hasTurned = best.ofOwn < kInfiniteCost;
    return best.choice;
}

void ExitChooser::choose(WorldState& state, std::span<const Leavers> leavers,
                         std::span<const std::int32_t> groundClasses, const std::vector<Chooser>& list,
                         std::size_t from, std::size_t stride, ThreadPool& pool) {
    Characters& c = state.characters;
    const std::size_t count = list.size() > from ? (list.size() - from + stride - 1) / stride : 0;
    chosen_.resize(count);
    forChunks(&pool, count, kPerTask, [&](std::size_t k) {
        const Chooser& chooser = list[from + k * stride];
        chosen_[k] = best(state, leavers[chooser.leavers], chooser, groundClasses);
    });
    for (std::size_t k = 0; k < count; ++k) {
        const std::int32_t i = list[from + k * stride].character;
        const std::uint32_t goal = chosen_[k].exit < 0 ? 0 : ids_[chosen_[k].exit];
        // The character's direction is found again.
        if (goal != c.goal[i] || chosen_[k].way != wayOf(i) || hasPassed(i)) c.direction[i] = {};
        c.goal[i] = goal;
        // A character that has not set out has not turned.
        if (!turns_.empty() && chosen_[k].hasTurned && c.hasSetOut(i, state.stepCount)) ++turns_[i];
        if (!way_.empty()) way_[i] = chosen_[k].way;
    }
}

// Agents without an exit choose in parts; each part knows the choices of the parts before it.
void ExitChooser::chooseFirst(WorldState& state, std::span<const Leavers> leavers,
                              std::span<const std::int32_t> groundClasses, ThreadPool& pool) {
    Characters& c = state.characters;
    for (const Chooser& chooser : first_) {
        c.goal[chooser.character] = 0;
        if (!way_.empty()) way_[chooser.character] = -1;
        if (!turns_.empty()) turns_[chooser.character] = 0;
    }
    for (std::size_t round = 0; round < std::min(kFirstRounds, first_.size()); ++round) {
        choose(state, leavers, groundClasses, first_, round, kFirstRounds, pool);
        for (std::size_t k = 0; k < chosen_.size(); ++k) {
            if (chosen_[k].exit < 0) continue;
            times_.add(static_cast<std::size_t>(chosen_[k].exit), chosen_[k].first);
            const std::int32_t i = first_[round + k * kFirstRounds].character;
            if (herding_) herds_.add(c.position[i], static_cast<std::size_t>(chosen_[k].exit));
        }
        serve(state);
    }
}

void ExitChooser::run(WorldState& state, GoalFields& fields, std::span<const Leavers> leavers,
                      std::span<const std::int32_t> groundClasses, ThreadPool& pool) {
    listExits(state, fields, leavers, groundClasses);
    listOptions(leavers);
    findDoors(state, fields, leavers);
    readWays(state, leavers, groundClasses);
    const bool looks = state.stepCount % kChoiceSteps == 0;
    if (!looks) listChoosers(state, leavers);
    if (looks || !first_.empty()) {
        findLines(state);
        count(state, leavers, groundClasses);
        serve(state);
        if (looks) {
            passDoors(state);
            listChoosers(state, leavers);
        }
        choose(state, leavers, groundClasses, turn_, 0, 1, pool);
        chooseFirst(state, leavers, groundClasses, pool);
    }
    keepWays(state, fields, leavers);
    const double step = state.parameters.stepTime;
    for (Area* exit : exits_) {
        ExitFlow& flow = exit->exit;
        const double kept = std::max(0.0, 1.0 - step / kThroughputTime);
        flow.served *= kept;
        flow.queued = flow.queued * kept + (flow.isQueued ? step : 0.0);
    }
}

}  // namespace muster
