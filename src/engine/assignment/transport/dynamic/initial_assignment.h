// Initial assignment of unmatched characters to free places.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/assignment/transport/dense/jonker_volgenant.h"
#include "engine/assignment/transport/dynamic/assignment_nodes.h"

namespace muster {

/// Matches as many unmatched characters as there are free places. A few are matched greedily, nearest pair
/// first. Many are partitioned, like the places, into leaves of a k-d tree of equal counts; leaves are
/// assigned to leaves exactly by the costs between their central points; within each pair both are halved
/// until they are small enough for an exact assignment by straight distance. Owns its working memory.
class InitialAssignment {
public:
    /// Allocates the memory of the greedy case for these numbers.
    void reserve(std::size_t characters, std::size_t places);
    /// Matches the characters and places that AssignmentNodes::update listed.
    void run(const AssignmentProblem& problem, AssignmentNodes& nodes);

private:
    // A pair that may be matched.
    struct Choice {
        double cost;  // Cost [m], or squared distance [m^2], the same for all choices.
        std::int32_t character;
        std::int32_t node;
    };

    void removeMatched(const AssignmentNodes& nodes);
    void matchGreedily(const AssignmentProblem& problem, AssignmentNodes& nodes);
    void matchEachToNearest(const AssignmentProblem& problem, AssignmentNodes& nodes);
    void matchLeaves(const AssignmentProblem& problem, AssignmentNodes& nodes);
    void evaluateLeafCosts(const AssignmentProblem& problem, std::int32_t leaves);
    void matchWithinLeaf(const AssignmentProblem& problem, AssignmentNodes& nodes,
                         std::span<std::int32_t> characters, std::span<std::int32_t> places, Vec2 shift);
    void matchExactly(const AssignmentProblem& problem, AssignmentNodes& nodes,
                      std::span<const std::int32_t> characters, std::span<const std::int32_t> places,
                      Vec2 shift);

    std::vector<std::int32_t> characters_;  // Unmatched characters.
    std::vector<std::int32_t> places_;      // Free places.
    std::vector<Choice> choices_;
    std::vector<std::int32_t> characterLeafEnds_;  // Per leaf: its end in characters_.
    std::vector<std::int32_t> placeLeafEnds_;      // Per leaf: its end in places_.
    std::vector<std::int32_t> centralPlaces_;      // Per leaf: the place nearest to its mean.
    std::vector<AssignmentPair> pairs_;            // Pairs whose costs are evaluated.
    std::vector<float> pairCosts_;                 // Their costs [m].
    std::vector<double> matrix_;                   // Dense cost matrix, row-major.
    JonkerVolgenantSolver leafSolver_;             // Assigns leaves to leaves.
    JonkerVolgenantSolver pairSolver_;             // Assigns characters to places.
};

}  // namespace muster
