// Chooses the heads of arcs: places near a node, and the nodes of characters near its assignee.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/cell_list.h"
#include "engine/assignment/transport/dynamic/assignment_nodes.h"
#include "engine/assignment/transport/dynamic/assignment_step.h"
#include "engine/assignment/transport/dynamic/exchange_arcs.h"

namespace muster {

/// A part of ExchangeGraph, which prepares the candidates of a step before it lets them choose. Owns its
/// working memory.
class ArcCandidates {
public:
    /// Sizes the working memory.
    void reserve(std::int32_t nodes) { expensive_.reserve(nodes); }
    /// Sorts characters and places into cells, and finds the expensive nodes and those of the highest dual.
    void prepare(const AssignmentStep& step, const AssignmentNodes& nodes, std::span<const double> dual,
                 std::span<const float> matchedCost);
    /// Replaces the heads of all arcs from a node. The generated arc stays where it leads to a place.
    void chooseHeads(const AssignmentStep& step, const AssignmentNodes& nodes,
                     std::span<const float> matchedCost, std::int32_t node, ExchangeArcs& arcs) const;
    /// Nodes whose matched cost was more than three times the mean at the last prepare(), ascending.
    const std::vector<std::int32_t>& expensive() const { return expensive_; }

private:
    void addExpensive(const AssignmentStep& step, const AssignmentNodes& nodes, std::int32_t node,
                      std::int32_t& slot, ExchangeArcs& arcs) const;

    CellList placeCells_;
    CellList characterCells_;
    std::vector<std::int32_t> expensive_;  // Expensive nodes, ascending.
    float expensiveCost_ = 0.0f;           // Matched cost above which a node is expensive [m].
    std::int32_t highestMatched_ = -1;     // The matched node of the highest dual, -1 for none.
    std::int32_t highestUnmatched_ = -1;  // The dummy node of the highest dual with an assignee, -1 for none.
};

}  // namespace muster
