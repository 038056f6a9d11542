#include "transport/sparse_matching_search.h"

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

void CycleSearch::reset(std::int32_t seats, std::int32_t limit) {
    const auto n = static_cast<std::size_t>(seats);
    const auto most = 64 + std::min(4 * n, 8 * static_cast<std::size_t>(limit));
    for (Side* side : {&forward_, &backward_}) {
        side->distance.assign(n, 0.0);
        side->through.assign(n, -1);
        side->seen.assign(n, 0);
        side->done.assign(n, 0);
        side->order.reserve(std::min(n, static_cast<std::size_t>(limit)) + 1);
        side->heap.reserve(most);
        side->most = most;
    }
    cycle_.reserve(2 * std::min(n, static_cast<std::size_t>(limit)) + 8);
    stamp_ = 0;
}

void CycleSearch::begin(Side& side, std::int32_t seat) {
    side.heap.clear();
    side.order.clear();
    side.radius = 0.0;
    side.lost = kInfinite;
    side.distance[static_cast<std::size_t>(seat)] = 0.0;
    side.through[static_cast<std::size_t>(seat)] = -1;
    side.seen[static_cast<std::size_t>(seat)] = stamp_;
    side.heap.push_back({0.0, seat});
}

// The least distance not settled yet.
double CycleSearch::top(Side& side) {
    while (!side.heap.empty() && side.done[static_cast<std::size_t>(side.heap.front().seat)] == stamp_) {
        std::pop_heap(side.heap.begin(), side.heap.end(), kLater);
        side.heap.pop_back();
    }
    return side.heap.empty() ? side.lost : std::min(side.heap.front().distance, side.lost);
}

void CycleSearch::label(Side& side, const Side& other, std::int32_t seat, std::int32_t through, double distance,
                        double bound) {
    const auto s = static_cast<std::size_t>(seat);
    if (side.seen[s] == stamp_ && !(distance < side.distance[s])) return;
    side.seen[s] = stamp_;
    side.distance[s] = distance;
    side.through[s] = through;
    if (other.seen[s] == stamp_ && distance + other.distance[s] < best_) {
        best_ = distance + other.distance[s];
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
void CycleSearch::settle(const MatchingArcs& arcs, std::span<const double> price, Side& side, const Side& other,
                         double bound) {
    const Entry entry = side.heap.front();
    std::pop_heap(side.heap.begin(), side.heap.end(), kLater);
    side.heap.pop_back();
    const std::int32_t seat = entry.seat;
    side.done[static_cast<std::size_t>(seat)] = stamp_;
    side.order.push_back(seat);
    ++settledCount_;
    const double own = price[static_cast<std::size_t>(seat)];
    const auto reach = [&](std::int32_t next, double reduced) {
        if (side.done[static_cast<std::size_t>(next)] == stamp_) return;
        const double distance = entry.distance + std::max(reduced, 0.0);
        if (distance < bound) label(side, other, next, seat, distance, bound);
    };
    const float* weights = arcs.weights().data();
    if constexpr (kForward) {
        const std::int32_t first = seat * MatchingArcs::kLanes;
        for (std::int32_t arc = first; arc < first + MatchingArcs::kLanes; ++arc) {
            const std::int32_t next = arcs.target(arc);
            reach(next, weights[arc] - price[static_cast<std::size_t>(next)] + own);
        }
    } else {
        for (const std::int32_t arc : arcs.into(seat)) {
            const std::int32_t next = arc / MatchingArcs::kLanes;
            reach(next, weights[arc] - own + price[static_cast<std::size_t>(next)]);
        }
    }
}

SearchEnd CycleSearch::run(const MatchingArcs& arcs, std::span<const double> price, std::int32_t from, std::int32_t to,
                           double violation, double direct, std::int32_t limit) {
    ++stamp_;
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

void CycleSearch::finish(double forwardTop, double backwardTop, double length) {
    forward_.radius = std::min(forwardTop, length);
    backward_.radius = std::min(backwardTop, length - forward_.radius);
}

void CycleSearch::movePrices(std::span<double> price) const {
    for (const std::int32_t s : forward_.order)
        price[static_cast<std::size_t>(s)] -= std::max(forward_.radius - forward_.distance[static_cast<std::size_t>(s)], 0.0);
    for (const std::int32_t s : backward_.order)
        price[static_cast<std::size_t>(s)] += std::max(backward_.radius - backward_.distance[static_cast<std::size_t>(s)], 0.0);
}

// Writes the cycle. Ways of length zero may lead past one seat twice: the loop between is left out.
void CycleSearch::trace(std::int32_t from, std::int32_t to) {
    cycle_.clear();
    cycle_.push_back(to);
    if (meeting_ >= 0) {
        cycle_.clear();
        for (std::int32_t s = meeting_; s >= 0; s = forward_.through[static_cast<std::size_t>(s)]) cycle_.push_back(s);
        std::reverse(cycle_.begin(), cycle_.end());
        std::int32_t s = backward_.through[static_cast<std::size_t>(meeting_)];
        for (; s >= 0; s = backward_.through[static_cast<std::size_t>(s)]) cycle_.push_back(s);
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
