#include "character/bodies/glb_file.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "muster/assert.h"

namespace muster::bodies {
namespace {

constexpr int kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;
constexpr const char* kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};

static_assert(std::endian::native == std::endian::little,
              "glTF is little-endian, so are the machines this is for");

template <class T>
std::string_view bytesOf(std::span<const T> numbers) {
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

void append(std::string& out, std::uint32_t number) {
    char bytes[4];
    std::memcpy(bytes, &number, 4);
    out.append(bytes, 4);
}

}  // namespace

std::size_t GlbFile::addView(std::string_view bytes, int target) {
    Json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
    if (target != 0) view["target"] = target;
    views_.push_back(std::move(view));
    bytes_ += bytes;
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    return views_.size() - 1;
}

std::size_t GlbFile::addAccessor(std::size_t view, int componentType, std::size_t count, const char* type) {
    accessors_.push_back(
        {{"bufferView", view}, {"componentType", componentType}, {"count", count}, {"type", type}});
    return accessors_.size() - 1;
}

std::size_t GlbFile::addFloats(std::span<const float> numbers, std::size_t width, int target, bool bounds) {
    const std::size_t count = numbers.size() / width;
    const std::size_t accessor = addAccessor(addView(bytesOf(numbers), target), kFloat, count, kTypes[width]);
    if (!bounds) return accessor;
    Json least = Json::array(), most = Json::array();
    for (std::size_t c = 0; c < width; ++c) {
        float low = numbers[c], high = numbers[c];
        for (std::size_t i = c; i < numbers.size(); i += width)
            low = std::min(low, numbers[i]), high = std::max(high, numbers[i]);
        least.push_back(low), most.push_back(high);
    }
    accessors_[accessor]["min"] = std::move(least);
    accessors_[accessor]["max"] = std::move(most);
    return accessor;
}

std::size_t GlbFile::addVectors(std::span<const Vec3> vectors, int target, bool bounds) {
    std::vector<float> numbers;
    for (const Vec3& v : vectors) {
        const Vec3 f = toFile(v);
        numbers.insert(numbers.end(), {f.x, f.y, f.z});
    }
    return addFloats(numbers, 3, target, bounds);
}

std::size_t GlbFile::addBytes(std::span<const std::uint8_t> numbers, int target) {
    return addAccessor(addView(bytesOf(numbers), target), kUnsignedByte, numbers.size() / 4, kTypes[4]);
}

std::size_t GlbFile::addIndices(std::span<const std::uint32_t> indices, std::size_t vertices) {
    if (vertices > 65535)
        return addAccessor(addView(bytesOf(indices), kIndices), kUnsignedInt, indices.size(), kTypes[1]);
    const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
    const auto view = addView(bytesOf(std::span<const std::uint16_t>(narrow)), kIndices);
    return addAccessor(view, kUnsignedShort, indices.size(), kTypes[1]);
}

std::size_t GlbFile::addMatrices(std::span<const float> numbers) {
    return addAccessor(addView(bytesOf(numbers), 0), kFloat, numbers.size() / 16, "MAT4");
}

std::string GlbFile::bytes(Json document) const {
    document["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
    document["bufferViews"] = views_;
    document["accessors"] = accessors_;
    std::string json = document.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::uint64_t length = std::uint64_t{12} + 8 + json.size() + 8 + bytes_.size();
    MUSTER_ASSERT(length <= 0xffffffffu);
    std::string text = "glTF";
    append(text, 2);
    append(text, static_cast<std::uint32_t>(length));
    append(text, static_cast<std::uint32_t>(json.size()));
    text += "JSON" + json;
    append(text, static_cast<std::uint32_t>(bytes_.size()));
    text.append("BIN\0", 4);
    return text + bytes_;
}

}  // namespace muster::bodies
