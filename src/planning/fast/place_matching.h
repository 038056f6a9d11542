// Who goes where in the fast plan: with classes or without.
#pragma once

#include <cstdint>
#include <span>

#include "assignment/dynamic/classed_assignment.h"
#include "assignment/dynamic/dynamic_assignment.h"

namespace muster {

/// What a matching is made from. Spans stay valid during the call only.
struct MatchingProblem {
    const DynamicAssignmentDef& def;          ///< Objective, threshold, limits of work.
    const AssignmentInput& input;             ///< Positions.
    AssignmentClasses classes;                ///< Empty spans for none.
    std::span<const std::int32_t> incumbent;  ///< Place of each character, -1 for none.
};

/// Hands a matching to the method that suits it: DynamicAssignment where there are no classes,
/// ClassedAssignment where there are. Where that changes, the new method starts from the incumbents.
class PlaceMatching {
public:
    /// Allocates memory for so many, without classes.
    void reserve(const DynamicAssignmentDef& def, std::size_t characters, std::size_t places) {
        assignment_.reserve(def, characters, places);
    }
    /// Forgets everything.
    void clear() { *this = {}; }
    /// Starts without incumbents.
    void coldStart(const MatchingProblem& problem, CostOracle& costs, ThreadPool& pool);
    /// One step from the incumbents.
    void update(const MatchingProblem& problem, CostOracle& costs, ThreadPool& pool);

    /// Per character, -1 unmatched.
    std::span<const std::int32_t> placeOf() const {
        return kind_ == Kind::Units ? assignment_.placeOf() : classed_.placeOf();
    }
    /// Per character: cost to its place at the last call [m]; 0 unmatched.
    std::span<const float> cost() const {
        return kind_ == Kind::Units ? assignment_.cost() : classed_.cost();
    }
    /// The objective less a lower bound of the optimum on the known arcs [m^p].
    double dualityGap() const {
        return kind_ == Kind::Units ? assignment_.dualityGap() : classed_.dualityGap();
    }

    /// Lets an archive read or write all that influences later results.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind_, assignment_, classed_);
        if constexpr (Archive::kReading)
            if (kind_ > Kind::Classes) archive.fail();
    }

private:
    enum class Kind : std::uint8_t { Units, Classes };

    void choose(const MatchingProblem& problem);

    Kind kind_ = Kind::Units;
    DynamicAssignment assignment_;
    ClassedAssignment classed_;
};

}  // namespace muster
