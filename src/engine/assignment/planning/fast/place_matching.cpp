#include "engine/assignment/planning/fast/place_matching.h"

#include <algorithm>

namespace muster {
namespace {

constexpr std::int32_t kStartEffort = 2;  // Effort of a first plan with weights, in steps.

}  // namespace

void PlaceMatching::choose(const MatchingProblem& problem) {
    const bool weights = !problem.supply.empty();
    const Kind kind = weights                             ? Kind::Weights
                      : problem.classes.character.empty() ? Kind::Units
                                                          : Kind::Classes;
    if (kind == kind_) return;
    clear();
    kind_ = kind;
}

void PlaceMatching::coldStart(const MatchingProblem& problem, CostOracle& costs, ThreadPool& pool) {
    choose(problem);
    const auto& incumbent = problem.incumbent;
    const bool nobody = std::all_of(incumbent.begin(), incumbent.end(), [](std::int32_t j) { return j < 0; });
    if (kind_ == Kind::Weights) {
        if (nobody) weighted_.clear();
        weighted_.update(problem, costs, pool, kStartEffort);
    } else if (kind_ == Kind::Units) {
        assignment_.coldStart(problem.def, problem.input, costs, pool);
    } else {
        classed_.coldStart(problem.def, problem.input, problem.classes, costs, pool);
    }
}

void PlaceMatching::hold(const MatchingProblem& problem, std::span<const float> cost) {
    if (problem.supply.empty()) {
        if (kind_ == Kind::Weights) clear();
        return;
    }
    choose(problem);
    weighted_.hold(problem, cost);
}

void PlaceMatching::update(const MatchingProblem& problem, CostOracle& costs, ThreadPool& pool) {
    choose(problem);
    if (kind_ == Kind::Weights) return weighted_.update(problem, costs, pool, 1);
    if (kind_ == Kind::Classes)
        return classed_.update(problem.def, problem.input, problem.classes, problem.incumbent, costs, pool);
    const auto assigned = assignment_.placeOf();
    const auto& incumbent = problem.incumbent;
    // A start with other characters or places is spread over the next steps.
    if (assigned.size() != incumbent.size())
        return assignment_.beginFrom(problem.def, problem.input, incumbent, costs, pool);
    if (!std::equal(assigned.begin(), assigned.end(), incumbent.begin(), incumbent.end()))
        assignment_.warmStart(problem.def, problem.input, incumbent, costs, pool);
    assignment_.update(problem.def, problem.input, costs, pool);
}

}  // namespace muster
