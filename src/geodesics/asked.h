// Which places were asked for lately.
#pragma once

#include <cstdint>
#include <vector>

namespace muster {

/// Steps for which a place that was asked for keeps what tells of it.
inline constexpr std::uint8_t kRemembered = 60;

/// Notes in `steps`, one per place, that this one was asked for. Several threads may do so at once, as long
/// as none reads.
inline void noteAsked(const std::vector<std::uint8_t>& steps, std::int32_t place) {
    auto* at = const_cast<std::uint8_t*>(&steps[place]);
    __atomic_store_n(at, kRemembered, __ATOMIC_RELAXED);
}

}  // namespace muster
