#include "bindings/c/c_world/memory.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

#include "bindings/c/c_world/call.h"
#include "muster/muster.h"

namespace muster::c_api {
namespace {

/// Stands before every block.
struct BlockHead {
    void* start;  ///< What the allocator gave.
    void* context;
    void (*release)(void* context, void* memory);
};

void* standardAllocate(void*, std::size_t size, std::size_t) {
    return std::malloc(size);
}
void standardRelease(void*, void* memory) {
    std::free(memory);
}

constexpr MusterAllocator kStandard{nullptr, standardAllocate, standardRelease};
// Exchanged as a whole, before other threads use the library.
constinit MusterAllocator hostAllocator = kStandard;
constinit bool engineIsCovered = false;

}  // namespace

void* takeFromHost(std::size_t size, std::size_t alignment) noexcept {
    alignment = std::max(alignment, alignof(std::max_align_t));
    const std::size_t room = sizeof(BlockHead) + alignment;
    if (size > SIZE_MAX - room) return nullptr;
    const MusterAllocator allocator = hostAllocator;
    void* const start = allocator.allocate(allocator.context, size + room, alignof(std::max_align_t));
    if (start == nullptr) return nullptr;
    const auto first = reinterpret_cast<std::uintptr_t>(start) + sizeof(BlockHead);
    const std::uintptr_t block = (first + alignment - 1) / alignment * alignment;
    char* const place = static_cast<char*>(start) + (block - reinterpret_cast<std::uintptr_t>(start));
    new (reinterpret_cast<BlockHead*>(place) - 1) BlockHead{start, allocator.context, allocator.release};
    return place;
}

void releaseToHost(void* block) noexcept {
    if (block == nullptr) return;
    const BlockHead head = *(static_cast<BlockHead*>(block) - 1);
    head.release(head.context, head.start);
}

bool coverEngine() noexcept {
    return engineIsCovered = true;
}

}  // namespace muster::c_api

using namespace muster;

MusterStatus muster_set_allocator(const MusterAllocator* allocator) {
    return c_api::call([&]() -> Status {
        if (allocator == nullptr) {
            c_api::hostAllocator = c_api::kStandard;
            return {};
        }
        if (allocator->allocate == nullptr || allocator->release == nullptr)
            return invalidArgument("allocator: found null, expected two functions");
        c_api::hostAllocator = *allocator;
        return {};
    });
}

bool muster_allocator_covers_engine(void) {
    return c_api::engineIsCovered;
}
