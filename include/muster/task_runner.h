// The interface through which a program lends its own threads to the library.
#pragma once

#include <cstdint>

namespace muster {

/// The job system of the program that uses the library, in place of the library's own threads. A default
/// runner has no function, and no world takes it.
struct TaskRunner {
    /// Largest number of workers that run at the same time, the calling thread included where it takes part
    /// [1 to 256].
    std::int32_t threads = 1;
    /// Passed unchanged as the first argument of each function below. May be null.
    void* context = nullptr;
    /// Calls `task(taskContext, item, worker)` once for every item in [0, count), in any order and on any
    /// threads. Returns when all calls have returned and their writes are visible to the calling thread.
    /// `worker` lies in [0, threads); no two simultaneous calls have the same `worker`. Must not be null.
    void (*run)(void* context, std::int32_t count,
                void (*task)(void* taskContext, std::int32_t item, std::int32_t worker),
                void* taskContext) = nullptr;
    /// Starts `task(taskContext)` on another thread, now or later, and returns at once. Null if the program
    /// has no thread for background work, which is then done in the calling thread.
    void (*launch)(void* context, void (*task)(void* taskContext), void* taskContext) = nullptr;
    /// Returns when the launched task has returned and its writes are visible to the calling thread. Must not
    /// be null if `launch` is not.
    void (*wait)(void* context) = nullptr;
};

}  // namespace muster
