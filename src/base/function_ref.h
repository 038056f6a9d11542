// A reference to a callable: a parameter that takes any lambda and allocates nothing.
#pragma once

#include <type_traits>
#include <utility>

#include "base/as_mutable.h"

namespace muster {

template <class Signature>
class FunctionRef;

/// Refers to a callable that is called as Result(Arguments...); nothing is copied.
template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
public:
    /// Refers to `callable`, which has to outlive the reference.
    template <class Callable>
    requires(!std::is_same_v<std::remove_cvref_t<Callable>, FunctionRef> &&
             std::is_invocable_r_v<Result, Callable&, Arguments...>)
        FunctionRef(Callable&& callable)  // NOLINT: implicit, so that lambdas can be passed.
        : object_(&asMutable(callable)), call_([](void* object, Arguments... arguments) -> Result {
              return (*static_cast<std::remove_reference_t<Callable>*>(object))(
                  std::forward<Arguments>(arguments)...);
          }) {}

    /// Calls the callable.
    Result operator()(Arguments... arguments) const {
        return call_(object_, std::forward<Arguments>(arguments)...);
    }

private:
    void* object_;
    Result (*call_)(void* object, Arguments... arguments);
};

}  // namespace muster
