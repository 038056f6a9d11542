// When somebody will have left by an exit and the doors before it: by walks and the waits at each
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

/// One rule for exits and doors: who is served where, and when.
class ExitTimes {
public:
    /// Where somebody comes to first.
    struct First {
        std::int32_t way = -1;    ///< -1 for the exit itself.
        double walk = 0.0;        ///< To there [s].
        std::int32_t place = -1;  ///< Behind so many others in the line before the exit; -1 for not in it.
    };
    /// Nobody goes to any of these exits. `toExit` are theirs, empty where there are no doors.
    void begin(const Doors& doors, std::span<Area* const> exits, std::vector<const Doors::ToExit*>& toExit,
               double metresPerSecond);
    /// Where somebody comes to first who has `seconds` to an exit, at `metresPerSecond`, by a way, -1 for
    /// the shortest.
    First first(std::size_t exit, Vec2 p, std::int32_t way, double seconds, double metresPerSecond) const;
    /// Counts somebody.
    void add(std::size_t exit, const First& first) {
        if (first.place >= 0) return waits_.addToLine(exit);
        waits_.add(nodeOf(exit, first.way), exit, first.walk);
    }
    /// Serves all who have been counted. `fields` lead to the exits.
    void serve(const Parameters::Character& usual, std::span<const GoalField* const> fields);
    /// When somebody will have left by an exit [s], who has been counted there or not.
    double leaves(std::size_t exit, const First& first, double metresPerSecond, bool isCounted) const;
    /// By how much that may err [s]: what one person takes where it comes to first and at the exit.
    double error(std::size_t exit, const First& first) const {
        return std::max(waits_.perPerson(exit), waits_.perPerson(nodeOf(exit, first.way)));
    }
    /// The way on from another one by which somebody leaves soonest who is there now; -1 for none.
    std::int32_t onwardFrom(std::int32_t way, std::size_t exit, double metresPerSecond) const;

private:
    std::size_t nodeOf(std::size_t exit, std::int32_t way) const {
        return way < 0 ? exit : waits_.nodeOf(way);
    }
    // The next door or exit after a way, to which `passed(way, at)` tells when somebody has passed it who
    // comes at a time.
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
    // When somebody has passed a door who comes to it at a time.
    double passes(std::int32_t way, double at, bool isCounted = false) const;
    void serveExit(std::size_t exit, const Parameters::Character& usual, const GoalField& field);

    const Doors* doors_ = nullptr;
    std::vector<Area*> exits_;
    std::vector<const Doors::ToExit*> toExit_;  // By exit; empty where there are no doors.
    double speed_ = 1.0;                        // Usual one [m/s].
    ExitWaits waits_;
    std::vector<double> flow_;  // By way [1/s].
};

}  // namespace muster
