#include "bodies/gltf_buffer.h"

#include <algorithm>
#include <bit>
#include <cstring>

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

std::size_t GltfBuffer::addView(std::string_view bytes, int target) {
    MUSTER_ASSERT(reserved_ == 0);
    Json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
    if (target != 0) view["target"] = target;
    views_.push_back(std::move(view));
    bytes_ += bytes;
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    return views_.size() - 1;
}

std::size_t GltfBuffer::addAccessor(std::size_t view, int componentType, std::size_t count,
                                    const char* type) {
    accessors_.push_back(
        {{"bufferView", view}, {"componentType", componentType}, {"count", count}, {"type", type}});
    return accessors_.size() - 1;
}

std::size_t GltfBuffer::addFloats(std::span<const float> numbers, std::size_t width, int target,
                                  bool bounds) {
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

std::size_t GltfBuffer::addVectors(std::span<const Vec3> vectors, int target, bool bounds) {
    std::vector<float> numbers;
    for (const Vec3& v : vectors) {
        const Vec3 f = toFile(v);
        numbers.insert(numbers.end(), {f.x, f.y, f.z});
    }
    return addFloats(numbers, 3, target, bounds);
}

std::size_t GltfBuffer::addBytes(std::span<const std::uint8_t> numbers, int target) {
    return addAccessor(addView(bytesOf(numbers), target), kUnsignedByte, numbers.size() / 4, kTypes[4]);
}

std::size_t GltfBuffer::addIndices(std::span<const std::uint32_t> indices, std::size_t vertices) {
    if (vertices > 65535)
        return addAccessor(addView(bytesOf(indices), kIndices), kUnsignedInt, indices.size(), kTypes[1]);
    const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
    const auto view = addView(bytesOf(std::span<const std::uint16_t>(narrow)), kIndices);
    return addAccessor(view, kUnsignedShort, indices.size(), kTypes[1]);
}

std::size_t GltfBuffer::addMatrices(std::span<const float> numbers) {
    return addAccessor(addView(bytesOf(numbers), 0), kFloat, numbers.size() / 16, "MAT4");
}

std::size_t GltfBuffer::reserve(std::size_t elements, std::size_t width, std::uint64_t& place) {
    place = size();
    const std::uint64_t length = static_cast<std::uint64_t>(elements) * width * sizeof(float);
    views_.push_back({{"buffer", 0}, {"byteOffset", place}, {"byteLength", length}});
    reserved_ += length;
    return addAccessor(views_.size() - 1, kFloat, elements, kTypes[width]);
}

Result<std::string> GltfBuffer::file(Json document) const {
    document["buffers"] = Json::array({{{"byteLength", size()}}});
    document["bufferViews"] = views_;
    document["accessors"] = accessors_;
    std::string json = document.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::uint64_t length = 12 + 8 + json.size() + 8 + size();
    if (length > 0xffffffffu) {
        return Status(
            StatusCode::LimitExceeded,
            "the file would be " + std::to_string(length / 1000000) +
                " MB long, a glb can have at most 4294 MB; take a shorter part or fewer frames a second");
    }
    std::string text = "glTF";
    append(text, 2);
    append(text, static_cast<std::uint32_t>(length));
    append(text, static_cast<std::uint32_t>(json.size()));
    text += "JSON" + json;
    append(text, static_cast<std::uint32_t>(size()));
    text.append("BIN\0", 4);
    return text + bytes_;
}

}  // namespace muster::bodies
