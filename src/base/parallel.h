// Independent pieces of work on several threads; results never depend on their number.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "muster/task_runner.h"

namespace muster {

/// A callable `(std::int32_t item, std::int32_t worker)` for the time of one call: a pointer to it, never a
/// copy.
class TaskRef {
public:
    /// Refers to `callable`, which has to outlive the reference.
    template <class Callable>
    requires(!std::is_same_v<std::remove_cvref_t<Callable>, TaskRef> &&
             std::is_invocable_v<Callable&, std::int32_t, std::int32_t>)
        TaskRef(Callable&& callable)  // NOLINT: lambdas are handed over as they are.
        : object_(const_cast<void*>(static_cast<const void*>(&callable))),
          call_([](void* object, std::int32_t item, std::int32_t worker) {
              (*static_cast<std::remove_reference_t<Callable>*>(object))(item, worker);
          }) {}

    /// Calls it.
    void operator()(std::int32_t item, std::int32_t worker) const { call_(object_, item, worker); }

private:
    void* object_;
    void (*call_)(void* object, std::int32_t item, std::int32_t worker);
};

/// A pool of worker threads. With one thread (or under WebAssembly) all runs in the caller.
class ThreadPool {
public:
    /// `threads` in total, the caller counted in; 0 takes what the machine has.
    explicit ThreadPool(std::int32_t threads = 1);
    /// No threads of its own: work goes to `runner`. Where it has no function or no thread, all runs in the
    /// caller.
    explicit ThreadPool(const TaskRunner& runner);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;  ///< Threads cannot be copied.
    ThreadPool& operator=(const ThreadPool&) = delete;

    /// Threads in total, at least 1.
    std::int32_t threads() const;
    /// Calls `work(item, worker)` once for every item in [0, count); returns when all are done.
    /// `worker` in [0, threads()) picks private working memory. Items must not touch each other's
    /// results: which worker takes which item is not fixed. Allocates nothing. Neither items nor other
    /// threads may call it meanwhile.
    void run(std::int32_t count, TaskRef work);
    /// Has `work(context)` done beside whatever the caller does until wait(), run() included: by a worker
    /// that has time, else by the caller. Waits for what was launched before. The work may not call this
    /// pool.
    void launch(void (*work)(void* context), void* context);
    /// Returns when what was launched is done, at once where nothing was.
    void wait();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Calls `each(i)` for all i in [0, count), `chunk` of them in one piece of work; in the caller where `pool`
/// is null or one chunk holds them all. Calls must not touch each other's results.
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
