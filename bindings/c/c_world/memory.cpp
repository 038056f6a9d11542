#include "bindings/c/c_world/memory.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>

namespace muster::c_api {
namespace {

constexpr std::size_t kLeastArenaBlock = 4096;

}  // namespace

void* takeBlock(std::size_t size) {
    void* const block = takeFromHost(size, alignof(std::max_align_t));
    if (block == nullptr) throw std::bad_alloc();
    return block;
}

void releaseBlock(void* block) noexcept {
    releaseToHost(block);
}

MusterBuffer makeBuffer(const void* bytes, std::size_t size) {
    auto* const data = static_cast<std::uint8_t*>(takeBlock(size + 1));
    if (size > 0) std::memcpy(data, bytes, size);
    data[size] = 0;
    return {data, size};
}

Arena::~Arena() {
    for (const Block& block : blocks_) releaseBlock(block.bytes);
}

void* Arena::take(std::size_t size) {
    constexpr std::size_t kAlignment = alignof(std::max_align_t);
    size = (size + kAlignment - 1) / kAlignment * kAlignment;
    while (current_ < blocks_.size() && blocks_[current_].size - used_ < size) {
        ++current_;
        used_ = 0;
    }
    if (current_ == blocks_.size()) {
        const std::size_t whole = std::max(size, kLeastArenaBlock);
        blocks_.reserve(blocks_.size() + 1);
        blocks_.push_back({static_cast<std::byte*>(takeBlock(whole)), whole});
        used_ = 0;
    }
    std::byte* const made = blocks_[current_].bytes + used_;
    used_ += size;
    std::memset(made, 0, size);
    return made;
}

const char* Arena::text(std::string_view text) {
    char* const copy = make<char>(text.size() + 1);
    if (!text.empty()) std::memcpy(copy, text.data(), text.size());
    return copy;
}

void Arena::reset() {
    current_ = 0;
    used_ = 0;
}

}  // namespace muster::c_api

using muster::c_api::releaseBlock;

void muster_free_buffer(MusterBuffer* buffer) {
    if (buffer == nullptr) return;
    releaseBlock(buffer->data);
    *buffer = {nullptr, 0};
}
