#include "files/export/usd_scene.h"

#include <algorithm>
#include <cstdio>

#include "base/maths.h"
#include "files/export/usd_text.h"
#include "people/bodies/body_mesh.h"

namespace muster {
namespace {

constexpr double kDegrees = 180.0 / kPi;

void put(Vec3 p, std::vector<double>& numbers) {
    for (const float v : {p.x, p.y, p.z}) numbers.push_back(static_cast<double>(v));
}

UsdValue points(const char* type, std::span<const Vec3> list) {
    UsdValue value{type, {}, {}};
    for (const Vec3 p : list) put(p, value.numbers);
    return value;
}

UsdValue point(const char* type, Vec3 p) {
    return points(type, {&p, 1});
}

template <class T>
UsdValue numbers(const char* type, const std::vector<T>& list) {
    return {type, std::vector<double>(list.begin(), list.end()), {}};
}

UsdValue number(double value) {
    return {"float", {value}, {}};
}

UsdValue word(const char* value) {
    return {"token", {}, {value}};
}

UsdProperty fixed(const char* name, UsdValue value) {
    return {.name = name, .value = std::move(value), .uniform = true};
}

UsdProperty related(const char* name, std::string target) {
    return {.name = name, .value = {}, .target = std::move(target)};
}

UsdProperty track(const char* name, UsdValue first) {
    return {.name = name, .value = std::move(first), .sampled = true};
}

UsdProperty order(std::vector<std::string> operations) {
    return fixed("xformOpOrder", {"token[]", {}, std::move(operations)});
}

UsdPrim material(const std::string& name, std::uint32_t colour, double alpha, double roughness,
                 const std::string& scope = "/World/Materials") {
    const std::string n = usdName(name);
    UsdPrim surface{.type = "Shader", .name = "Surface"};
    surface.properties = {fixed("info:id", word("UsdPreviewSurface")),
                          {"inputs:diffuseColor", point("color3f", linearColour(colour))},
                          {"inputs:metallic", number(0.0)},
                          {"inputs:opacity", number(alpha)},
                          {"inputs:roughness", number(roughness)},
                          {"outputs:surface", {"token", {}, {}}}};
    const UsdProperty link{
        "outputs:surface", {"token", {}, {}}, scope + "/" + n + "/Surface.outputs:surface"};
    return {.type = "Material", .name = n, .properties = {link}, .children = {surface}};
}

/// Bounds, triangles, normals and points of a mesh.
std::vector<UsdProperty> shape(std::span<const Vec3> corners, std::span<const Vec3> normals,
                               const std::vector<std::uint32_t>& indices) {
    Vec3 bounds[] = {corners[0], corners[0]};
    for (const Vec3 p : corners) {
        bounds[0] = {std::min(bounds[0].x, p.x), std::min(bounds[0].y, p.y), std::min(bounds[0].z, p.z)};
        bounds[1] = {std::max(bounds[1].x, p.x), std::max(bounds[1].y, p.y), std::max(bounds[1].z, p.z)};
    }
    UsdProperty upright{"normals", points("normal3f[]", normals)};
    upright.interpolation = "vertex";
    return {{"extent", points("float3[]", bounds)},
            {"faceVertexCounts", numbers("int[]", std::vector<int>(indices.size() / 3, 3))},
            {"faceVertexIndices", numbers("int[]", indices)},
            upright,
            {"points", points("point3f[]", corners)},
            fixed("subdivisionScheme", word("none"))};
}

UsdPrim subset(const BodyMesh& mesh, std::size_t region) {
    std::vector<std::size_t> faces;
    for (std::size_t t = mesh.regionBegin[region] / 3; t < mesh.regionBegin[region + 1] / 3; ++t)
        faces.push_back(t);
    UsdPrim prim{.type = "GeomSubset", .name = bodyRegionName(static_cast<BodyRegion>(region))};
    prim.schema = "MaterialBindingAPI";
    prim.properties = {fixed("elementType", word("face")),
                       fixed("familyName", word("materialBind")),
                       {"indices", numbers("int[]", faces)}};
    return prim;
}

UsdPrim body(BodyKind kind) {
    const BodyMesh mesh = makeBody(kind, BodyLevel::Near);
    std::vector<Vec3> corners, normals;
    std::vector<int> joints;
    std::vector<float> weights;
    for (const BodyVertex& v : mesh.vertices) {
        corners.push_back(v.position);
        normals.push_back(v.normal);
        joints.insert(joints.end(), v.joints.begin(), v.joints.end());
        weights.insert(weights.end(), v.weights.begin(), v.weights.end());
    }
    UsdPrim prim{.type = "Mesh", .name = "Body" + std::to_string(static_cast<int>(kind) + 1)};
    prim.schema = "SkelBindingAPI";
    prim.properties = shape(corners, normals, mesh.indices);
    UsdProperty places{"primvars:skel:jointIndices", numbers("int[]", joints)};
    UsdProperty shares{"primvars:skel:jointWeights", numbers("float[]", weights)};
    for (UsdProperty* four : {&places, &shares}) four->elementSize = 4, four->interpolation = "vertex";
    prim.properties.insert(prim.properties.end(),
                           {{"primvars:skel:geomBindTransform",
                             {"matrix4d", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, {}}},
                            places,
                            shares,
                            related("skel:skeleton", "/World/Bodies/Skeleton"),
                            fixed("subsetFamily:materialBind:familyType", word("partition"))});
    for (std::size_t r = 0; r < kBodyRegionCount; ++r)
        if (mesh.regionBegin[r] < mesh.regionBegin[r + 1]) prim.children.push_back(subset(mesh, r));
    return prim;
}

void putMoved(Vec3 p, std::vector<double>& numbers) {
    numbers.insert(numbers.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
    put(p, numbers);
    numbers.push_back(1);
}

UsdProperty joints() {
    std::vector<std::string> paths;
    for (const Joint& joint : skeleton())
        paths.push_back((joint.parent < 0 ? "" : paths[joint.parent] + "/") + joint.name);
    return fixed("joints", {"token[]", {}, paths});
}

/// Each joint's place in its parent, which no pose changes: hips move as a whole with the body.
UsdValue offsets() {
    std::vector<Vec3> list;
    for (const Joint& joint : skeleton()) list.push_back(joint.offset);
    return points("float3[]", list);
}

UsdPrim animation(const std::vector<double>& rotations) {
    return {.type = "SkelAnimation",
            .name = "Animation",
            .properties = {joints(),
                           {"translations", offsets()},
                           {"scales", {"half3[]", std::vector<double>(3 * kJointCount, 1.0), {}}},
                           track("rotations", {"quatf[]", rotations, {}})}};
}

UsdPrim dressed(const std::string& root, const CharacterLook& look) {
    UsdPrim prim{.type = "Mesh", .name = "Body"};
    prim.reference = "/World/Bodies/Body" + std::to_string(static_cast<int>(look.body) + 1);
    prim.properties = {related("skel:skeleton", root + "/Skeleton")};
    for (std::size_t r = 0; r < kBodyRegionCount; ++r) {
        const auto region = static_cast<BodyRegion>(r);
        const bool own = region == BodyRegion::Shirt && look.chosen;
        UsdPrim part{UsdSpecifier::Over, "", bodyRegionName(region)};
        part.properties = {related("material:binding", (own ? root : std::string("/World/Materials")) + "/" +
                                                           usdName(regionColour(region, look).name))};
        prim.children.push_back(part);
    }
    return prim;
}

}  // namespace

UsdPrim usdMaterials() {
    UsdPrim scope{.type = "Scope", .name = "Materials"};
    for (int f = 0; f < static_cast<int>(Finish::Count); ++f) {
        const FinishLook& look = finishLook(static_cast<Finish>(f));
        scope.children.push_back(material(look.name, look.colour, static_cast<double>(look.alpha),
                                          static_cast<double>(look.roughness)));
    }
    for (std::uint32_t k = 0; k < std::max(kAccents, kSkinTones); ++k) {
        const CharacterLook look{BodyKind::Broad, k % kSkinTones, k % kSkinTones, k % kAccents, {}};
        for (std::size_t r = 0; r < kBodyRegionCount; ++r) {
            const auto region = static_cast<BodyRegion>(r);
            const bool toned = region == BodyRegion::Skin || region == BodyRegion::Hair;
            const bool known = region == BodyRegion::Shirt ? k >= kAccents : toned ? k >= kSkinTones : k > 0;
            const NamedColour colour = regionColour(region, look);
            if (!known) scope.children.push_back(material(colour.name, colour.colour, 1.0, 0.85));
        }
    }
    return scope;
}

UsdPrim usdBodies() {
    JointTransforms rest;
    jointTransforms(restPose(), {}, rest);
    UsdValue binds{"matrix4d[]", {}, {}}, rests{"matrix4d[]", {}, {}};
    for (const Transform& joint : rest) putMoved(joint.translation, binds.numbers);
    for (const Joint& joint : skeleton()) putMoved(joint.offset, rests.numbers);
    UsdPrim bones{.type = "Skeleton", .name = "Skeleton"};
    bones.schema = "SkelBindingAPI";
    bones.properties = {fixed("bindTransforms", binds), joints(), fixed("restTransforms", rests)};
    UsdPrim scope{UsdSpecifier::Class, "Scope", "Bodies"};
    scope.children = {bones};
    for (std::size_t k = 0; k < kBodyKindCount; ++k) scope.children.push_back(body(static_cast<BodyKind>(k)));
    return scope;
}

UsdPrim usdThing(const SceneThing& thing) {
    UsdPrim prim{.type = "Xform", .name = usdName(thing.name)};
    const UsdValue place{"double3", {thing.pivot.x, thing.pivot.y, 0.0}, {}};
    if (thing.path.still()) {
        prim.properties = {{"xformOp:translate", place}, order({"xformOp:translate"})};
    } else {
        prim.properties = {track("xformOp:rotateZ", number(0.0)), track("xformOp:translate", place),
                           order({"xformOp:translate", "xformOp:rotateZ"})};
    }
    for (const SceneSurface& surface : thing.surfaces) {
        UsdPrim mesh{.type = "Mesh", .name = usdName(finishLook(surface.finish).name)};
        mesh.schema = "MaterialBindingAPI";
        mesh.properties = shape(surface.positions, surface.normals, surface.indices);
        mesh.properties.push_back(related("material:binding", "/World/Materials/" + mesh.name));
        prim.children.push_back(std::move(mesh));
    }
    return prim;
}

UsdPrim usdCamera(const SceneCamera& camera) {
    const double half = 0.5 * camera.fieldOfView, high = 24.0;  // The film is 24 mm high.
    UsdValue placed{"matrix4d", {}, {}};
    for (const auto& [row, w] : {std::pair{camera.right, 0.0}, std::pair{camera.up, 0.0},
                                 std::pair{-camera.forward, 0.0}, std::pair{camera.eye, 1.0}}) {
        put(row, placed.numbers);
        placed.numbers.push_back(w);
    }
    return {.type = "Camera",
            .name = "Camera",
            .properties = {{"clippingRange", {"float2", {0.1, camera.farthest}, {}}},
                           {"focalLength", number(0.5 * high * cosine(half) / sine(half))},
                           {"horizontalAperture", number(high * camera.aspect)},
                           {"projection", word("perspective")},
                           {"verticalAperture", number(high)},
                           {"xformOp:transform", placed},
                           order({"xformOp:transform"})}};
}

UsdPersonValues usdPersonValues(const ExportCharacter& character, double turn) {
    UsdPersonValues values;
    const auto of = [&](UsdPersonTrack which) -> std::vector<double>& {
        return values[static_cast<std::size_t>(which)];
    };
    of(UsdPersonTrack::Place) = {character.position.x, character.position.y, 0.0};
    of(UsdPersonTrack::Turn) = {turn * kDegrees};
    put(character.pose->hips - skeleton()[0].offset, of(UsdPersonTrack::Hips));
    std::vector<double>& turns = of(UsdPersonTrack::Rotations);
    turns.reserve(4 * kJointCount);
    for (const Quat& rotation : character.pose->rotation) {
        const Quat q = normalized(rotation);
        for (const float v : {q.w, q.x, q.y, q.z}) turns.push_back(static_cast<double>(v));
    }
    return values;
}

UsdPrim usdPerson(const ExportCharacter& character, const CharacterLook& look, const UsdPersonValues& first) {
    char name[40];
    std::snprintf(name, sizeof(name), "character_%04u", character.id);
    const std::string root = std::string("/World/") + name;
    const auto size = static_cast<double>(character.size);
    const auto value = [&](UsdPersonTrack which) { return first[static_cast<std::size_t>(which)]; };
    UsdPrim bones{.type = "Skeleton", .name = "Skeleton"};
    bones.reference = "/World/Bodies/Skeleton";
    bones.properties = {related("skel:animationSource", root + "/Animation")};
    UsdPrim prim{.type = "SkelRoot", .name = name};
    prim.properties = {
        track("xformOp:translate", {"float3", value(UsdPersonTrack::Place), {}}),
        track("xformOp:rotateZ", {"float", value(UsdPersonTrack::Turn), {}}),
        {"xformOp:scale", {"float3", {size, size, size}, {}}},
        track("xformOp:translate:hips", {"float3", value(UsdPersonTrack::Hips), {}}),
        order({"xformOp:translate", "xformOp:rotateZ", "xformOp:scale", "xformOp:translate:hips"}),
        track("visibility", word("inherited"))};
    prim.children = {bones, animation(value(UsdPersonTrack::Rotations)), dressed(root, look)};
    if (look.chosen) {
        const NamedColour shirt = regionColour(BodyRegion::Shirt, look);
        prim.children.push_back(material(shirt.name, shirt.colour, 1.0, 0.85, root));
    }
    return prim;
}

}  // namespace muster
