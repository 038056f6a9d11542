// Relaxed atomic stores to plain variables.
#pragma once

#include <atomic>

namespace muster {

/// Stores a value that several threads may store at once, with no order among them. Nobody may read the
/// variable meanwhile.
template <class T>
void storeRelaxed(T& variable, T value) {
#ifdef __cpp_lib_atomic_ref
    std::atomic_ref<T>(variable).store(value, std::memory_order_relaxed);
#else
    // The standard library of the WebAssembly build has no std::atomic_ref.
    __atomic_store_n(&variable, value, __ATOMIC_RELAXED);
#endif
}

}  // namespace muster
