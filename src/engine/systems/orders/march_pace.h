// The pace of marches at which members keep up (SPEC U6).
#pragma once

#include <vector>

#include "engine/state/world_state.h"

namespace muster {

/// The pace of marches. Its working memory is reused.
class MarchPace {
public:
    /// The pace of a group in this step: a share of its speed, [0, 1].
    double of(const WorldState& state, const Group& group);

private:
    std::vector<double> lags_;  // Lags of the members of one group [m].
};

}  // namespace muster
