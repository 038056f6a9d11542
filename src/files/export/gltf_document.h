// The JSON part of a glTF file and the numbers in it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/gltf.h"
#include "json/json.h"

namespace muster {

std::string jsonNumber(double value);                            ///< Formats with nine digits.
std::string jsonNumbers(std::span<const float> values);          ///< "[1,2,3]".
std::string jsonNumbers(std::span<const std::uint32_t> values);  ///< Formats as "[1,2,3]".
std::string jsonNumbers(Vec3 v);                                 ///< Formats as "[x,y,z]".
std::string jsonNumbers(Quat q);                                 ///< "[x,y,z,w]".

/// One of the lists that a glTF file consists of; items refer to each other by index.
class GltfList {
public:
    /// Adds an object, given as JSON; returns its index.
    std::uint32_t add(std::string_view object);
    std::uint32_t size() const { return count_; }  ///< Number of items.
    /// The list as `"name":[...],`, or nothing where it is empty.
    std::string member(const char* name) const;

private:
    std::string text_;
    std::uint32_t count_ = 0;
};

/// All lists of a glTF file with one scene, one buffer and one animation.
struct GltfDocument {
    GltfList nodes, meshes, skins, materials, cameras, accessors, views, samplers, channels;
    GltfList roots;  ///< Indices of the scene's root nodes.

    /// Adds a range of the buffer.
    std::uint32_t addView(std::uint64_t offset, std::uint64_t bytes, GltfTarget target);
    /// Adds an accessor: values in a view, `offset` bytes from its start.
    std::uint32_t addAccessor(std::uint32_t view, std::uint64_t offset, const GltfValues& values);
    /// Adds a material; the colour is linear, each component from 0 to 1.
    std::uint32_t addMaterial(std::string_view name, Vec3 colour, double alpha, double roughness);
    /// Adds a channel of the animation: `path` is "rotation", "translation" or "scale".
    void animate(std::uint32_t node, const char* path, std::uint32_t times, std::uint32_t values,
                 bool steps = false);

    /// The whole JSON text for a buffer of that many bytes.
    std::string text(std::string_view name, std::uint64_t bufferBytes) const;
};

}  // namespace muster
