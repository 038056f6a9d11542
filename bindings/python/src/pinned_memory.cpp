#include "pinned_memory.h"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <new>
#include <vector>

namespace muster::python {
namespace {

/// Memory that does not come through the operators below.
template <class T>
struct PlainMemory {
    using value_type = T;
    PlainMemory() = default;
    template <class Other>
    PlainMemory(const PlainMemory<Other>&) {}
    T* allocate(std::size_t count) {
        if (void* const block = std::malloc(count * sizeof(T))) return static_cast<T*>(block);
        throw std::bad_alloc();
    }
    void deallocate(T* block, std::size_t) { std::free(block); }
    friend bool operator==(const PlainMemory&, const PlainMemory&) { return true; }
};

struct Pin {
    std::uintptr_t place = 0;
    std::size_t count = 0;
    void* block = nullptr;  // Where the engine has given it back.
};

using Pins = std::vector<Pin, PlainMemory<Pin>>;

std::atomic<std::size_t> pinnedPlaces{0};

struct PinTable {
    std::mutex mutex;
    Pins pins;  // In ascending order of places.
};

PinTable& table() {
    static PinTable* const made = new (std::malloc(sizeof(PinTable)))
        PinTable;  // Lives as long as the process.
    return *made;
}

Pins::iterator firstAt(Pins& pins, std::uintptr_t place) {
    return std::lower_bound(pins.begin(), pins.end(), place,
                            [](const Pin& pin, std::uintptr_t p) { return pin.place < p; });
}

/// The pins within a block.
std::pair<Pins::iterator, Pins::iterator> pinsWithin(Pins& pins, void* block) {
    const auto begin = reinterpret_cast<std::uintptr_t>(block);
    return {firstAt(pins, begin), firstAt(pins, begin + malloc_usable_size(block))};
}

/// What the operators delete do.
void giveBack(void* block) noexcept {
    if (block == nullptr) return;
    if (pinnedPlaces.load(std::memory_order_acquire) > 0) {
        PinTable& known = table();
        const std::lock_guard lock(known.mutex);
        const auto [first, last] = pinsWithin(known.pins, block);
        if (first != last) {
            for (auto pin = first; pin != last; ++pin) pin->block = block;
            return;
        }
    }
    std::free(block);
}

}  // namespace

void pin(const void* place) {
    PinTable& known = table();
    const std::lock_guard lock(known.mutex);
    const auto number = reinterpret_cast<std::uintptr_t>(place);
    auto at = firstAt(known.pins, number);
    if (at == known.pins.end() || at->place != number) at = known.pins.insert(at, Pin{number, 0, nullptr});
    ++at->count;
    pinnedPlaces.store(known.pins.size(), std::memory_order_release);
}

void unpin(const void* place) {
    PinTable& known = table();
    const std::lock_guard lock(known.mutex);
    const auto at = firstAt(known.pins, reinterpret_cast<std::uintptr_t>(place));
    if (--at->count > 0) return;
    void* const block = at->block;
    known.pins.erase(at);
    pinnedPlaces.store(known.pins.size(), std::memory_order_release);
    if (block == nullptr) return;
    const auto [first, last] = pinsWithin(known.pins, block);
    if (first == last) std::free(block);
}

std::size_t keptBlocks() {
    PinTable& known = table();
    const std::lock_guard lock(known.mutex);
    std::vector<void*, PlainMemory<void*>> blocks;
    for (const Pin& pin : known.pins)
        if (pin.block != nullptr) blocks.push_back(pin.block);
    std::sort(blocks.begin(), blocks.end());
    return static_cast<std::size_t>(std::unique(blocks.begin(), blocks.end()) - blocks.begin());
}

}  // namespace muster::python

// The operators of this module and of nobody else: it shows no symbol but its entry (module.map).
void* operator new(std::size_t size) {
    if (void* const block = std::malloc(size == 0 ? 1 : size)) return block;
    throw std::bad_alloc();
}
void* operator new[](std::size_t size) {
    return operator new(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    const auto step = static_cast<std::size_t>(alignment);
    if (void* const block = std::aligned_alloc(step, (size / step + 1) * step)) return block;
    throw std::bad_alloc();
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return operator new(size, alignment);
}
void operator delete(void* block) noexcept {
    muster::python::giveBack(block);
}
void operator delete[](void* block) noexcept {
    muster::python::giveBack(block);
}
void operator delete(void* block, std::size_t) noexcept {
    muster::python::giveBack(block);
}
void operator delete[](void* block, std::size_t) noexcept {
    muster::python::giveBack(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
    muster::python::giveBack(block);
}
void operator delete[](void* block, std::align_val_t) noexcept {
    muster::python::giveBack(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
    muster::python::giveBack(block);
}
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept {
    muster::python::giveBack(block);
}
