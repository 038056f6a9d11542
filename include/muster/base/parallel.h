// Independent pieces of work on several threads; results never depend on their number.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

namespace muster {

/// A pool of worker threads. With one thread (or under WebAssembly) all runs in the caller.
class ThreadPool {
public:
    /// `threads` in total, the caller counted in; 0 takes what the machine has.
    explicit ThreadPool(std::int32_t threads = 1);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;  ///< Threads cannot be copied.
    ThreadPool& operator=(const ThreadPool&) = delete;

    /// Threads in total, at least 1.
    std::int32_t threads() const;
    /// Calls `work(item, worker)` once for every item in [0, count); returns when all are done.
    /// `worker` in [0, threads()) picks private working memory. Items must not touch each other's
    /// results: which worker takes which item is not fixed.
    void run(std::int32_t count, const std::function<void(std::int32_t item, std::int32_t worker)>& work);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
