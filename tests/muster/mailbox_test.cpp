#include "mailbox.h"

#include <doctest.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace muster;

TEST_CASE("messages come in the order they were posted, all at once, and only once") {
    Mailbox<std::string> box(100);
    std::vector<std::string> messages{"left from before"};
    box.collect(0.0, messages);
    CHECK(messages.empty());
    for (const std::string text : {"a", "b", "c"}) CHECK(box.post(text, 1));
    box.collect(0.0, messages);
    CHECK(messages == std::vector<std::string>{"a", "b", "c"});
    box.collect(0.0, messages);
    CHECK(messages.empty());
}

TEST_CASE("the mailbox is full at its capacity to the byte, and empty once collected") {
    Mailbox<int> box(10);
    std::vector<int> messages;
    CHECK(!box.post(0, 11));
    CHECK(box.post(1, 4));
    CHECK(box.post(2, 5));
    CHECK(!box.post(3, 2));
    CHECK(box.post(4, 1));
    CHECK(!box.post(5, 1));
    CHECK(box.post(6));  // Of no size: always fits.
    CHECK(!box.post(7, static_cast<std::size_t>(-1)));
    box.collect(0.0, messages);
    CHECK(messages == std::vector<int>{1, 2, 4, 6});
    CHECK(box.post(8, 10));
    CHECK(!box.post(9, 1));
    box.collect(0.0, messages);
    CHECK(messages == std::vector<int>{8});
}

TEST_CASE("messages that can only be moved") {
    Mailbox<std::unique_ptr<int>> box(1);
    CHECK(box.post(std::make_unique<int>(7), 1));
    std::vector<std::unique_ptr<int>> messages;
    box.collect(0.0, messages);
    REQUIRE(messages.size() == 1);
    CHECK(*messages[0] == 7);
}

TEST_CASE("of many threads that post no message is lost, and each thread's stay in order") {
    constexpr int kThreads = 4, kEach = 2000;
    Mailbox<std::pair<int, int>> box(64);
    std::atomic<int> refused{0};
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t) {
        threads.emplace_back([&, t] {
            for (int i = 0; i < kEach; ++i) {
                while (!box.post({t, i}, 1)) {
                    ++refused;
                    std::this_thread::yield();
                }
            }
        });
    }
    std::vector<int> next(kThreads, 0);
    std::vector<std::pair<int, int>> messages;
    int count = 0;
    bool ordered = true, bounded = true;
    while (count < kThreads * kEach) {
        box.collect(10.0, messages);
        bounded = bounded && messages.size() <= 64;
        for (const auto& [thread, number] : messages) ordered = ordered && number == next[thread]++;
        count += static_cast<int>(messages.size());
    }
    for (std::thread& thread : threads) thread.join();
    CHECK(ordered);
    CHECK(bounded);
    CHECK(next == std::vector<int>(kThreads, kEach));
    box.collect(0.0, messages);
    CHECK(messages.empty());
}
