#include "engine/state/reform.h"

#include <algorithm>
#include <numeric>

#include "engine/assignment/transport/dynamic/cost_oracle.h"
#include "engine/assignment/transport/dynamic/dynamic_assignment.h"
#include "engine/assignment/transport/dynamic/initial_assignment.h"

namespace muster {
namespace {

constexpr std::size_t kRepaired = 128;  // So many are matched near-optimally, more in leaves of a k-d tree.

/// Straight distances.
class StraightCosts final : public CostOracle {
public:
    StraightCosts(std::span<const Vec2> characters, std::span<const Vec2> places)
        : characters_(characters), places_(places) {}
    float cost(std::int32_t character, std::int32_t place) override {
        return static_cast<float>(distance(characters_[character], places_[place]));
    }
    double leastUnitCost() const override { return 1.0; }
    void evaluate(std::span<const AssignmentPair> pairs, std::span<float> cost, ThreadPool&) override {
        for (std::size_t k = 0; k < pairs.size(); ++k)
            cost[k] = StraightCosts::cost(pairs[k].character, pairs[k].place);
    }

private:
    std::span<const Vec2> characters_, places_;  // [m]
};

}  // namespace

std::vector<std::int32_t> matchNear(std::span<const Vec2> to, std::span<const Vec2> from, double reach) {
    std::vector<std::int32_t> byX(from.size());
    std::iota(byX.begin(), byX.end(), 0);
    std::sort(byX.begin(), byX.end(), [&](std::int32_t a, std::int32_t b) {
        return from[a].x != from[b].x ? from[a].x < from[b].x : a < b;
    });
    std::vector<std::uint8_t> taken(from.size(), 0);
    std::vector<std::int32_t> match(to.size(), -1);
    for (std::size_t k = 0; k < to.size(); ++k) {
        double nearest = reach * reach;
        auto at = std::lower_bound(byX.begin(), byX.end(), to[k].x - reach,
                                   [&](std::int32_t a, double x) { return from[a].x < x; });
        for (; at != byX.end() && from[*at].x <= to[k].x + reach; ++at) {
            const double d = lengthSquared(from[*at] - to[k]);
            if (taken[*at] != 0 || d > nearest || (d == nearest && match[k] >= 0)) continue;
            nearest = d;
            match[k] = *at;
        }
        if (match[k] >= 0) taken[match[k]] = 1;
    }
    return match;
}

std::vector<std::int32_t> matchAll(std::span<const Vec2> to, std::span<const Vec2> from) {
    std::vector<std::int32_t> match(to.size(), -1);
    if (to.empty() || from.empty()) return match;
    StraightCosts costs(from, to);
    ThreadPool alone;
    const DynamicAssignmentDef def;
    const AssignmentInput input{from, to, {}, {}};
    const auto take = [&](std::size_t i, std::int32_t place) {
        if (place >= 0) match[place] = static_cast<std::int32_t>(i);
    };
    if (from.size() > kRepaired) {
        AssignmentNodes nodes;
        std::vector<std::int32_t> changed;
        nodes.reset(static_cast<std::int32_t>(from.size()), static_cast<std::int32_t>(to.size()));
        nodes.update(input, changed);
        InitialAssignment().run({def, input, costs, alone}, nodes);
        for (std::size_t i = 0; i < from.size(); ++i) take(i, nodes.nodeOf(static_cast<std::int32_t>(i)));
        return match;
    }
    DynamicAssignment assignment;
    assignment.coldStart(def, input, costs, alone);
    for (std::size_t i = 0; i < from.size(); ++i) take(i, assignment.placeOf()[i]);
    return match;
}

}  // namespace muster
