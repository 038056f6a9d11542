#include "engine/assignment/planning/commit_rule.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kNegligible = 1e-7;  // Share of the largest flow up to which amounts count as rounding.

}  // namespace

// Finds the representative of a node, with path halving.
std::int32_t CommitRule::find(std::int32_t node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
}

void CommitRule::unite(std::int32_t a, std::int32_t b) {
    a = find(a);
    b = find(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
}

// Merges the lists: calls visit(flow, incumbent amount, optimal amount) for every pair in either, in order.
template <class Visit>
void CommitRule::forEachPair(std::span<const Flow> incumbent, std::span<const Flow> optimal,
                             Visit visit) const {
    const auto before = [](const Flow& a, const Flow& b) {
        return a.character != b.character ? a.character < b.character : a.place < b.place;
    };
    std::size_t a = 0;
    std::size_t b = 0;
    while (a < incumbent.size() || b < optimal.size()) {
        if (b == optimal.size() || (a < incumbent.size() && before(incumbent[a], optimal[b]))) {
            visit(incumbent[a], incumbent[a].amount, 0.0);
            ++a;
        } else if (a == incumbent.size() || before(optimal[b], incumbent[a])) {
            visit(optimal[b], 0.0, optimal[b].amount);
            ++b;
        } else {
            visit(optimal[b], incumbent[a].amount, optimal[b].amount);
            ++a;
            ++b;
        }
    }
}

// With the bottleneck objective an exchange is also worthwhile for lowering its own costliest pair to the
// bottleneck of the optimal flows.
bool CommitRule::isWorthwhile(const PlanDef& def, const Exchange& exchange, double bottleneck) const {
    const auto threshold = [&](double cost) {
        return std::max(def.commitThreshold, def.commitThresholdShare * cost);
    };
    if (exchange.moreMatched > tolerance_ || exchange.moreInClass > tolerance_) return true;
    if (def.bottleneck && exchange.incumbentBottleneck - bottleneck > threshold(exchange.incumbentBottleneck))
        return true;
    return exchange.incumbentCost - exchange.optimalCost > threshold(exchange.incumbentCost);
}

void CommitRule::choose(const PlanDef& def, std::int32_t characters, std::int32_t places, FlowCostOf costOf,
                        std::span<const Flow> incumbent, std::span<const Flow> optimal,
                        std::vector<Flow>& committed) {
    const std::int32_t nodes = characters + places;
    parent_.resize(nodes);
    for (std::int32_t k = 0; k < nodes; ++k) parent_[k] = k;
    exchanges_.assign(nodes, {});
    tolerance_ = 0.0;
    for (const Flow& flow : optimal) tolerance_ = std::max(tolerance_, kNegligible * flow.amount);
    const auto differ = [this](double before, double after) { return std::abs(after - before) > tolerance_; };

    forEachPair(incumbent, optimal, [&](const Flow& flow, double before, double after) {
        if (differ(before, after)) unite(flow.character, characters + flow.place);
    });
    double bottleneck = 0.0;  // Cost of the costliest pair of the optimal flows.
    forEachPair(incumbent, optimal, [&](const Flow& flow, double before, double after) {
        const auto [c, inClass] = costOf(flow.character, flow.place);
        if (after > tolerance_) bottleneck = std::max(bottleneck, c);
        if (!differ(before, after)) return;
        Exchange& exchange = exchanges_[find(flow.character)];
        if (before > tolerance_) exchange.incumbentBottleneck = std::max(exchange.incumbentBottleneck, c);
        exchange.moreMatched += after - before;
        if (inClass) exchange.moreInClass += after - before;
        exchange.incumbentCost += c * before;
        exchange.optimalCost += c * after;
    });
    for (Exchange& exchange : exchanges_) exchange.commit = isWorthwhile(def, exchange, bottleneck);
    committed.clear();
    forEachPair(incumbent, optimal, [&](const Flow& flow, double before, double after) {
        const bool commit = !differ(before, after) || exchanges_[find(flow.character)].commit;
        const double amount = commit ? after : before;
        if (amount > 0.0) committed.push_back({flow.character, flow.place, amount});
    });
}

}  // namespace muster
