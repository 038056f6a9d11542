// The matching of characters and places in the fast plan: with classes, with weights, or without.
#pragma once

#include <cstdint>
#include <span>

#include "engine/assignment/planning/fast/weighted_matching.h"
#include "engine/assignment/transport/dynamic/classed_assignment.h"
#include "engine/assignment/transport/dynamic/dynamic_assignment.h"

namespace muster {

/// Input of a matching. Spans stay valid during the call only.
struct MatchingProblem {
    const DynamicAssignmentDef& def;          ///< Objective, threshold, limits of work.
    const AssignmentInput& input;             ///< Positions of characters and places.
    AssignmentClasses classes;                ///< Classes; empty spans for none.
    std::span<const std::int32_t> incumbent;  ///< Place of each character, -1 for none.
    std::span<const double> supply;           ///< Units of each character; empty where all flows are of 1.
    std::span<const double> demand;           ///< Units of each place; empty like `supply`.
};

/// Hands a matching to the method that suits it: WeightedMatching where supplies or demands differ,
/// ClassedAssignment where there are classes, else DynamicAssignment. Where the method changes, the new one
/// starts from the incumbents.
class PlaceMatching {
public:
    /// Allocates memory for these numbers, without classes.
    void reserve(const DynamicAssignmentDef& def, std::size_t characters, std::size_t places) {
        assignment_.reserve(def, characters, places);
    }
    /// Forgets everything.
    void clear() {
        kind_ = Kind::Units;
        assignment_.clear();
        classed_.clear();
        weighted_.clear();
    }
    /// Starts without incumbents.
    void coldStart(const MatchingProblem& problem, CostOracle& costs, ThreadPool& pool);
    /// One step from the incumbents.
    void update(const MatchingProblem& problem, CostOracle& costs, ThreadPool& pool);
    /// Keeps the incumbents, whose costs are given [m]; does nothing where all flows are of one unit.
    void hold(const MatchingProblem& problem, std::span<const float> cost);

    /// True while update() is still starting from the incumbents of other characters or places.
    bool starting() const { return kind_ == Kind::Units && assignment_.starting(); }

    /// Place per character, -1 unmatched.
    std::span<const std::int32_t> placeOf() const {
        if (kind_ == Kind::Weights) return weighted_.placeOf();
        return kind_ == Kind::Units ? assignment_.placeOf() : classed_.placeOf();
    }
    /// Per character: cost to its place at the last call [m]; 0 unmatched.
    std::span<const float> cost() const {
        if (kind_ == Kind::Weights) return weighted_.cost();
        return kind_ == Kind::Units ? assignment_.cost() : classed_.cost();
    }
    /// The objective less a lower bound of the optimum on the known arcs [m^p].
    double dualityGap() const {
        if (kind_ == Kind::Weights) return weighted_.dualityGap();
        return kind_ == Kind::Units ? assignment_.dualityGap() : classed_.dualityGap();
    }
    /// The flows where supplies or demands differ; null where every flow is of one unit.
    const WeightedMatching* weighted() const { return kind_ == Kind::Weights ? &weighted_ : nullptr; }

    /// Lets an archive read or write all data that influences later results.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind_, assignment_, classed_);
        if constexpr (Archive::kReading) {
            if (kind_ > Kind::Weights) archive.fail();
            weighted_.clear();
        }
        if (kind_ == Kind::Weights) archive(weighted_);
    }

private:
    enum class Kind : std::uint8_t { Units, Classes, Weights };

    void choose(const MatchingProblem& problem);

    Kind kind_ = Kind::Units;
    DynamicAssignment assignment_;
    ClassedAssignment classed_;
    WeightedMatching weighted_;
};

}  // namespace muster
