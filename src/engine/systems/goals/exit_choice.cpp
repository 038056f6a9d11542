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

constexpr double kThinksEvery = 1.0;   // Everybody thinks again once in so long [s].
constexpr std::uint32_t kLooksIn = 4;  // Those whose turn it is in so many steps think in the last of these.
constexpr double kChangePays = 1.0;    // A change gains at least so much [s]...
constexpr double kChangeShare = 0.1;   // ... and this share of the time that is left.
constexpr double kMemory = 10.0;       // For so long what an exit let through counts [s].
constexpr std::size_t kRounds = 8;  // Those who choose at once do it in so many parts, one after the other.

// How much somebody errs about an exit, in deviations: a normal number by the world's seed.
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

// Cost that somebody walks in a second [m].
double ExitChooser::speedOf(const WorldState& state, std::size_t i) const {
    const Parameters& parameters = state.parameters;
    const double open = parameters.cost.alpha + parameters.cost.beta;
    return open * maxSpeedOf(parameters.character, state.characters.body[i]);
}

// Who has not set out yet comes so much later.
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

// Who stands in a line, or where an exit lets people out by a rate, is served by its place.
void ExitChooser::findPlaces(const WorldState& state) {
    const Characters& c = state.characters;
    place_.clear();
    for (std::size_t e = 0; e < exits_.size(); ++e) {
        if (place_.empty() && !exits_[e]->exit.line.empty()) place_.assign(c.size(), -1);
        std::int32_t place = 0;
        for (const std::uint32_t id : exits_[e]->exit.line)
            if (const std::int32_t i = c.indexOf(id); i >= 0 && c.goal[i] == ids_[e]) place_[i] = place++;
    }
}

// Counts who goes where.
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
        const std::int32_t place = placeOf(i);
        times_.add(e, groundClasses[i] != 0 || place >= 0
                          ? ExitTimes::First{-1, way, place}
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

// Who has no exit, whose exit is closed or out of reach chooses at once, others in turn.
void ExitChooser::listChoosers(const WorldState& state, std::span<const Leavers> leavers) {
    const Characters& c = state.characters;
    const std::uint32_t turns = stepsIn(state, kThinksEvery);
    const bool isTurn = state.stepCount % kLooksIn == 0;
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
            else if (hasChoice && (hasPassed(i) || (state.stepCount + c.id[i]) % turns < kLooksIn))
                turn_.push_back(chooser);
        }
    }
}

// Offers an exit by the shortest way, which takes `way` [s], and by all other doors of the room.
template <class Offer>
void ExitChooser::offerWays(const WorldState& state, std::size_t i, std::int32_t exit, bool byTime,
                            double way, bool hasDoors, const Offer& offer) const {
    const auto e = static_cast<std::size_t>(exit);
    const double speed = speedOf(state, i);
    const Vec2 p = state.characters.position[i];
    const std::uint32_t goal = state.characters.goal[i];
    const bool isOwn = goal != 0 && goal == ids_[e] && !hasPassed(static_cast<std::int32_t>(i));
    const std::int32_t place = isOwn ? placeOf(i) : -1, ownWay = wayOf(i);
    const ExitTimes::First direct = hasDoors && place < 0 ? times_.first(e, p, -1, way, speed)
                                                          : ExitTimes::First{-1, way, place};
    const auto leaves = [&](const ExitTimes::First& first) {
        const bool isCounted = isOwn && first.way == (ownWay < 0 ? direct.way : ownWay);
        return times_.leaves(e, first, speed, isCounted);
    };
    if (way < kInfiniteCost) offer(Choice{exit, -1, direct}, byTime ? leaves(direct) : way, direct.way);
    // Who is in the room of the exit needs no door.
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

// The exit and the door by which somebody will have left soonest; its own ones unless others are clearly
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
    // A change gains more than the times may err, and each makes the next one costlier. Of the time that is
    // left counts what comes after it has set out.
    const double left = std::max(0.0, best.ofOwn - walkTime(state, i, 0.0));
    const double pays = std::max({kChangePays, best.error, best.ownError}) + kChangeShare * left;
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
        // Another way is to be found.
        if (goal != c.goal[i] || chosen_[k].way != wayOf(i) || hasPassed(i)) c.direction[i] = {};
        c.goal[i] = goal;
        // Who has not set out has not gone anywhere yet.
        if (!turns_.empty() && chosen_[k].hasTurned && c.hasSetOut(i, state.stepCount)) ++turns_[i];
        if (!way_.empty()) way_[i] = chosen_[k].way;
    }
}

// Those who have no exit choose in parts, each of which knows what the parts before have chosen.
void ExitChooser::chooseFirst(WorldState& state, std::span<const Leavers> leavers,
                              std::span<const std::int32_t> groundClasses, ThreadPool& pool) {
    Characters& c = state.characters;
    for (const Chooser& chooser : first_) {
        c.goal[chooser.character] = 0;
        if (!way_.empty()) way_[chooser.character] = -1;
        if (!turns_.empty()) turns_[chooser.character] = 0;
    }
    for (std::size_t round = 0; round < std::min(kRounds, first_.size()); ++round) {
        choose(state, leavers, groundClasses, first_, round, kRounds, pool);
        for (std::size_t k = 0; k < chosen_.size(); ++k) {
            if (chosen_[k].exit < 0) continue;
            times_.add(static_cast<std::size_t>(chosen_[k].exit), chosen_[k].first);
            const std::int32_t i = first_[round + k * kRounds].character;
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
    const bool looks = state.stepCount % kLooksIn == 0;
    if (!looks) listChoosers(state, leavers);
    if (looks || !first_.empty()) {
        findPlaces(state);
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
        const double kept = std::max(0.0, 1.0 - step / kMemory);
        flow.served *= kept;
        flow.queued = flow.queued * kept + (flow.isQueued ? step : 0.0);
    }
}

}  // namespace muster
