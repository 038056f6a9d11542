// The basis of a transportation problem: a spanning tree with its flows and duals (Dantzig 1951).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace muster {

/// A cost in two parts, of which the level counts first.
struct LevelCost {
    std::int64_t level = 0;  ///< Level, which counts before the value.
    double value = 0.0;      ///< Cost to the power of the objective.

    LevelCost operator+(LevelCost b) const { return {level + b.level, value + b.value}; }  ///< Sum.
    LevelCost operator-(LevelCost b) const { return {level - b.level, value - b.value}; }  ///< Difference.
    bool operator<(LevelCost b) const {                                                    ///< Lexicographic.
        return level != b.level ? level < b.level : value < b.value;
    }
};

/// Characters, places and a root are the nodes of a spanning tree; flow goes along its arcs only. The supply
/// that a character does not send goes to the root, the amount that a place lacks comes from there, at a
/// level above all others. So every tree has a feasible flow, whatever the amounts are, and the least cost
/// sends as much as possible. The tree is strongly feasible (Cunningham 1976), so that pivots without a
/// change of flow do not go round in circles.
class TransportTree {
public:
    /// Level of a unit that is not sent.
    static constexpr std::int64_t kUnsentLevel = std::int64_t{1} << 24;

    /// Sizes the tree; every node hangs on the root.
    void reset(std::int32_t characters, std::int32_t places);
    /// Replaces the tree by the forest of these pairs, which must have no cycle. `hook` names a node of each
    /// part, by which it hangs on the root. After reset().
    void plant(std::span<const std::int32_t> character, std::span<const std::int32_t> place,
               std::span<const std::int32_t> hook);
    /// Takes over amounts [units] >= 0 and finds the flows. Where a node would need a negative flow, its
    /// subtree goes to the root.
    void balance(std::span<const std::int64_t> supply, std::span<const std::int64_t> demand);
    /// Finds the duals from arcCost().
    void findDuals();
    /// Exchanges an arc of the tree for one from `tail`, a character or the root, to `head`, a place or the
    /// root, which must have a negative reduced cost. Returns the number of nodes that it touched.
    std::int64_t pivot(std::int32_t tail, std::int32_t head, LevelCost cost);

    std::int32_t characters() const { return characters_; }      ///< Number of characters.
    std::int32_t places() const { return places_; }              ///< Number of places.
    std::int32_t root() const { return characters_ + places_; }  ///< The last node.
    /// The node of a place.
    std::int32_t nodeOfPlace(std::int32_t place) const { return characters_ + place; }
    std::int32_t parent(std::int32_t node) const { return parent_[node]; }  ///< The parent of a node.
    /// Units between a node and its parent.
    std::int64_t flow(std::int32_t node) const { return flow_[node]; }
    /// True where a node's arc is a pair, whose character and place it tells.
    bool pairOf(std::int32_t node, std::int32_t& character, std::int32_t& place) const;
    /// Cost of the arc between a node and its parent; that of arcs to the root is known.
    LevelCost& arcCost(std::int32_t node) { return arcCost_[node]; }
    /// Cost of the arc between a node and its parent.
    LevelCost arcCost(std::int32_t node) const { return arcCost_[node]; }
    LevelCost dual(std::int32_t node) const { return dual_[node]; }  ///< Dual of a node, after findDuals().
    /// The reduced cost of an arc of this cost between two nodes.
    LevelCost reducedCost(std::int32_t tail, std::int32_t head, LevelCost cost) const {
        return cost - dual_[tail] - dual_[head];
    }
    /// The place that gets most from a character, the first of several; -1 where nothing is sent.
    std::int32_t mainPlace(std::int32_t character) const;
    /// Calls visit(place) for every place that is joined to a character.
    template <class Visit>
    void forPlacesOf(std::int32_t character, Visit visit) const {
        if (parent_[character] != root()) visit(parent_[character] - characters_);
        for (std::int32_t c = firstChild_[character]; c >= 0; c = nextSibling_[c]) visit(c - characters_);
    }

    /// Lets an archive read or write the tree; the rest follows from it in balance().
    template <class Archive>
    void visit(Archive& archive) {
        archive(characters_, places_, parent_);
        if constexpr (Archive::kReading)
            if (!consistent()) archive.fail();
    }

private:
    bool isCharacter(std::int32_t node) const { return node < characters_; }
    bool consistent();
    void link();
    bool findOrder();
    void hangOnRoot(std::int32_t node);
    void unlink(std::int32_t node);
    void adopt(std::int32_t node, std::int32_t parent);
    bool findFlows(std::span<const std::int64_t> supply, std::span<const std::int64_t> demand);
    std::int32_t push(std::int32_t tail, std::int32_t head, std::int64_t& most, std::int64_t& work);
    void reroot(std::int32_t node, std::int32_t top, std::int32_t parent, LevelCost cost, std::int64_t flow,
                std::int64_t& work);
    std::int64_t shift(std::int32_t top, LevelCost change);

    std::int32_t characters_ = 0;
    std::int32_t places_ = 0;
    std::vector<std::int32_t> parent_;  // Parent of each node but the root.
    // Follows from the tree, the amounts and the costs.
    std::vector<std::int64_t> flow_;  // Per node [units]: from characters up, to places down.
    std::vector<LevelCost> arcCost_;  // Cost of each node's arc.
    std::vector<LevelCost> dual_;     // Dual per node; that of the root is 0.
    std::vector<std::int32_t> depth_, firstChild_, nextSibling_, previousSibling_;
    std::vector<std::int32_t> order_;  // Nodes, parents first.
    // Working memory.
    std::vector<std::int32_t> stack_;
    std::vector<std::int32_t> edgeBegin_, edges_;
};

}  // namespace muster
