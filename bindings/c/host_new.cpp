// Operators new and delete that take memory from the host. Only in a shared library that holds its own copy
// of the C++ library (MUSTER_HOST_ALLOCATOR): there nobody else's memory meets them.
#include <cstddef>
#include <new>

#include "bindings/c/c_world/memory.h"

using muster::c_api::releaseToHost;
using muster::c_api::takeFromHost;

namespace {

[[maybe_unused]] const bool kCovers = muster::c_api::coverEngine();

void* takeOrThrow(std::size_t size, std::size_t alignment) {
    void* const block = takeFromHost(size, alignment);
    if (block == nullptr) throw std::bad_alloc();
    return block;
}

constexpr std::size_t kUsual = alignof(std::max_align_t);

}  // namespace

void* operator new(std::size_t size) {
    return takeOrThrow(size, kUsual);
}
void* operator new[](std::size_t size) {
    return takeOrThrow(size, kUsual);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return takeOrThrow(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return takeOrThrow(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return takeFromHost(size, kUsual);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return takeFromHost(size, kUsual);
}
void operator delete(void* block) noexcept {
    releaseToHost(block);
}
void operator delete[](void* block) noexcept {
    releaseToHost(block);
}
void operator delete(void* block, std::size_t) noexcept {
    releaseToHost(block);
}
void operator delete[](void* block, std::size_t) noexcept {
    releaseToHost(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
    releaseToHost(block);
}
void operator delete[](void* block, std::align_val_t) noexcept {
    releaseToHost(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
    releaseToHost(block);
}
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept {
    releaseToHost(block);
}
