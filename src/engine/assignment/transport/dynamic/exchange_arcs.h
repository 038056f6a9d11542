// The arcs of the exchange graph, sixteen from each node.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace muster {

/// Heads and costs of the arcs. Arcs are numbered node by node: the arcs from node k are those from
/// k * kArcsPerNode. A slot without an arc holds a self loop. An arc cost keeps the value of its last refresh
/// (ExchangeGraph::arcCost).
class ExchangeArcs {
public:
    static constexpr std::int32_t kArcsPerNode = 16;    ///< Number of arc slots of each node.
    static constexpr std::int32_t kGeneratedSlot = 14;  ///< The slot of the arc that column generation adds.
    static constexpr float kSelfLoopCost = 1e35f;  ///< Cost of a self loop, so large that no path uses it.

    /// Makes all arcs self loops.
    void reset(std::int32_t nodes);
    /// Puts an arc from `tail` to `head` into slot `slot` and steps on to the next slot. Does nothing where
    /// `head` is -1, is `tail`, or is in an earlier slot, or where `slot` is `end`.
    void add(std::int32_t tail, std::int32_t& slot, std::int32_t end, std::int32_t head) {
        if (head < 0 || head == tail || slot >= end) return;
        const auto row = head_.begin() + static_cast<std::ptrdiff_t>(tail) * kArcsPerNode;
        if (std::find(row, row + slot, head) != row + slot) return;
        setHead(tail * kArcsPerNode + slot++, head);
    }
    /// Fills the slots from `slot` to `end` with self loops.
    void padWithSelfLoops(std::int32_t node, std::int32_t& slot, std::int32_t end) {
        for (; slot < end; ++slot) setHead(node * kArcsPerNode + slot, node);
    }
    /// The arc that column generation added to a node; a self loop where there is none.
    static std::int32_t generatedArc(std::int32_t node) { return node * kArcsPerNode + kGeneratedSlot; }
    /// Replaces the arc that column generation added.
    void setGeneratedArc(std::int32_t tail, std::int32_t head, float cost) {
        setHead(generatedArc(tail), head);
        cost_[generatedArc(tail)] = cost;
    }
    /// Sets an arc cost.
    void setCost(std::int32_t arc, float cost) { cost_[arc] = cost; }
    /// Sorts the arcs by their heads, for incoming(). Does nothing where they are sorted already.
    void indexIncoming();
    /// Sizes the working memory for arcs that were read.
    void afterReading();

    /// Node at the tail of an arc.
    static std::int32_t tail(std::int32_t arc) { return arc / kArcsPerNode; }
    std::int32_t head(std::int32_t arc) const { return head_[arc]; }  ///< Node at the head of an arc.
    /// Cost of an arc; see ExchangeGraph::arcCost.
    float cost(std::int32_t arc) const { return cost_[arc]; }
    const std::vector<std::int32_t>& heads() const { return head_; }  ///< Heads per arc.
    const std::vector<float>& costs() const { return cost_; }         ///< Costs per arc.
    /// The arc from one node to another, the first where there are several, -1 for none.
    std::int32_t find(std::int32_t tail, std::int32_t head) const;
    /// Arcs to a node, self loops included, ascending, as they were at the last indexIncoming().
    std::span<const std::int32_t> incoming(std::int32_t node) const {
        const std::int32_t begin = incomingBegin_[node];
        return {incoming_.data() + begin, incoming_.data() + incomingBegin_[node + 1]};
    }

    /// Lets an archive read or write the arcs.
    template <class Archive>
    void visit(Archive& archive) {
        archive(head_, cost_);
        if constexpr (Archive::kReading)
            if (!consistent()) archive.fail();
    }

private:
    // The index holds on where the head stays the same.
    void setHead(std::int32_t arc, std::int32_t head) {
        if (head_[arc] == head) return;
        indexed_ = false;
        --incomingCount_[head_[arc]];
        ++incomingCount_[head];
        head_[arc] = head;
    }
    bool consistent() const;

    std::vector<std::int32_t> head_;  // Head of each arc.
    std::vector<float> cost_;         // Cost of each arc [units of CostPower].
    // The index of incoming arcs.
    std::vector<std::int32_t> incomingCount_;  // Per node: arcs to it.
    std::vector<std::int32_t> incoming_;       // Arcs, sorted by head.
    std::vector<std::int32_t> incomingBegin_;  // Per node: its first in incoming_; one more at the end.
    bool indexed_ = false;                     // True if the index is that of the present heads.
};

}  // namespace muster
