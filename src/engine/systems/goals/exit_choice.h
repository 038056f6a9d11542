// The exit and the door by which each person leaves: those by which it will have left soonest, by its route
// and the waits at doors and before the exit (docs/method/goals.md).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "engine/systems/goals/doors.h"
#include "engine/systems/goals/exit_times.h"
#include "engine/systems/goals/goal_fields.h"
#include "engine/systems/goals/herds.h"

namespace muster {

/// The members of a group that leaves.
struct Leavers {
    Group* group = nullptr;        ///< The group.
    const Order* order = nullptr;  ///< The order that the group carries out.
    Gathering* gathering = nullptr;
};

/// Chooses exits for all people who leave.
class ExitChooser {
public:
    /// Forgets what follows from the ground; call when the state has become another.
    void reset() { doors_.reset(); }
    /// Chooses for people without an exit and for those whose turn it is, in all these groups.
    /// `groundClasses` are those of all characters.
    void run(WorldState& state, GoalFields& fields, std::span<const Leavers> leavers,
             std::span<const std::int32_t> groundClasses, ThreadPool& pool);
    /// Classes of ground of all people who leave, ascending.
    std::span<const std::int32_t> classes() const { return classes_; }
    /// The area of the exit that a character has chosen, and the field to it; null for none.
    const Area* areaOf(const Characters& characters, std::size_t i) const;
    const GoalField* fieldOf(const Characters& characters, std::size_t i,
                             std::span<const std::int32_t> groundClasses) const;
    /// The way of a character that does not take the shortest route; -1 for others.
    std::int32_t wayOf(std::size_t i) const { return way_.empty() ? -1 : way_[i]; }
    /// The route of such a character from a point; it keeps `wallGap` [m] farther from walls than it must.
    GoalWay wayThrough(const Characters& characters, std::size_t i, double wallGap) const;
    /// The field that this route follows.
    const GoalField& fieldThrough(const Characters& characters, std::size_t i) const;

private:
    /// An exit as a group sees it.
    struct Option {
        std::int32_t exit = 0;
        double attraction = 0.0;  // [s]
    };
    /// An agent that chooses.
    struct Chooser {
        std::int32_t character = 0;
        std::int32_t leavers = 0;
    };
    void listExits(WorldState& state, GoalFields& fields, std::span<const Leavers> leavers,
                   std::span<const std::int32_t> groundClasses);
    void listOptions(std::span<const Leavers> leavers);
    void findDoors(WorldState& state, GoalFields& fields, std::span<const Leavers> leavers);
    void readWays(const WorldState& state, std::span<const Leavers> leavers,
                  std::span<const std::int32_t> groundClasses);
    std::uint32_t doorsKey() const { return toExit_.empty() ? 0 : doors_.key(); }
    void findLines(const WorldState& state);
    void keepWays(const WorldState& state, GoalFields& fields, std::span<const Leavers> leavers);
    void count(const WorldState& state, std::span<const Leavers> leavers,
               std::span<const std::int32_t> groundClasses);
    void serve(const WorldState& state);
    std::int32_t aheadOf(std::size_t i) const { return ahead_.empty() ? -1 : ahead_[i]; }
    bool hasPassed(std::int32_t i) const { return !passed_.empty() && passed_[i] != 0; }
    void passDoors(const WorldState& state);
    void listChoosers(const WorldState& state, std::span<const Leavers> leavers);
    void choose(WorldState& state, std::span<const Leavers> leavers,
                std::span<const std::int32_t> groundClasses, const std::vector<Chooser>& list,
                std::size_t from, std::size_t stride, ThreadPool& pool);
    void chooseFirst(WorldState& state, std::span<const Leavers> leavers,
                     std::span<const std::int32_t> groundClasses, ThreadPool& pool);
    std::int32_t indexOf(std::uint32_t area) const;
    std::int32_t classIndex(std::int32_t groundClass) const;
    const GoalField& fieldTo(std::int32_t exit, std::int32_t classIndex) const {
        return *fields_[static_cast<std::size_t>(exit) * classes_.size() +
                        static_cast<std::size_t>(classIndex)];
    }
    /// The exit and the door that an agent has chosen.
    struct Choice {
        std::int32_t exit = -1;  // -1 for none.
        std::int32_t way = -1;   // -1 for the shortest.
        ExitTimes::First first;
        bool hasTurned = false;  // True if the agent had another choice that is still possible.
    };
    /// The choice by which an agent leaves soonest, and its present choice.
    struct Best {
        Choice choice, own;
        double least = kInfiniteCost, ofOwn = kInfiniteCost;
        double error = 0.0, ownError = 0.0;  // Errors of these times.
    };
    Choice best(const WorldState& state, const Leavers& leavers, const Chooser& chooser,
                std::span<const std::int32_t> groundClasses) const;
    template <class Offer>
    void offerWays(const WorldState& state, std::size_t i, std::int32_t exit, bool byTime, double way,
                   bool hasDoors, const Offer& offer) const;
    double speedOf(const WorldState& state, std::size_t i) const;
    double walkTime(const WorldState& state, std::size_t i, double cost) const;

    std::vector<Area*> exits_;                  // Open exits by which people may leave, in ascending order.
    std::vector<const GoalField*> fields_;      // By exit and index of class.
    std::vector<std::uint32_t> ids_;            // Ids of the areas of the exits.
    std::vector<std::int32_t> classes_;         // Classes of ground, ascending.
    std::vector<std::vector<Option>> options_;  // By leavers.
    std::vector<std::uint8_t> allowed_;         // By exit: whether the group at hand may leave by it.
    std::vector<Chooser> first_;                // Agents without an exit.
    std::vector<Chooser> turn_;                 // Agents whose turn it is to choose again.
    std::vector<Choice> chosen_;                // By first_ or turn_.
    std::vector<std::int32_t> way_;             // By character, as wayOf(); empty where there are no doors.
    // By character: how often it has changed its choice; empty without choice.
    std::vector<std::int32_t> turns_;
    std::vector<std::int32_t> ahead_;   // By character: number of people ahead in its line; -1 for none.
    std::vector<std::uint8_t> passed_;  // By character: 1 if it has come through such a door.
    std::vector<const GoalField*> ownFields_;   // By exit, for the first class.
    std::vector<const Doors::ToExit*> toExit_;  // By exit; empty where there are no doors.
    Doors doors_;
    ExitTimes times_;
    Herds herds_;
    bool herding_ = false;  // True if an agent follows others.
};

}  // namespace muster
