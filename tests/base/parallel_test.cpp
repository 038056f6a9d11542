// Pools at their edges: no items, one item, more threads than items, many rounds, several pools.
#include <doctest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <numeric>
#include <thread>
#include <vector>

#include "base/parallel.h"

using namespace muster;

TEST_CASE("a pool runs every item once, with any number of threads") {
    for (const int threads : {1, 2, 4, 8}) {
        ThreadPool pool(threads);
        for (int round = 0; round < 50; ++round) {
            std::vector<std::atomic<int>> hits(97);
            pool.run(97, [&](std::int32_t item, std::int32_t worker) {
                CHECK(worker < threads);
                ++hits[item];
            });
            for (const auto& hit : hits) REQUIRE(hit.load() == 1);
        }
    }
}

TEST_CASE("a pool without items calls nobody and returns") {
    for (const int threads : {1, 3}) {
        ThreadPool pool(threads);
        std::atomic<int> calls{0};
        pool.run(0, [&](std::int32_t, std::int32_t) { ++calls; });
        pool.run(-4, [&](std::int32_t, std::int32_t) { ++calls; });
        CHECK(calls == 0);
        pool.run(2, [&](std::int32_t, std::int32_t) { ++calls; });  // And it still works.
        CHECK(calls == 2);
    }
}

TEST_CASE("a single item runs in the calling thread") {
    ThreadPool pool(4);
    std::thread::id where;
    std::int32_t by = -1;
    pool.run(1, [&](std::int32_t, std::int32_t worker) {
        where = std::this_thread::get_id();
        by = worker;
    });
    CHECK(where == std::this_thread::get_id());
    CHECK(by == 0);
}

TEST_CASE("the number of threads is the requested one, at least one") {
    CHECK(ThreadPool(1).threads() == 1);
    CHECK(ThreadPool(3).threads() == 3);
    CHECK(ThreadPool(0).threads() >= 1);
    CHECK(ThreadPool(-7).threads() >= 1);
}

TEST_CASE("a pool that never ran closes, again and again") {
    for (int i = 0; i < 50; ++i) {
        const ThreadPool pool(4);
        CHECK(pool.threads() == 4);
    }
}

TEST_CASE("private memory by worker needs no lock") {
    ThreadPool pool(4);
    std::vector<std::vector<std::int32_t>> took(4);
    for (int round = 0; round < 100; ++round) {
        for (auto& items : took) items.clear();
        pool.run(301, [&](std::int32_t item, std::int32_t worker) { took[worker].push_back(item); });
        std::vector<int> hits(301, 0);
        for (const auto& items : took) {
            for (const std::int32_t item : items) ++hits[item];
        }
        for (const int hit : hits) REQUIRE(hit == 1);
    }
}

TEST_CASE("what the items wrote is seen by the caller when run returns") {
    ThreadPool pool(3);
    std::vector<std::int64_t> results(500, 0);
    for (std::int64_t round = 1; round <= 300; ++round) {
        pool.run(500, [&](std::int32_t item, std::int32_t) { results[item] += item * round; });
    }
    const std::int64_t rounds = 300 * 301 / 2;
    for (std::int64_t i = 0; i < 500; ++i) REQUIRE(results[i] == i * rounds);
}

TEST_CASE("rounds of very different size follow each other") {
    ThreadPool pool(4);
    std::int64_t expected = 0;
    std::atomic<std::int64_t> sum{0};
    for (std::int32_t count : {7, 1, 0, 2000, 3, 1, 1, 50, 0, 4}) {
        pool.run(count, [&](std::int32_t item, std::int32_t) { sum += item + 1; });
        expected += static_cast<std::int64_t>(count) * (count + 1) / 2;
        REQUIRE(sum == expected);
    }
}

TEST_CASE("an item may use a pool of its own") {
    ThreadPool outer(2);
    std::atomic<int> hits{0};
    outer.run(4, [&](std::int32_t, std::int32_t) {
        ThreadPool inner(2);
        inner.run(10, [&](std::int32_t, std::int32_t) { ++hits; });
    });
    CHECK(hits == 40);
}

TEST_CASE("pools in several threads do not disturb each other") {
    std::vector<std::int64_t> sums(3, 0);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < 3; ++t) {
        threads.emplace_back([&sums, t] {
            ThreadPool pool(2);
            std::vector<std::int64_t> squares(100);
            for (int round = 0; round < 50; ++round) {
                pool.run(100, [&](std::int32_t i, std::int32_t) { squares[i] = std::int64_t{i} * i; });
            }
            sums[t] = std::accumulate(squares.begin(), squares.end(), std::int64_t{0});
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const std::int64_t sum : sums) CHECK(sum == 99 * 100 * 199 / 6);
}

TEST_CASE("any callable can be handed over, and none is copied") {
    struct Counter {
        std::int32_t calls = 0;
        void operator()(std::int32_t, std::int32_t) { ++calls; }
    };
    ThreadPool pool(1);
    Counter counter;
    pool.run(5, counter);
    CHECK(counter.calls == 5);
    pool.run(4, std::ref(counter));
    CHECK(counter.calls == 9);
    std::int32_t sum = 0;
    const std::function<void(std::int32_t, std::int32_t)> add = [&](std::int32_t item, std::int32_t) {
        sum += item;
    };
    pool.run(4, add);
    CHECK(sum == 6);
    const TaskRef again = add;
    pool.run(3, again);
    CHECK(sum == 9);
}

TEST_CASE("workers that fell asleep wake for the next round, and rounds that follow at once are whole") {
    for (const int threads : {2, 3, 8}) {
        ThreadPool pool(threads);
        std::atomic<std::int64_t> sum{0};
        std::int64_t expected = 0;
        for (int round = 0; round < 2000; ++round) {
            // Now and then longer than anybody spins.
            if (round % 400 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(3));
            const std::int32_t count = 2 + round % 5;
            pool.run(count, [&](std::int32_t item, std::int32_t) { sum += round * 10 + item; });
            expected += static_cast<std::int64_t>(count) * round * 10 + count * (count - 1) / 2;
            REQUIRE(sum == expected);
        }
    }
}

TEST_CASE("a caller that waits longer than it spins is woken by the last worker") {
    ThreadPool pool(2);
    for (int round = 0; round < 5; ++round) {
        std::atomic<std::int32_t> slow{0};
        const std::thread::id caller = std::this_thread::get_id();
        // Whoever is not the caller takes long; the caller waits until that one has begun.
        pool.run(2, [&](std::int32_t, std::int32_t) {
            if (std::this_thread::get_id() == caller) {
                while (slow == 0) std::this_thread::yield();
            } else {
                slow = 1;
                std::this_thread::sleep_for(std::chrono::milliseconds(4));
                slow = 2;
            }
        });
        CHECK(slow == 2);
    }
}

TEST_CASE("work goes to the task runner, except single items") {
    struct Log {
        std::vector<std::int32_t> counts;
    } log;
    const TaskRunner runner{
        4, &log,
        [](void* context, std::int32_t count, void (*task)(void*, std::int32_t, std::int32_t), void* of) {
            static_cast<Log*>(context)->counts.push_back(count);
            for (std::int32_t i = count; i-- > 0;) task(of, i, i % 4);
        }};
    ThreadPool pool(runner);
    CHECK(pool.threads() == 4);
    std::vector<std::int32_t> order;
    const auto note = [&](std::int32_t item, std::int32_t worker) { order.push_back(item * 10 + worker); };
    pool.run(5, note);
    CHECK(order == std::vector<std::int32_t>{40, 33, 22, 11, 0});
    order.clear();
    pool.run(1, note);
    pool.run(0, note);
    CHECK(order == std::vector<std::int32_t>{0});
    CHECK(log.counts == std::vector<std::int32_t>{5});
}

TEST_CASE("without a function or threads of the runner the caller does all work") {
    for (const TaskRunner& runner :
         {TaskRunner{},
          TaskRunner{0, nullptr,
                     [](void*, std::int32_t, void (*)(void*, std::int32_t, std::int32_t), void*) {}}}) {
        ThreadPool pool(runner);
        CHECK(pool.threads() == 1);
        std::int32_t calls = 0;
        pool.run(3, [&](std::int32_t, std::int32_t worker) { calls += 1 + worker; });
        CHECK(calls == 3);
    }
}

namespace {

// Background work: fills its numbers in order, with a delay if set.
struct Launched {
    std::vector<std::int64_t> numbers = std::vector<std::int64_t>(200, 0);
    std::int64_t round = 0;
    bool slow = false;
    std::thread::id where;

    static void work(void* context) {
        auto& self = *static_cast<Launched*>(context);
        self.where = std::this_thread::get_id();
        if (self.slow) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        for (std::int64_t& n : self.numbers) n = ++self.round;
    }
};

}  // namespace

TEST_CASE("background work is done when wait returns, with rounds meanwhile") {
    for (const int threads : {1, 2, 3, 8}) {
        ThreadPool pool(threads);
        pool.wait();  // For nothing.
        Launched launched;
        std::atomic<std::int64_t> sum{0};
        for (int k = 1; k <= 300; ++k) {
            launched.slow = k % 100 == 0;
            // Workers fall asleep.
            if (k % 50 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            pool.launch(&Launched::work, &launched);
            for (int r = 0; r < k % 3; ++r)
                pool.run(5, [&](std::int32_t item, std::int32_t) { sum += item; });
            pool.wait();
            REQUIRE(launched.round == 200 * k);
            REQUIRE(launched.numbers.back() == launched.round);
        }
        CHECK(sum == 300 * 10);
        if (threads == 1) CHECK(launched.where == std::this_thread::get_id());
    }
}

TEST_CASE("launching waits for earlier background work, and so does closing the pool") {
    Launched launched{.slow = true};
    {
        ThreadPool pool(2);
        for (int k = 0; k < 5; ++k) pool.launch(&Launched::work, &launched);
    }
    CHECK(launched.round == 5 * 200);
}

TEST_CASE("a task runner gets background work if it can launch, else the caller does it") {
    struct Log {
        int launches = 0;
        int waits = 0;
        std::thread thread;
    } log;
    TaskRunner runner{
        2, &log, [](void*, std::int32_t count, void (*task)(void*, std::int32_t, std::int32_t), void* of) {
            for (std::int32_t i = 0; i < count; ++i) task(of, i, 0);
        }};
    Launched launched;
    {
        ThreadPool pool(runner);
        pool.launch(&Launched::work, &launched);
        CHECK(launched.where == std::this_thread::get_id());
        pool.wait();
    }
    runner.launch = [](void* context, void (*task)(void*), void* of) {
        auto& l = *static_cast<Log*>(context);
        ++l.launches;
        l.thread = std::thread(task, of);
    };
    runner.wait = [](void* context) {
        auto& l = *static_cast<Log*>(context);
        ++l.waits;
        l.thread.join();
    };
    {
        ThreadPool pool(runner);
        for (int k = 0; k < 3; ++k) pool.launch(&Launched::work, &launched);
    }
    CHECK(log.launches == 3);
    CHECK(log.waits == 3);
    CHECK(launched.round == 4 * 200);
    CHECK(launched.where != std::this_thread::get_id());
}

TEST_CASE("chunks cover every item once, with a pool and without") {
    ThreadPool pool(3);
    for (ThreadPool* with : {static_cast<ThreadPool*>(nullptr), &pool})
        for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{7}, std::size_t{8},
                                        std::size_t{9}, std::size_t{1000}}) {
            std::vector<std::atomic<int>> hits(count);
            forChunks(with, count, 8, [&](std::size_t i) { ++hits[i]; });
            for (const std::atomic<int>& hit : hits) REQUIRE(hit == 1);
        }
    // One chunk runs in the caller.
    std::thread::id where;
    forChunks(&pool, 8, 8, [&](std::size_t) { where = std::this_thread::get_id(); });
    CHECK(where == std::this_thread::get_id());
}
