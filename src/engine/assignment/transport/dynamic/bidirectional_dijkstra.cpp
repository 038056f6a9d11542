#include "engine/assignment/transport/dynamic/bidirectional_dijkstra.h"

#include <algorithm>

#include "base/infinite_cost.h"

namespace muster {
namespace {

// Heap order: a total order, so that results are equal on every platform.
constexpr auto kSettledLater = [](const auto& a, const auto& b) {
    return a.distance != b.distance ? a.distance > b.distance : a.node > b.node;
};

}  // namespace

void BidirectionalDijkstra::reset(std::int32_t nodes, std::int32_t limit) {
    const std::size_t n = nodes;
    const std::size_t most = limit;
    const std::size_t capacity = 64 + std::min(4 * n, 8 * most);
    for (Side* side : {&forward_, &backward_}) {
        side->label.assign(n, {});
        side->order.reserve(std::min(n, most) + 1);
        side->heap.reserve(capacity);
        side->capacity = capacity;
    }
    cycle_.reserve(2 * std::min(n, most) + 8);
    stamp_ = 0;
}

// Labels are not cleared between searches, but before the stamps run out.
void BidirectionalDijkstra::newStamp() {
    stamp_ += 2;
    if (stamp_ != 0) return;
    for (Side* side : {&forward_, &backward_})
        for (Label& label : side->label) label.stamp = 0;
    stamp_ = 2;
}

void BidirectionalDijkstra::begin(Side& side, std::int32_t node) {
    side.heap.clear();
    side.order.clear();
    side.radius = 0.0;
    side.overflowDistance = kInfiniteCost;
    side.label[node] = {0.0, -1, stamp_};
    side.heap.push_back({0.0, node});
}

// The least distance of a node that is not settled; infinite where there is none.
double BidirectionalDijkstra::leastDistance(Side& side) {
    while (!side.heap.empty() && side.label[side.heap.front().node].stamp == stamp_ + 1) {
        std::pop_heap(side.heap.begin(), side.heap.end(), kSettledLater);
        side.heap.pop_back();
    }
    return side.heap.empty() ? side.overflowDistance
                             : std::min(side.heap.front().distance, side.overflowDistance);
}

void BidirectionalDijkstra::reach(Side& side, const Side& other, std::int32_t node, std::int32_t predecessor,
                                  double distance, double bound) {
    Label& label = side.label[node];
    if (label.stamp == stamp_ && !(distance < label.distance)) return;
    label = {distance, predecessor, stamp_};
    const Label& opposite = other.label[node];
    if (opposite.stamp >= stamp_ && distance + opposite.distance < pathLength_) {
        pathLength_ = distance + opposite.distance;
        meeting_ = node;
    }
    // A node beyond the bound is on no path that is short enough. Its dual is left as it is, although the
    // radius may come to exceed its distance.
    if (!(distance < bound)) return;
    if (side.heap.size() == side.capacity) {
        side.overflowDistance = std::min(side.overflowDistance, distance);
        return;
    }
    side.heap.push_back({distance, node});
    std::push_heap(side.heap.begin(), side.heap.end(), kSettledLater);
}

template <bool kForward>
void BidirectionalDijkstra::settle(const ExchangeArcs& arcs, std::span<const double> dual, Side& side,
                                   const Side& other, double bound) {
    constexpr std::int32_t kArcsPerNode = ExchangeArcs::kArcsPerNode;
    const Entry entry = side.heap.front();
    std::pop_heap(side.heap.begin(), side.heap.end(), kSettledLater);
    side.heap.pop_back();
    const std::int32_t node = entry.node;
    side.label[node].stamp = stamp_ + 1;
    side.order.push_back(node);
    ++settled_;
    const double nodeDual = dual[node];
    const Label* labels = side.label.data();
    const std::uint32_t settledStamp = stamp_ + 1;
    const double nodeDistance = entry.distance;
    const auto relax = [&](std::int32_t next, double distance) {
        if (distance < bound && labels[next].stamp != settledStamp)
            reach(side, other, next, node, distance, bound);
    };
    const float* costs = arcs.costs().data();
    if constexpr (kForward) {
        // Few heads are within the bound, so all distances are computed first, without a branch.
        const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(node) * kArcsPerNode;
        const std::int32_t* heads = arcs.heads().data() + first;
        double distance[kArcsPerNode];
        for (std::int32_t k = 0; k < kArcsPerNode; ++k)
            distance[k] = nodeDistance + std::max(costs[first + k] - dual[heads[k]] + nodeDual, 0.0);
        for (std::int32_t k = 0; k < kArcsPerNode; ++k) relax(heads[k], distance[k]);
    } else {
        for (const std::int32_t arc : arcs.incoming(node)) {
            const std::int32_t next = ExchangeArcs::tail(arc);
            relax(next, nodeDistance + std::max(costs[arc] - nodeDual + dual[next], 0.0));
        }
    }
}

SearchResult BidirectionalDijkstra::run(const ExchangeArcs& arcs, std::span<const double> dual,
                                        std::int32_t tail, std::int32_t head, double violation,
                                        double returnCost, std::int32_t limit) {
    newStamp();
    settled_ = 0;
    pathLength_ = returnCost;
    meeting_ = -1;
    begin(forward_, head);
    begin(backward_, tail);
    for (;;) {
        const double ahead = leastDistance(forward_);
        const double behind = leastDistance(backward_);
        const double length = std::min(pathLength_, violation);
        if (ahead + behind >= length) {
            setRadii(ahead, behind, length);
            if (!(pathLength_ < violation)) return SearchResult::NoCycle;
            traceCycle(tail, head);
            return SearchResult::Cycle;
        }
        if (settled_ >= limit ||
            std::min(forward_.overflowDistance, backward_.overflowDistance) < kInfiniteCost) {
            forward_.radius = ahead;
            backward_.radius = behind;
            return SearchResult::LimitReached;
        }
        if (forward_.heap.size() <= backward_.heap.size())
            settle<true>(arcs, dual, forward_, backward_, length - behind);
        else
            settle<false>(arcs, dual, backward_, forward_, length - ahead);
    }
}

void BidirectionalDijkstra::setRadii(double forwardDistance, double backwardDistance, double length) {
    forward_.radius = std::min(forwardDistance, length);
    backward_.radius = std::min(backwardDistance, length - forward_.radius);
}

void BidirectionalDijkstra::updateDuals(std::span<double> dual) const {
    for (const std::int32_t node : forward_.order)
        dual[node] -= std::max(forward_.radius - forward_.label[node].distance, 0.0);
    for (const std::int32_t node : backward_.order)
        dual[node] += std::max(backward_.radius - backward_.label[node].distance, 0.0);
}

// Writes the path. Where arcs of length zero lead past a node twice, the loop between is left out.
void BidirectionalDijkstra::traceCycle(std::int32_t tail, std::int32_t head) {
    cycle_.clear();
    cycle_.push_back(head);
    if (meeting_ >= 0) {
        cycle_.clear();
        for (std::int32_t n = meeting_; n >= 0; n = forward_.label[n].predecessor) cycle_.push_back(n);
        std::reverse(cycle_.begin(), cycle_.end());
        std::int32_t next = backward_.label[meeting_].predecessor;
        for (; next >= 0; next = backward_.label[next].predecessor) cycle_.push_back(next);
        std::ptrdiff_t size = 0;
        for (std::size_t k = 0; k < cycle_.size(); ++k) {
            const std::int32_t node = cycle_[k];
            if (node == tail) break;
            size = std::find(cycle_.begin(), cycle_.begin() + size, node) - cycle_.begin();
            cycle_[size++] = node;
        }
        cycle_.resize(size);
    }
    cycle_.push_back(tail);
}

}  // namespace muster
