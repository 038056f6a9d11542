#include <cmath>
#include <vector>

#include "engine/assignment/transport/dense/transportation_problem.h"
#include "engine/fields/cost/unit_cost_builder.h"
#include "engine/fields/eikonal/eikonal_solver.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/metrics.h"

namespace muster {
namespace {

/// The ground with its obstacles only, so that a metre costs a metre everywhere.
Result<Environment> withoutPatches(const Environment& environment) {
    auto bare = Environment::create(environment.def());
    if (!bare.ok()) return bare;
    for (ObstacleId id : environment.obstacleIds()) {
        if (const auto added = bare->addObstacle(*environment.obstacle(id)); !added.ok())
            return added.status();
    }
    bare->setTime(environment.time());
    return bare;
}

/// Lengths of the shortest paths, a row per start.
bool geodesics(const Environment& environment, double radius, std::span<const Vec2> starts,
               std::span<const Vec2> places, std::vector<double>& lengths) {
    const auto bare = withoutPatches(environment);
    if (!bare.ok()) return false;
    Parameters parameters;
    parameters.cost.alpha = 1.0;
    parameters.cost.beta = 0.0;
    parameters.density.enabled = false;
    parameters.discomfort.enabled = false;
    UnitCost cost;
    UnitCostBuilder builder;
    builder.build(parameters, *bare, DensityField(environment.def().box, {}), radius, cost);
    EikonalSolver solver;
    CostField field;
    for (std::size_t j = 0; j < places.size(); ++j) {
        solver.solve(cost, places[j], starts, field);
        for (std::size_t i = 0; i < starts.size(); ++i)
            lengths[i * places.size() + j] = field.cost(starts[i]);
    }
    return true;
}

}  // namespace

double leastWalk(const Environment& environment, double radius, std::span<const Vec2> starts,
                 std::span<const Vec2> places) {
    if (starts.empty()) return 0.0;
    std::vector<double> lengths(starts.size() * places.size());
    if (environment.pieces().empty()) {
        for (std::size_t i = 0; i < starts.size(); ++i) {
            for (std::size_t j = 0; j < places.size(); ++j) {
                lengths[i * places.size() + j] = distance(starts[i], places[j]);
            }
        }
    } else if (!geodesics(environment, radius, starts, places, lengths)) {
        return -1.0;
    }
    TransportationProblem problem;
    problem.rows = static_cast<std::int32_t>(starts.size());
    problem.columns = static_cast<std::int32_t>(places.size());
    problem.cost = lengths;
    TransportationSolver solver;
    TransportationSolution solution;
    if (!solver.solve(problem, solution).ok()) return -1.0;
    return solution.amount > static_cast<double>(starts.size()) - 0.5 ? solution.cost : -1.0;
}

}  // namespace muster
