#include "engine/systems/goals/exit_waits.h"

#include <algorithm>

namespace muster {

void ExitWaits::clear(std::size_t exits) {
    count_.assign(exits * kBins, 0.0f);
    before_.assign(exits * kBins, 0.0f);
    perPerson_.assign(exits * kBins, 0.0f);
}

bool ExitWaits::isQueued(std::size_t exit, double flow) const {
    double come = 0.0;
    bool isCrowded = false, isThere = false;
    for (std::size_t k = 0; k < binOf(kSoon); ++k) {
        come += static_cast<double>(count_[exit * kBins + k]);
        const double until = static_cast<double>(k + 1) * kBin;
        if (until == kNear) isThere = come > kThere * flow * kNear;
        if (until >= kNear) isCrowded = isCrowded || come > flow * until;
    }
    return isThere && isCrowded;
}

double ExitWaits::leaves(std::size_t exit, double walk) const {
    const std::size_t k = binOf(walk), at = exit * kBins + k;
    const double begins = static_cast<double>(k) * kBin;
    const double share = std::min(1.0, (walk - begins) / kBin);  // Of those in its bin who are nearer.
    const double nearer = static_cast<double>(count_[at]) * share;
    return std::max(walk, timeAfter(before_[at], begins, nearer, perPerson_[at]));
}

}  // namespace muster
