#include "studio/session/takes/take_moments.h"

#include <utility>

namespace muster {

void TakeMoments::keep(std::uint32_t step, TakeMoment moment) {
    if (!missing(step)) return;
    bytes_ += moment.bytes();
    moments_.emplace(step, std::move(moment));
    while (bytes_ > mostBytes_ && moments_.size() > 2) thin();
}

void TakeMoments::thin() {
    spacing_ *= 2;
    for (auto at = moments_.begin(); at != moments_.end();) {
        if (at->first % spacing_ == 0) {
            ++at;
            continue;
        }
        bytes_ -= at->second.bytes();
        at = moments_.erase(at);
    }
}

const std::pair<const std::uint32_t, TakeMoment>* TakeMoments::before(std::uint32_t step) const {
    auto after = moments_.upper_bound(step);
    return after == moments_.begin() ? nullptr : &*--after;
}

}  // namespace muster
