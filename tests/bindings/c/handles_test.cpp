// Handles and memory of the C API, piece by piece.
#include <doctest.h>

#include <cstdint>
#include <set>
#include <thread>

#include "bindings/c/both_worlds.h"
#include "bindings/c/c_world/handle_table.h"
#include "bindings/c/c_world/memory.h"

using namespace muster;
using namespace muster::c_api;

namespace {

/// Counts how many of it live.
struct Counted {
    explicit Counted(int& alive) : alive_(alive) { ++alive_; }
    ~Counted() { --alive_; }
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;

    int& alive_;
};

using Table = HandleTable<MusterWorldId, Counted>;

}  // namespace

TEST_SUITE("handles") {
    TEST_CASE("a slot that is used again has another generation") {
        int alive = 0;
        Table table("thing");
        const MusterWorldId first = table.add(std::make_unique<Counted>(alive));
        const MusterWorldId second = table.add(std::make_unique<Counted>(alive));
        CHECK(first.index1 == 1);
        CHECK(second.index1 == 2);
        CHECK(alive == 2);
        CHECK(table.destroy(first).ok());
        CHECK(alive == 1);
        const MusterWorldId third = table.add(std::make_unique<Counted>(alive));
        CHECK(third.index1 == first.index1);
        CHECK(third.generation == first.generation + 1);
        CHECK(!table.find(first).ok());
        CHECK(table.find(third).ok());
        CHECK(table.find(second).ok());
    }

    TEST_CASE("handles of no slot, of a slot to come and of another generation name nothing") {
        int alive = 0;
        Table table("thing");
        CHECK(table.find({0, 0}).status().message() == "thing: found no handle, expected one");
        CHECK(table.find({1, 1}).status().code() == StatusCode::NotFound);
        const MusterWorldId id = table.add(std::make_unique<Counted>(alive));
        CHECK(!table.find({id.index1, id.generation + 1}).ok());
        CHECK(!table.find({id.index1, 0}).ok());
        CHECK(!table.find({UINT32_MAX, UINT32_MAX}).ok());
        CHECK(table.destroy(id).ok());
        CHECK(table.destroy(id).code() == StatusCode::NotFound);
        CHECK(alive == 0);
    }

    TEST_CASE("a thing that is taken out lives on") {
        int alive = 0;
        Table table("thing");
        const MusterWorldId id = table.add(std::make_unique<Counted>(alive));
        {
            const auto taken = table.take(id);
            REQUIRE(taken.ok());
            CHECK(alive == 1);
            CHECK(!table.find(id).ok());
        }
        CHECK(alive == 0);
    }

    TEST_CASE("threads make and end worlds at the same time, and each world is its own") {
        constexpr int kThreads = 4;
        std::uint64_t hashes[kThreads] = {};
        std::vector<std::thread> threads;
        for (int t = 0; t < kThreads; ++t)
            threads.emplace_back([&hashes, t] {
                for (int round = 0; round < 3; ++round) {
                    MusterWorldDef def = muster_default_world_def();
                    MusterGroupDef group = muster_default_group_def();
                    group.count = 10 + t % 2;
                    def.groups = &group;
                    def.groupCount = 1;
                    MusterWorldId world{};
                    if (muster_world_create(&def, 1, &world) != MUSTER_OK) return;
                    for (int step = 0; step < 5; ++step) (void)muster_world_step(world);
                    (void)muster_world_hash(world, &hashes[t]);
                    if (muster_world_destroy(world) != MUSTER_OK) hashes[t] = 0;
                }
            });
        for (std::thread& thread : threads) thread.join();
        CHECK(hashes[0] != 0);
        CHECK(hashes[0] == hashes[2]);
        CHECK(hashes[1] == hashes[3]);
        CHECK(hashes[0] != hashes[1]);
    }
}

TEST_SUITE("memory of read-outs") {
    TEST_CASE("an arena gives zeroed memory, apart and aligned, and the same again after a reset") {
        Arena arena;
        std::set<const void*> first;
        for (int k = 0; k < 100; ++k) {
            double* const numbers = arena.make<double>(static_cast<std::size_t>(k + 1));
            CHECK(reinterpret_cast<std::uintptr_t>(numbers) % alignof(std::max_align_t) == 0);
            for (int i = 0; i <= k; ++i) {
                CHECK(numbers[i] == 0.0);
                numbers[i] = 1.0 + k;
            }
            CHECK(first.insert(numbers).second);
        }
        arena.reset();
        for (int k = 0; k < 100; ++k) {
            const double* const numbers = arena.make<double>(static_cast<std::size_t>(k + 1));
            CHECK(numbers[k] == 0.0);
            CHECK(first.contains(numbers));
        }
    }

    TEST_CASE("an arena takes pieces larger than its blocks, and none for nothing") {
        Arena arena;
        CHECK(arena.make<int>(0) == nullptr);
        auto* const small = arena.make<std::uint8_t>(3);
        auto* const large = arena.make<std::uint8_t>(1 << 20);
        small[2] = 7;
        large[(1 << 20) - 1] = 9;
        CHECK(small[2] == 7);
        CHECK(std::string(arena.text("some text")) == "some text");
        CHECK(std::string(arena.text("")).empty());
    }

    TEST_CASE("a buffer ends with a zero byte") {
        MusterBuffer buffer = makeBuffer("abc", 3);
        CHECK(buffer.size == 3);
        CHECK(std::string(reinterpret_cast<char*>(buffer.data)) == "abc");
        muster_free_buffer(&buffer);
        CHECK(buffer.size == 0);
        buffer = makeBuffer(nullptr, 0);
        REQUIRE(buffer.data != nullptr);
        CHECK(buffer.data[0] == 0);
        muster_free_buffer(&buffer);
        muster_free_buffer(&buffer);
        CHECK(buffer.data == nullptr);
    }
}
