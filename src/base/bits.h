// The bits of a value as another type.
#pragma once

#include <cstring>
#include <type_traits>

namespace muster {

/// As std::bit_cast, which emscripten's library does not have yet.
template <class To, class From>
To bitCast(const From& from) {
    static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> &&
                  std::is_trivially_copyable_v<From>);
    To to;
    std::memcpy(&to, &from, sizeof(To));
    return to;
}

}  // namespace muster
