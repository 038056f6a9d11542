// The game's job system: threads that live as long as the game. Muster steps on them.
#pragma once

#include <muster/task_runner.h>

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace game {

class Jobs {
public:
    /// Starts `workers` threads beside the caller's, and one for what may take longer than a frame.
    explicit Jobs(std::int32_t workers);
    ~Jobs();
    Jobs(const Jobs&) = delete;
    Jobs& operator=(const Jobs&) = delete;

    /// What Muster calls. The jobs must outlive the world.
    muster::TaskRunner runner();
    std::uint64_t rounds() const { return rounds_; }
    std::uint64_t launches() const { return launches_; }

private:
    using Task = void (*)(void* context, std::int32_t item, std::int32_t worker);

    void run(std::int32_t count, Task task, void* context);
    void launch(void (*task)(void*), void* context);
    void wait();
    void work(std::int32_t worker);
    void workInBackground();
    void takeItems(std::unique_lock<std::mutex>& lock, std::int32_t worker);

    const std::int32_t workers_;
    std::mutex mutex_;
    std::condition_variable begun_, ended_;
    Task task_ = nullptr;  // The items being run.
    void* context_ = nullptr;
    std::int32_t next_ = 0, count_ = 0, running_ = 0;
    void (*background_)(void*) = nullptr;  // The piece of work in the background.
    void* backgroundContext_ = nullptr;
    bool stop_ = false;
    std::uint64_t rounds_ = 0, launches_ = 0;
    std::vector<std::thread> threads_;
};

}  // namespace game
