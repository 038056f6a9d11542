// The JSON part of a glTF file, written piece by piece, and the numbers in it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/gltf.h"
#include "base/json.h"

namespace muster {

std::string jsonNumber(double value);                            ///< With nine digits.
std::string jsonNumbers(std::span<const float> values);          ///< "[1,2,3]".
std::string jsonNumbers(std::span<const std::uint32_t> values);  ///< The same.
std::string jsonNumbers(Vec3 v);                                 ///< The same.
std::string jsonNumbers(Quat q);                                 ///< "[x,y,z,w]".

/// One of the lists that a glTF file consists of; things are named by their place in it.
class GltfList {
public:
    /// Adds an object, given as JSON; returns its index.
    std::uint32_t add(std::string_view object);
    std::uint32_t size() const { return count_; }  ///< So many.
    /// `"name":[...],` or nothing where the list is empty.
    std::string member(const char* name) const;

private:
    std::string text_;
    std::uint32_t count_ = 0;
};

/// All lists of a glTF file with one scene, one buffer and one animation.
struct GltfDocument {
    GltfList nodes, meshes, skins, materials, cameras, accessors, views, samplers, channels;
    GltfList roots;  ///< Numbers of the nodes of the scene.

    /// A stretch of the buffer.
    std::uint32_t addView(std::uint64_t offset, std::uint64_t bytes, GltfTarget target);
    /// Values in a view, `offset` bytes from its front.
    std::uint32_t addAccessor(std::uint32_t view, std::uint64_t offset, const GltfValues& values);
    /// Linear light, 0 to 1.
    std::uint32_t addMaterial(std::string_view name, Vec3 colour, double alpha, double roughness);
    /// One track: `path` is "rotation", "translation" or "scale".
    void animate(std::uint32_t node, const char* path, std::uint32_t times, std::uint32_t values,
                 bool steps = false);

    /// The whole text for a buffer of so many bytes.
    std::string text(std::string_view name, std::uint64_t bufferBytes) const;
};

}  // namespace muster
