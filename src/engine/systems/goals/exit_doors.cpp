// The doors of people who do not take the shortest route to their exit.
#include <algorithm>

#include "base/infinite_cost.h"
#include "engine/systems/goals/exit_choice.h"

namespace muster {

// Doors matter to bodies of the usual size that choose by time.
void ExitChooser::findDoors(WorldState& state, GoalFields& fields, std::span<const Leavers> leavers) {
    toExit_.clear();
    const bool byTime = std::any_of(leavers.begin(), leavers.end(), [](const Leavers& some) {
        return some.order->choice != ExitChoice::Nearest;
    });
    const bool usual = !classes_.empty() && classes_.front() <= 0 &&
                       std::find(classes_.begin(), classes_.end(), 0) != classes_.end();
    if (!byTime || !usual) return;
    doors_.update(state, fields);
    if (!doors_.any()) return;
    for (Area* exit : exits_) toExit_.push_back(&doors_.toExit(*exit, fields.toArea(*exit, 0)));
}

// Takes over the ways that the groups keep, unless the doors have changed.
void ExitChooser::readWays(const WorldState& state, std::span<const Leavers> leavers,
                           std::span<const std::int32_t> groundClasses) {
    const Characters& c = state.characters;
    way_.clear();
    turns_.clear();
    passed_.clear();
    if (toExit_.empty() && exits_.size() < 2) return;
    turns_.assign(c.size(), 0);
    if (!toExit_.empty()) {
        way_.assign(c.size(), -1);
        passed_.assign(c.size(), 0);
    }
    for (const Leavers& some : leavers) {
        if (some.gathering->doors != doorsKey()) continue;
        const std::int32_t group = c.group[some.group->members.empty() ? 0 : some.group->members.front()];
        for (const DoorWay& own : some.gathering->ways) {
            const std::int32_t i = c.indexOf(own.character);
            if (i < 0 || !std::cmp_equal(c.group[i], group) || groundClasses[i] != 0) continue;
            turns_[i] = own.turns;
            if (!way_.empty() && own.way >= 0 && std::cmp_less(own.way, doors_.ways())) way_[i] = own.way;
        }
    }
}

// An agent that has come through its door, or is no longer before it, goes on from there.
void ExitChooser::passDoors(const WorldState& state) {
    const Characters& c = state.characters;
    for (std::size_t i = 0; i < way_.size(); ++i) {
        if (way_[i] < 0 || doors_.walk(way_[i], c.position[i]) < kInfiniteCost) continue;
        const std::int32_t exit = indexOf(c.goal[i]);
        passed_[i] = 1;
        way_[i] = exit >= 0 && doors_.isBehind(way_[i], c.position[i])
                      ? times_.onwardFrom(way_[i], static_cast<std::size_t>(exit), speedOf(state, i))
                      : -1;
    }
}

// Writes the ways of the members to their groups, and solves the fields of these ways.
void ExitChooser::keepWays(const WorldState& state, GoalFields& fields, std::span<const Leavers> leavers) {
    for (const Leavers& some : leavers) {
        some.gathering->ways.clear();
        some.gathering->doors = doorsKey();
        if (turns_.empty()) continue;
        for (const std::int32_t i : some.group->members) {
            const std::int32_t way = wayOf(i);
            if (way < 0 && turns_[i] == 0) continue;
            some.gathering->ways.push_back({state.characters.id[i], way, turns_[i]});
            if (way >= 0) doors_.prepareField(way, fields);
        }
    }
}

GoalWay ExitChooser::wayThrough(const Characters& characters, std::size_t i, double wallGap) const {
    const auto exit = static_cast<std::size_t>(indexOf(characters.goal[i]));
    const GoalField& field = fieldThrough(characters, i);
    GoalWay way = field.at(characters.position[i], wallGap);
    if (&field == &doors_.field(way_[i])) way.cost += toExit_[exit]->onward[way_[i]];
    return way;
}

// An agent in the frame of another door goes by the shortest route.
const GoalField& ExitChooser::fieldThrough(const Characters& characters, std::size_t i) const {
    const GoalField& through = doors_.field(way_[i]);
    if (through.cost(characters.position[i]) < kInfiniteCost) return through;
    return fieldTo(indexOf(characters.goal[i]), classIndex(0));
}

}  // namespace muster
