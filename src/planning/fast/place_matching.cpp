#include "planning/fast/place_matching.h"

#include <algorithm>

namespace muster {

void PlaceMatching::choose(const MatchingProblem& problem) {
    const Kind kind = problem.classes.character.empty() ? Kind::Units : Kind::Classes;
    if (kind == kind_) return;
    kind_ = kind;
    assignment_.clear();
    classed_.clear();
}

void PlaceMatching::coldStart(const MatchingProblem& problem, CostOracle& costs, ThreadPool& pool) {
    choose(problem);
    if (kind_ == Kind::Units)
        assignment_.coldStart(problem.def, problem.input, costs, pool);
    else
        classed_.coldStart(problem.def, problem.input, problem.classes, costs, pool);
}

void PlaceMatching::update(const MatchingProblem& problem, CostOracle& costs, ThreadPool& pool) {
    choose(problem);
    if (kind_ == Kind::Classes)
        return classed_.update(problem.def, problem.input, problem.classes, problem.incumbent, costs, pool);
    const auto assigned = assignment_.placeOf();
    const auto& incumbent = problem.incumbent;
    const bool others = assigned.size() != incumbent.size();
    if (!std::equal(assigned.begin(), assigned.end(), incumbent.begin(), incumbent.end()))
        assignment_.warmStart(problem.def, problem.input, incumbent, costs, pool);
    if (others) return;  // A start with other characters or places is enough work for one step.
    assignment_.update(problem.def, problem.input, costs, pool);
}

}  // namespace muster
