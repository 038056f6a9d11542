#include "engine/systems/goals/exit_waits.h"

#include <algorithm>

namespace muster {

void ExitWaits::clear(std::size_t exits) {
    count_.assign(exits * kBins, 0.0f);
    before_.assign(exits * kBins, 0.0f);
    perPerson_.assign(exits * kBins, 0.0f);
}

double ExitWaits::queueing(std::size_t exit) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < binOf(kNear); ++k) sum += static_cast<double>(count_[exit * kBins + k]);
    return sum;
}

double ExitWaits::leaves(std::size_t exit, double walk) const {
    const std::size_t k = binOf(walk), at = exit * kBins + k;
    const double begins = static_cast<double>(k) * kBin;
    const double share = std::min(1.0, (walk - begins) / kBin);  // Of those in its bin who are nearer.
    const double nearer = static_cast<double>(count_[at]) * share;
    return std::max(walk, timeAfter(before_[at], begins, nearer, perPerson_[at]));
}

}  // namespace muster
