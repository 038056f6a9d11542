#include "engine/assignment/transport/dynamic/exchange_arcs.h"

#include <algorithm>

namespace muster {

void ExchangeArcs::reset(std::int32_t nodes) {
    const std::int32_t arcs = nodes * kArcsPerNode;
    head_.resize(arcs);
    cost_.assign(arcs, kSelfLoopCost);
    for (std::int32_t arc = 0; arc < arcs; ++arc) head_[arc] = tail(arc);
    afterReading();
}

void ExchangeArcs::afterReading() {
    incomingCount_.assign(head_.size() / kArcsPerNode, 0);
    for (const std::int32_t head : head_) ++incomingCount_[head];
    incomingBegin_.assign(incomingCount_.size() + 1, 0);
    incoming_.assign(head_.size(), 0);
    indexed_ = false;
}

// Counting sort. The unsigned casts spare a sign extension per address in this loop, which is often run.
void ExchangeArcs::indexIncoming() {
    if (indexed_) return;
    indexed_ = true;
    const std::int32_t* heads = head_.data();
    std::int32_t* begin = incomingBegin_.data();
    std::int32_t* incoming = incoming_.data();
    std::int32_t sum = 0;
    for (std::size_t node = 0; node < incomingCount_.size(); ++node)
        begin[node] = sum += incomingCount_[node];
    incomingBegin_.back() = sum;
    for (std::size_t k = head_.size(); k-- > 0;)
        incoming[static_cast<std::uint32_t>(
            --begin[static_cast<std::uint32_t>(heads[k])])] = static_cast<std::int32_t>(k);
}

std::int32_t ExchangeArcs::find(std::int32_t tail, std::int32_t head) const {
    const std::int32_t first = tail * kArcsPerNode;
    const std::int32_t* row = head_.data() + first;
    // Backward and without an early exit, so that compilers compare several heads at once.
    std::int32_t slot = kArcsPerNode;
    for (std::int32_t k = kArcsPerNode; k-- > 0;) slot = row[k] == head ? k : slot;
    return slot < kArcsPerNode ? first + slot : -1;
}

bool ExchangeArcs::consistent() const {
    const auto nodes = static_cast<std::int32_t>(head_.size() / kArcsPerNode);
    if (head_.size() % kArcsPerNode != 0 || cost_.size() != head_.size()) return false;
    return std::all_of(head_.begin(), head_.end(), [&](std::int32_t h) { return h >= 0 && h < nodes; });
}

}  // namespace muster
