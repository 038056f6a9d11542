// Prices for a matching that has none yet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assignment/dynamic/exchange_graph.h"

namespace muster {

/// Between two seats with arcs both ways the difference of prices may lie in an interval; prices are fitted
/// to the middles of these, the narrow ones weighing most. First a plane for each of a few hundred parts of
/// the formation, then a few rounds over all seats. Averages cannot run away, and the repair does the rest.
class InitialDuals {
public:
    /// Writes state.price from the weights of all arcs.
    void run(const AssignmentStep& context, ExchangeGraph& state);

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

    // An arc to a seat from which one leads back.
    struct Paired {
        std::int32_t from;
        std::int32_t to;
        float middle;  // Wanted price of `to` less that of `from`.
        float weight;  // > 0
    };

    // A part that shares arcs with another.
    struct Coupled {
        std::size_t part;
        double weight;
    };

    void pairArcs(const ExchangeGraph& state);
    void divide(const AssignmentStep& context, const ExchangeGraph& state);
    void fitSlopes();
    void fitHeights();
    void listCoupled();
    void solveHeights();
    void smooth(ExchangeGraph& state) const;

    Vec2 at(std::int32_t seat) const { return at_[seat]; }
    std::size_t partOf(std::int32_t seat) const { return static_cast<std::size_t>(partOf_[seat]); }

    std::vector<Paired> paired_;          // Of all seats in turn...
    std::vector<std::size_t> pairedEnd_;  // ... up to here.
    std::vector<std::int32_t> partOf_;
    std::vector<Plane> planes_;
    std::vector<double> coupling_;         // Parts x parts.
    std::vector<Coupled> coupled_;         // Of all parts in turn...
    std::vector<std::size_t> coupledEnd_;  // ... up to here.
    std::vector<double> wanted_;           // Per part.
    std::vector<Normal> normals_;          // Per part.
    std::vector<Vec2> at_;                 // Per seat.
    std::vector<std::int32_t> order_;
    std::vector<std::int32_t> ends_;
};

}  // namespace muster
