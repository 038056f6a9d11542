// The host's allocator: every block remembers where it came from, so that the allocator can be exchanged.
#pragma once

#include <cstddef>

namespace muster::c_api {

/// `size` bytes at a multiple of `alignment`, a power of two; null where there are none.
void* takeFromHost(std::size_t size, std::size_t alignment) noexcept;
/// Gives a block back to the functions that it came from. Null is fine.
void releaseToHost(void* block) noexcept;
/// Notes that operators new and delete of the library use these functions too. Gives true back.
bool coverEngine() noexcept;

}  // namespace muster::c_api
