// By which exit each leaves: where it will have left soonest, by its way and the wait before the exit
// (docs/method/goals.md).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "engine/systems/goals/exit_waits.h"
#include "engine/systems/goals/goal_fields.h"
#include "engine/systems/goals/herds.h"

namespace muster {

/// The members of a group that leaves.
struct Leavers {
    Group* group = nullptr;        ///< Theirs.
    const Order* order = nullptr;  ///< That they carry out.
};

/// Chooses exits for all who leave.
class ExitChooser {
public:
    /// Chooses for those who have no exit, and for those whose turn it is, of all these groups.
    /// `groundClasses` are those of all characters.
    void run(WorldState& state, GoalFields& fields, std::span<const Leavers> leavers,
             std::span<const std::int32_t> groundClasses, ThreadPool& pool);
    /// Classes of ground of all who leave, ascending.
    std::span<const std::int32_t> classes() const { return classes_; }
    /// The area of the exit that a character has chosen, and the field to it; null for none.
    const Area* areaOf(const Characters& characters, std::size_t i) const;
    const GoalField* fieldOf(const Characters& characters, std::size_t i,
                             std::span<const std::int32_t> groundClasses) const;

private:
    /// An exit as a group sees it.
    struct Option {
        std::int32_t exit = 0;
        double attraction = 0.0;  // [s]
    };
    /// Somebody who chooses.
    struct Chooser {
        std::int32_t character = 0;
        std::int32_t leavers = 0;
    };
    void listExits(WorldState& state, GoalFields& fields, std::span<const Leavers> leavers,
                   std::span<const std::int32_t> groundClasses);
    void listOptions(std::span<const Leavers> leavers);
    void count(const WorldState& state, std::span<const Leavers> leavers);
    void serve(WorldState& state);
    void listChoosers(const WorldState& state, std::span<const Leavers> leavers);
    std::int32_t indexOf(std::uint32_t area) const;
    std::int32_t classIndex(std::int32_t groundClass) const;
    const GoalField& fieldTo(std::int32_t exit, std::int32_t classIndex) const {
        return *fields_[static_cast<std::size_t>(exit) * classes_.size() +
                        static_cast<std::size_t>(classIndex)];
    }
    std::int32_t best(const WorldState& state, const Leavers& leavers, const Chooser& chooser,
                      std::span<const std::int32_t> groundClasses, double& walk) const;
    double walkTime(const WorldState& state, std::size_t i, double cost) const;

    std::vector<Area*> exits_;                  // Open ones that somebody may leave by, in ascending order.
    std::vector<const GoalField*> fields_;      // By exit and index of class.
    std::vector<std::uint32_t> ids_;            // Of their areas.
    std::vector<std::int32_t> classes_;         // Of ground, ascending.
    std::vector<std::vector<Option>> options_;  // By leavers.
    std::vector<std::uint8_t> allowed_;         // By exit: whether the group at hand may leave by it.
    std::vector<Chooser> first_;                // Who have no exit.
    std::vector<Chooser> turn_;                 // Whose turn it is to think again.
    std::vector<std::int32_t> chosen_;          // By first_ or turn_: an exit, -1 for none.
    std::vector<double> walk_;                  // And the time of the way to it [s].
    ExitWaits waits_;
    Herds herds_;
    bool herding_ = false;  // Somebody follows others.
};

}  // namespace muster
