// Initial duals: a least-squares fit to the arc costs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/assignment/transport/dynamic/exchange_graph.h"

namespace muster {

/// Where arcs join two nodes in both directions, complementary slackness confines the difference of their
/// duals to an interval. The fit makes the differences those of the interval midpoints, and narrow intervals
/// weigh most: first one linear function per leaf of a k-d tree of the nodes, by normal equations for the
/// slopes and Gauss-Seidel iteration for the heights, then some sweeps over all nodes. CycleCancelling mends
/// the rest. Owns its working memory.
class InitialDuals {
public:
    /// Sets the duals of all nodes from the costs of all arcs.
    void run(const AssignmentStep& step, ExchangeGraph& graph);

private:
    // The linear function of one leaf.
    struct Plane {
        Vec2 centre;          // Mean position of the leaf's nodes [m].
        Vec2 slope;           // Slope of the dual [dual per metre].
        double height = 0.0;  // Dual at the centre.
    };
    // Normal equations of a leaf's slope: a symmetric 2 x 2 matrix and a right-hand side.
    struct NormalEquations {
        double xx = 0.0, xy = 0.0, yy = 0.0;
        Vec2 right;
    };
    // The wanted difference of duals of two nodes that are joined in both directions.
    struct Difference {
        std::int32_t tail;
        std::int32_t head;
        float wanted;  // Dual of `head` less dual of `tail`: the midpoint of the interval.
        float weight;  // Weight > 0; 1 for an empty interval, falling with its width.
    };
    // A leaf that differences join with another.
    struct Neighbour {
        std::int32_t leaf;
        double weight;  // Sum of the weights of the differences.
    };

    void collectDifferences(const ExchangeGraph& graph);
    void partition(const AssignmentStep& step, const ExchangeGraph& graph);
    void fitSlopes();
    void collectHeightEquations();
    void listNeighbours();
    void solveHeights();
    void sweep(std::span<double> dual) const;

    std::vector<Difference> differences_;           // Differences, tail by tail.
    std::vector<std::int32_t> differencesEnd_;      // Per tail: its end in differences_.
    std::vector<std::int32_t> leafOf_;              // Leaf of each node.
    std::vector<Plane> planes_;                     // Planes per leaf.
    std::vector<double> coupling_;                  // Leaves x leaves: sums of weights.
    std::vector<Neighbour> neighbours_;             // Neighbours, leaf by leaf.
    std::vector<std::int32_t> neighboursEnd_;       // Per leaf: its end in neighbours_.
    std::vector<double> right_;                     // Per leaf: right-hand side of its height equation.
    std::vector<NormalEquations> normalEquations_;  // Normal equations per leaf.
    std::vector<Vec2> position_;                    // Position of each node [m].
    std::vector<std::int32_t> order_;               // Nodes, leaf by leaf.
    std::vector<std::int32_t> leafEnds_;            // Per leaf: its end in order_.
};

}  // namespace muster
