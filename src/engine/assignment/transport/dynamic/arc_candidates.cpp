#include "engine/assignment/transport/dynamic/arc_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/assignment/transport/dynamic/nearest_points.h"

namespace muster {
namespace {

constexpr std::int32_t kNearPlaces = 8;
constexpr std::int32_t kNearCharacters = 6;
// Number of arcs of an expensive node to neighbours, which are fewer, as some lead to other expensive nodes
// instead.
constexpr std::int32_t kExpensiveNearPlaces = 6;
constexpr std::int32_t kExpensiveNearCharacters = 4;
constexpr std::int32_t kExpensiveArcs = 4;
constexpr float kExpensiveTimesMean = 3.0f;
// Expensive nodes that are compared for one node; more are sampled evenly.
constexpr std::size_t kExpensiveCompared = 200;
// Index of the last slot, which joins dummy nodes and free places with the matched ones.
constexpr std::int32_t kLastSlot = ExchangeArcs::kArcsPerNode - 1;

}  // namespace

void ArcCandidates::prepare(const AssignmentStep& step, const AssignmentNodes& nodes,
                            std::span<const double> dual, std::span<const float> matchedCost) {
    placeCells_.sort(step.input.places, NearestPoints::cellEdge(step.input.places));
    characterCells_.sort(step.input.characters, NearestPoints::cellEdge(step.input.characters));
    double sum = 0.0;
    std::int32_t matched = 0;
    highestMatched_ = highestUnmatched_ = -1;
    const auto higher = [&](std::int32_t a, std::int32_t b) { return b < 0 || dual[a] > dual[b]; };
    for (std::int32_t node = 0; node < nodes.count(); ++node) {
        if (nodes.assignee(node) < 0) continue;
        if (!nodes.isPlace(node)) {
            if (higher(node, highestUnmatched_)) highestUnmatched_ = node;
            continue;
        }
        sum += matchedCost[node];
        ++matched;
        if (higher(node, highestMatched_)) highestMatched_ = node;
    }
    expensiveCost_ = kExpensiveTimesMean * static_cast<float>(sum / std::max(matched, 1));
    expensive_.clear();
    for (std::int32_t node = 0; node < nodes.count(); ++node)
        if (nodes.isMatched(node) && matchedCost[node] > expensiveCost_) expensive_.push_back(node);
}

// Adds arcs to the nearest expensive nodes.
void ArcCandidates::addExpensive(const AssignmentStep& step, const AssignmentNodes& nodes, std::int32_t node,
                                 std::int32_t& slot, ExchangeArcs& arcs) const {
    std::array<std::int32_t, kExpensiveArcs> nearest{};
    std::array<double, kExpensiveArcs> distance{};
    std::int32_t found = 0;
    const std::size_t stride = expensive_.size() / kExpensiveCompared + 1;
    for (std::size_t k = static_cast<std::size_t>(node) % stride; k < expensive_.size(); k += stride) {
        if (expensive_[k] == node) continue;
        const double d = lengthSquared(nodes.position(expensive_[k], step) - nodes.position(node, step));
        std::int32_t at = found;
        while (at > 0 && distance[at - 1] > d) --at;
        if (at == kExpensiveArcs) continue;
        found = std::min(found + 1, kExpensiveArcs);
        for (std::int32_t m = found - 1; m > at; --m) {
            nearest[m] = nearest[m - 1];
            distance[m] = distance[m - 1];
        }
        nearest[at] = expensive_[k];
        distance[at] = d;
    }
    for (std::int32_t k = 0; k < found; ++k) arcs.add(node, slot, ExchangeArcs::kGeneratedSlot, nearest[k]);
}

void ArcCandidates::chooseHeads(const AssignmentStep& step, const AssignmentNodes& nodes,
                                std::span<const float> matchedCost, std::int32_t node,
                                ExchangeArcs& arcs) const {
    constexpr std::int32_t kGeneratedSlot = ExchangeArcs::kGeneratedSlot;
    std::int32_t slot = 0;
    const std::int32_t generatedHead = arcs.head(ExchangeArcs::generatedArc(node));
    const std::int32_t assignee = nodes.assignee(node);
    if (assignee >= 0 || nodes.isPlace(node)) {
        const bool expensive = nodes.isMatched(node) && matchedCost[node] > expensiveCost_;
        const auto& characters = step.input.characters;
        const Vec2 from = assignee >= 0 ? characters[assignee] : nodes.position(node, step);
        NearestPoints near;
        near.find(placeCells_, step.input.places, nodes.isPlace(node) ? nodes.position(node, step) : from,
                  expensive ? kExpensiveNearPlaces : kNearPlaces,
                  [&](std::int32_t p) { return p != node && nodes.isPlace(p); });
        for (std::int32_t k = 0; k < near.size(); ++k) arcs.add(node, slot, kGeneratedSlot, near[k]);
        near.find(characterCells_, characters, from, expensive ? kExpensiveNearCharacters : kNearCharacters,
                  [&](std::int32_t i) { return i != assignee && nodes.nodeOf(i) >= 0; });
        for (std::int32_t k = 0; k < near.size(); ++k)
            arcs.add(node, slot, kGeneratedSlot, nodes.nodeOf(near[k]));
        if (expensive) addExpensive(step, nodes, node, slot, arcs);
        arcs.padWithSelfLoops(node, slot, kGeneratedSlot);
        if (nodes.isPlace(generatedHead)) arcs.add(node, slot, kLastSlot, generatedHead);
        arcs.padWithSelfLoops(node, slot, kLastSlot);
        arcs.add(node, slot, ExchangeArcs::kArcsPerNode, assignee < 0 ? highestMatched_ : highestUnmatched_);
    }
    arcs.padWithSelfLoops(node, slot, ExchangeArcs::kArcsPerNode);
}

}  // namespace muster
