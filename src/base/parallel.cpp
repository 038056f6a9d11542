#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace muster {
namespace {

// How often a thread looks for work, or for the end of it, before it sleeps: about 0.1 ms. A sleeper wakes
// late by as much as a stage of a step takes.
constexpr std::int32_t kSpins = 3000;

void relax() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

// True as soon as `condition` holds, false where it does not within `spins` looks.
template <class Condition>
bool spinUntil(std::int32_t spins, const Condition& condition) {
    for (std::int32_t i = 0; i < spins; ++i) {
        if (condition()) return true;
        relax();
    }
    return condition();
}

constexpr std::uint64_t kLeftMask = 0xffffffffu;

// What became of the work that was launched.
enum class Aside : std::int32_t { None, Offered, Taken, Done };

}  // namespace

// A round lives in one word: its number above, items that nobody has taken below. Who takes an item by
// exchanging the word knows that the round is still the one it saw, and that the round cannot end before it
// reports the item: so a worker that wakes late finds nothing to do and nobody waits for it.
struct ThreadPool::Impl {
    std::int32_t total = 1;
    TaskRunner runner;
    std::vector<std::thread> workers;
    std::int32_t spins = 0;
    // Of this round, as is the count: read only by those who hold an item of it.
    const TaskRef* work = nullptr;
    std::uint32_t count = 0;
    std::atomic<std::uint64_t> round{0};
    std::atomic<std::uint32_t> done{0};  // Items reported.
    std::atomic<std::int32_t> sleepers{0};
    std::atomic<bool> callerSleeps{false};
    std::atomic<Aside> aside{Aside::None};
    void (*asideWork)(void* context) = nullptr;  // Read only by who takes it.
    void* asideContext = nullptr;
    std::atomic<bool> stopping{false};
    std::mutex mutex;  // Only for falling asleep and waking.
    std::condition_variable wake;
    std::condition_variable finished;

    bool somethingToDo() const {
        return (round.load() & kLeftMask) != 0 || aside.load() == Aside::Offered || stopping.load();
    }

    // Takes the launched work where nobody has, and does it.
    bool doAside() {
        Aside offered = Aside::Offered;
        if (!aside.compare_exchange_strong(offered, Aside::Taken)) return false;
        asideWork(asideContext);
        aside.store(Aside::Done);
        if (callerSleeps.load()) {
            const std::lock_guard lock(mutex);
            finished.notify_one();
        }
        return true;
    }

    // Takes items until none is left.
    void drain(std::int32_t worker) {
        std::uint32_t mine = 0;
        std::uint32_t all = 0;
        std::uint64_t seen = round.load(std::memory_order_acquire);
        while ((seen & kLeftMask) != 0) {
            if (!round.compare_exchange_weak(seen, seen - 1, std::memory_order_acq_rel,
                                             std::memory_order_acquire))
                continue;
            all = count;
            (*work)(static_cast<std::int32_t>(all - static_cast<std::uint32_t>(seen & kLeftMask)), worker);
            ++mine;
            seen = round.load(std::memory_order_acquire);
        }
        // From the last report on the caller may return and begin another round: only the lock is touched
        // then.
        if (mine == 0 || done.fetch_add(mine) + mine != all || !callerSleeps.load()) return;
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
            doAside();
        }
    }

    // Either a worker about to sleep sees what there is to do, or it is counted and waiting once the lock is
    // had.
    void wakeAll() {
        if (sleepers.load() == 0) return;
        const std::lock_guard lock(mutex);
        wake.notify_all();
    }

    // In the caller, until `over`: looks for a while, then sleeps.
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
#ifdef __EMSCRIPTEN__
    threads = 1;
#else
    const auto cores = static_cast<std::int32_t>(std::thread::hardware_concurrency());
    if (threads <= 0) threads = cores;
    threads = std::clamp(threads, 1, 256);
    // Where threads share cores, who spins keeps from work those it waits for.
    impl_->spins = threads <= cores ? kSpins : 0;
    for (std::int32_t i = 1; i < threads; ++i)
        impl_->workers.emplace_back([impl = impl_.get(), i] { impl->loop(i); });
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
    for (auto& worker : impl_->workers) worker.join();
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
    const bool foreign = s.runner.run != nullptr;
    if (foreign ? s.runner.launch == nullptr || s.runner.wait == nullptr : s.total == 1) {
        work(context);
    } else if (foreign) {
        s.aside.store(Aside::Taken);
        s.runner.launch(s.runner.context, work, context);
    } else {
        s.asideWork = work;
        s.asideContext = context;
        s.aside.store(Aside::Offered);
        s.wakeAll();
    }
}

void ThreadPool::wait() {
    Impl& s = *impl_;
    if (s.aside.load() == Aside::None) return;
    if (s.runner.run != nullptr)
        s.runner.wait(s.runner.context);
    else if (!s.doAside())
        s.await([&] { return s.aside.load() == Aside::Done; });
    s.aside.store(Aside::None);
}

}  // namespace muster
