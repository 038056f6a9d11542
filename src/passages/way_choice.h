// Who goes through which passage, so that the last one arrives soonest (quickest flow; Ford and Fulkerson
// 1958).
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace muster {

/// Characters that have to go through one of some passages. Goals are exchanged freely among the characters
/// of a pool, so only the number of goals of a pool that are reached through a passage is tied to that of its
/// characters.
struct WayChoiceInput {
    /// Time of the walk to each passage [s], passages of character 0 first; infinite for those not open to
    /// it.
    std::span<const double> arrival;
    /// Time of the walk from each passage to the goal of each character, in the same order [s].
    std::span<const double> onward;
    std::span<const std::int32_t> pool;  ///< Of each character, 0 or more.
    std::span<const std::uint8_t>
        movable;                       ///< Per character, 0 for one that keeps its passage if it has one.
    std::span<const double> capacity;  ///< Characters a second that each passage lets through.
};

/// Chooses passages. Owns the working memory.
class WayChoice {
public:
    /// Takes what has to be chosen among; the spans must stay valid.
    void read(const WayChoiceInput& input);
    /// The longest wait where everybody takes the shortest way [s]. Call after read().
    double longestWait();
    /// Reads the passage of each character in `way` (-1 for none yet) and changes those of the movable, where
    /// the last arrival then is earlier by more than a twentieth and half a second or where somebody
    /// has none. Writes when each is let through in `slot` [s]. Returns the time of the last arrival [s].
    /// Call after read().
    double choose(std::span<std::int32_t> way, std::span<double> slot);

private:
    void sortAll();
    void begin(std::span<const std::int32_t> way);
    double improve();
    bool improveFrom(std::int32_t from, std::int32_t batch);
    const std::vector<std::int32_t>& nearGoals(std::int32_t from, std::int32_t to);
    bool move(std::int32_t from, std::int32_t to, std::int32_t batch);
    void takeBack(std::int32_t from);
    void exchangeAll(const std::vector<std::vector<std::int32_t>>& byDetour, std::vector<std::int32_t>& way,
                     std::span<const std::uint8_t> free);
    double lastBy(std::int32_t passage, double* slot);
    double cost(std::span<const double> table, std::int32_t i, std::int32_t p) const {
        return table[static_cast<std::size_t>(i) * passages_ + p];
    }

    WayChoiceInput input_;
    std::size_t passages_ = 0;
    std::size_t people_ = 0;
    std::vector<std::int32_t> way_;      // Of each character.
    std::vector<std::int32_t> none_;     // For each character, no passage.
    std::vector<std::int32_t> goalWay_;  // Of each character's goal.
    std::vector<std::uint8_t> free_;
    std::vector<double> last_;                             // Per passage [s].
    std::vector<std::vector<std::int32_t>> byArrival_;     // Per passage.
    std::vector<std::vector<std::int32_t>> byOnward_;      // Per passage, the farthest goal first.
    std::vector<std::vector<std::int32_t>> byDetour_;      // Per two passages, the least first.
    std::vector<std::vector<std::int32_t>> byGoalDetour_;  // The same for goals.
    std::vector<std::vector<std::int32_t>> byNearGoal_;    // The same, near goals first where equal.
    std::vector<std::int32_t> movedPeople_, movedGoals_, wanted_;
    std::vector<std::size_t> cursor_;  // Per pool.
    std::vector<std::int32_t> before_, beforeGoals_;
    std::vector<std::uint8_t> settled_;  // Per passage.
    std::vector<std::pair<double, std::int32_t>> keys_;
    std::vector<double> slots_;
};

}  // namespace muster
