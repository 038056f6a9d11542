// A binary glTF file that grows in memory.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/gltf.h"
#include "json/json.h"

namespace muster::bodies {

/// Collects the buffer, buffer views and accessors of a glTF file. Each add function returns the index of its
/// new accessor.
class GlbFile {
public:
    /// Adds floats, `width` (1 to 4) per value. `bounds` adds minimum and maximum of each component.
    std::size_t addFloats(std::span<const float> numbers, std::size_t width, GltfTarget target,
                          bool bounds = false);
    /// Adds vectors, converted to the file's axes.
    std::size_t addVectors(std::span<const Vec3> vectors, GltfTarget target, bool bounds = false);
    /// Adds whole numbers below 256, four per value.
    std::size_t addBytes(std::span<const std::uint8_t> numbers, GltfTarget target);
    /// Adds indices of vertices, in the smallest type that fits the number of `vertices`.
    std::size_t addIndices(std::span<const std::uint32_t> indices, std::size_t vertices);
    /// Adds matrices of 16 numbers each.
    std::size_t addMatrices(std::span<const float> numbers);

    /// The whole file; `document` is an object that lacks buffers, views and accessors. Must stay below 4
    /// GiB.
    std::string bytes(const Json& document) const;

private:
    /// Adds a view of these bytes and an accessor to its values.
    std::size_t add(std::string_view bytes, GltfTarget target, const GltfValues& values);

    std::string views_, accessors_;  // JSON objects separated by commas.
    std::size_t count_ = 0;          // Number of views, which equals that of accessors.
    std::string bytes_;
};

}  // namespace muster::bodies
