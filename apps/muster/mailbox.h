// A bounded queue of messages from one thread to another.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <vector>

namespace muster {

/// Any thread may post; one thread collects all messages at once. The lock protects only the exchange of
/// lists.
template <class Message>
class Mailbox {
public:
    /// Sets the limit for the bytes of messages that are not collected yet.
    explicit Mailbox(std::size_t bytes) : capacity_(bytes) {}

    /// Posts a message of that size; returns false where the queue is full. A message of size 0 always fits.
    bool post(Message message, std::size_t bytes = 0) {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (bytes > capacity_ - used_) return false;
            used_ += bytes;
            messages_.push_back(std::move(message));
        }
        arrived_.notify_one();
        return true;
    }

    /// Waits for a message, at most `seconds`, then moves all of them to `messages` (emptied first).
    void collect(double seconds, std::vector<Message>& messages) {
        messages.clear();
        std::unique_lock<std::mutex> lock(mutex_);
        arrived_.wait_for(lock, std::chrono::duration<double>(seconds),
                          [this] { return !messages_.empty(); });
        messages.swap(messages_);
        used_ = 0;
    }

private:
    std::mutex mutex_;
    std::condition_variable arrived_;
    std::vector<Message> messages_;
    std::size_t capacity_;
    std::size_t used_ = 0;
};

}  // namespace muster
