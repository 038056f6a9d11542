// Bodies: skinned meshes on Muster's skeleton, made by computation.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "muster/clip.h"
#include "muster/vec3.h"

namespace muster {

/// What a corner of a body is made of; files and the page number them as here.
enum class BodyRegion : std::uint8_t { Skin, Shirt, Trousers, Hair, Shoes, Count };
inline constexpr std::size_t kBodyRegionCount = static_cast<std::size_t>(BodyRegion::Count);
/// "skin", "shirt"...
const char* bodyRegionName(BodyRegion region);

/// Which body.
enum class BodyKind : std::uint8_t {
    Broad,   ///< Wide shoulders, short hair.
    Narrow,  ///< Narrow shoulders, wider hips, tied hair.
    Count
};
inline constexpr std::size_t kBodyKindCount = static_cast<std::size_t>(BodyKind::Count);

/// How fine a mesh is.
enum class BodyLevel : std::uint8_t {
    Near,  ///< About 2,000 triangles.
    Far,   ///< About 300.
};

/// A corner of a body's mesh.
struct BodyVertex {
    Vec3 position;  ///< In the rest pose, in the character's own frame [m].
    Vec3 normal;    ///< Unit.
    Vec3 colour;    ///< Red, green, blue, linear light, 0 to 1: how it is dressed by default.
    BodyRegion region = BodyRegion::Skin;  ///< What it is made of.
    std::array<std::uint8_t, 4> joints{};  ///< JointRole values, the heaviest first.
    std::array<float, 4> weights{};        ///< Of the joints; none negative, sum 1.
};

/// A body in the rest pose, on the skeleton as it stands (1.75 m).
struct BodyMesh {
    std::vector<BodyVertex> vertices;
    std::vector<std::uint32_t>
        indices;  ///< Three a triangle, anticlockwise seen from outside; grouped by region.
    std::array<std::size_t, kBodyRegionCount + 1>
        regionBegin{};  ///< Where each region's indices begin, and the end.
};

/// The mesh of a body. The same for every call.
BodyMesh makeBody(BodyKind kind, BodyLevel level);

/// Where a vertex goes when the joints are as given (linear blend skinning) [m].
Vec3 skinned(const BodyVertex& vertex, const JointTransforms& joints);

/// The mesh as a binary glTF 2.0 file: one skinned mesh, joints named as the skeleton's, attributes POSITION,
/// NORMAL, COLOR_0, JOINTS_0, WEIGHTS_0 and _REGION (the region's number).
std::string bodyGlb(BodyKind kind, BodyLevel level);

}  // namespace muster
