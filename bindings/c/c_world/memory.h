// Memory that the C API takes from the host: blocks, and arenas for what it lends until the next call.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <vector>

#include "muster/muster.h"

namespace muster::c_api {

/// Takes `size` bytes from the host's allocator, or from the standard one. Throws std::bad_alloc where there
/// are none.
void* takeBlock(std::size_t size);
/// Gives back a block to where it came from. Null is fine.
void releaseBlock(void* block) noexcept;

/// Bytes for the caller, which muster_free_buffer() releases; a zero byte follows them.
MusterBuffer makeBuffer(const void* bytes, std::size_t size);

/// Memory for arrays of plain structs, all released at once; what was taken is used again.
class Arena {
public:
    Arena() = default;
    Arena(const Arena&) = delete;
    Arena& operator=(const Arena&) = delete;
    ~Arena();

    /// An array of `count` zeroed elements; null for none.
    template <class T>
    T* make(std::size_t count) {
        static_assert(std::is_trivially_destructible_v<T>);
        return count == 0 ? nullptr : static_cast<T*>(take(count * sizeof(T)));
    }
    /// A copy of a text with a zero byte at its end.
    const char* text(std::string_view text);
    /// Everything that was made becomes invalid.
    void reset();

private:
    struct Block {
        std::byte* bytes;
        std::size_t size;
    };
    void* take(std::size_t size);

    std::vector<Block> blocks_;
    std::size_t current_ = 0;  // Block in use.
    std::size_t used_ = 0;     // Bytes of it.
};

/// `size` bytes at a multiple of `alignment`, a power of two; null where there are none.
void* takeFromHost(std::size_t size, std::size_t alignment) noexcept;
/// Gives a block back to the functions that it came from. Null is fine.
void releaseToHost(void* block) noexcept;
/// Notes that operators new and delete of the library use these functions too. Gives true back.
bool coverEngine() noexcept;

}  // namespace muster::c_api
