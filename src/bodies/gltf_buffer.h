// Binary glTF 2.0: numbers in a buffer, their description in JSON, and the file around both.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "muster/base/status.h"
#include "muster/bodies/body.h"

namespace muster::bodies {

using Json = nlohmann::ordered_json;

/// Files have y up and face +z: x, y, z there are our y, z, x. A proper rotation, so quaternions turn
/// likewise.
constexpr Vec3 toFile(Vec3 p) {
    return {p.y, p.z, p.x};
}
constexpr Quat toFile(Quat q) {
    return {q.y, q.z, q.x, q.w};
}

/// The buffer of a file. Numbers that come later get their places beforehand.
class GltfBuffer {
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

    /// Elements of `width` floats each that come later; `place` gets their offset in the buffer. After the
    /// first call nothing may be added. Returns the accessor.
    std::size_t reserve(std::size_t elements, std::size_t width, std::uint64_t& place);

    /// Length of the whole buffer.
    std::uint64_t size() const { return bytes_.size() + reserved_; }

    /// The file up to and with what was added; `document` gets buffer, views and accessors. Fails with
    /// LimitExceeded where it would be longer than a file can be. What was reserved follows and is to be
    /// written by the caller, its first byte at the returned text's length.
    Result<std::string> file(Json document) const;

private:
    std::size_t addView(std::string_view bytes, int target);
    std::size_t addAccessor(std::size_t view, int componentType, std::size_t count, const char* type);

    Json views_ = Json::array(), accessors_ = Json::array();
    std::string bytes_;
    std::uint64_t reserved_ = 0;
};

/// The vertices of a body's mesh: attributes for a primitive, without indices. `dressed` adds COLOR_0 and
/// _REGION.
Json addBodyVertices(const BodyMesh& mesh, bool dressed, GltfBuffer& buffer);
/// The skeleton's inverse bind matrices; returns the accessor.
std::size_t addInverseBinds(GltfBuffer& buffer);
/// The joints' nodes in the rest pose, numbered from `first` in the skeleton's order, names ending in
/// `suffix`.
void addJointNodes(std::size_t first, const std::string& suffix, Json& nodes);

}  // namespace muster::bodies
