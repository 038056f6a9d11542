// A pool of worker threads. Results never depend on the number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "base/function_ref.h"
#include "muster/task_runner.h"

namespace muster {

/// One item of parallel work: a callable `(std::int32_t item, std::int32_t worker)`.
using TaskRef = FunctionRef<void(std::int32_t, std::int32_t)>;

/// Worker threads for a fork-join loop, and for one piece of background work at a time. With one thread, and
/// under WebAssembly, all work is done in the calling thread.
class ThreadPool {
public:
    /// `threads` in total, the calling thread included [0 to 256]; 0 for as many as the machine has.
    explicit ThreadPool(std::int32_t threads = 1);
    /// A pool without threads of its own that passes all work to `runner`. Without a `run` function, or with
    /// fewer than one thread, all work is done in the calling thread.
    explicit ThreadPool(const TaskRunner& runner);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    /// Threads in total, the calling thread included; at least 1.
    std::int32_t threads() const;
    /// Calls `work(item, worker)` once for every item in [0, count) and returns when all calls have returned.
    /// No two simultaneous calls have the same `worker`, in [0, threads()), so that it can select working
    /// memory. Which worker takes which item is not defined: items must not touch each other's results. Does
    /// not allocate. Neither items nor other threads may call it meanwhile.
    void run(std::int32_t count, TaskRef work);
    /// Starts `work(context)` in the background and returns. A worker does it while the calling thread goes
    /// on, also into run(); if no worker has time until wait(), the calling thread does it there. Waits for
    /// the background work launched before. The work must not call this pool.
    void launch(void (*work)(void* context), void* context);
    /// Returns when the background work is done; at once where none was launched.
    void wait();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Default number of calls in an item of forChunks().
inline constexpr std::size_t kPerTask = 256;

/// Calls `each(i)` for all i in [0, count), in items of `chunk` calls; in the calling thread where `pool` is
/// null or one item is enough. Calls must not touch each other's results.
template <class Each>
void forChunks(ThreadPool* pool, std::size_t count, std::size_t chunk, const Each& each) {
    const auto task = [&](std::int32_t item, std::int32_t) {
        const std::size_t first = static_cast<std::size_t>(item) * chunk;
        const std::size_t last = std::min(count, first + chunk);
        for (std::size_t i = first; i < last; ++i) each(i);
    };
    const auto chunks = static_cast<std::int32_t>((count + chunk - 1) / chunk);
    if (pool != nullptr && chunks > 1)
        pool->run(chunks, task);
    else
        for (std::int32_t item = 0; item < chunks; ++item) task(item, 0);
}

}  // namespace muster
