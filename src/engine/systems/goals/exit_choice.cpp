#include "engine/systems/goals/exit_choice.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/hash.h"
#include "base/infinite_cost.h"
#include "base/maths.h"
#include "engine/passages/specific_flow.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/systems/events/standstill.h"
#include "engine/systems/passages/goals.h"

namespace muster {
namespace {

constexpr double kThinksEvery = 1.0;  // Everybody thinks again once in so long [s].
constexpr double kChangePays = 1.0;   // A change gains at least so much [s]...
constexpr double kChangeShare = 0.1;  // ... and this share of the time that is left.
constexpr double kMemory = 10.0;      // For so long what an exit let through counts [s].
constexpr double kPrior = 1.0;        // The law counts like so long a measurement [s].
constexpr std::size_t kRounds = 8;    // Those who choose at once do it in so many parts, one after the other.
constexpr double kLeastFlow = 1e-3;   // Of an exit [1/s].

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

// Who has not set out yet comes so much later.
double ExitChooser::walkTime(const WorldState& state, std::size_t i, double cost) const {
    const Parameters& parameters = state.parameters;
    const double open = parameters.cost.alpha + parameters.cost.beta;
    const Characters& c = state.characters;
    const std::uint32_t stays = c.setsOutAt[i] > state.stepCount ? c.setsOutAt[i] - state.stepCount : 0;
    return cost / (open * maxSpeedOf(parameters.character, c.body[i])) + stays * parameters.stepTime;
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

// Counts who goes where, and what the exits let through of late.
void ExitChooser::count(const WorldState& state, std::span<const Leavers> leavers) {
    const Characters& c = state.characters;
    herding_ = std::any_of(leavers.begin(), leavers.end(),
                           [](const Leavers& some) { return some.order->herding > 0.0; });
    waits_.clear(exits_.size());
    if (herding_) herds_.clear(state.environment.def().box, exits_.size());
    for (std::size_t i = 0; i < c.size(); ++i) {
        if (c.goal[i] == 0 || !(c.cost[i] < kInfiniteCost)) continue;
        const std::int32_t exit = indexOf(c.goal[i]);
        if (exit < 0) continue;
        waits_.add(static_cast<std::size_t>(exit), walkTime(state, i, c.cost[i]));
        if (herding_) herds_.add(c.position[i], static_cast<std::size_t>(exit));
    }
}

void ExitChooser::serve(WorldState& state) {
    const Parameters::Character& usual = state.parameters.character;
    const double flow = specificFlow(usual);
    const double speed = metresPerSecond(state.parameters);
    for (std::size_t e = 0; e < exits_.size(); ++e) {
        Area& area = *exits_[e];
        const GoalField& field = fieldTo(static_cast<std::int32_t>(e), 0);
        const auto byWidth = [&](double walk) {
            return flow * (field.width(walk * speed) + 2.0 * usual.radius);
        };
        const double measured = (kPrior * byWidth(0.0) + area.exit.served) / (kPrior + area.exit.queued);
        const double whole = area.def.rate > 0.0 ? std::min(area.def.rate, measured) : measured;
        area.exit.isQueued = waits_.isQueued(e, whole);
        waits_.serve(e, [&](double walk) { return std::max(kLeastFlow, std::min(whole, byWidth(walk))); });
    }
}

// Who has no exit, whose exit is closed or out of reach chooses at once, others in turn.
void ExitChooser::listChoosers(const WorldState& state, std::span<const Leavers> leavers) {
    const Characters& c = state.characters;
    const std::uint32_t turns = stepsIn(state, kThinksEvery);
    first_.clear();
    turn_.clear();
    for (std::size_t g = 0; g < leavers.size(); ++g) {
        allowed_.assign(exits_.size(), 0);
        for (const Option& option : options_[g]) allowed_[option.exit] = 1;
        for (const std::int32_t i : leavers[g].group->members) {
            const std::int32_t exit = c.goal[i] == 0 ? -1 : indexOf(c.goal[i]);
            const Chooser chooser{i, static_cast<std::int32_t>(g)};
            if (exit < 0 || allowed_[exit] == 0 || !(c.cost[i] < kInfiniteCost))
                first_.push_back(chooser);
            else if (options_[g].size() > 1 && (state.stepCount + c.id[i]) % turns == 0)
                turn_.push_back(chooser);
        }
    }
}

// The exit by which somebody will have left soonest; its own one unless another one is clearly better.
std::int32_t ExitChooser::best(const WorldState& state, const Leavers& leavers, const Chooser& chooser,
                               std::span<const std::int32_t> groundClasses, double& walk) const {
    const Characters& c = state.characters;
    const auto i = static_cast<std::size_t>(chooser.character);
    const Order& order = *leavers.order;
    const std::int32_t own = c.goal[i] == 0 ? -1 : indexOf(c.goal[i]);
    const std::int32_t groundClass = classIndex(groundClasses[i]);
    std::optional<Herds::Sight> sight;
    if (order.herding > 0.0 && !options_[chooser.leavers].empty())
        sight.emplace(herds_, fieldTo(0, groundClass).ground(), c.position[i], own);
    std::int32_t found = -1;
    double least = kInfiniteCost, ofOwn = kInfiniteCost, ownWalk = 0.0;
    for (const Option& option : options_[chooser.leavers]) {
        const double way = walkTime(state, i, fieldTo(option.exit, groundClass).cost(c.position[i]));
        if (!(way < kInfiniteCost)) continue;
        double time = order.choice == ExitChoice::Nearest
                          ? way
                          : waits_.leaves(static_cast<std::size_t>(option.exit), way);
        time -= option.attraction;
        if (sight) time -= order.herding * sight->share(static_cast<std::size_t>(option.exit));
        if (order.misjudgement > 0.0)
            time += order.misjudgement * errorOf(state.seed, c.id[i], ids_[option.exit]);
        if (option.exit == own) {
            ofOwn = time;
            ownWalk = way;
        }
        if (time >= least) continue;
        least = time;
        found = option.exit;
        walk = way;
    }
    const bool stays = ofOwn < kInfiniteCost &&
                       ofOwn - least < kChangePays + kChangeShare * std::max(0.0, ofOwn);
    if (!stays) return found;
    walk = ownWalk;
    return own;
}

void ExitChooser::run(WorldState& state, GoalFields& fields, std::span<const Leavers> leavers,
                      std::span<const std::int32_t> groundClasses, ThreadPool& pool) {
    Characters& c = state.characters;
    listExits(state, fields, leavers, groundClasses);
    listOptions(leavers);
    count(state, leavers);
    serve(state);
    listChoosers(state, leavers);
    const auto choose = [&](const std::vector<Chooser>& list, std::size_t from, std::size_t stride) {
        const std::size_t count = list.size() > from ? (list.size() - from + stride - 1) / stride : 0;
        chosen_.resize(count);
        walk_.resize(count);
        forChunks(&pool, count, kPerTask, [&](std::size_t k) {
            const Chooser& chooser = list[from + k * stride];
            chosen_[k] = best(state, leavers[chooser.leavers], chooser, groundClasses, walk_[k]);
        });
        for (std::size_t k = 0; k < count; ++k) {
            const std::int32_t i = list[from + k * stride].character;
            const std::uint32_t goal = chosen_[k] < 0 ? 0 : ids_[chosen_[k]];
            if (goal != c.goal[i]) c.direction[i] = {};  // Another way is to be found.
            c.goal[i] = goal;
        }
    };
    choose(turn_, 0, 1);
    for (const Chooser& chooser : first_) c.goal[chooser.character] = 0;
    for (std::size_t round = 0; round < std::min(kRounds, first_.size()); ++round) {
        choose(first_, round, kRounds);
        for (std::size_t k = 0; k < chosen_.size(); ++k) {
            if (chosen_[k] < 0) continue;
            waits_.add(static_cast<std::size_t>(chosen_[k]), walk_[k]);
            const std::int32_t i = first_[round + k * kRounds].character;
            if (herding_) herds_.add(c.position[i], static_cast<std::size_t>(chosen_[k]));
        }
        serve(state);
    }
    const double step = state.parameters.stepTime;
    for (Area* exit : exits_) {
        ExitFlow& flow = exit->exit;
        const double kept = std::max(0.0, 1.0 - step / kMemory);
        flow.served *= kept;
        flow.queued = flow.queued * kept + (flow.isQueued ? step : 0.0);
    }
}

}  // namespace muster
