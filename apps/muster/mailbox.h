// Letters from one thread to another.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <vector>

namespace muster {

/// A bounded queue: many may post, one collects all at once. The lock is held for a swap only.
template <class Letter>
class Mailbox {
public:
    /// Room for so many bytes of letters that are not collected yet.
    explicit Mailbox(std::size_t bytes) : room_(bytes) {}

    /// Posts a letter of that size; false where there is no room. Size 0 always finds room.
    bool post(Letter letter, std::size_t bytes = 0) {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (bytes > room_ - used_) return false;
            used_ += bytes;
            letters_.push_back(std::move(letter));
        }
        arrived_.notify_one();
        return true;
    }

    /// Waits for a letter, at most `seconds`, then moves all to `letters` (emptied first).
    void collect(double seconds, std::vector<Letter>& letters) {
        letters.clear();
        std::unique_lock<std::mutex> lock(mutex_);
        arrived_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return !letters_.empty(); });
        letters.swap(letters_);
        used_ = 0;
    }

private:
    std::mutex mutex_;
    std::condition_variable arrived_;
    std::vector<Letter> letters_;
    std::size_t room_;
    std::size_t used_ = 0;
};

}  // namespace muster
