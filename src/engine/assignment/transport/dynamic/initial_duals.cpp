#include "engine/assignment/transport/dynamic/initial_duals.h"

#include <algorithm>
#include <cmath>

#include "engine/assignment/transport/dynamic/kd_partition.h"

namespace muster {
namespace {

constexpr std::int32_t kNodesPerLeaf = 40;
constexpr std::int32_t kMostDualLeaves = 256;
constexpr std::int32_t kSweeps = 6;
constexpr std::int32_t kHeightIterations = 60;
constexpr double kOverRelaxation = 1.7;
// Width of an interval whose weight is a quarter, in mean matched costs.
constexpr double kQuarterWeightWidth = 0.02;

}  // namespace

void InitialDuals::run(const AssignmentStep& step, ExchangeGraph& graph) {
    collectDifferences(graph);
    partition(step, graph);
    fitSlopes();
    collectHeightEquations();
    listNeighbours();
    solveHeights();
    const std::span<double> dual = graph.duals();
    for (std::int32_t node = 0; node < graph.count(); ++node) {
        const Plane& plane = planes_[leafOf_[node]];
        dual[node] = plane.height + dot(plane.slope, position_[node] - plane.centre);
    }
    sweep(dual);
}

// An arc without a reverse arc bounds the difference on one side only, and is left out.
void InitialDuals::collectDifferences(const ExchangeGraph& graph) {
    const ExchangeArcs& arcs = graph.arcs();
    const std::span<const double> powers = graph.matchedPowers();
    differences_.clear();
    differences_.reserve(arcs.heads().size());
    differencesEnd_.clear();
    double soft = 1e-12;
    for (const double c : powers) soft += kQuarterWeightWidth * c / static_cast<double>(powers.size());
    for (std::int32_t tail = 0; tail < graph.count(); ++tail) {
        const std::int32_t first = tail * ExchangeArcs::kArcsPerNode;
        for (std::int32_t arc = first; arc < first + ExchangeArcs::kArcsPerNode; ++arc) {
            const std::int32_t head = arcs.head(arc);
            const std::int32_t reverse = head != tail ? arcs.find(head, tail) : -1;
            if (reverse < 0) continue;
            const double there = arcs.cost(arc);
            const double back = arcs.cost(reverse);
            const double width = std::max(there + back, 0.0);
            const auto weight = static_cast<float>((soft / (soft + width)) * (soft / (soft + width)));
            if (weight > 0.0f)
                differences_.push_back({tail, head, static_cast<float>(0.5 * (there - back)), weight});
        }
        differencesEnd_.push_back(static_cast<std::int32_t>(differences_.size()));
    }
}

void InitialDuals::partition(const AssignmentStep& step, const ExchangeGraph& graph) {
    const std::int32_t nodes = graph.count();
    position_.resize(nodes);
    order_.resize(nodes);
    for (std::int32_t node = 0; node < nodes; ++node) {
        position_[node] = graph.nodes().position(node, step);
        order_[node] = node;
    }
    leafEnds_.clear();
    partitionIntoLeaves(position_, order_, std::clamp(nodes / kNodesPerLeaf, 1, kMostDualLeaves), 0,
                        leafEnds_);
    const auto leaves = static_cast<std::int32_t>(leafEnds_.size());
    leafOf_.assign(nodes, 0);
    planes_.assign(leaves, {});
    std::int32_t begin = 0;
    for (std::int32_t leaf = 0; leaf < leaves; ++leaf) {
        Vec2& centre = planes_[leaf].centre;
        for (std::int32_t k = begin; k < leafEnds_[leaf]; ++k) {
            leafOf_[order_[k]] = leaf;
            centre += position_[order_[k]];
        }
        centre = centre / std::max(1.0, static_cast<double>(leafEnds_[leaf] - begin));
        begin = leafEnds_[leaf];
    }
}

void InitialDuals::fitSlopes() {
    normalEquations_.assign(planes_.size(), {});
    for (const Difference& difference : differences_) {
        const double weight = difference.weight;
        const Vec2 offset = position_[difference.head] - position_[difference.tail];
        for (const std::int32_t node : {difference.tail, difference.head}) {
            NormalEquations& n = normalEquations_[leafOf_[node]];
            n.xx += weight * offset.x * offset.x;
            n.xy += weight * offset.x * offset.y;
            n.yy += weight * offset.y * offset.y;
            n.right += offset * (weight * difference.wanted);
        }
    }
    for (std::size_t leaf = 0; leaf < planes_.size(); ++leaf) {
        const NormalEquations& n = normalEquations_[leaf];
        const double trace = n.xx + n.yy;
        if (!(trace > 0.0)) continue;
        // A small multiple of the identity keeps the matrix regular where all nodes lie on one line.
        const double xx = n.xx + 1e-6 * trace;
        const double yy = n.yy + 1e-6 * trace;
        const double determinant = xx * yy - n.xy * n.xy;
        planes_[leaf].slope = {(yy * n.right.x - n.xy * n.right.y) / determinant,
                               (xx * n.right.y - n.xy * n.right.x) / determinant};
    }
}

// The differences between nodes of two leaves say by how much the leaves' heights should differ.
void InitialDuals::collectHeightEquations() {
    const std::size_t leaves = planes_.size();
    coupling_.assign(leaves * leaves, 0.0);
    right_.assign(leaves, 0.0);
    for (const Difference& difference : differences_) {
        const double weight = difference.weight;
        const std::size_t a = leafOf_[difference.tail];
        const std::size_t b = leafOf_[difference.head];
        if (a == b) continue;
        const double inA = dot(planes_[a].slope, position_[difference.tail] - planes_[a].centre);
        const double inB = dot(planes_[b].slope, position_[difference.head] - planes_[b].centre);
        const double rise = difference.wanted + inA - inB;  // Height of b less height of a.
        coupling_[a * leaves + b] += weight;
        coupling_[b * leaves + a] += weight;
        right_[a] -= weight * rise;
        right_[b] += weight * rise;
    }
}

// Each of some hundreds of leaves has about a dozen neighbours.
void InitialDuals::listNeighbours() {
    const auto leaves = static_cast<std::int32_t>(planes_.size());
    neighbours_.clear();
    neighboursEnd_.clear();
    for (std::int32_t a = 0; a < leaves; ++a) {
        for (std::int32_t b = 0; b < leaves; ++b)
            if (const double weight = coupling_[a * leaves + b]; weight != 0.0)
                neighbours_.push_back({b, weight});
        neighboursEnd_.push_back(static_cast<std::int32_t>(neighbours_.size()));
    }
}

// Gauss-Seidel iteration with over-relaxation.
void InitialDuals::solveHeights() {
    for (std::int32_t iteration = 0; iteration < kHeightIterations; ++iteration) {
        std::int32_t k = 0;
        for (std::size_t a = 0; a < planes_.size(); ++a) {
            double sum = right_[a];
            double weight = 0.0;
            for (; k < neighboursEnd_[a]; ++k) {
                sum += neighbours_[k].weight * planes_[neighbours_[k].leaf].height;
                weight += neighbours_[k].weight;
            }
            if (weight > 0.0) planes_[a].height += kOverRelaxation * (sum / weight - planes_[a].height);
        }
    }
}

// Sets each dual in turn to the weighted mean of the values that its neighbours want.
void InitialDuals::sweep(std::span<double> dual) const {
    for (std::int32_t sweep = 0; sweep < kSweeps; ++sweep) {
        std::int32_t k = 0;
        for (std::size_t node = 0; node < differencesEnd_.size(); ++node) {
            double sum = 0.0;
            double weight = 0.0;
            for (; k < differencesEnd_[node]; ++k) {
                const double w = differences_[k].weight;
                sum += w * (dual[differences_[k].head] - differences_[k].wanted);
                weight += w;
            }
            if (weight > 0.0) dual[node] = sum / weight;
        }
    }
}

}  // namespace muster
