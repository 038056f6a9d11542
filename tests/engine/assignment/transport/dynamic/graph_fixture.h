// An exchange graph in the middle of its work, for tests of the phases.
#pragma once

#include <numeric>
#include <optional>
#include <vector>

#include "engine/assignment/transport/dynamic/assignment_scene.h"
#include "engine/assignment/transport/dynamic/exchange_graph.h"
#include "engine/assignment/transport/dynamic/initial_assignment.h"

namespace muster_test {

using muster::kInfiniteCost;
inline constexpr std::int32_t kArcsPerNode = muster::ExchangeGraph::kArcsPerNode;

/// 0, 1, ... count - 1.
inline std::vector<std::int32_t> ascending(std::size_t count) {
    std::vector<std::int32_t> all(count);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

/// A graph over a scene with as many characters as places. begin() and its step come before all else.
struct GraphFixture {
    AssignmentScene scene;
    muster::ThreadPool pool{1};
    muster::DynamicAssignmentDef def = lowThresholds();
    muster::AssignmentInput input;
    muster::ExchangeGraph graph;
    muster::InitialAssignment initial;
    std::optional<muster::AssignmentStep> current;

    GraphFixture(std::int32_t count, std::uint64_t seed, double away = 2.0)
        : scene(count, count, seed, away), input(scene.input()) {
        graph.reset(count, count);
    }
    const muster::AssignmentStep& step() const { return *current; }
    /// Begins a step.
    void begin() { current.emplace(graph.beginStep({def, input, scene.costs, pool}, initial)); }
    /// Assigns the places given, and begins a step.
    void begin(const std::vector<std::int32_t>& placeOf) {
        graph.assignPlaces(placeOf);
        begin();
    }
    /// Begins a step and makes all arcs again.
    void rebuild() {
        begin();
        graph.rebuildArcs(step());
        graph.indexIncomingArcs();
    }
    /// Everybody at the place of the same index, or at that of the optimum; duals at random up to `most`.
    void disturb(std::uint64_t seed, double most, bool optimal) {
        graph.assignPlaces(optimal ? optimum() : ascending(graph.count()));
        muster::Random random(seed);
        for (double& dual : graph.duals()) dual = random.uniform(-most, most);
        rebuild();
    }
    /// The optimum, by a dense solver.
    std::vector<std::int32_t> optimum() const {
        const std::int32_t n = graph.count();
        std::vector<double> matrix;
        for (std::int32_t i = 0; i < n; ++i)
            for (std::int32_t j = 0; j < n; ++j)
                matrix.push_back(scene.costs.exact(i, j) * scene.costs.exact(i, j));
        return optimalColumns(n, n, matrix);
    }
    /// Per arc; infinite for self loops.
    std::vector<double> reducedCosts() const {
        std::vector<double> all;
        for (std::int32_t arc = 0; arc < graph.count() * kArcsPerNode; ++arc) {
            const bool loop = graph.arcs().head(arc) == muster::ExchangeArcs::tail(arc);
            all.push_back(loop ? kInfiniteCost : graph.reducedCost(arc));
        }
        return all;
    }
    /// The sum over all nodes of the largest violation of their arcs.
    double violations() const {
        double sum = 0.0;
        for (std::int32_t node = 0; node < graph.count(); ++node)
            sum -= std::min(0.0, graph.leastReducedCost(node));
        return sum;
    }
    /// Lengths of the shortest paths from a node, by sweeps over all arcs until nothing changes
    /// (Bellman-Ford).
    std::vector<double> distancesFrom(std::int32_t node) const {
        std::vector<double> distance(graph.count(), kInfiniteCost);
        distance[node] = 0.0;
        for (bool changed = true; changed;) {
            changed = false;
            for (std::int32_t arc = 0; arc < graph.count() * kArcsPerNode; ++arc) {
                const std::int32_t tail = muster::ExchangeArcs::tail(arc);
                const std::int32_t head = graph.arcs().head(arc);
                if (head == tail) continue;
                const double there = distance[tail] + std::max(graph.reducedCost(arc), 0.0);
                if (!(there < distance[head])) continue;
                distance[head] = there;
                changed = true;
            }
        }
        return distance;
    }
};

}  // namespace muster_test
