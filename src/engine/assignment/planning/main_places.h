// Main places of characters whose supply goes to several places (SPEC A1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/assignment/transport/dense/transportation_problem.h"

namespace muster {

/// Writes the place to which each character walks: that of its largest flow, of equal flows the first. While
/// its present place gets nearly as much, the character keeps it, so that it does not waver between two; -1
/// where nothing flows. `flows` are ordered by character; `incumbent` is the place of each one, -1 for none.
void findMainPlaces(std::span<const Flow> flows, std::span<const std::int32_t> incumbent,
                    std::vector<std::int32_t>& place);

}  // namespace muster
