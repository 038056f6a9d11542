#include "files/export/gltf_document.h"

#include <array>
#include <cstdio>

namespace muster {
namespace {

template <class T, class Write>
std::string jsonList(std::span<const T> values, const Write& write) {
    std::string text = "[";
    for (const T& value : values) {
        if (text.size() > 1) text += ',';
        text += write(value);
    }
    return text + "]";
}

}  // namespace

std::string jsonNumber(double value) {
    char text[40];
    // Minus zero would be read as a different number than it prints.
    std::snprintf(text, sizeof(text), "%.9g", value == 0.0 ? 0.0 : value);
    return text;
}

std::string jsonNumbers(std::span<const float> values) {
    return jsonList(values, [](float value) { return jsonNumber(static_cast<double>(value)); });
}

std::string jsonNumbers(std::span<const std::uint32_t> values) {
    return jsonList(values, [](std::uint32_t value) { return std::to_string(value); });
}

std::string jsonNumbers(Vec3 v) {
    return jsonNumbers(std::array{v.x, v.y, v.z});
}

std::string jsonNumbers(Quat q) {
    return jsonNumbers(std::array{q.x, q.y, q.z, q.w});
}

std::uint32_t GltfList::add(std::string_view object) {
    if (count_ > 0) text_ += ",\n";
    text_ += object;
    return count_++;
}

std::string GltfList::member(const char* name) const {
    if (count_ == 0) return {};
    std::string list = "\"";
    list += name;
    list += "\":[\n";
    list += text_;
    return list += "],\n";
}

std::uint32_t GltfDocument::addView(std::uint64_t offset, std::uint64_t bytes, GltfTarget target) {
    return views.add(gltfView(offset, bytes, target));
}

std::uint32_t GltfDocument::addAccessor(std::uint32_t view, std::uint64_t offset, const GltfValues& values) {
    return accessors.add(gltfAccessor(view, offset, values));
}

std::uint32_t GltfDocument::addMaterial(std::string_view name, Vec3 colour, double alpha, double roughness) {
    const std::array<float, 4> factor{colour.x, colour.y, colour.z, static_cast<float>(alpha)};
    std::string text = "{\"name\":" + jsonText(name) +
                       ",\"pbrMetallicRoughness\":{\"baseColorFactor\":" + jsonNumbers(factor) +
                       ",\"metallicFactor\":0,\"roughnessFactor\":" + jsonNumber(roughness) + "}";
    if (alpha < 1.0) text += ",\"alphaMode\":\"BLEND\",\"doubleSided\":true";
    return materials.add(text + "}");
}

void GltfDocument::animate(std::uint32_t node, const char* path, std::uint32_t times, std::uint32_t values,
                           bool steps) {
    const std::uint32_t sampler = samplers.add("{\"input\":" + std::to_string(times) +
                                               ",\"output\":" + std::to_string(values) +
                                               (steps ? ",\"interpolation\":\"STEP\"}" : "}"));
    channels.add("{\"sampler\":" + std::to_string(sampler) + ",\"target\":{\"node\":" + std::to_string(node) +
                 ",\"path\":\"" + path + "\"}}");
}

std::string GltfDocument::text(std::string_view name, std::uint64_t bufferBytes) const {
    std::string text = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"Muster\"},\n\"scene\":0,\n";
    std::string scene = roots.member("nodes");
    scene.erase(scene.rfind(','));
    text += "\"scenes\":[{\"name\":" + jsonText(name) + ",\n" + scene + "}],\n";
    text += nodes.member("nodes") + cameras.member("cameras") + materials.member("materials") +
            meshes.member("meshes") + skins.member("skins");
    if (channels.size() > 0) {
        std::string channel = channels.member("channels");
        channel.erase(channel.rfind(','));
        text += "\"animations\":[{\"name\":\"Take\",\n" + samplers.member("samplers") + channel + "}],\n";
    }
    text += accessors.member("accessors") + views.member("bufferViews");
    return text + "\"buffers\":[{\"byteLength\":" + std::to_string(bufferBytes) + "}]}";
}

}  // namespace muster
