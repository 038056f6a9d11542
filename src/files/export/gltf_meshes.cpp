#include "files/export/gltf_meshes.h"

#include <algorithm>

namespace muster {
std::uint32_t GltfMeshes::material(const NamedColour& colour) {
    const auto found = materials_.find(colour.name);
    if (found != materials_.end()) return found->second;
    const std::uint32_t made = document_.addMaterial(colour.name, linearColour(colour.colour), 1.0, 0.85);
    return materials_[colour.name] = made;
}

std::uint32_t GltfMeshes::material(Finish finish) {
    const FinishLook& look = finishLook(finish);
    const auto found = materials_.find(look.name);
    if (found != materials_.end()) return found->second;
    const std::uint32_t made = document_.addMaterial(look.name, linearColour(look.colour),
                                                     static_cast<double>(look.alpha),
                                                     static_cast<double>(look.roughness));
    return materials_[look.name] = made;
}

Result<std::uint32_t> GltfMeshes::write(std::string_view bytes, GltfTarget target, const GltfValues& values) {
    std::uint64_t offset = 0;
    if (Status s = buffer_.append(bytes, offset); !s.ok()) return s;
    return document_.addAccessor(document_.addView(offset, bytes.size(), target), 0, values);
}

Result<std::uint32_t> GltfMeshes::writePoints(std::span<const Vec3> points, bool bounded) {
    std::vector<float> numbers;
    Vec3 least = gltfAxes(points[0]), most = least;
    for (const Vec3& p : points) {
        const Vec3 q = gltfAxes(p);
        numbers.insert(numbers.end(), {q.x, q.y, q.z});
        least = {std::min(least.x, q.x), std::min(least.y, q.y), std::min(least.z, q.z)};
        most = {std::max(most.x, q.x), std::max(most.y, q.y), std::max(most.z, q.z)};
    }
    GltfValues values{GltfNumber::Float, "VEC3", points.size()};
    if (bounded) values.least = jsonNumbers(least), values.most = jsonNumbers(most);
    return write(bytesOf(numbers), GltfTarget::Vertices, values);
}

Result<std::uint32_t> GltfMeshes::writeIndices(std::span<const std::uint32_t> indices) {
    const std::uint32_t most = *std::max_element(indices.begin(), indices.end());
    if (most >= 65535u) {
        const std::vector<std::uint32_t> numbers(indices.begin(), indices.end());
        return write(bytesOf(numbers), GltfTarget::Indices,
                     {GltfNumber::UnsignedInt, "SCALAR", indices.size()});
    }
    std::vector<std::uint16_t> numbers;
    for (const std::uint32_t i : indices) numbers.push_back(static_cast<std::uint16_t>(i));
    return write(bytesOf(numbers), GltfTarget::Indices,
                 {GltfNumber::UnsignedShort, "SCALAR", indices.size()});
}

Result<std::uint32_t> GltfMeshes::thing(const SceneThing& thing) {
    std::string primitives;
    for (const SceneSurface& surface : thing.surfaces) {
        const auto positions = writePoints(surface.positions, true);
        if (!positions.ok()) return positions.status();
        const auto normals = writePoints(surface.normals, false);
        if (!normals.ok()) return normals.status();
        const auto indices = writeIndices(surface.indices);
        if (!indices.ok()) return indices.status();
        primitives += std::string(primitives.empty() ? "" : ",") +
                      "{\"attributes\":{\"POSITION\":" + std::to_string(*positions) +
                      ",\"NORMAL\":" + std::to_string(*normals) +
                      "},\"indices\":" + std::to_string(*indices) +
                      ",\"material\":" + std::to_string(material(surface.finish)) + "}";
    }
    return document_.meshes.add("{\"name\":" + jsonText(thing.name) + ",\"primitives\":[" + primitives +
                                "]}");
}

Status GltfMeshes::writeBody(const BodyMesh& mesh, BodyParts& parts) {
    std::vector<Vec3> positions, normals;
    std::vector<std::array<std::uint8_t, 4>> joints;
    std::vector<std::array<float, 4>> weights;
    for (const BodyVertex& v : mesh.vertices) {
        positions.push_back(v.position);
        normals.push_back(v.normal);
        joints.push_back(v.joints);
        weights.push_back(v.weights);
    }
    const std::size_t n = mesh.vertices.size();
    const Result<std::uint32_t> accessors[] = {
        writePoints(positions, true), writePoints(normals, false),
        write(bytesOf(joints), GltfTarget::Vertices, {GltfNumber::UnsignedByte, "VEC4", n}),
        write(bytesOf(weights), GltfTarget::Vertices, {GltfNumber::Float, "VEC4", n})};
    const char* const names[] = {"POSITION", "NORMAL", "JOINTS_0", "WEIGHTS_0"};
    for (std::size_t k = 0; k < 4; ++k) {
        if (!accessors[k].ok()) return accessors[k].status();
        parts.attributes += (k == 0 ? "\"" : ",\"") + std::string(names[k]) +
                            "\":" + std::to_string(*accessors[k]);
    }
    for (std::size_t r = 0; r < kBodyRegionCount; ++r) {
        const std::size_t from = mesh.regionBegin[r], to = mesh.regionBegin[r + 1];
        parts.indices[r] = -1;
        if (from == to) continue;
        const auto indices = writeIndices(std::span(mesh.indices).subspan(from, to - from));
        if (!indices.ok()) return indices.status();
        parts.indices[r] = *indices;
    }
    return {};
}

Result<const GltfMeshes::BodyParts*> GltfMeshes::bodyParts(BodyKind kind) {
    const auto found = bodies_.find(kind);
    if (found != bodies_.end()) return &found->second;
    BodyParts& parts = bodies_[kind];
    if (Status s = writeBody(makeBody(kind, BodyLevel::Near), parts); !s.ok()) return s;
    return &parts;
}

Result<std::uint32_t> GltfMeshes::body(const CharacterLook& look) {
    const auto known = meshes_.find(look);
    if (known != meshes_.end()) return known->second;
    const auto parts = bodyParts(look.body);
    if (!parts.ok()) return parts.status();
    std::string primitives;
    for (std::size_t r = 0; r < kBodyRegionCount; ++r) {
        if ((*parts)->indices[r] < 0) continue;
        const std::uint32_t dressed = material(regionColour(static_cast<BodyRegion>(r), look));
        primitives += std::string(primitives.empty() ? "" : ",") + "{\"attributes\":{" +
                      (*parts)->attributes + "},\"indices\":" + std::to_string((*parts)->indices[r]) +
                      ",\"material\":" + std::to_string(dressed) + "}";
    }
    const std::string name = "body " + std::to_string(static_cast<int>(look.body) + 1);
    const std::uint32_t mesh = document_.meshes.add("{\"name\":" + jsonText(name) + ",\"primitives\":[" +
                                                    primitives + "]}");
    return meshes_[look] = mesh;
}

Result<std::uint32_t> GltfMeshes::inverseBinds() {
    if (inverseBinds_ >= 0) return static_cast<std::uint32_t>(inverseBinds_);
    JointTransforms rest;
    jointTransforms(restPose(), {}, rest);
    std::vector<float> numbers;
    for (const Transform& joint : rest) {
        const Vec3 p = gltfAxes(-joint.translation);
        numbers.insert(numbers.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, p.x, p.y, p.z, 1});
    }
    const auto made = write(bytesOf(numbers), GltfTarget::None, {GltfNumber::Float, "MAT4", kJointCount});
    if (made.ok()) inverseBinds_ = *made;
    return made;
}

}  // namespace muster
