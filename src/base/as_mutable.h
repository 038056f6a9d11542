// The one place where constness is cast away.
#pragma once

namespace muster {

/// Gives an object for changes. Archives use it, whose visit() serves reading and writing alike, and
/// references to callables of any constness. Its users must not change an object that is const.
template <class T>
T& asMutable(const T& object) {
    return const_cast<T&>(object);
}

}  // namespace muster
