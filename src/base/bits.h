// The bits of a value as another type.
#pragma once

#include <cstring>
#include <type_traits>

namespace muster {

/// std::bit_cast, which the standard library of Emscripten does not have yet.
template <class To, class From>
To bitCast(const From& from) {
    static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> &&
                  std::is_trivially_copyable_v<From>);
    To to;
    std::memcpy(&to, &from, sizeof(To));
    return to;
}

}  // namespace muster
