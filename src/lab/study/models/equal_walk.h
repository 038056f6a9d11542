// The gate of a fair study: one straight open walk takes as long by every control scheme.
#pragma once

#include <string>

#include "muster/status.h"

namespace muster {

/// Time from the last event of one order until the middle of the crowd has gone 20 m straight over open
/// ground [s], towards a point 25 m away. Fails where the scheme is unknown or the crowd does not get there
/// within a minute.
Result<double> equalWalkSeconds(const std::string& scheme, std::int32_t crowd);

}  // namespace muster
