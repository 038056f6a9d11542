#include "assignment/dynamic/bidirectional_dijkstra.h"

#include <algorithm>
#include <limits>

namespace muster {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// Of two entries the later to be settled: a total order, so that heaps come out the same everywhere.
constexpr auto kLater = [](const auto& a, const auto& b) {
    return a.distance != b.distance ? a.distance > b.distance : a.seat > b.seat;
};

}  // namespace

void BidirectionalDijkstra::reset(std::int32_t seats, std::int32_t limit) {
    const auto n = static_cast<std::size_t>(seats);
    const auto most = 64 + std::min(4 * n, 8 * static_cast<std::size_t>(limit));
    for (Side* side : {&forward_, &backward_}) {
        side->node.assign(n, {});
        side->order.reserve(std::min(n, static_cast<std::size_t>(limit)) + 1);
        side->heap.reserve(most);
        side->most = most;
    }
    cycle_.reserve(2 * std::min(n, static_cast<std::size_t>(limit)) + 8);
    stamp_ = 0;
}

// Nothing is cleared between searches; stamps begin anew before they run out.
void BidirectionalDijkstra::newStamp() {
    stamp_ += 2;
    if (stamp_ != 0) return;
    for (Side* side : {&forward_, &backward_})
        for (Node& node : side->node) node.stamp = 0;
    stamp_ = 2;
}

void BidirectionalDijkstra::begin(Side& side, std::int32_t seat) {
    side.heap.clear();
    side.order.clear();
    side.radius = 0.0;
    side.lost = kInfinite;
    side.node[seat] = {0.0, -1, stamp_};
    side.heap.push_back({0.0, seat});
}

// The least distance not settled yet.
double BidirectionalDijkstra::top(Side& side) {
    while (!side.heap.empty() && side.node[side.heap.front().seat].stamp == stamp_ + 1) {
        std::pop_heap(side.heap.begin(), side.heap.end(), kLater);
        side.heap.pop_back();
    }
    return side.heap.empty() ? side.lost : std::min(side.heap.front().distance, side.lost);
}

void BidirectionalDijkstra::label(Side& side, const Side& other, std::int32_t seat, std::int32_t through,
                                  double distance, double bound) {
    Node& node = side.node[seat];
    if (node.stamp == stamp_ && !(distance < node.distance)) return;
    node = {distance, through, stamp_};
    const Node& there = other.node[seat];
    if (there.stamp >= stamp_ && distance + there.distance < best_) {
        best_ = distance + there.distance;
        meeting_ = seat;
    }
    // Beyond the bound a node is needed neither for the way back nor for the prices.
    if (!(distance < bound)) return;
    if (side.heap.size() == side.most) {
        side.lost = std::min(side.lost, distance);
        return;
    }
    side.heap.push_back({distance, seat});
    std::push_heap(side.heap.begin(), side.heap.end(), kLater);
}

template <bool kForward>
void BidirectionalDijkstra::settle(const ExchangeArcs& arcs, std::span<const double> price, Side& side,
                                   const Side& other, double bound) {
    const Entry entry = side.heap.front();
    std::pop_heap(side.heap.begin(), side.heap.end(), kLater);
    side.heap.pop_back();
    const std::int32_t seat = entry.seat;
    side.node[seat].stamp = stamp_ + 1;
    side.order.push_back(seat);
    ++settledCount_;
    const double own = price[seat];
    const Node* nodes = side.node.data();
    const std::uint32_t done = stamp_ + 1;
    const double soFar = entry.distance;
    const auto reach = [&](std::int32_t next, double distance) {
        if (distance < bound && nodes[next].stamp != done) label(side, other, next, seat, distance, bound);
    };
    const float* weights = arcs.weights().data();
    if constexpr (kForward) {
        // Few are within the bound: first all distances, without a branch.
        const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(seat) * ExchangeArcs::kLanes;
        const std::int32_t* targets = arcs.targets().data() + first;
        double distance[ExchangeArcs::kLanes];
        for (std::int32_t k = 0; k < ExchangeArcs::kLanes; ++k)
            distance[k] = soFar + std::max(weights[first + k] - price[targets[k]] + own, 0.0);
        for (std::int32_t k = 0; k < ExchangeArcs::kLanes; ++k) reach(targets[k], distance[k]);
    } else {
        for (const std::int32_t arc : arcs.into(seat)) {
            const std::int32_t next = arc / ExchangeArcs::kLanes;
            reach(next, soFar + std::max(weights[arc] - own + price[next], 0.0));
        }
    }
}

SearchEnd BidirectionalDijkstra::run(const ExchangeArcs& arcs, std::span<const double> price,
                                     std::int32_t from, std::int32_t to, double violation, double direct,
                                     std::int32_t limit) {
    newStamp();
    settledCount_ = 0;
    best_ = direct;
    meeting_ = -1;
    begin(forward_, to);
    begin(backward_, from);
    for (;;) {
        const double ahead = top(forward_);
        const double behind = top(backward_);
        const double length = std::min(best_, violation);
        if (ahead + behind >= length) {
            finish(ahead, behind, length);
            if (!(best_ < violation)) return SearchEnd::Settled;
            trace(from, to);
            return SearchEnd::Cycle;
        }
        if (settledCount_ >= limit || std::min(forward_.lost, backward_.lost) < kInfinite) {
            forward_.radius = ahead;
            backward_.radius = behind;
            return SearchEnd::Capped;
        }
        if (forward_.heap.size() <= backward_.heap.size())
            settle<true>(arcs, price, forward_, backward_, length - behind);
        else
            settle<false>(arcs, price, backward_, forward_, length - ahead);
    }
}

void BidirectionalDijkstra::finish(double forwardTop, double backwardTop, double length) {
    forward_.radius = std::min(forwardTop, length);
    backward_.radius = std::min(backwardTop, length - forward_.radius);
}

void BidirectionalDijkstra::movePrices(std::span<double> price) const {
    for (const std::int32_t s : forward_.order)
        price[s] -= std::max(forward_.radius - forward_.node[s].distance, 0.0);
    for (const std::int32_t s : backward_.order)
        price[s] += std::max(backward_.radius - backward_.node[s].distance, 0.0);
}

// Writes the cycle. Ways of length zero may lead past one seat twice: the loop between is left out.
void BidirectionalDijkstra::trace(std::int32_t from, std::int32_t to) {
    cycle_.clear();
    cycle_.push_back(to);
    if (meeting_ >= 0) {
        cycle_.clear();
        for (std::int32_t s = meeting_; s >= 0; s = forward_.node[s].through) cycle_.push_back(s);
        std::reverse(cycle_.begin(), cycle_.end());
        std::int32_t s = backward_.node[meeting_].through;
        for (; s >= 0; s = backward_.node[s].through) cycle_.push_back(s);
        std::size_t kept = 0;
        for (std::size_t k = 0; k < cycle_.size(); ++k) {
            const std::int32_t seat = cycle_[k];
            if (seat == from) break;
            const auto end = cycle_.begin() + static_cast<std::ptrdiff_t>(kept);
            kept = static_cast<std::size_t>(std::find(cycle_.begin(), end, seat) - cycle_.begin());
            cycle_[kept++] = seat;
        }
        cycle_.resize(kept);
    }
    cycle_.push_back(from);
}

}  // namespace muster
