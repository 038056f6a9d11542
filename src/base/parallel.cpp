#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#ifdef _MSC_VER
#include <intrin.h>
#endif

namespace muster {
namespace {

// Number of times that a thread polls before it sleeps, about 0.1 ms. Waking a sleeping thread takes as long
// as a short stage of a step.
constexpr std::int32_t kSpins = 3000;

void relax() {
#if defined(_MSC_VER) && (defined(_M_X64) || defined(_M_IX86))
    _mm_pause();
#elif defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
    __builtin_ia32_pause();
#elif defined(__GNUC__) && defined(__aarch64__)
    asm volatile("yield");
#endif
}

// Polls `condition` up to `spins` times; returns whether it became true.
template <class Condition>
bool spinUntil(std::int32_t spins, const Condition& condition) {
    for (std::int32_t i = 0; i < spins; ++i) {
        if (condition()) return true;
        relax();
    }
    return condition();
}

constexpr std::uint64_t kLeftMask = 0xffffffffu;

// State of the background work.
enum class Background : std::int32_t { None, Offered, Taken, Done };

}  // namespace

// A round, one call of run(), is one atomic word: its number in the upper half, the number of items left in
// the lower half. A worker takes an item by a compare-and-exchange of the word. It then knows that the round
// is still the one it saw, and that the round cannot end before it reports the item. So a worker that wakes
// late finds nothing to do, and no thread waits for it.
struct ThreadPool::Impl {
    std::int32_t total = 1;
    TaskRunner runner;
    std::vector<std::thread> workers;
    std::int32_t spins = 0;
    // Task and number of items of the round; read only by workers that have an item of it.
    const TaskRef* work = nullptr;
    std::uint32_t count = 0;
    std::atomic<std::uint64_t> round{0};
    std::atomic<std::uint32_t> done{0};  // Number of items reported.
    std::atomic<std::int32_t> sleepers{0};
    std::atomic<bool> callerSleeps{false};
    std::atomic<Background> background{Background::None};
    // Function of the background work; read only by the thread that takes it.
    void (*backgroundWork)(void* context) = nullptr;
    void* backgroundContext = nullptr;
    std::atomic<bool> stopping{false};
    std::mutex mutex;  // Mutex that is held only to fall asleep and to wake others.
    std::condition_variable wake;
    std::condition_variable finished;
    std::atomic<std::int32_t> users{1};  // The pool and its detached workers: the last one deletes this.

    void leave() {
        if (users.fetch_sub(1) == 1) delete this;
    }

    bool somethingToDo() const {
        return (round.load() & kLeftMask) != 0 || background.load() == Background::Offered || stopping.load();
    }

    // Does the background work where no other thread has taken it.
    bool doBackground() {
        Background offered = Background::Offered;
        if (!background.compare_exchange_strong(offered, Background::Taken)) return false;
        backgroundWork(backgroundContext);
        background.store(Background::Done);
        if (callerSleeps.load()) {
            const std::lock_guard lock(mutex);
            finished.notify_one();
        }
        return true;
    }

    // Takes items until none is left.
    void drain(std::int32_t worker) {
        std::uint32_t taken = 0;
        std::uint32_t all = 0;
        std::uint64_t seen = round.load(std::memory_order_acquire);
        while ((seen & kLeftMask) != 0) {
            if (!round.compare_exchange_weak(seen, seen - 1, std::memory_order_acq_rel,
                                             std::memory_order_acquire))
                continue;
            all = count;
            (*work)(static_cast<std::int32_t>(all - static_cast<std::uint32_t>(seen & kLeftMask)), worker);
            ++taken;
            seen = round.load(std::memory_order_acquire);
        }
        // After the last report the calling thread may return and start another round: from here on only the
        // lock is touched.
        if (taken == 0 || done.fetch_add(taken) + taken != all || !callerSleeps.load()) return;
        const std::lock_guard lock(mutex);
        finished.notify_one();
    }

    void loop(std::int32_t worker) {
        while (!stopping.load()) {
            if (!spinUntil(spins, [&] { return somethingToDo(); })) {
                std::unique_lock lock(mutex);
                ++sleepers;
                wake.wait(lock, [&] { return somethingToDo(); });
                --sleepers;
            }
            drain(worker);
            doBackground();
        }
    }

    // A worker that is about to sleep either sees the new work, or is counted in `sleepers` and waits by the
    // time the lock is acquired.
    void wakeAll() {
        if (sleepers.load() == 0) return;
        const std::lock_guard lock(mutex);
        wake.notify_all();
    }

    // Makes the calling thread wait until `over`: it polls for a while, then sleeps.
    template <class Condition>
    void await(const Condition& over) {
        if (spinUntil(spins, over)) return;
        std::unique_lock lock(mutex);
        callerSleeps.store(true);
        finished.wait(lock, over);
        callerSleeps.store(false);
    }

    void runAll(std::uint32_t items, const TaskRef& task) {
        work = &task;
        count = items;
        done.store(0, std::memory_order_relaxed);
        round.store(((round.load(std::memory_order_relaxed) & ~kLeftMask) + (kLeftMask + 1)) | items);
        wakeAll();
        drain(0);
        await([&] { return done.load() == items; });
    }
};

ThreadPool::ThreadPool(std::int32_t threads) : impl_(std::make_unique<Impl>()) {
#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
    threads = 1;
#else
    const auto cores = static_cast<std::int32_t>(std::thread::hardware_concurrency());
    if (threads <= 0) threads = cores;
    threads = std::clamp(threads, 1, 256);
    // If threads share cores, polling would keep the awaited threads from working.
    impl_->spins = threads <= cores ? kSpins : 0;
    for (std::int32_t i = 1; i < threads; ++i) {
        impl_->users.fetch_add(1);
        impl_->workers.emplace_back([impl = impl_.get(), i] {
            impl->loop(i);
            impl->leave();
        });
    }
#endif
    impl_->total = threads;
}

ThreadPool::ThreadPool(const TaskRunner& runner) : impl_(std::make_unique<Impl>()) {
    if (runner.run == nullptr || runner.threads < 1) return;
    impl_->runner = runner;
    impl_->total = runner.threads;
}

ThreadPool::~ThreadPool() {
    wait();
    {
        const std::lock_guard lock(impl_->mutex);
        impl_->stopping.store(true);
    }
    impl_->wake.notify_all();
    // In browsers a thread may begin only after the calling thread has returned to the page: to wait for its
    // end could mean to wait for ever. Workers have nothing to do any more and touch nothing but their pool.
    for (auto& worker : impl_->workers) {
#ifdef __EMSCRIPTEN__
        worker.detach();
#else
        worker.join();
#endif
    }
    impl_.release()->leave();
}

std::int32_t ThreadPool::threads() const {
    return impl_->total;
}

void ThreadPool::run(std::int32_t count, TaskRef work) {
    if (count > 1 && impl_->runner.run != nullptr) {
        const auto call = [](void* task, std::int32_t item, std::int32_t worker) {
            (*static_cast<const TaskRef*>(task))(item, worker);
        };
        impl_->runner.run(impl_->runner.context, count, call, &work);
    } else if (count > 1 && impl_->total > 1) {
        impl_->runAll(static_cast<std::uint32_t>(count), work);
    } else {
        for (std::int32_t i = 0; i < count; ++i) work(i, 0);
    }
}

void ThreadPool::launch(void (*work)(void* context), void* context) {
    wait();
    Impl& s = *impl_;
    const bool hasRunner = s.runner.run != nullptr;
    if (hasRunner ? s.runner.launch == nullptr || s.runner.wait == nullptr : s.total == 1) {
        work(context);
    } else if (hasRunner) {
        s.background.store(Background::Taken);
        s.runner.launch(s.runner.context, work, context);
    } else {
        s.backgroundWork = work;
        s.backgroundContext = context;
        s.background.store(Background::Offered);
        s.wakeAll();
    }
}

void ThreadPool::wait() {
    Impl& s = *impl_;
    if (s.background.load() == Background::None) return;
    if (s.runner.run != nullptr)
        s.runner.wait(s.runner.context);
    else if (!s.doBackground())
        s.await([&] { return s.background.load() == Background::Done; });
    s.background.store(Background::None);
}

}  // namespace muster
