// Assigns passages to agents so that the last one arrives soonest (quickest flow; Ford and Fulkerson 1958).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/passages/key_sort.h"

namespace muster {

/// Characters that have to go through one of some passages. Goals are exchanged freely among the characters
/// of a pool, so only the number of goals of a pool that are reached through a passage is tied to that of its
/// characters.
struct WayChoiceInput {
    /// Time of the walk to each passage [s], passages of character 0 first; infinite for passages that are
    /// closed to it.
    std::span<const double> arrival;
    /// Time of the walk from each passage to the goal of each character, in the same order [s].
    std::span<const double> onward;
    std::span<const std::int32_t> pool;  ///< Pool of each character, 0 or more.
    /// Per character, 0 for one that keeps its passage if it has one.
    std::span<const std::uint8_t> movable;
    std::span<const double> capacity;  ///< Capacity of each passage [1/s].
};

/// Chooses passages. Owns the working memory.
class WayChoice {
public:
    /// Takes the input of a choice; the spans must stay valid.
    void read(const WayChoiceInput& input);
    /// The longest wait if every agent takes the shortest route [s]. Call after read().
    double longestWait();
    /// Reads the passage of each character in `way` (-1 for none yet) and changes those of movable characters
    /// where the last arrival becomes earlier by more than a twentieth and half a second, or where a
    /// character has none. Writes when each is let through in `slot` [s]. Returns the time of the last
    /// arrival [s]. Call after read().
    double choose(std::span<std::int32_t> way, std::span<double> slot);

private:
    // An agent and its time at a passage, or a goal and the time of the walk to it.
    struct Turn {
        double time = 0.0;  // [s]
        std::int32_t index = 0;
        std::int32_t pool = 0;
    };
    static bool isSooner(const Turn& x, const Turn& y) {
        return x.time < y.time || (x.time == y.time && x.index < y.index);
    }
    // The agents that go through one passage.
    struct Line {
        std::vector<Turn> queue;            // By arrival.
        std::vector<Turn> goals;            // By pool, the farthest first.
        std::vector<std::int32_t> poolEnd;  // Per pool: behind its last goal.
    };
    // Agents that may leave one passage for another, sorted on demand.
    struct Order {
        std::vector<SortKey> keys;
        bool known = false;
    };

    void begin(std::span<const std::int32_t> way);
    double improve();
    bool improveFrom(std::int32_t from, std::int32_t batch);
    const std::vector<SortKey>& leavers(bool goals, std::int32_t from, std::int32_t to);
    bool move(std::int32_t from, std::int32_t to, std::int32_t batch);
    void takeBack(std::int32_t from);
    void fillMoved(std::int32_t to);
    void keepMove(std::int32_t from, std::int32_t to);
    bool freeOthers(std::span<const std::int32_t> way);
    void readSlots(std::span<double> slot);
    bool exchangeAll(std::span<const double> table, std::vector<std::int32_t>& way,
                     std::span<const std::uint8_t> free);
    bool exchange(std::span<const double> table, std::vector<std::int32_t>& way,
                  std::span<const std::uint8_t> free, std::int32_t p, std::int32_t q);
    bool keepWorthwhile();
    std::int32_t nextOf(const std::vector<SortKey>& order, std::size_t& at, std::int32_t pool) const;

    void fillLines();
    void fill(Line& line, std::vector<SortKey>& people, std::vector<SortKey>& goals);
    void dropLeft(const Line& line, std::int32_t passage, Line& out) const;
    static void merge(const Line& one, const Line& other, Line& out);
    double lastOf(std::int32_t passage, const Line& joining, double limit, double* slot);
    double cost(std::span<const double> table, std::int32_t i, std::int32_t p) const {
        return table[static_cast<std::size_t>(i) * passages_ + p];
    }

    WayChoiceInput input_;
    std::size_t passages_ = 0;
    std::size_t people_ = 0;
    std::size_t pools_ = 0;
    std::vector<std::int32_t> way_;      // Passage of each character.
    std::vector<std::int32_t> none_;     // For each character, no passage.
    std::vector<std::int32_t> goalWay_;  // Passage of each character's goal.
    std::vector<std::uint8_t> free_;
    std::vector<double> last_;  // Time of the last arrival per passage [s].
    std::vector<Line> lines_;   // Per passage.
    Line moved_, other_, nobody_;
    std::vector<Order> leavers_, goalLeavers_;  // Per two passages.
    std::vector<std::int32_t> movedPeople_, movedGoals_, wanted_;
    std::vector<std::int32_t> cursor_, joiningCursor_;  // Per pool.
    std::vector<std::int32_t> before_, beforeGoals_;
    std::vector<std::uint8_t> settled_;                  // Per passage.
    std::vector<SortKey> there_, back_;                  // Agents that may be exchanged.
    std::vector<double> leastThere_, leastBack_;         // Per pool.
    std::vector<std::vector<SortKey>> keys_, goalKeys_;  // Per passage.
    std::vector<double> slots_;
    KeySort sort_;
};

}  // namespace muster
