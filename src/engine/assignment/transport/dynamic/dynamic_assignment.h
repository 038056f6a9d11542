// Dynamic assignment: keeps an assignment near-optimal while costs change from step to step.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/assignment/transport/dynamic/column_generation.h"
#include "engine/assignment/transport/dynamic/cycle_cancelling.h"
#include "engine/assignment/transport/dynamic/exchange_graph.h"
#include "engine/assignment/transport/dynamic/initial_assignment.h"
#include "engine/assignment/transport/dynamic/initial_duals.h"

namespace muster {

/// Matches as many characters with places of their own as possible, at a near-least sum of cost^p
/// (docs/method/dynamic-assignment.md). Every present character must be able to reach every usable place
/// within one call, if only at CostOracle::kUnreachable. Positions are finite.
class DynamicAssignment {
public:
    DynamicAssignment();
    DynamicAssignment(const DynamicAssignment& other);
    DynamicAssignment& operator=(const DynamicAssignment& other);
    DynamicAssignment(DynamicAssignment&& other) noexcept;
    DynamicAssignment& operator=(DynamicAssignment&& other) noexcept;
    ~DynamicAssignment();

    /// Forgets everything.
    void clear();
    /// Allocates memory for these numbers, and forgets everything.
    void reserve(const DynamicAssignmentDef& def, std::size_t characters, std::size_t places);
    /// Starts without incumbents: makes an initial assignment and repairs it.
    void coldStart(const DynamicAssignmentDef& def, const AssignmentInput& input, CostOracle& costs,
                   ThreadPool& pool);
    /// Starts from given places, per character, -1 for none; of several characters that name one place the
    /// first has it. They stay until the next update() finds better ones.
    void warmStart(const DynamicAssignmentDef& def, const AssignmentInput& input,
                   std::span<const std::int32_t> placeOf, CostOracle& costs, ThreadPool& pool);
    /// Begins from given places like warmStart(), but the next calls of update() do the work: each chooses
    /// the arcs of `def.startNodes` nodes, the last one fits the duals. Until then all characters keep their
    /// places, except those that had none.
    void beginFrom(const DynamicAssignmentDef& def, const AssignmentInput& input,
                   std::span<const std::int32_t> placeOf, CostOracle& costs, ThreadPool& pool);
    /// True while update() has to go on with the work that beginFrom() began.
    bool starting() const { return unstarted_ > 0; }
    /// One step: refreshes costs, matches the unmatched while places are free, and repairs. A cold start
    /// where the numbers of characters and places are not those of the last call.
    void update(const DynamicAssignmentDef& def, const AssignmentInput& input, CostOracle& costs,
                ThreadPool& pool);

    /// Place per character, -1 unmatched.
    std::span<const std::int32_t> placeOf() const { return placeOf_; }
    /// Per character: cost to its place at the last call [m]; 0 unmatched.
    std::span<const float> cost() const { return cost_; }
    double objective() const { return objective_; }  ///< Sum of cost^p over the matched characters [m^p].
    /// The objective less a lower bound of the optimum on the arcs of the graph, which the duals prove [m^p].
    double dualityGap() const { return dualityGap_; }
    /// Number of exchanges committed by the last call.
    std::int32_t exchanges() const { return cycleCancelling_.exchanges(); }
    /// Number of nodes settled by the last call.
    std::int64_t settled() const { return cycleCancelling_.settled(); }
    /// Writes a dual for each place [m^p]. With duals v, the sum of min_j (c_ij^p - v_j) over the characters
    /// and of all v_j is a lower bound of the optimum where there are as many characters as places.
    void duals(const AssignmentInput& input, std::span<double> dual) const;

    /// Lets an archive read or write all data that influences later results.
    template <class Archive>
    void visit(Archive& archive) {
        archive(round_, stepOfRound_, fitDelay_, violatedNodes_, unstarted_, far_, graph_, placeOf_, cost_,
                objective_, dualityGap_, dualSlope_, units_, columnGeneration_);
        if constexpr (Archive::kReading) {
            if (placeOf_.size() != static_cast<std::size_t>(graph_.nodes().characters()) ||
                cost_.size() != placeOf_.size() || unstarted_ < 0 || unstarted_ > graph_.count() + 1)
                archive.fail();
            if (!archive.ok()) clear();
            afterReading();
        }
    }

private:
    void reset(const DynamicAssignmentDef& def, std::size_t characters, std::size_t places);
    AssignmentStep start(const AssignmentProblem& problem, std::span<const std::int32_t> placeOf);
    void continueStart(const AssignmentStep& step);
    void refresh(const AssignmentStep& step);
    RefreshSchedule schedule(const DynamicAssignmentDef& def) const;
    void measureDistance(const DynamicAssignmentDef& def);
    void repair(const AssignmentStep& step);
    void publish(const AssignmentStep& step);
    void measureDualityGap(const AssignmentStep& step);
    void afterReading();

    std::int32_t round_ = 0;          // Number of rounds, each of DynamicAssignmentDef::stepsPerRound calls.
    std::int32_t stepOfRound_ = 0;    // Number of calls of this round so far.
    std::int32_t violatedNodes_ = 0;  // Number of violated nodes when the last repair began.
    std::int32_t fitDelay_ = 0;       // Number of repairs until the duals may be fitted again.
    // While it starts: nodes whose arcs are still to be chosen, the last ones, and one more for the duals.
    std::int32_t unstarted_ = 0;
    bool far_ = false;   // True if the mean matched cost was above farCost at the last refresh.
    bool near_ = false;  // True if it was below nearCost.
    ExchangeGraph graph_;
    std::vector<std::int32_t> placeOf_;  // Place per character, -1 unmatched.
    std::vector<float> cost_;            // Cost per character [m].
    double objective_ = 0.0;             // Objective [m^p].
    double dualityGap_ = 0.0;            // Duality gap [m^p].
    Vec2 dualSlope_;                     // AssignmentStep::dualSlope of the last call.
    double units_ = 1.0;                 // CostPower::units() of the last call.
    std::int32_t searchLimit_ = 0;       // Search limit for which cycleCancelling_ is sized.
    // The phases and their working memory.
    InitialAssignment initialAssignment_;
    InitialDuals initialDuals_;
    ColumnGeneration columnGeneration_;
    CycleCancelling cycleCancelling_;
};

}  // namespace muster
