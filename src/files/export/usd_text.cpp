#include "files/export/usd_text.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

#include "base/maths.h"

namespace muster {
namespace {

constexpr std::size_t kLineFrames = 16;  // Number of frames that are buffered.
constexpr double kDegrees = 180.0 / kPi;

template <class T, class Write>
std::string usdList(const T& values, const Write& write) {
    std::string text = "[";
    for (const auto& value : values) {
        if (text.size() > 1) text += ", ";
        text += write(value);
    }
    return text + "]";
}

std::string material(const std::string& name, std::uint32_t colour, double alpha, double roughness,
                     const std::string& scope = "/World/Materials") {
    const std::string n = usdName(name);
    return "        def Material \"" + n + "\"\n        {\n" +
           "            token outputs:surface.connect = <" + scope + "/" + n + "/Surface.outputs:surface>\n" +
           "            def Shader \"Surface\"\n            {\n" +
           "                uniform token info:id = \"UsdPreviewSurface\"\n" +
           "                color3f inputs:diffuseColor = " + usdPoint(linearColour(colour)) + "\n" +
           "                float inputs:metallic = 0\n" +
           "                float inputs:opacity = " + usdNumber(alpha) + "\n" +
           "                float inputs:roughness = " + usdNumber(roughness) + "\n" +
           "                token outputs:surface\n            }\n        }\n";
}

/// Points, normals, triangles and bounds of a mesh.
std::string shape(std::span<const Vec3> points, std::span<const Vec3> normals,
                  std::span<const std::uint32_t> indices, const std::string& indent) {
    Vec3 least = points[0], most = least;
    for (const Vec3 p : points) {
        least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
        most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
    }
    const auto number = [](std::uint32_t i) { return std::to_string(i); };
    const std::vector<std::uint32_t> threes(indices.size() / 3, 3);
    return indent + "float3[] extent = [" + usdPoint(least) + ", " + usdPoint(most) + "]\n" + indent +
           "int[] faceVertexCounts = " + usdList(threes, number) + "\n" + indent +
           "int[] faceVertexIndices = " + usdList(indices, number) + "\n" + indent +
           "normal3f[] normals = " + usdList(normals, usdPoint) + " (interpolation = \"vertex\")\n" + indent +
           "point3f[] points = " + usdList(points, usdPoint) + "\n" + indent +
           "uniform token subdivisionScheme = \"none\"\n";
}

std::string subset(const BodyMesh& mesh, std::size_t region) {
    const std::size_t from = mesh.regionBegin[region] / 3, to = mesh.regionBegin[region + 1] / 3;
    if (from == to) return {};
    std::vector<std::size_t> faces;
    for (std::size_t t = from; t < to; ++t) faces.push_back(t);
    return std::string("            def GeomSubset \"") + bodyRegionName(static_cast<BodyRegion>(region)) +
           "\" (\n                prepend apiSchemas = [\"MaterialBindingAPI\"]\n            )\n            "
           "{\n" +
           "                uniform token elementType = \"face\"\n" +
           "                uniform token familyName = \"materialBind\"\n                int[] indices = " +
           usdList(faces, [](std::size_t t) { return std::to_string(t); }) + "\n            }\n";
}

std::string body(BodyKind kind) {
    const BodyMesh mesh = makeBody(kind, BodyLevel::Near);
    std::vector<Vec3> points, normals;
    std::vector<int> joints;
    std::vector<float> weights;
    for (const BodyVertex& v : mesh.vertices) {
        points.push_back(v.position);
        normals.push_back(v.normal);
        joints.insert(joints.end(), v.joints.begin(), v.joints.end());
        weights.insert(weights.end(), v.weights.begin(), v.weights.end());
    }
    const std::string four =
        " (\n                elementSize = 4\n                interpolation = \"vertex\"\n            )\n";
    std::string text = "        def Mesh \"Body" + std::to_string(static_cast<int>(kind) + 1) + "\" (\n" +
                       "            prepend apiSchemas = [\"SkelBindingAPI\"]\n        )\n        {\n" +
                       shape(points, normals, mesh.indices, "            ") +
                       "            matrix4d primvars:skel:geomBindTransform = " +
                       "( (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1) )\n" +
                       "            int[] primvars:skel:jointIndices = " +
                       usdList(joints, [](int j) { return std::to_string(j); }) + four +
                       "            float[] primvars:skel:jointWeights = " +
                       usdList(weights, [](float w) { return usdNumber(static_cast<double>(w)); }) + four +
                       "            rel skel:skeleton = </World/Bodies/Skeleton>\n" +
                       "            uniform token subsetFamily:materialBind:familyType = \"partition\"\n";
    for (std::size_t r = 0; r < kBodyRegionCount; ++r) text += subset(mesh, r);
    return text + "        }\n";
}

std::string moved(Vec3 p) {
    return "( (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (" + usdNumber(static_cast<double>(p.x)) + ", " +
           usdNumber(static_cast<double>(p.y)) + ", " + usdNumber(static_cast<double>(p.z)) + ", 1) )";
}

}  // namespace

std::string usdName(std::string_view name) {
    std::string text;
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        text += plain ? c : '_';
    }
    if (text.empty() || (text[0] >= '0' && text[0] <= '9')) text.insert(text.begin(), '_');
    return text;
}

std::string usdNumber(double value) {
    char text[40];
    std::snprintf(text, sizeof(text), "%.7g", value == 0.0 ? 0.0 : value);
    return text;
}

std::string usdPoint(Vec3 p) {
    return std::string("(") + usdNumber(static_cast<double>(p.x)) + ", " +
           usdNumber(static_cast<double>(p.y)) + ", " + usdNumber(static_cast<double>(p.z)) + ")";
}

void usdFixed(double value, int width, int decimals, std::string& text) {
    char number[64];
    for (; decimals >= 0; --decimals)
        if (std::snprintf(number, sizeof(number), "%*.*f", width, decimals, value) == width) break;
    if (decimals < 0) std::snprintf(number, sizeof(number), "%*d", width, 0);
    text += number;
}

std::string usdMaterials() {
    std::string text = "    def Scope \"Materials\"\n    {\n";
    for (int f = 0; f < static_cast<int>(Finish::Count); ++f) {
        const FinishLook& look = finishLook(static_cast<Finish>(f));
        text += material(look.name, look.colour, static_cast<double>(look.alpha),
                         static_cast<double>(look.roughness));
    }
    for (std::uint32_t k = 0; k < std::max(kAccents, kSkinTones); ++k) {
        const CharacterLook look{BodyKind::Broad, k % kSkinTones, k % kSkinTones, k % kAccents, {}};
        for (std::size_t r = 0; r < kBodyRegionCount; ++r) {
            const auto region = static_cast<BodyRegion>(r);
            const bool toned = region == BodyRegion::Skin || region == BodyRegion::Hair;
            const bool known = region == BodyRegion::Shirt ? k >= kAccents : toned ? k >= kSkinTones : k > 0;
            const NamedColour colour = regionColour(region, look);
            if (!known) text += material(colour.name, colour.colour, 1.0, 0.85);
        }
    }
    return text + "    }\n";
}

std::string usdShirt(const NamedColour& colour, const std::string& scope) {
    return material(colour.name, colour.colour, 1.0, 0.85, scope);
}

std::string usdJoints() {
    std::vector<std::string> paths;
    for (const Joint& joint : skeleton())
        paths.push_back((joint.parent < 0 ? "" : paths[joint.parent] + "/") + joint.name);
    return usdList(paths, [](const std::string& path) { return "\"" + path + "\""; });
}

std::string usdBodies() {
    JointTransforms rest;
    jointTransforms(restPose(), {}, rest);
    std::string text = "    class Scope \"Bodies\"\n    {\n        def Skeleton \"Skeleton\" (\n" +
                       std::string(
                           "            prepend apiSchemas = [\"SkelBindingAPI\"]\n        )\n        {\n") +
                       "            uniform matrix4d[] bindTransforms = " +
                       usdList(rest, [](const Transform& joint) { return moved(joint.translation); }) + "\n" +
                       "            uniform token[] joints = " + usdJoints() + "\n" +
                       "            uniform matrix4d[] restTransforms = " +
                       usdList(skeleton(), [](const Joint& joint) { return moved(joint.offset); }) +
                       "\n        }\n";
    for (std::size_t k = 0; k < kBodyKindCount; ++k) text += body(static_cast<BodyKind>(k));
    return text + "    }\n";
}

std::string usdThing(const SceneThing& thing, double from, double fps, std::size_t frames) {
    std::string text = "    def Xform \"" + usdName(thing.name) + "\"\n    {\n";
    std::string places, turns;
    const auto place = [](Vec2 p) {
        return std::string("(") + usdNumber(p.x) + ", " + usdNumber(p.y) + ", 0)";
    };
    for (std::size_t k = 0; k < frames && !thing.path.still(); ++k) {
        const double time = from + static_cast<double>(k) / fps;
        places += "            " + std::to_string(k) + ": " + place(thing.place(time)) + ",\n";
        turns += "            " + std::to_string(k) + ": " + usdNumber(thing.turn(time) * kDegrees) + ",\n";
    }
    if (thing.path.still()) {
        text += "        double3 xformOp:translate = " + place(thing.pivot) + "\n" +
                "        uniform token[] xformOpOrder = [\"xformOp:translate\"]\n";
    } else {
        text += "        float xformOp:rotateZ.timeSamples = {\n" + turns + "        }\n" +
                "        double3 xformOp:translate.timeSamples = {\n" + places + "        }\n" +
                "        uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:rotateZ\"]\n";
    }
    for (const SceneSurface& surface : thing.surfaces) {
        const std::string name = usdName(finishLook(surface.finish).name);
        text += "        def Mesh \"" + name +
                "\" (\n            prepend apiSchemas = [\"MaterialBindingAPI\"]\n" +
                "        )\n        {\n" +
                shape(surface.positions, surface.normals, surface.indices, "            ") +
                "            rel material:binding = </World/Materials/" + name + ">\n        }\n";
    }
    return text + "    }\n";
}

std::string usdCamera(const SceneCamera& camera) {
    const auto row = [](Vec3 v, int w) {
        return std::string("(") + usdNumber(static_cast<double>(v.x)) + ", " +
               usdNumber(static_cast<double>(v.y)) + ", " + usdNumber(static_cast<double>(v.z)) + ", " +
               std::to_string(w) + ")";
    };
    const double half = 0.5 * camera.fieldOfView, high = 24.0;  // The film is 24 mm high.
    return "    def Camera \"Camera\"\n    {\n        float2 clippingRange = (0.1, " +
           usdNumber(camera.farthest) +
           ")\n        float focalLength = " + usdNumber(0.5 * high * cosine(half) / sine(half)) +
           "\n        float horizontalAperture = " + usdNumber(high * camera.aspect) +
           "\n        token projection = \"perspective\"\n        float verticalAperture = " +
           usdNumber(high) + "\n        matrix4d xformOp:transform = ( " + row(camera.right, 0) + ", " +
           row(camera.up, 0) + ", " + row(-camera.forward, 0) + ", " + row(camera.eye, 1) +
           " )\n        uniform token[] xformOpOrder = [\"xformOp:transform\"]\n    }\n";
}

Status UsdSamples::reserve(OutputFile& file) {
    begin_ = file.size();
    const std::string blank(std::min<std::size_t>(frames_, 1024) * width_, ' ');
    for (std::size_t left = frames_ * width_; left > 0;) {
        const std::size_t now = std::min(left, blank.size());
        if (Status s = file.write({blank.data(), now}); !s.ok()) return s;
        left -= now;
    }
    return {};
}

Status UsdSamples::add(OutputFile& file, std::string_view line) {
    MUSTER_ASSERT(line.size() == width_ && filled_ < frames_);
    lines_ += line;
    ++filled_;
    return lines_.size() < kLineFrames * width_ ? Status() : flush(file);
}

Status UsdSamples::flush(OutputFile& file) {
    if (lines_.empty()) return {};
    const std::uint64_t place = begin_ + filled_ * width_ - lines_.size();
    Status s = file.rewrite(place, lines_);
    lines_.clear();
    return s;
}

}  // namespace muster
