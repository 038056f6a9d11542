// Definition and input of a dynamic assignment.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "muster/vec2.h"

namespace muster {

/// The objective, the commit threshold, and the work of one step. Work is limited by counts, never by time,
/// so that results do not depend on the machine. "Far" and "near" compare the mean cost of all nodes with
/// `farCost` and `nearCost`.
struct DynamicAssignmentDef {
    double exponent = 2.0;  ///< Exponent p of the objective sum c^p, 1 to 16.
    /// Gain in the objective that an exchange must exceed [cost^p] >= 0. The plan sets it (PlanDef).
    double threshold = 0.0;
    /// Share of the objective of its assignees that the gain of an exchange must exceed >= 0. The plan sets
    /// it (PlanDef).
    double thresholdShare = 0.0;
    std::int32_t refreshPeriod = 4;      ///< Steps between two refreshes of a node's arcs, >= 1.
    std::int32_t farRefreshPeriod = 16;  ///< Steps between two refreshes while the crowd is far, >= 1.
    std::int32_t nearRefreshPeriod = 2;  ///< Steps between two refreshes while the crowd is near, >= 1.
    std::int32_t candidatePeriod = 32;   ///< Steps between two searches for the heads of a node's arcs, >= 1.
    double farCost = 15.0;               ///< Mean cost above which the crowd is far [m].
    double nearCost = 1.0;               ///< Mean cost below which the crowd is near [m].
    double settledPerNode = 3.0;     ///< Number of nodes that the searches of a step may settle, per node.
    double farSettledPerNode = 0.4;  ///< Number of these nodes while the crowd is far.
    std::int32_t searchLimit = 600;  ///< Number of nodes that one search may settle.
    /// Steps before a node whose cycle gained too little is tried again, <= 255.
    std::int32_t retryDelay = 5;
    /// Steps before such a node is tried again while the crowd is far, <= 255.
    std::int32_t farRetryDelay = 16;
    double invalidatingChange = 0.3;  ///< Change of a matched cost that invalidates all arcs of its node [m].
    std::int32_t initialRounds = 3;   ///< Number of repairs after a cold start.
    std::int32_t startNodes = 400;   ///< Number of nodes whose arcs one call of a spread start chooses, >= 1.
    std::int32_t stepsPerRound = 1;  ///< Steps over which one round of refresh and repair is spread, >= 1.

    /// Steps at the end of a round that repair. A round of one step refreshes and repairs in it.
    std::int32_t repairSteps() const { return std::max(1, (stepsPerRound + 1) / 3); }
    /// Steps at the beginning of a round that refresh arcs.
    std::int32_t refreshSteps() const { return std::max(1, stepsPerRound - repairSteps()); }
    /// The rounds in a number of steps; about twice as many steps where rounds take several.
    std::int32_t rounds(std::int32_t steps) const {
        return std::max(1, stepsPerRound <= 1 ? steps : (2 * steps + stepsPerRound - 1) / stepsPerRound);
    }
};

/// The positions of one step. Spans stay valid during the call only.
struct AssignmentInput {
    std::span<const Vec2> characters;       ///< Positions of the characters [m].
    std::span<const Vec2> places;           ///< Positions of the places [m].
    std::span<const std::uint8_t> usable;   ///< Per place, 0 for one nobody may take; empty for all.
    std::span<const std::uint8_t> present;  ///< Per character, 0 for one that is left out; empty for all.

    /// True where the place may be taken.
    bool isUsable(std::int32_t place) const { return usable.empty() || usable[place] != 0; }
    /// True where the character takes part.
    bool isPresent(std::int32_t character) const { return present.empty() || present[character] != 0; }
};

}  // namespace muster
