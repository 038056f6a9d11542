// Replaces all forms of operator new by counting ones. Only linked into the program.
#include <cstdlib>
#include <new>

#include "scale/meter.h"

namespace {

void* counted(std::size_t size) noexcept {
    muster::scale::countAllocation();
    return std::malloc(size > 0 ? size : 1);
}

void* counted(std::size_t size, std::align_val_t alignment) noexcept {
    muster::scale::countAllocation();
    const auto edge = static_cast<std::size_t>(alignment);
    return std::aligned_alloc(edge, (size + edge - 1) / edge * edge);
}

void* orThrow(void* memory) {
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    return orThrow(counted(size));
}
void* operator new[](std::size_t size) {
    return orThrow(counted(size));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return counted(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return counted(size);
}
void* operator new(std::size_t size, std::align_val_t edge) {
    return orThrow(counted(size, edge));
}
void* operator new[](std::size_t size, std::align_val_t edge) {
    return orThrow(counted(size, edge));
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
