// Versions of the structs that callers hand over: a number per kind, so that none is taken for another.
#pragma once

#include <cstdint>
#include <string>

#include "bindings/c/c_world/call.h"
#include "muster/muster.h"

namespace muster::c_api {

/// What `structVersion` holds in a struct of type T, and who sets it.
template <class T>
struct StructVersion;

constexpr std::uint32_t structVersion(std::uint32_t kind, std::uint32_t version) {
    return kind << 16 | version;
}

#define MUSTER_STRUCT_VERSION(type, kind, version, maker)                     \
    template <>                                                               \
    struct StructVersion<type> {                                              \
        static constexpr std::uint32_t kValue = structVersion(kind, version); \
        static constexpr const char* kMaker = maker;                          \
    }

// The numbers themselves are generated, from schema/definitions.txt and schema/api.

/// Fails where a struct that is to be filled is null or of another version.
template <class T>
Status needStruct(const T* out, const char* name) {
    if (out == nullptr) return nullArgument(name);
    if (out->structVersion == StructVersion<T>::kValue) return {};
    return invalidArgument(std::string(name) + ": found structVersion " + std::to_string(out->structVersion) +
                           ", expected " + std::to_string(StructVersion<T>::kValue) + " as " +
                           StructVersion<T>::kMaker + "() sets it");
}

}  // namespace muster::c_api
