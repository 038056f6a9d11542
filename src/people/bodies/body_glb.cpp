#include <numeric>

#include "people/bodies/body_mesh.h"
#include "people/bodies/glb_file.h"

namespace muster {
namespace {

using bodies::GlbFile;

/// Adds the vertices to the file; returns the attributes of a glTF primitive.
Json addVertices(const BodyMesh& mesh, GlbFile& file) {
    std::vector<Vec3> positions, normals;
    std::vector<float> weights, colours, regions;
    std::vector<std::uint8_t> joints;
    for (const BodyVertex& v : mesh.vertices) {
        positions.push_back(v.position);
        normals.push_back(v.normal);
        weights.insert(weights.end(), v.weights.begin(), v.weights.end());
        joints.insert(joints.end(), v.joints.begin(), v.joints.end());
        colours.insert(colours.end(), {v.colour.x, v.colour.y, v.colour.z});
        regions.push_back(static_cast<float>(v.region));
    }
    Json attributes;
    attributes["POSITION"] = file.addVectors(positions, GltfTarget::Vertices, true);
    attributes["NORMAL"] = file.addVectors(normals, GltfTarget::Vertices);
    attributes["JOINTS_0"] = file.addBytes(joints, GltfTarget::Vertices);
    attributes["WEIGHTS_0"] = file.addFloats(weights, 4, GltfTarget::Vertices);
    attributes["COLOR_0"] = file.addFloats(colours, 3, GltfTarget::Vertices);
    attributes["_REGION"] = file.addFloats(regions, 1, GltfTarget::Vertices);
    return attributes;
}

/// Adds the skeleton's inverse bind matrices; returns their accessor.
std::size_t addInverseBinds(GlbFile& file) {
    JointTransforms rest;
    jointTransforms(restPose(), {}, rest);
    std::vector<float> numbers;
    for (const Transform& joint : rest) {
        const Vec3 p = gltfAxes(joint.translation);
        numbers.insert(numbers.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -p.x, -p.y, -p.z, 1});
    }
    return file.addMatrices(numbers);
}

/// Adds the nodes of the joints in the rest pose, numbered from `first` in the skeleton's order.
void addJointNodes(std::size_t first, Json& nodes) {
    const auto& bones = skeleton();
    for (std::size_t j = 0; j < kJointCount; ++j) {
        const Vec3 p = gltfAxes(bones[j].offset);
        Json node = {{"name", bones[j].name}, {"translation", Json::array({p.x, p.y, p.z})}};
        for (std::size_t child = j + 1; child < kJointCount; ++child)
            if (bones[child].parent == static_cast<std::int32_t>(j)) node["children"].push(first + child);
        nodes.push(std::move(node));
    }
}

}  // namespace

std::string bodyGlb(BodyKind kind, BodyLevel level) {
    const BodyMesh mesh = makeBody(kind, level);
    const std::string name = kind == BodyKind::Broad ? "Broad" : "Narrow";
    GlbFile file;
    Json attributes = addVertices(mesh, file);
    const std::size_t indices = file.addIndices(mesh.indices, mesh.vertices.size());
    Json primitive = {{"attributes", std::move(attributes)}, {"indices", indices}, {"material", 0}};

    std::vector<std::size_t> joints(kJointCount);
    std::iota(joints.begin(), joints.end(), std::size_t{2});
    Json nodes = Json::array(
        {{{"name", name}, {"mesh", 0}, {"skin", 0}}, {{"name", "Root"}, {"children", Json::array({2})}}});
    addJointNodes(2, nodes);

    Json document;
    document["asset"] = {{"version", "2.0"}, {"generator", "Muster"}};
    document["scene"] = 0;
    document["scenes"] = Json::array({{{"nodes", Json::array({0, 1})}}});
    document["nodes"] = std::move(nodes);
    document["meshes"] = Json::array({{{"name", name}, {"primitives", Json::array({std::move(primitive)})}}});
    document["materials"] = Json::array(
        {{{"name", "Body"}, {"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 0.85}}}}});
    document["skins"] = Json::array({{{"inverseBindMatrices", addInverseBinds(file)},
                                      {"skeleton", 1},
                                      {"joints", Json::arrayOf(joints)}}});
    return file.bytes(document);
}

}  // namespace muster
