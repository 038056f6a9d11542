// A shared library whose whole memory is the host's.
#include <doctest.h>

#include <muster/muster.h>

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <set>

namespace {

/// A host's memory, which threads of the library use too.
class HostMemory {
public:
    MusterAllocator allocator() {
        return {this,
                [](void* context, std::size_t size, std::size_t) -> void* {
                    return static_cast<HostMemory*>(context)->take(size);
                },
                [](void* context, void* block) { static_cast<HostMemory*>(context)->release(block); }};
    }
    std::size_t taken() const { return taken_; }
    std::size_t blocks() const {
        const std::lock_guard lock(mutex_);
        return blocks_.size();
    }
    std::size_t strangers() const { return strangers_; }

private:
    void* take(std::size_t size) {
        void* const block = std::malloc(size);
        taken_ += size;
        const std::lock_guard lock(mutex_);
        blocks_.insert(block);
        return block;
    }
    void release(void* block) {
        {
            const std::lock_guard lock(mutex_);
            strangers_ += blocks_.erase(block) == 0 ? 1u : 0u;
        }
        std::free(block);
    }

    mutable std::mutex mutex_;
    std::set<void*> blocks_;
    std::atomic<std::size_t> taken_{0};
    std::size_t strangers_ = 0;
};

/// Builds a world, orders it about for a second and ends it; gives its hash.
std::uint64_t runWorld(std::int32_t threads) {
    MusterWorldDef def = muster_default_world_def();
    MusterGroupDef group = muster_default_group_def();
    group.count = 200;
    def.groups = &group;
    def.groupCount = 1;
    MusterWorldId world{};
    REQUIRE(muster_world_create(&def, threads, &world) == MUSTER_OK);
    MusterCommand command = muster_default_command(MUSTER_COMMAND_GIVE_ORDER);
    command.body.giveOrder.group = 1;
    command.body.giveOrder.order.target = {6.0, 2.0};
    CHECK(muster_world_submit(world, &command) == MUSTER_OK);
    for (int step = 0; step < 60; ++step) CHECK(muster_world_step(world) == MUSTER_OK);
    std::uint64_t hash = 0;
    CHECK(muster_world_hash(world, &hash) == MUSTER_OK);
    CHECK(muster_world_destroy(world) == MUSTER_OK);
    return hash;
}

}  // namespace

TEST_CASE("the engine's memory comes from the host and goes back to it, on every thread") {
    REQUIRE(muster_allocator_covers_engine());
    const std::uint64_t before = runWorld(2);  // Also makes what stays for the life of the process.
    HostMemory memory;
    const MusterAllocator allocator = memory.allocator();
    REQUIRE(muster_set_allocator(&allocator) == MUSTER_OK);
    CHECK(runWorld(1) == before);
    CHECK(runWorld(2) == before);
    REQUIRE(muster_set_allocator(nullptr) == MUSTER_OK);
    CHECK(memory.taken() > 1000000);
    CHECK(memory.blocks() == 0);
    CHECK(memory.strangers() == 0);
}

TEST_CASE("memory that the host has not is a code, not an end") {
    const MusterAllocator empty{nullptr, [](void*, std::size_t, std::size_t) -> void* { return nullptr; },
                                [](void*, void*) {}};
    const MusterWorldDef def = muster_default_world_def();
    MusterWorldId world{};
    REQUIRE(muster_set_allocator(&empty) == MUSTER_OK);
    const MusterStatus status = muster_world_create(&def, 1, &world);
    REQUIRE(muster_set_allocator(nullptr) == MUSTER_OK);
    CHECK(status == MUSTER_OUT_OF_MEMORY);
    CHECK(world.index1 == 0);
}
