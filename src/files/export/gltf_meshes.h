// Meshes and materials in a glTF file, each written once.
#pragma once

#include <array>
#include <map>
#include <string>

#include "files/export/character_look.h"
#include "files/export/gltf_buffer.h"
#include "files/export/gltf_document.h"
#include "files/export/scene_mesh.h"

namespace muster {

/// Writes meshes to a document and its buffer.
class GltfMeshes {
public:
    GltfMeshes(GltfDocument& document, GltfBuffer& buffer) : document_(document), buffer_(buffer) {}

    /// The mesh of an obstacle, a patch or the ground; fails with write errors.
    Result<std::uint32_t> thing(const SceneThing& thing);
    /// The mesh of a character's body, in its colours.
    Result<std::uint32_t> body(const CharacterLook& look);
    /// The inverse bind matrices; all skins share them.
    Result<std::uint32_t> inverseBinds();

private:
    /// Accessors of one body's vertices and of each region's triangles.
    struct BodyParts {
        std::string attributes;                                ///< The vertex attributes as JSON.
        std::array<std::int64_t, kBodyRegionCount> indices{};  ///< -1 where a region is empty.
    };
    std::uint32_t material(const NamedColour& colour);
    std::uint32_t material(Finish finish);
    Result<const BodyParts*> bodyParts(BodyKind kind);
    Status writeBody(const BodyMesh& mesh, BodyParts& parts);
    /// Writes values and adds their view and accessor; returns the accessor.
    Result<std::uint32_t> write(std::string_view bytes, GltfTarget target, const GltfValues& values);
    Result<std::uint32_t> writePoints(std::span<const Vec3> points, bool bounded);
    Result<std::uint32_t> writeIndices(std::span<const std::uint32_t> indices);

    GltfDocument& document_;
    GltfBuffer& buffer_;
    std::map<std::string, std::uint32_t> materials_;
    std::map<BodyKind, BodyParts> bodies_;
    std::map<CharacterLook, std::uint32_t> meshes_;
    std::int64_t inverseBinds_ = -1;
};

}  // namespace muster
