#include "engine/systems/goals/exit_waits.h"

#include <algorithm>

namespace muster {

void ExitWaits::clear(std::size_t exits, std::size_t ways) {
    exits_ = exits;
    ways_ = ways;
    people_.bins = 0;
    people_.count.clear();
    people_.byExit.clear();
    inLine_.assign(exits, 0.0);
}

void ExitWaits::beginServing() {
    all_ = people_;
    before_.assign(all_.bins * nodes(), 0.0f);
    perPerson_.assign(all_.bins * nodes(), 0.0f);
    left_.assign(nodes(), 0.0);
    queue_.assign(ways_ * exits_, 0.0);
    waiting_.assign(ways_, 0.0);
    perNode_.assign(nodes(), 0.0);
    begins_.assign(exits_, 0.0);
}

void ExitWaits::addBin() {
    all_.addBin(nodes(), ways_ * exits_);
    before_.resize(all_.bins * nodes(), 0.0f);
    perPerson_.resize(all_.bins * nodes(), 0.0f);
}

double ExitWaits::passes(std::int32_t way, double now, double at) const {
    const std::size_t node = nodeOf(way), end = std::min(binOf(at), all_.bins);
    const double each = perNode_[node];
    double left = left_[node];
    for (std::size_t k = binOf(now) + 1; k < end; ++k)
        if (const float people = all_.count[k * nodes() + node]; people > 0.0f)
            left = timeAfter(left, static_cast<double>(k) * kBinTime, people, each);
    return std::max(left, at);
}

bool ExitWaits::isQueued(std::size_t exit, double flow) const {
    double come = inLine_[exit];
    bool isCrowded = false, isThere = false;
    for (std::size_t k = 0; k < binOf(kSoonTime); ++k) {
        if (k < all_.bins) come += static_cast<double>(all_.count[k * nodes() + exit]);
        const double until = static_cast<double>(k + 1) * kBinTime;
        if (until == kBeforeExitTime) isThere = come > kQueueShare * flow * kBeforeExitTime;
        if (until >= kBeforeExitTime) isCrowded = isCrowded || come > flow * until;
    }
    return isThere && isCrowded;
}

double ExitWaits::leavesLine(std::size_t exit, std::int32_t ahead, double walk) const {
    return std::max(walk, begins_[exit] + static_cast<double>(ahead) * perNode_[exit]);
}

double ExitWaits::leaves(std::size_t node, double walk, bool isCounted) const {
    const std::size_t k = binOf(walk), at = k * nodes() + node;
    if (k >= all_.bins) return std::max(walk, left_[node]);
    const double begins = static_cast<double>(k) * kBinTime;
    // Share of the people in its bin who are nearer.
    const double share = std::min(1.0, (walk - begins) / kBinTime);
    const double others = static_cast<double>(all_.count[at]) - (isCounted ? 1.0 : 0.0);
    const double nearer = std::max(0.0, others) * share;
    return std::max(walk, timeAfter(before_[at], begins, nearer, perPerson_[at]));
}

}  // namespace muster
