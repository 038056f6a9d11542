// Binary glTF 2.0: numbers in a buffer, their description in JSON, and the file around both.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "muster/vec3.h"

namespace muster::bodies {

using Json = nlohmann::ordered_json;

/// Files have y up and face +z: x, y, z there are our y, z, x.
constexpr Vec3 toFile(Vec3 p) {
    return {p.y, p.z, p.x};
}

/// A file that grows in memory.
class GlbFile {
public:
    /// What a view is for, as glTF numbers it; 0 where it is for neither.
    static constexpr int kVertices = 34962, kIndices = 34963;

    /// Numbers, `width` to an element; returns the accessor. `bounds` adds the least and the largest.
    std::size_t addFloats(std::span<const float> numbers, std::size_t width, int target, bool bounds = false);
    /// The same of vectors, in the file's axes.
    std::size_t addVectors(std::span<const Vec3> vectors, int target, bool bounds = false);
    /// Four small whole numbers to an element.
    std::size_t addBytes(std::span<const std::uint8_t> numbers, int target);
    /// Indices of vertices; `vertices` is how many there are, which says how wide they must be.
    std::size_t addIndices(std::span<const std::uint32_t> indices, std::size_t vertices);
    /// A matrix each of 16 numbers.
    std::size_t addMatrices(std::span<const float> numbers);

    /// The whole file; `document` gets buffer, views and accessors. Must stay below 4 GiB.
    std::string bytes(Json document) const;

private:
    std::size_t addView(std::string_view bytes, int target);
    std::size_t addAccessor(std::size_t view, int componentType, std::size_t count, const char* type);

    Json views_ = Json::array(), accessors_ = Json::array();
    std::string bytes_;
};

}  // namespace muster::bodies
