// Dynamic transportation: keeps a transport near-optimal while costs and amounts change from step to step.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/assignment/transport/dense/transportation_problem.h"
#include "engine/assignment/transport/dynamic/classed_assignment.h"
#include "engine/assignment/transport/dynamic/nearest_points.h"
#include "engine/assignment/transport/dynamic/transport_start.h"
#include "engine/assignment/transport/dynamic/transport_tree.h"

namespace muster {

/// Input of a transport. Spans stay valid during the call only.
struct TransportInput {
    const AssignmentInput& positions;  ///< Positions of the characters and places that take part.
    std::span<const double> supply;    ///< Units of each character >= 0; empty for 1 each.
    std::span<const double> demand;    ///< Units of each place >= 0; empty for 1 each.
    AssignmentClasses classes;         ///< Classes; empty spans for none.
    double exponent = 2.0;             ///< Exponent p of the objective sum c^p f, 1 to 16.
    /// Place of each character, -1 for none, from which a new tree starts; empty for none.
    std::span<const std::int32_t> incumbent = {};
};

/// Sends as many units as possible, of these as many as possible within their classes, at a near-least sum of
/// cost^p (docs/method/roles.md): a network simplex whose tree stays from step to step. Each step looks at
/// some pairs only and makes a bounded number of pivots. Requirements as of DynamicAssignment.
class DynamicTransport {
public:
    /// Forgets everything.
    void clear() { *this = DynamicTransport(); }
    /// One step, of `effort` times the usual work. Starts again, from the incumbents if there are any, where
    /// the numbers of characters and places are not those of the last call.
    void update(const TransportInput& input, CostOracle& costs, ThreadPool& pool, std::int32_t effort = 1);

    const std::vector<Flow>& flows() const { return flows_; }  ///< Flows, ordered by character, then place.
    /// Upper bound of the gain by pairs through which nothing is sent, among the pairs that the last call
    /// looked at [m^p].
    double gap() const { return gap_; }
    std::int64_t pivots() const { return pivots_; }  ///< Number of pivots of the last call.

    /// Lets an archive read or write all data that influences later results.
    template <class Archive>
    void visit(Archive& archive) {
        archive(tree_, row_, column_, pass_, round_);
        if constexpr (Archive::kReading)
            if (row_ < 0 || column_ < 0) archive.fail();
    }

private:
    /// An arc that may enter the tree.
    struct Candidate {
        std::int32_t tail;
        std::int32_t head;
        LevelCost cost;
    };
    /// A pair of a scanned row or column, with a bound of its reduced cost.
    struct Bound {
        LevelCost reduced;
        AssignmentPair pair;
    };

    void countUnits(const TransportInput& input);
    std::int64_t levelOf(const TransportInput& input, std::int32_t character, std::int32_t place) const;
    void evaluateTree(const TransportInput& input, CostOracle& costs, ThreadPool& pool);
    void collectNear(const TransportInput& input);
    void collectNearOf(const TransportInput& input, std::int32_t character);
    void add(std::int32_t character, std::int32_t place);
    void scan(const TransportInput& input, CostOracle& costs);
    void consider(const TransportInput& input, CostOracle& costs, std::int32_t character, std::int32_t place);
    void keepBest();
    void evaluateCandidates(const TransportInput& input, CostOracle& costs, ThreadPool& pool);
    void exchange(std::int64_t budget);
    bool exchangeBest(std::size_t first, std::size_t end, std::int64_t& work);
    void plant(const TransportInput& input);
    void publish();

    TransportTree tree_;
    std::int32_t row_ = 0;     // The next character for which all places are looked at.
    std::int32_t column_ = 0;  // The next place for which all characters are looked at.
    std::uint32_t pass_ = 0;   // Number of scans.
    std::uint32_t round_ = 0;  // Number of steps.
    // Flows of the last step.
    std::vector<Flow> flows_;
    double gap_ = 0.0;
    std::int64_t pivots_ = 0;
    // Working memory.
    TransportStart start_;
    CostPower power_;
    double tolerance_ = 0.0;  // Violation up to which a pair is left alone [units of CostPower].
    double leastUnitCost_ = 0.0;
    double unitsPerAmount_ = 1.0;                // Units in which flows are counted.
    std::vector<std::int64_t> supply_, demand_;  // Amounts [units].
    std::vector<AssignmentPair> pairs_;
    std::vector<float> pairCosts_;
    std::vector<std::int32_t> arcs_;  // Nodes whose arcs are pairs.
    std::vector<Candidate> candidates_;
    std::vector<Bound> bounds_;
    std::vector<double> worst_;  // Per character: violation of its pairs.
    CellList placeCells_, characterCells_;
};

}  // namespace muster
