// Changes the blocks of a take afterwards: when each begins, how long it takes, and whether it is there.
#pragma once

#include <cstdint>
#include <string>

#include "muster/take.h"
#include "studio/session/takes/take_blocks.h"

namespace muster {

/// What is done to a block: Move, Copy, Remove or Stretch.
struct TrackChange {
    protocol::TrackEdit edit{};
    std::uint32_t block = 0;  ///< Index into takeBlocks().
    std::uint32_t step = 0;   ///< Where it begins then; for Stretch, where it ends.
    GroupId group;            ///< For Copy: whose the copy is; none for the same group's.
    std::uint32_t zero = 0;   ///< Where the part begins, from which sentences count times.
};

/// A changed take.
struct ChangedTake {
    Take take;         ///< To be simulated again: as runAgain() leaves it.
    std::string what;  ///< "Move “Form a ring”".
};

/// The take with that change. Commands of a block keep their times to each other, or spread alike when it is
/// stretched; an order is stretched by its pace, a wait by its seconds. A block that would end after the take
/// makes the take longer. Fails with one sentence with InvalidArgument where there is no such block, and with
/// Unsupported where it cannot be: before its group has come, or where later blocks would miss what it makes.
Result<ChangedTake> editTracks(const Take& take, const TakePaths& paths, const TakeNews& news,
                               const TrackChange& change);

}  // namespace muster
