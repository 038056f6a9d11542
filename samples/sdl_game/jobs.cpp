#include "jobs.h"

namespace game {

Jobs::Jobs(std::int32_t workers) : workers_(workers) {
    for (std::int32_t worker = 1; worker <= workers; ++worker)
        threads_.emplace_back([this, worker] { work(worker); });
    threads_.emplace_back([this] { workInBackground(); });
}

Jobs::~Jobs() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    begun_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

muster::TaskRunner Jobs::runner() {
    return {.threads = workers_ + 1,
            .context = this,
            .run = [](void* jobs, std::int32_t count, Task task,
                      void* context) { static_cast<Jobs*>(jobs)->run(count, task, context); },
            .launch = [](void* jobs, void (*task)(void*),
                         void* context) { static_cast<Jobs*>(jobs)->launch(task, context); },
            .wait = [](void* jobs) { static_cast<Jobs*>(jobs)->wait(); }};
}

/// Takes items until there are none. The lock is held between items, not during them.
void Jobs::takeItems(std::unique_lock<std::mutex>& lock, std::int32_t worker) {
    while (next_ < count_) {
        const std::int32_t item = next_++;
        ++running_;
        lock.unlock();
        task_(context_, item, worker);
        lock.lock();
        --running_;
    }
    if (running_ == 0) ended_.notify_all();
}

void Jobs::run(std::int32_t count, Task task, void* context) {
    std::unique_lock lock(mutex_);
    ++rounds_;
    task_ = task;
    context_ = context;
    next_ = 0;
    count_ = count;
    begun_.notify_all();
    takeItems(lock, 0);
    ended_.wait(lock, [this] { return running_ == 0; });
    next_ = count_ = 0;
}

void Jobs::work(std::int32_t worker) {
    std::unique_lock lock(mutex_);
    while (true) {
        begun_.wait(lock, [this] { return stop_ || next_ < count_; });
        if (stop_) return;
        takeItems(lock, worker);
    }
}

void Jobs::launch(void (*task)(void*), void* context) {
    {
        const std::lock_guard lock(mutex_);
        ++launches_;
        background_ = task;
        backgroundContext_ = context;
    }
    begun_.notify_all();
}

void Jobs::wait() {
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [this] { return background_ == nullptr; });
}

void Jobs::workInBackground() {
    std::unique_lock lock(mutex_);
    while (true) {
        begun_.wait(lock, [this] { return stop_ || background_ != nullptr; });
        if (stop_) return;
        lock.unlock();
        background_(backgroundContext_);
        lock.lock();
        background_ = nullptr;
        ended_.notify_all();
    }
}

}  // namespace game
