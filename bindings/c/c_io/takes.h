// The takes of a C program.
#pragma once

#include "bindings/c/c_io/generated/struct_versions.h"
#include "bindings/c/c_world/command_list.h"
#include "bindings/c/c_world/layout.h"
#include "muster/muster.h"
#include "muster/take.h"

namespace muster::c_api {

/// A take, and the same for C.
struct TakeThing {
    explicit TakeThing(Take read);

    Take take;
    Arena arena;
    MusterTake written{};
};

/// The take of that handle; NotFound where there is none.
Result<TakeThing*> findTake(MusterTakeId id);
/// InvalidArgument where that is no number of threads.
inline Status checkTakeThreads(std::int32_t threads) {
    if (threads >= 0 && threads <= 256) return {};
    return invalidArgument("threads: found " + std::to_string(threads) + ", expected 0 to 256");
}

static_assert(sizeof(MusterSpeedPiece) == sizeof(SpeedPiece) &&
              offsetof(MusterSpeedPiece, ease) == offsetof(SpeedPiece, ease));

}  // namespace muster::c_api
