// The frame of every call of the C API: no exception leaves it, and failures leave their sentence.
#pragma once

#include <exception>
#include <new>
#include <string>

#include "muster/muster.h"
#include "muster/status.h"

namespace muster::c_api {

/// Keeps the sentence of a failure for this thread, and logs it. Gives its code back.
MusterStatus fail(MusterStatus code, const char* sentence) noexcept;
/// The code of a status, whose sentence is kept where it failed.
MusterStatus finish(const Status& status) noexcept;
/// Sends a message to the host's log.
void log(MusterLogLevel level, const char* message) noexcept;

/// Runs `work`, which gives a Status, and turns all that can happen into a code.
template <class Work>
MusterStatus call(Work&& work) noexcept {
    try {
        return finish(work());
    } catch (const std::bad_alloc&) {
        return fail(MUSTER_OUT_OF_MEMORY, "memory: found too little, expected more");
    } catch (const std::exception& failure) {
        return fail(MUSTER_INTERNAL, failure.what());
    } catch (...) {
        return fail(MUSTER_INTERNAL, "found an exception of unknown kind, expected none");
    }
}

/// The failure of an argument that must not be null.
inline Status nullArgument(const char* name) {
    return invalidArgument(std::string(name) + ": found null, expected a pointer");
}
/// Fails where one of the arguments, in the order of `names`, is null.
template <class... Pointers>
Status needPointers(std::initializer_list<const char*> names, Pointers... pointers) {
    const char* const* name = names.begin();
    const char* missing = nullptr;
    ((missing = missing == nullptr && pointers == nullptr ? *name : missing, ++name), ...);
    return missing == nullptr ? Status{} : nullArgument(missing);
}

}  // namespace muster::c_api
