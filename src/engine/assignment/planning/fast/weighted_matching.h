// The matching of the fast plan where supplies and demands differ (SPEC A1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/assignment/planning/commit_rule.h"
#include "engine/assignment/transport/dynamic/dynamic_transport.h"

namespace muster {

struct MatchingProblem;

/// The flows that hold, and a transport that follows the optimum. The difference between them falls into
/// exchanges; exchanges that gain enough are committed, as in the exact plan, and other flows stay.
/// Characters walk to their main places (engine/assignment/planning/main_places.h, docs/method/roles.md).
class WeightedMatching {
public:
    /// Forgets everything.
    void clear() { *this = WeightedMatching(); }
    /// One step from the incumbents, of `effort` times the usual work.
    void update(const MatchingProblem& problem, CostOracle& costs, ThreadPool& pool, std::int32_t effort);
    /// Keeps the incumbents, each with all that the character supplies; `cost` is the cost of each character
    /// to its place [m].
    void hold(const MatchingProblem& problem, std::span<const float> cost);

    /// Place per character, -1 unmatched.
    std::span<const std::int32_t> placeOf() const { return placeOf_; }
    /// Per character: cost to its place at the last call [m]; 0 unmatched.
    std::span<const float> cost() const { return cost_; }
    std::span<const Flow> flows() const { return flows_; }  ///< Flows, ordered by character, then place.
    /// Sum of cost^p over the flows [m^p], for an exponent p.
    double objective(double exponent) const { return sumOf(flows_, flowCost_, exponent); }
    /// The objective less that of the transport, and the bound of this above the optimum of known pairs
    /// [m^p].
    double dualityGap() const { return dualityGap_; }

    /// Lets an archive read or write all data that influences later results.
    template <class Archive>
    void visit(Archive& archive) {
        archive(transport_, flows_, flowCost_, placeOf_, cost_, dualityGap_);
        if constexpr (Archive::kReading) {
            if (!consistent()) archive.fail();
            if (!archive.ok()) clear();
        }
    }

private:
    bool consistent() const;
    void collectIncumbents(const MatchingProblem& problem);
    void claim(const MatchingProblem& problem, std::int32_t character, std::int32_t place, double amount);
    void evaluatePairs(std::size_t characters, CostOracle& costs, ThreadPool& pool);
    void commit(const MatchingProblem& problem);
    float costOf(std::int32_t character, std::int32_t place) const;
    void gatherCosts(std::span<const Flow> flows, std::vector<float>& cost) const;
    static double sumOf(std::span<const Flow> flows, std::span<const float> cost, double exponent);
    void publish(std::span<const std::int32_t> incumbent);

    DynamicTransport transport_;
    std::vector<Flow> flows_;
    std::vector<float> flowCost_;        // Cost per flow [m].
    std::vector<std::int32_t> placeOf_;  // Place per character, -1 unmatched.
    std::vector<float> cost_;            // Cost per character [m].
    double dualityGap_ = 0.0;            // Duality gap [m^p].
    // Working memory.
    CommitRule commitRule_;
    std::vector<Flow> incumbents_;                 // Flows that may stay.
    std::vector<double> openSupply_, openDemand_;  // Supply and demand that incumbents leave.
    std::vector<AssignmentPair> pairs_;            // Pairs of both lists, by character, then place.
    std::vector<std::int32_t> firstPair_;          // Index per character, and the end.
    std::vector<float> pairCosts_, optimumCost_;   // Costs of pairs [m].
};

}  // namespace muster
