#include "muster/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace muster {

struct ThreadPool::Impl {
    std::int32_t total = 1;
    std::vector<std::thread> workers;
    std::mutex mutex;
    std::condition_variable wake;
    std::condition_variable done;
    const std::function<void(std::int32_t, std::int32_t)>* work = nullptr;
    std::int32_t count = 0;
    std::atomic<std::int32_t> next{0};
    std::int32_t busy = 0;
    std::uint64_t round = 0;
    bool stopping = false;

    void drain(std::int32_t worker) {
        for (;;) {
            const std::int32_t item = next.fetch_add(1, std::memory_order_relaxed);
            if (item >= count) return;
            (*work)(item, worker);
        }
    }

    void loop(std::int32_t worker) {
        std::uint64_t seen = 0;
        for (;;) {
            {
                std::unique_lock lock(mutex);
                wake.wait(lock, [&] { return stopping || round != seen; });
                if (stopping) return;
                seen = round;
            }
            drain(worker);
            const std::lock_guard lock(mutex);
            if (--busy == 0) done.notify_one();
        }
    }
};

ThreadPool::ThreadPool(std::int32_t threads) : impl_(std::make_unique<Impl>()) {
#ifdef __EMSCRIPTEN__
    threads = 1;
#else
    if (threads <= 0) threads = static_cast<std::int32_t>(std::thread::hardware_concurrency());
    threads = std::clamp(threads, 1, 256);
    for (std::int32_t i = 1; i < threads; ++i)
        impl_->workers.emplace_back([impl = impl_.get(), i] { impl->loop(i); });
#endif
    impl_->total = threads;
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(impl_->mutex);
        impl_->stopping = true;
    }
    impl_->wake.notify_all();
    for (auto& worker : impl_->workers) worker.join();
}

std::int32_t ThreadPool::threads() const { return impl_->total; }

void ThreadPool::run(std::int32_t count, const std::function<void(std::int32_t, std::int32_t)>& work) {
    if (impl_->total == 1 || count <= 1) {
        for (std::int32_t i = 0; i < count; ++i) work(i, 0);
        return;
    }
    {
        const std::lock_guard lock(impl_->mutex);
        impl_->work = &work;
        impl_->count = count;
        impl_->next.store(0, std::memory_order_relaxed);
        impl_->busy = impl_->total - 1;
        ++impl_->round;
    }
    impl_->wake.notify_all();
    impl_->drain(0);
    std::unique_lock lock(impl_->mutex);
    impl_->done.wait(lock, [&] { return impl_->busy == 0; });
}

}  // namespace muster
