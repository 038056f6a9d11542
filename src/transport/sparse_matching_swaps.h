// Exchanges of two.
#pragma once

#include <cstdint>

#include "transport/sparse_matching_state.h"

namespace muster {

/// Lets two exchange their seats wherever that gains more than the threshold by the weights as they stand, in at most so
/// many rounds. Asks for no costs, so own costs must be asked for afterwards. Returns the number of exchanges.
std::int32_t swapPairs(const MatchingContext& context, MatchingState& state, std::int32_t rounds);

}  // namespace muster
