// The commands that lead from what the world is now to what a difference leads to.
#pragma once

#include <cstdint>
#include <vector>

#include "studio/session/history/definition.h"
#include "studio/session/history/step_record.h"

namespace muster {

/// A group that has come back.
struct FreshGroup {
    std::uint32_t name = 0;
    GroupId before;  ///< The id that it had.
};

/// Who asks, and what came with the commands before.
struct Leading {
    std::uint32_t client = 0;
    std::vector<FreshGroup> fresh;  ///< What the step before has brought.
};

/// Commands, and whether others are to follow once the ids of new groups are known.
struct LeadingBatch : Batch {
    bool follows = false;
    std::vector<CommandBody> starts;  ///< For the place alone: how groups start.

    bool empty() const { return bodies.empty() && starts.empty(); }
};

/// The commands that lead to `after` of the difference, of which `before` becomes what they replace. What is
/// done stays done: orders that are carried out are not given again, and what is gone is not changed. None
/// where nothing is left to do.
LeadingBatch commandsBetween(Difference& difference, const Leading& leading, const Scene& scene);

}  // namespace muster
