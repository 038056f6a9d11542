#include "base/gltf.h"

#include <bit>

#include "muster/assert.h"

namespace muster {
namespace {

static_assert(std::endian::native == std::endian::little,
              "glTF files hold numbers with the lowest byte first");

constexpr std::uint64_t kMagic = 0x46546C67, kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

void putWord(std::uint64_t word, std::string& bytes) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((word >> shift) & 255u);
}

}  // namespace

std::string gltfView(std::uint64_t offset, std::uint64_t bytes, GltfTarget target) {
    std::string text = "{\"buffer\":0,\"byteOffset\":" + std::to_string(offset) +
                       ",\"byteLength\":" + std::to_string(bytes);
    if (target != GltfTarget::None) text += ",\"target\":" + std::to_string(static_cast<int>(target));
    return text + "}";
}

std::string gltfAccessor(std::uint64_t view, std::uint64_t offset, const GltfValues& values) {
    std::string text = "{\"bufferView\":" + std::to_string(view);
    if (offset > 0) text += ",\"byteOffset\":" + std::to_string(offset);
    text += ",\"componentType\":" + std::to_string(static_cast<int>(values.number));
    if (values.normalized) text += ",\"normalized\":true";
    text += ",\"count\":" + std::to_string(values.count) + ",\"type\":\"" + values.type + "\"";
    if (!values.least.empty()) text += ",\"min\":" + values.least + ",\"max\":" + values.most;
    return text + "}";
}

std::uint64_t glbSize(std::uint64_t jsonBytes, std::uint64_t bufferBytes) {
    return 12 + 8 + gltfPadded(jsonBytes) + 8 + bufferBytes;
}

std::string glbStart(std::string_view json, std::uint64_t bufferBytes) {
    const std::uint64_t size = glbSize(json.size(), bufferBytes), jsonBytes = gltfPadded(json.size());
    MUSTER_ASSERT(size <= 0xFFFFFFFFull);
    std::string bytes;
    for (const std::uint64_t word : {kMagic, kVersion, size, jsonBytes, kJsonChunk}) putWord(word, bytes);
    bytes += json;
    bytes.append(jsonBytes - json.size(), ' ');
    putWord(bufferBytes, bytes);
    putWord(kBinaryChunk, bytes);
    return bytes;
}

}  // namespace muster
