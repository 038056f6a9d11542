#include "engine/assignment/transport/dynamic/column_generation.h"

#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"

namespace muster {
namespace {

// Number of nodes of which a step prices one, within these limits, and as many expensive nodes.
constexpr std::int32_t kNodesPerPriced = 250;
constexpr std::int32_t kLeastPriced = 2;
constexpr std::int32_t kMostPriced = 8;
constexpr std::int32_t kMostBounds = 200000;     // Number of pairs that are bounded in a step.
constexpr std::size_t kMostEvaluated = 64;       // Number of costs evaluated for one node, from it and to it.
constexpr double kSquareRounding = 1.0 - 1e-12;  // Factor that keeps a square below its exact value.
// The square of the cost at which CostPower stops growing, or just less [m^2].
constexpr double kMostSquare = 0.99 * CostOracle::kUnreachable * CostOracle::kUnreachable;

}  // namespace

void ColumnGeneration::reset(std::int32_t nodes) {
    all_ = expensive_ = {};
    reserve(nodes);
}

void ColumnGeneration::reserve(std::int32_t nodes) {
    candidates_.reserve(nodes);
    tailTerm_.reserve(nodes);
    headTerm_.reserve(nodes);
    pairs_.reserve(kMostEvaluated);
    pairCosts_.reserve(kMostEvaluated);
}

void ColumnGeneration::run(const AssignmentStep& step, ExchangeGraph& graph, double tolerance) {
    generated_ = 0;
    const std::int32_t count = graph.count();
    if (count == 0) return;
    leastUnitCost_ = step.costs.leastUnitCost();
    leastSquare_ = step.power.exponent() == 2.0 ? kSquareRounding * step.power(leastUnitCost_) : 0.0;
    collectTerms(step, graph);
    const std::int32_t most = std::min(kMostPriced, std::max(1, kMostBounds / count));
    const std::int32_t priced = std::clamp(count / kNodesPerPriced, std::min(kLeastPriced, most), most);
    for (std::int32_t k = 0; k < priced; ++k, ++all_.next) {
        if (all_.next >= count) all_ = {0, all_.pass + 1};
        priceNode(step, graph, all_.next, all_.pass, tolerance);
    }
    const auto& expensive = graph.expensiveNodes();
    for (std::int32_t k = 0; k < std::min(priced, static_cast<std::int32_t>(expensive.size())); ++k) {
        auto next = std::lower_bound(expensive.begin(), expensive.end(), expensive_.next);
        if (next == expensive.end()) {
            next = expensive.begin();
            ++expensive_.pass;
        }
        expensive_.next = *next + 1;
        priceNode(step, graph, *next, expensive_.pass, tolerance);
    }
}

void ColumnGeneration::collectTerms(const AssignmentStep& step, const ExchangeGraph& graph) {
    const AssignmentNodes& nodes = graph.nodes();
    tailTerm_.clear();
    headTerm_.clear();
    for (std::int32_t node = 0; node < graph.count(); ++node) {
        tailTerm_.push_back(nodes.assignee(node) >= 0 ? graph.tailTerm(step, node) : kInfiniteCost);
        headTerm_.push_back(nodes.isPlace(node) ? graph.headTerm(step, node) : kInfiniteCost);
    }
}

void ColumnGeneration::priceNode(const AssignmentStep& step, ExchangeGraph& graph, std::int32_t node,
                                 std::uint32_t pass, double tolerance) {
    if (!graph.nodes().isMatched(node)) return;
    collectFrom(step, graph, node, tolerance);
    generate(step, graph, pass, tolerance);
    collectTo(step, graph, node, tolerance);
    generate(step, graph, pass, tolerance);
}

// Makes a pair a candidate where its reduced cost may be negative. `terms` is the reduced cost less the cost
// to the power, plus the tolerance; it is negative.
inline void ColumnGeneration::consider(const AssignmentStep& step, const ExchangeGraph& graph,
                                       std::int32_t tail, std::int32_t head, double terms) {
    if (tail == head) return;
    const std::int32_t assignee = graph.nodes().assignee(tail);
    const double square = lengthSquared(step.input.places[head] - step.input.characters[assignee]);
    // Most pairs are too far, and most of these are excluded without a square root.
    if (std::min(square * leastSquare_, kMostSquare) + terms >= 0.0) return;
    if (!(step.power(leastUnitCost_ * std::sqrt(square)) + terms < 0.0)) return;
    if (graph.arcs().find(tail, head) >= 0) return;
    if (step.power(step.costs.lowerBound(assignee, head)) + terms < 0.0)
        candidates_.push_back({assignee, head});
}

void ColumnGeneration::collectFrom(const AssignmentStep& step, const ExchangeGraph& graph, std::int32_t tail,
                                   double tolerance) {
    candidates_.clear();
    const double base = tailTerm_[tail] + tolerance;
    for (std::int32_t head = 0; head < graph.nodes().places(); ++head) {
        const double terms = base + headTerm_[head];
        if (terms < 0.0) consider(step, graph, tail, head, terms);
    }
}

void ColumnGeneration::collectTo(const AssignmentStep& step, const ExchangeGraph& graph, std::int32_t head,
                                 double tolerance) {
    candidates_.clear();
    const double base = headTerm_[head] + tolerance;
    for (std::int32_t tail = 0; tail < graph.count(); ++tail) {
        const double terms = base + tailTerm_[tail];
        if (terms < 0.0) consider(step, graph, tail, head, terms);
    }
}

// Evaluates candidates, and makes the most violated pair of each node its generated arc. Of very many
// candidates a sample is evaluated, another one in the next pass.
void ColumnGeneration::generate(const AssignmentStep& step, ExchangeGraph& graph, std::uint32_t pass,
                                double tolerance) {
    const std::size_t stride = candidates_.size() / kMostEvaluated + 1;
    pairs_.clear();
    for (std::size_t k = pass % stride; k < candidates_.size(); k += stride) pairs_.push_back(candidates_[k]);
    pairCosts_.resize(pairs_.size());
    step.costs.evaluate(pairs_, pairCosts_, step.pool);
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        const std::int32_t tail = graph.nodes().nodeOf(pairs_[k].character);
        const std::int32_t head = pairs_[k].place;
        const auto cost = static_cast<float>(graph.arcCost(step, tail, head, step.power(pairCosts_[k])));
        const double reduced = graph.reducedCost(tail, head, cost);
        const double known = graph.reducedCost(ExchangeArcs::generatedArc(tail));
        if (!(reduced < std::min(-tolerance, known))) continue;
        graph.setGeneratedArc(tail, head, cost);
        ++generated_;
    }
}

}  // namespace muster
