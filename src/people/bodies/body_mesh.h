// Bodies: procedural skinned meshes on Muster's skeleton.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "muster/clip.h"
#include "muster/vec3.h"

namespace muster {

/// Material of a vertex. The numbers are written to files and known to the page.
enum class BodyRegion : std::uint8_t { Skin, Shirt, Trousers, Hair, Shoes, Count };
inline constexpr std::size_t kBodyRegionCount = static_cast<std::size_t>(BodyRegion::Count);
/// The name of a region: "skin", "shirt", "trousers", "hair" or "shoes".
const char* bodyRegionName(BodyRegion region);

/// The two bodies.
enum class BodyKind : std::uint8_t {
    Broad,   ///< Wide shoulders, short hair.
    Narrow,  ///< Narrow shoulders, wider hips, tied hair.
    Count
};
inline constexpr std::size_t kBodyKindCount = static_cast<std::size_t>(BodyKind::Count);

/// Level of detail of a mesh.
enum class BodyLevel : std::uint8_t {
    Near,  ///< Mesh of about 2,000 triangles.
    Far,   ///< Mesh of about 300 triangles.
};

/// A vertex of a body's mesh.
struct BodyVertex {
    Vec3 position;                         ///< Position in the rest pose, in the character's own frame [m].
    Vec3 normal;                           ///< Normal, a unit vector.
    Vec3 colour;                           ///< Default colour: linear red, green, blue, 0 to 1.
    BodyRegion region = BodyRegion::Skin;  ///< Its material.
    std::array<std::uint8_t, 4> joints{};  ///< JointRole values by descending weight.
    std::array<float, 4> weights{};        ///< Weights of the joints, not negative, sum 1.
};

/// A body in the rest pose, on the skeleton at its own size (1.75 m).
struct BodyMesh {
    std::vector<BodyVertex> vertices;
    /// Indices, three per triangle, anticlockwise seen from outside, grouped by region.
    std::vector<std::uint32_t> indices;
    /// First index of each region, then the end.
    std::array<std::size_t, kBodyRegionCount + 1> regionBegin{};
};

/// The mesh of a body; every call gives the same bits.
BodyMesh makeBody(BodyKind kind, BodyLevel level);

/// Position of a vertex for the given joint transforms, by linear blend skinning [m].
Vec3 skinned(const BodyVertex& vertex, const JointTransforms& joints);

/// The mesh as a binary glTF 2.0 file: one skinned mesh, joints named as the skeleton's, attributes POSITION,
/// NORMAL, COLOR_0, JOINTS_0, WEIGHTS_0 and _REGION (the region's number).
std::string bodyGlb(BodyKind kind, BodyLevel level);

}  // namespace muster
