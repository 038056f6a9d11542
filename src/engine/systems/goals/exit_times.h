// When a person will have left by an exit and the doors before it, from walks and the waits at each
// (docs/method/goals.md).
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/state/area.h"
#include "engine/systems/goals/doors.h"
#include "engine/systems/goals/exit_waits.h"

namespace muster {

/// One rule for exits and doors: people are served in the order of their arrival.
class ExitTimes {
public:
    /// The door or exit to which a person comes first.
    struct First {
        std::int32_t way = -1;  ///< -1 for the exit itself.
        double walk = 0.0;      ///< Time of the walk to it [s].
        /// Number of others ahead in the line before the exit; -1 for a person not in it.
        std::int32_t ahead = -1;
    };
    /// Begins without people. `toExit` belong to `exits`, empty where there are no doors.
    void begin(const Doors& doors, std::span<Area* const> exits, std::vector<const Doors::ToExit*>& toExit,
               double metresPerSecond);
    /// The first door or exit of a person at `p` that has `seconds` to an exit, at `metresPerSecond`, by a
    /// way, -1 for the shortest.
    First first(std::size_t exit, Vec2 p, std::int32_t way, double seconds, double metresPerSecond) const;
    /// Counts a person.
    void add(std::size_t exit, const First& first) {
        if (first.ahead >= 0) return waits_.addToLine(exit);
        waits_.add(nodeOf(exit, first.way), exit, first.walk);
    }
    /// Serves all people that have been counted. `fields` lead to the exits.
    void serve(const Parameters::Character& usual, std::span<const GoalField* const> fields);
    /// When a person will have left by an exit [s], whether it has been counted there or not.
    double leaves(std::size_t exit, const First& first, double metresPerSecond, bool isCounted) const;
    /// The error of leaves() [s]: the time that one person takes at its first door and at the exit.
    double error(std::size_t exit, const First& first) const {
        return std::max(waits_.perPerson(exit), waits_.perPerson(nodeOf(exit, first.way)));
    }
    /// The way after `way` by which a person who is there now leaves soonest; -1 for none.
    std::int32_t onwardFrom(std::int32_t way, std::size_t exit, double metresPerSecond) const;

private:
    std::size_t nodeOf(std::size_t exit, std::int32_t way) const {
        return way < 0 ? exit : waits_.nodeOf(way);
    }
    // The next door or exit after a way. `passed(way, at)` tells when a person who comes to a way at a time
    // has passed it.
    template <class Passed>
    First next(std::int32_t way, std::size_t exit, double now, double metresPerSecond,
               const Passed& passed) const {
        const Doors::ToExit& to = *toExit_[exit];
        if (doors_->leadsTo(way, to)) return {-1, to.onward[way] / metresPerSecond};
        First best{-1, to.onward[way] / metresPerSecond};
        double least = kInfiniteCost;
        for (const Doors::Next& other : doors_->next(way)) {
            if (!(to.onward[other.way] < kInfiniteCost)) continue;
            const double walk = other.cost / metresPerSecond;
            const double time = passed(other.way, now + walk) + to.onward[other.way] / metresPerSecond;
            if (!(time < least)) continue;
            least = time;
            best = {other.way, walk};
        }
        return best;
    }
    // Time at which a person who comes to a door at a time has passed it [s].
    double passes(std::int32_t way, double at, bool isCounted = false) const;
    void serveExit(std::size_t exit, const Parameters::Character& usual, const GoalField& field);

    const Doors* doors_ = nullptr;
    std::vector<Area*> exits_;
    std::vector<const Doors::ToExit*> toExit_;  // By exit; empty where there are no doors.
    double speed_ = 1.0;                        // Usual speed [m/s].
    ExitWaits waits_;
    std::vector<double> flow_;  // By way [1/s].
};

}  // namespace muster
