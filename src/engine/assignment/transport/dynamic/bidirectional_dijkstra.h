// Bidirectional Dijkstra search on reduced costs (Pohl 1971) for the cycle that closes a violated arc.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/assignment/transport/dynamic/exchange_arcs.h"

namespace muster {

/// The end of a search.
enum class SearchResult : std::uint8_t {
    Cycle,         ///< A cycle of negative cost through the arc was found; see BidirectionalDijkstra::cycle.
    NoCycle,       ///< The graph has none: the duals can be changed so that the arc is no longer violated.
    LimitReached,  ///< The limit of settled nodes came first: the duals can be changed part of the way.
};

/// Searches for the shortest path from the head of a violated arc back to its tail, forward from the head and
/// backward from the tail. The length of an arc is its reduced cost, or 0 where that is negative. Owns its
/// working memory.
class BidirectionalDijkstra {
public:
    /// Sizes the working memory for searches that settle at most `limit` nodes.
    void reset(std::int32_t nodes, std::int32_t limit);
    /// Looks for a path from node `head` to node `tail` that is shorter than the violation of the arc between
    /// them: minus its reduced cost, > 0. `returnCost` is the length of the return arc, which needs no
    /// search. Settles at most `limit` nodes. The incoming arcs must be indexed.
    SearchResult run(const ExchangeArcs& arcs, std::span<const double> dual, std::int32_t tail,
                     std::int32_t head, double violation, double returnCost, std::int32_t limit);
    /// Changes the duals as far as the last search allows: lower around the head, higher around the tail. No
    /// reduced cost that is not negative becomes negative, and none that is negative falls, but for arcs to
    /// nodes that the search reached beyond its bound and dropped.
    void updateDuals(std::span<double> dual) const;

    /// The nodes of the cycle from head to tail, after SearchResult::Cycle.
    std::span<const std::int32_t> cycle() const { return cycle_; }
    /// Nodes settled by the last search.
    std::int32_t settled() const { return settled_; }

private:
    // An entry of a heap; out of date once its node is settled.
    struct Entry {
        double distance;
        std::int32_t node;
    };
    // State of a node on one side.
    struct Label {
        double distance = 0.0;          // Valid where the stamp is that of this search.
        std::int32_t predecessor = -1;  // The node it was reached from.
        std::uint32_t stamp = 0;        // The search that reached it; one more once it is settled.
    };
    // One direction of the search.
    struct Side {
        std::vector<Label> label;         // Labels per node.
        std::vector<Entry> heap;          // Binary heap, least distance first.
        std::vector<std::int32_t> order;  // Settled nodes.
        std::size_t capacity = 0;         // Entries that fit in the heap.
        double overflowDistance = 0.0;    // Least distance of the entries that did not fit.
        double radius = 0.0;              // Duals of settled nodes nearer than this change.
    };

    void newStamp();
    void begin(Side& side, std::int32_t node);
    double leastDistance(Side& side);
    void reach(Side& side, const Side& other, std::int32_t node, std::int32_t predecessor, double distance,
               double bound);
    template <bool kForward>
    void settle(const ExchangeArcs& arcs, std::span<const double> dual, Side& side, const Side& other,
                double bound);
    void setRadii(double forwardDistance, double backwardDistance, double length);
    void traceCycle(std::int32_t tail, std::int32_t head);

    Side forward_;
    Side backward_;
    std::uint32_t stamp_ = 0;  // Stamp of this search; even.
    std::int32_t settled_ = 0;
    double pathLength_ = 0.0;    // Length of the shortest path found so far.
    std::int32_t meeting_ = -1;  // The node where its two halves meet; -1 for the return arc.
    std::vector<std::int32_t> cycle_;
};

}  // namespace muster
