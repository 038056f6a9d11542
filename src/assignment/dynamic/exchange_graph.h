// All that a sparse matching knows from step to step.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "assignment/dynamic/assignment_nodes.h"
#include "assignment/dynamic/exchange_arcs.h"

namespace muster {

/// Seats, arcs and prices. Shared by the parts of DynamicAssignment.
struct ExchangeGraph {
    AssignmentNodes seats;
    ExchangeArcs arcs;
    std::vector<double> price;  ///< Per seat, in the frame of the step (AssignmentStep::slope).
    /// Per seat: has another holder, or another standing, since its targets were chosen.
    std::vector<std::uint8_t> changed;
    /// Per seat: steps for which a change that did not gain enough is not tried again.
    std::vector<std::uint8_t> resting;
    /// Per seat: cost of its holder to its place [m]; 0 where one is missing.
    std::vector<float> own;
    /// Per seat: that cost when all arcs of its row were asked for last [m].
    std::vector<float> asked;
    std::vector<double> ownPower;  ///< The same to the power; worked out in each step.

    /// Room for so many, nobody seated.
    void reset(std::int32_t characters, std::int32_t places) {
        seats.reset(characters, places);
        arcs.reset(seats.count());
        const auto n = static_cast<std::size_t>(seats.count());
        price.assign(n, 0.0);
        changed.assign(n, 1);
        resting.assign(n, 0);
        own.assign(n, 0.0f);
        asked.assign(n, 0.0f);
        ownPower.assign(n, 0.0);
    }
    /// Reduced cost of an arc: what it would gain if the prices were right; negative where it is violated.
    double reduced(std::int32_t arc) const {
        return reduced(arc / ExchangeArcs::kLanes, arcs.target(arc), arcs.weight(arc));
    }
    /// The same for an arc of this weight between two seats.
    double reduced(std::int32_t from, std::int32_t to, float weight) const {
        return weight - price[to] + price[from];
    }
    /// The least reduced cost of the arcs from a seat. (Rounding keeps the order, so what all have in common
    /// is added last.)
    double leastFrom(std::int32_t seat) const {
        const std::int32_t* target = arcs.targets().data() +
                                     static_cast<std::ptrdiff_t>(seat) * ExchangeArcs::kLanes;
        const float* weight = arcs.weights().data() +
                              static_cast<std::ptrdiff_t>(seat) * ExchangeArcs::kLanes;
        double least[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
        for (std::int32_t k = 0; k < ExchangeArcs::kLanes; k += 2)
            for (std::int32_t m = 0; m < 2; ++m)
                least[m] = std::min(least[m], weight[k + m] - price[target[k + m]]);
        return std::min(least[0], least[1]) + price[seat];
    }
    /// The part of the reduced costs from a seat that is the same for all arcs.
    double leaving(const AssignmentStep& context, std::int32_t seat) const {
        const auto s = static_cast<std::size_t>(seat);
        return price[s] - ownPower[s] + dot(context.slope, seats.at(seat, context));
    }
    /// The part of the reduced costs to a seat that is the same for all arcs.
    double arriving(const AssignmentStep& context, std::int32_t seat) const {
        return -price[seat] - dot(context.slope, seats.at(seat, context));
    }
    /// Sets the cost of a seat's holder.
    void setOwn(std::int32_t seat, float cost, const CostPower& power) {
        own[seat] = cost;
        ownPower[seat] = seats.matched(seat) ? power(cost) : 0.0;
    }

    /// Lets an archive read or write all that influences later steps.
    template <class Archive>
    void visit(Archive& archive) {
        archive(seats, arcs, price, changed, resting, own, asked);
        if constexpr (Archive::kReading) {
            const auto n = static_cast<std::size_t>(seats.count());
            if (arcs.targets().size() != n * ExchangeArcs::kLanes || price.size() != n ||
                changed.size() != n || resting.size() != n || own.size() != n || asked.size() != n)
                archive.fail();
            ownPower.assign(n, 0.0);
        }
    }
};

}  // namespace muster
