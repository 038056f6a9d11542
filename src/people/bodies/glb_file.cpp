#include "people/bodies/glb_file.h"

#include <algorithm>

namespace muster::bodies {
namespace {

constexpr const char* kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};

}  // namespace

std::size_t GlbFile::add(std::string_view bytes, GltfTarget target, const GltfValues& values) {
    if (count_ > 0) views_ += ',', accessors_ += ',';
    views_ += gltfView(bytes_.size(), bytes.size(), target);
    accessors_ += gltfAccessor(count_, 0, values);
    bytes_ += bytes;
    bytes_.resize(gltfPadded(bytes_.size()), '\0');
    return count_++;
}

std::size_t GlbFile::addFloats(std::span<const float> numbers, std::size_t width, GltfTarget target,
                               bool bounds) {
    GltfValues values{GltfNumber::Float, kTypes[width], numbers.size() / width};
    if (bounds) {
        Json least = Json::array(), most = Json::array();
        for (std::size_t c = 0; c < width; ++c) {
            float low = numbers[c], high = numbers[c];
            for (std::size_t i = c; i < numbers.size(); i += width)
                low = std::min(low, numbers[i]), high = std::max(high, numbers[i]);
            least.push(low), most.push(high);
        }
        values.least = compactJson(least);
        values.most = compactJson(most);
    }
    return add(bytesOf(numbers), target, values);
}

std::size_t GlbFile::addVectors(std::span<const Vec3> vectors, GltfTarget target, bool bounds) {
    std::vector<float> numbers;
    for (const Vec3& v : vectors) {
        const Vec3 f = gltfAxes(v);
        numbers.insert(numbers.end(), {f.x, f.y, f.z});
    }
    return addFloats(numbers, 3, target, bounds);
}

std::size_t GlbFile::addBytes(std::span<const std::uint8_t> numbers, GltfTarget target) {
    return add(bytesOf(numbers), target, {GltfNumber::UnsignedByte, kTypes[4], numbers.size() / 4});
}

std::size_t GlbFile::addIndices(std::span<const std::uint32_t> indices, std::size_t vertices) {
    GltfValues values{GltfNumber::UnsignedInt, kTypes[1], indices.size()};
    if (vertices > 65535) return add(bytesOf(indices), GltfTarget::Indices, values);
    const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
    values.number = GltfNumber::UnsignedShort;
    return add(bytesOf(narrow), GltfTarget::Indices, values);
}

std::size_t GlbFile::addMatrices(std::span<const float> numbers) {
    return add(bytesOf(numbers), GltfTarget::None, {GltfNumber::Float, "MAT4", numbers.size() / 16});
}

std::string GlbFile::bytes(const Json& document) const {
    std::string json = compactJson(document);
    json.pop_back();  // The closing brace.
    json += ",\"buffers\":[{\"byteLength\":" + std::to_string(bytes_.size()) + "}],\"bufferViews\":[" +
            views_ + "],\"accessors\":[" + accessors_ + "]}";
    return glbStart(json, bytes_.size()) + bytes_;
}

}  // namespace muster::bodies
