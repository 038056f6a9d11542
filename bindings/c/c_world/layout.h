// Arrays of the engine seen as arrays of the C API: types of the same layout, so that nothing is copied.
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <string>

#include "bindings/c/c_world/call.h"
#include "bindings/c/c_world/memory.h"
#include "muster/muster.h"
#include "muster/world.h"

namespace muster::c_api {

/// True for pairs of types whose members stand at the same places.
template <class A, class B>
inline constexpr bool kSame = sizeof(A) == sizeof(B) ? alignof(A) == alignof(B) : false;

static_assert(offsetof(MusterVec2, y) == offsetof(Vec2, y));
static_assert(offsetof(MusterBox, max) == offsetof(Box, max));
static_assert(offsetof(MusterPose, rotation) == offsetof(Pose, rotation));
static_assert(offsetof(MusterRotation, s) == offsetof(Rotation, s));
static_assert(offsetof(MusterMeshPoint, weight) == offsetof(MeshPoint, weight));

/// The data of a span, seen as another type of the same layout.
template <class A, class B>
const A* same(std::span<const B> span) {
    static_assert(kSame<A, B>);
    return reinterpret_cast<const A*>(span.data());
}
/// Gives a span of the same layout as a pointer and a count.
template <class A, class B>
Status giveSpan(std::span<const B> span, const A** out, const char* name, std::int32_t* outCount) {
    if (const Status given = needPointers({name, "outCount"}, out, outCount); !given.ok()) return given;
    *out = same<A>(span);
    *outCount = static_cast<std::int32_t>(span.size());
    return {};
}
/// A copy in an arena.
template <class A, class B>
const A* copyOf(const std::vector<B>& values, Arena& arena) {
    static_assert(kSame<A, B>);
    A* const copy = arena.make<A>(values.size());
    if (!values.empty()) std::memcpy(copy, values.data(), values.size() * sizeof(A));
    return copy;
}

}  // namespace muster::c_api
