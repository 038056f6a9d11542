// Alternatives of variants by an index that is known at run time.
#pragma once

#include <cstddef>
#include <variant>

namespace muster {

/// Makes the alternative of that index, with its defaults; nothing where there is none.
template <class Variant, std::size_t Index = 0>
void emplaceIndex(Variant& variant, std::size_t index) {
    if constexpr (Index < std::variant_size_v<Variant>) {
        if (index == Index)
            variant.template emplace<Index>();
        else
            emplaceIndex<Variant, Index + 1>(variant, index);
    }
}

}  // namespace muster
