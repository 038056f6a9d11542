#include "lossy_link.h"

#include <algorithm>
#include <utility>

namespace lockstep {

void LossyLink::hold(std::uint32_t tick, Bytes bytes) {
    const double takes = def_.delay + random_.between(-def_.jitter, def_.jitter);
    held_.emplace(tick * kTickMilliseconds + std::max(takes, 0.0), std::move(bytes));
}

void LossyLink::send(std::uint32_t tick, const Bytes& bytes) {
    ++sent_;
    sentBytes_ += bytes.size();
    if (def_.garbage > 0.0 && random_.chance(def_.garbage)) hold(tick, garbage(bytes));
    if (random_.chance(def_.loss))
        ++lost_;
    else
        hold(tick, bytes);
}

Bytes LossyLink::garbage(const Bytes& bytes) {
    Bytes bad = bytes;
    switch (random_.below(3)) {
        case 0:  // Random bytes of any length.
            bad.resize(random_.below(1500));
            for (std::uint8_t& byte : bad) byte = static_cast<std::uint8_t>(random_.below(256));
            break;
        case 1:  // Cut short.
            bad.resize(random_.below(static_cast<std::uint32_t>(bad.size())));
            break;
        default:  // One wrong byte.
            bad[random_.below(static_cast<std::uint32_t>(bad.size()))] ^= static_cast<std::uint8_t>(
                1 + random_.below(255));
    }
    return bad;
}

std::vector<Bytes> LossyLink::arrivals(std::uint32_t tick) {
    std::vector<Bytes> arrived;
    const auto end = held_.upper_bound(tick * kTickMilliseconds + 1e-6);
    for (auto it = held_.begin(); it != end; ++it) arrived.push_back(std::move(it->second));
    held_.erase(held_.begin(), end);
    return arrived;
}

}  // namespace lockstep
