// The one place where constness is cast away.
#pragma once

namespace muster {

/// The same object, to be changed. For archives, whose visit() serves reading and writing alike, and for
/// references to callables of any constness; whoever calls it must not change an object that is const.
template <class T>
T& asMutable(const T& object) {
    return const_cast<T&>(object);
}

}  // namespace muster
