// Makes a matching better where prices say that it can be.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assignment/dynamic/bidirectional_dijkstra.h"
#include "assignment/dynamic/exchange_graph.h"

namespace muster {

/// Takes violated arcs, the worst first, and either exchanges places along a cycle or moves prices until no
/// arc is violated by more than some tolerance, or the step's work is used up. Owns its working memory.
class CycleCancelling {
public:
    /// Makes room.
    void reset(std::int32_t seats, std::int32_t searchLimit);
    /// Settles at most `budget` nodes. A change that gained too little is not tried again for `rest` steps.
    void run(const AssignmentStep& context, ExchangeGraph& state, std::int64_t budget, std::int32_t rest);

    /// Violations up to this are let be [in the units of the power].
    static double tolerance(const AssignmentStep& context, const ExchangeGraph& state);

    std::int32_t exchanges() const { return exchanges_; }  ///< Cycles committed by the last run.
    std::int32_t violated() const { return violated_; }    ///< Seats with a violated arc at its beginning.
    std::int64_t settled() const { return settled_; }      ///< Nodes settled by it.

private:
    struct Violation {
        double size;
        std::int32_t arc;
    };

    void collect(const ExchangeGraph& state, double tolerance, std::int32_t most);
    std::int32_t worstArc(const ExchangeGraph& state, std::int32_t seat) const;
    void repairSeat(const AssignmentStep& context, ExchangeGraph& state, std::int32_t seat, double tolerance,
                    std::int64_t budget);
    double backAgain(const AssignmentStep& context, ExchangeGraph& state, std::int32_t from, std::int32_t to);
    bool commit(const AssignmentStep& context, ExchangeGraph& state);
    void askCycle(const AssignmentStep& context, const ExchangeGraph& state);
    void rotate(const AssignmentStep& context, ExchangeGraph& state);
    void noteWeights(const AssignmentStep& context, ExchangeGraph& state);

    BidirectionalDijkstra search_;
    std::vector<Violation> violations_;
    // Of the cycle: each holder to the next seat, 0 where one is missing.
    std::vector<float> costs_;
    std::vector<std::int32_t> holders_;  // Of the cycle: holders before it.
    double asked_ = 0.0;                 // What the last cycle looked at had to gain.
    std::uint8_t rest_ = 0;
    std::int32_t exchanges_ = 0;
    std::int32_t violated_ = 0;
    std::int64_t settled_ = 0;
};

}  // namespace muster
