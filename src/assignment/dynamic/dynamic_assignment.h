// Keeps an assignment of characters to places near-optimal, step after step, at little cost.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assignment/dynamic/column_generation.h"
#include "assignment/dynamic/cycle_cancelling.h"
#include "assignment/dynamic/exchange_graph.h"
#include "assignment/dynamic/initial_assignment.h"
#include "assignment/dynamic/initial_duals.h"

namespace muster {

/// As many characters as possible get a place of their own, at near the least sum of cost^p. Within one call
/// every character that takes part can come to every place that may be taken. Positions are finite.
class DynamicAssignment {
public:
    /// Forgets everything.
    void clear();
    /// Makes room for so many, and forgets everything.
    void reserve(const DynamicAssignmentDef& def, std::size_t characters, std::size_t places);
    /// From nothing: matches parts of the crowd with parts of the formation, then improves.
    void coldStart(const DynamicAssignmentDef& def, const AssignmentInput& input, CostOracle& costs,
                   ThreadPool& pool);
    /// From given places (per character, -1 for none; of two that name one place the first has it): these are
    /// kept until the next update() finds better ones.
    void warmStart(const DynamicAssignmentDef& def, const AssignmentInput& input,
                   std::span<const std::int32_t> placeOf, CostOracle& costs, ThreadPool& pool);
    /// One step: asks for costs, seats those who have no place while one is free, repairs. A cold start where
    /// sizes are not those of the last one.
    void update(const DynamicAssignmentDef& def, const AssignmentInput& input, CostOracle& costs,
                ThreadPool& pool);

    std::span<const std::int32_t> placeOf() const { return placeOf_; }  ///< Per character, -1 unmatched.
    /// Per character, to its place by the last call [m]; 0 unmatched.
    std::span<const float> cost() const { return cost_; }
    double objective() const { return objective_; }  ///< Sum of cost^p over the matched [m^p].
    /// What the optimum on the arcs known may be below the objective at most [m^p], by the prices.
    double dualityGap() const { return dualityGap_; }
    std::int32_t exchanges() const { return repair_.exchanges(); }  ///< Cycles committed by the last call.
    /// Seats with a violated arc when repairs began last.
    std::int32_t violated() const { return violated_; }
    std::int64_t settled() const { return repair_.settled(); }  ///< Nodes settled by the last call.
    /// Writes a price for each place [m^p]: with prices v the sum over characters of min_j (c_ij^p - v_j),
    /// and of all v, is a lower bound of the optimum where there are as many characters as places.
    void duals(const AssignmentInput& input, std::span<double> price) const;

    /// Lets an archive read or write all that influences later results.
    template <class Archive>
    void visit(Archive& archive) {
        archive(step_, turn_, restOfFit_, violated_, far_, state_, stale_, placeOf_, cost_, objective_,
                dualityGap_, slope_, units_, pricing_);
        if constexpr (Archive::kReading) {
            if (placeOf_.size() != static_cast<std::size_t>(state_.seats.characters()) ||
                cost_.size() != placeOf_.size() ||
                stale_.size() != static_cast<std::size_t>(state_.seats.count()))
                archive.fail();
            if (!archive.ok()) clear();
            afterReading();
        }
    }

private:
    AssignmentStep contextFor(const DynamicAssignmentDef& def, const AssignmentInput& input,
                              CostOracle& costs, ThreadPool& pool) const;
    void prepare(const DynamicAssignmentDef& def, std::size_t characters, std::size_t places);
    void seatWaiting(const AssignmentStep& context);
    void frame(AssignmentStep& context) const;
    void askOwn(const AssignmentStep& context);
    void jumped(std::int32_t seat);
    void refreshAll(const AssignmentStep& context);
    void askRows(const AssignmentStep& context);
    void noteHowFar(const AssignmentStep& context);
    bool unsteady(const AssignmentStep& context, std::int32_t seat) const;
    std::int32_t refreshPeriod(const DynamicAssignmentDef& def) const;
    void refreshSome(const AssignmentStep& context);
    void collectStale();
    void repair(const AssignmentStep& context);
    double marginOf(const AssignmentStep& context, std::size_t seat) const;
    void repriceFlipped();
    void publish(const AssignmentStep& context);
    void measureDualityGap(const AssignmentStep& context);
    void afterReading();

    std::int32_t step_ = 0;       // Rounds, each of DynamicAssignmentDef::turns calls.
    std::int32_t turn_ = 0;       // Calls of this round so far.
    std::int32_t violated_ = 0;   // Seats, when repairs began last.
    std::int32_t restOfFit_ = 0;  // Repairs until prices may be fitted again.
    bool far_ = false;            // All was far away when costs were asked for last.
    bool near_ = false;           // All had nearly arrived in this call.
    ExchangeGraph state_;
    std::vector<std::int32_t> placeOf_;
    std::vector<float> cost_;
    double objective_ = 0.0;
    double dualityGap_ = 0.0;
    Vec2 slope_;          // Of the prices' frame in the last call.
    double units_ = 1.0;  // CostPower::units() there.
    // Working memory.
    std::int32_t searchLimit_ = 0;
    CycleCancelling repair_;
    InitialAssignment start_;
    InitialDuals fit_;
    ColumnGeneration pricing_;
    std::vector<AssignmentPair> pairs_;
    std::vector<float> answers_;
    std::vector<std::int32_t> rows_;
    std::vector<std::int32_t> tightRows_;  // Of these only the arcs are asked for that may soon be violated.
    std::vector<double> margin_;           // Per seat: what makes them so.
    std::vector<std::int32_t> flipped_;    // Seats that became or ceased to be places, or lost their holder.
    // Per seat: the weights of arcs to it are to be asked for in the next round.
    std::vector<std::uint8_t> stale_;
    std::vector<std::int32_t> staleArcs_;
};

}  // namespace muster
