// Binary glTF 2.0 (GLB): axes, views and accessors as JSON, and the container. All writers of the format use
// these.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "muster/quat.h"
#include "muster/vec3.h"

namespace muster {

/// Muster's axes (x forward, y left, z up) as those of glTF (y up, facing +z).
constexpr Vec3 gltfAxes(Vec3 v) {
    return {v.y, v.z, v.x};
}
/// A rotation in the axes of glTF.
constexpr Quat gltfAxes(Quat q) {
    return {q.y, q.z, q.x, q.w};
}

/// Types of numbers in accessors, as glTF numbers them.
enum class GltfNumber : std::uint16_t {
    UnsignedByte = 5121,
    Short = 5122,
    UnsignedShort = 5123,
    UnsignedInt = 5125,
    Float = 5126
};

/// Contents of a view, as glTF numbers them; None for neither.
enum class GltfTarget : std::uint16_t { None = 0, Vertices = 34962, Indices = 34963 };

/// Layout of the values of an accessor.
struct GltfValues {
    GltfNumber number = GltfNumber::Float;  ///< Type of each component.
    const char* type = "SCALAR";            ///< Components of a value: "SCALAR", "VEC3", "VEC4", "MAT4".
    std::uint64_t count = 0;                ///< Number of values.
    bool normalized = false;                ///< True for whole numbers that stand for -1 to 1.
    std::string least = {}, most = {};      ///< Bounds as JSON arrays, where glTF requires them; else empty.
};

/// A view of `bytes` bytes of buffer 0, as JSON.
std::string gltfView(std::uint64_t offset, std::uint64_t bytes, GltfTarget target);
/// An accessor to values `offset` bytes from the front of a view, as JSON.
std::string gltfAccessor(std::uint64_t view, std::uint64_t offset, const GltfValues& values);

/// The bytes of contiguous numbers as files hold them, lowest byte first.
template <class Numbers>
std::string_view bytesOf(const Numbers& numbers) {
    const std::span view(numbers);
    return {reinterpret_cast<const char*>(view.data()), view.size_bytes()};
}

/// The number of bytes rounded up to a multiple of 4: chunks and views have such sizes.
constexpr std::uint64_t gltfPadded(std::uint64_t bytes) {
    return (bytes + 3) / 4 * 4;
}

/// Size of a GLB file whose JSON and buffer have these sizes [bytes].
std::uint64_t glbSize(std::uint64_t jsonBytes, std::uint64_t bufferBytes);
/// A GLB file up to its buffer, whose bytes follow; their number is a multiple of 4. The file must be below 4
/// GiB.
std::string glbStart(std::string_view json, std::uint64_t bufferBytes);

}  // namespace muster
