// Copies of spans.
#pragma once

#include <span>
#include <vector>

namespace muster {

/// Copies a span into a vector, which keeps its memory.
template <class T>
void copySpan(std::span<const T> from, std::vector<T>& to) {
    to.assign(from.begin(), from.end());
}

}  // namespace muster
