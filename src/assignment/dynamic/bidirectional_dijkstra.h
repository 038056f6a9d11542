// One violated arc: either a cycle of exchanges that gains, or prices under which the arc is no longer
// violated.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assignment/dynamic/exchange_arcs.h"

namespace muster {

/// What a search came to.
enum class SearchEnd : std::uint8_t {
    Cycle,    ///< There is a cycle through the arc of negative weight; see cycle().
    Settled,  ///< None on the arcs known: the prices can be moved until the arc is no longer violated.
    Capped,   ///< The work allowed did not suffice: the prices can be moved some of the way.
};

/// Searches forward from the head of an arc and backward from its tail, over arcs whose reduced costs
/// (negative ones count as zero) are lengths. Owns its working memory.
class BidirectionalDijkstra {
public:
    /// Makes room for searches that settle at most `limit` nodes.
    void reset(std::int32_t seats, std::int32_t limit);
    /// Looks for a way from seat `to` back to seat `from` that is shorter than the violation (> 0) of the arc
    /// between them. `direct` is the length of going straight back. Settles at most `limit` nodes.
    SearchEnd run(const ExchangeArcs& arcs, std::span<const double> price, std::int32_t from, std::int32_t to,
                  double violation, double direct, std::int32_t limit);
    /// Moves prices as far as the last search allows: lower behind the arc, higher before it. No reduced cost
    /// that is not negative becomes so, none that is negative sinks further.
    void movePrices(std::span<double> price) const;

    /// After SearchEnd::Cycle: each seat's holder moves to the next seat, the last one's to the first.
    std::span<const std::int32_t> cycle() const { return cycle_; }
    /// Nodes settled by the last search.
    std::int32_t settled() const { return settledCount_; }

private:
    struct Entry {
        double distance;
        std::int32_t seat;
    };
    struct Node {
        double distance = 0.0;      // Valid where this search has seen it.
        std::int32_t through = -1;  // The seat it was reached from.
        std::uint32_t stamp = 0;    // The search that saw it; one more where it is settled.
    };
    struct Side {
        std::vector<Node> node;  // Per seat.
        std::vector<Entry> heap;
        std::vector<std::int32_t> order;  // Settled seats.
        std::size_t most = 0;             // Entries that fit in the heap.
        double lost = 0.0;                // Least distance of those that did not fit.
        double radius = 0.0;              // How far prices move.
    };

    void newStamp();
    void begin(Side& side, std::int32_t seat);
    double top(Side& side);
    void label(Side& side, const Side& other, std::int32_t seat, std::int32_t through, double distance,
               double bound);
    template <bool kForward>
    void settle(const ExchangeArcs& arcs, std::span<const double> price, Side& side, const Side& other,
                double bound);
    void finish(double forwardTop, double backwardTop, double length);
    void trace(std::int32_t from, std::int32_t to);

    Side forward_;
    Side backward_;
    std::uint32_t stamp_ = 0;  // Even.
    std::int32_t settledCount_ = 0;
    double best_ = 0.0;         // Shortest way back that is known.
    std::int32_t meeting_ = 0;  // A seat on it; -1 for the direct one.
    std::vector<std::int32_t> cycle_;
};

}  // namespace muster
