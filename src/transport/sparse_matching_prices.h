// Prices for a matching that has none yet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "transport/sparse_matching_state.h"

namespace muster {

/// Between two seats with arcs both ways the difference of prices may lie in an interval; prices are fitted to the middles of
/// these, the narrow ones weighing most. First a plane for each of a few hundred parts of the formation, then a few
/// rounds over all seats. Averages cannot run away, and the repair does the rest.
class PriceFit {
public:
    /// Writes state.price from the weights of all arcs.
    void run(const MatchingContext& context, MatchingState& state);

private:
    struct Plane {
        Vec2 middle;
        Vec2 slope;
        double height = 0.0;
    };
    // What arcs within a part ask of its slope: a symmetric 2 x 2 matrix and a right side.
    struct Normal {
        double xx = 0.0, xy = 0.0, yy = 0.0;
        Vec2 right;
    };

    // A part that shares arcs with another.
    struct Coupled {
        std::size_t part;
        double weight;
    };

    void pairArcs(const MatchingState& state);
    void divide(const MatchingContext& context, const MatchingState& state);
    void fitSlopes(const MatchingContext& context, const MatchingState& state);
    void fitHeights(const MatchingContext& context, const MatchingState& state);
    void listCoupled();
    void solveHeights();
    void smooth(MatchingState& state) const;

    std::vector<float> middle_;  // Per arc: wanted price of the target less that of the seat.
    std::vector<float> weight_;  // Per arc: 0 where there is no arc back.
    std::vector<std::int32_t> partOf_;
    std::vector<Plane> planes_;
    std::vector<double> coupling_;  // Parts x parts.
    std::vector<Coupled> coupled_;  // Of all parts in turn...
    std::vector<std::size_t> coupledEnd_;  // ... up to here.
    std::vector<double> wanted_;    // Per part.
    std::vector<Normal> normals_;   // Per part.
    std::vector<Vec2> at_;          // Per seat.
    std::vector<std::int32_t> order_;
    std::vector<std::int32_t> ends_;
};

}  // namespace muster
