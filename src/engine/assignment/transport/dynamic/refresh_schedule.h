// The nodes that refresh their arcs in a step.
#pragma once

#include <cstdint>

namespace muster {

/// Spreads the refreshes of all nodes evenly over the steps of a round and the rounds of a period.
struct RefreshSchedule {
    std::int32_t round = 0;            ///< Rounds since the start.
    bool beginsRound = true;           ///< True in the first step of the round.
    std::int32_t first = 0;            ///< The first node of this step of the round.
    std::int32_t end = 0;              ///< One past the last node of this step of the round.
    std::int32_t period = 1;           ///< Rounds between two refreshes of a node, >= 1.
    std::int32_t candidatePeriod = 1;  ///< Rounds between two searches for the heads of its arcs, >= 1.

    /// True where the heads of the node's arcs are to be searched for.
    bool headsDue(std::int32_t node) const { return inStep(node) && (node + round) % candidatePeriod == 0; }
    /// True where the costs of the node's arcs are to be refreshed.
    bool costsDue(std::int32_t node) const { return inStep(node) && (node + round) % period == 0; }
    /// True where such a refresh evaluates all arcs of the node, instead of the tight ones only.
    bool allArcsDue(std::int32_t node) const { return (node + round) / period % kFullRefreshEvery == 0; }

private:
    static constexpr std::int32_t kFullRefreshEvery = 4;
    bool inStep(std::int32_t node) const { return node >= first && node < end; }
};

}  // namespace muster
