#include <doctest.h>

#include <array>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "people/bodies/body_samples.h"
#include "people/bodies/glb_file.h"

using namespace muster;
using namespace muster::testing;
using nlohmann::json;

namespace {

std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
    std::uint32_t word = 0;
    REQUIRE(at + 4 <= bytes.size());
    std::memcpy(&word, bytes.data() + at, 4);
    return word;
}

/// A file taken apart by the specification alone.
struct Glb {
    json document;
    std::string buffer;

    explicit Glb(const std::string& bytes) {
        REQUIRE(bytes.substr(0, 4) == "glTF");
        REQUIRE(wordAt(bytes, 4) == 2);
        REQUIRE(wordAt(bytes, 8) == bytes.size());
        const std::size_t length = wordAt(bytes, 12);
        REQUIRE(bytes.substr(16, 4) == "JSON");
        REQUIRE(length % 4 == 0);
        document = json::parse(bytes.substr(20, length));
        const std::size_t rest = 20 + length;
        REQUIRE(bytes.substr(rest + 4, 4) == std::string("BIN\0", 4));
        REQUIRE(wordAt(bytes, rest) % 4 == 0);
        buffer = bytes.substr(rest + 8);
        REQUIRE(buffer.size() == wordAt(bytes, rest));
        REQUIRE(document["buffers"][0]["byteLength"] == buffer.size());
    }

    /// All numbers of an accessor, whatever their type.
    std::vector<double> numbers(std::size_t accessor) const {
        const json& a = document["accessors"][accessor];
        const json& view = document["bufferViews"][a["bufferView"].get<std::size_t>()];
        static const std::map<std::string, std::size_t> kWidths{
            {"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
        const std::size_t count = a["count"].get<std::size_t>() * kWidths.at(a["type"]);
        const std::size_t begin = view["byteOffset"];
        const int type = a["componentType"];
        const std::size_t size = type == 5121 ? 1 : type == 5123 ? 2 : 4;
        REQUIRE(begin % size == 0);
        REQUIRE(view["byteLength"].get<std::size_t>() == count * size);
        REQUIRE(begin + count * size <= buffer.size());
        std::vector<double> out;
        for (std::size_t i = 0; i < count; ++i) {
            const char* at = buffer.data() + begin + i * size;
            float real = 0.0f;
            std::uint16_t half = 0;
            if (type == 5126) std::memcpy(&real, at, 4), out.push_back(real);
            if (type == 5123) std::memcpy(&half, at, 2), out.push_back(half);
            if (type == 5121) out.push_back(static_cast<unsigned char>(*at));
        }
        REQUIRE(out.size() == count);
        return out;
    }
};

using Matrix = std::array<double, 16>;  // Columns one after another.

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix out{};
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t r = 0; r < 4; ++r)
            for (std::size_t k = 0; k < 4; ++k) out[4 * c + r] += a[4 * k + r] * b[4 * c + k];
    return out;
}

Matrix matrixOf(Quat q, double x, double y, double z) {
    Matrix out{};
    const Vec3 columns[] = {rotate(q, {1, 0, 0}), rotate(q, {0, 1, 0}), rotate(q, {0, 0, 1})};
    for (std::size_t c = 0; c < 3; ++c)
        out[4 * c] = columns[c].x, out[4 * c + 1] = columns[c].y, out[4 * c + 2] = columns[c].z;
    out[12] = x, out[13] = y, out[14] = z, out[15] = 1.0;
    return out;
}

/// A rotation in the file's axes: its x, y, z are our y, z, x.
Quat fileTurn(Quat q) {
    return {q.y, q.z, q.x, q.w};
}

/// Matrices of all nodes, rotations of the joints by name.
std::vector<Matrix> nodeMatrices(const json& nodes, const BodyPose& pose) {
    std::vector<Matrix> global(nodes.size(), matrixOf({}, 0, 0, 0));
    for (std::size_t n = 0; n < nodes.size(); ++n) {  // Parents come first in these files.
        Quat turn;
        json at = nodes[n].value("translation", json::array({0.0, 0.0, 0.0}));
        for (std::size_t j = 0; j < kJointCount; ++j)
            if (nodes[n]["name"] == skeleton()[j].name) turn = fileTurn(pose.rotation[j]);
        global[n] = product(global[n], matrixOf(turn, at[0], at[1], at[2]));
        for (const json& child : nodes[n].value("children", json::array()))
            global[child.get<std::size_t>()] = global[n];
    }
    return global;
}

}  // namespace

TEST_CASE("a body's file has what the page and other programs look for") {
    for (const Sample& sample : samples()) {
        CAPTURE(sample.name);
        const Glb glb(bodyGlb(sample.kind, sample.level));
        const json& primitive = glb.document["meshes"][0]["primitives"][0];
        const json& attributes = primitive["attributes"];
        for (const char* name : {"POSITION", "NORMAL", "JOINTS_0", "WEIGHTS_0", "COLOR_0", "_REGION"}) {
            CAPTURE(name);
            REQUIRE(attributes.contains(name));
            const json& accessor = glb.document["accessors"][attributes[name].get<std::size_t>()];
            CHECK(accessor["count"] == sample.mesh.vertices.size());
        }
        const auto indices = glb.numbers(primitive["indices"]);
        REQUIRE(indices.size() == sample.mesh.indices.size());
        for (std::size_t i = 0; i < indices.size(); ++i) REQUIRE(indices[i] == sample.mesh.indices[i]);
        const auto regions = glb.numbers(attributes["_REGION"]);
        for (std::size_t i = 0; i < regions.size(); ++i)
            REQUIRE(regions[i] == static_cast<double>(sample.mesh.vertices[i].region));
        const auto& joints = glb.document["skins"][0]["joints"];
        REQUIRE(joints.size() == kJointCount);
        for (std::size_t j = 0; j < kJointCount; ++j)
            CHECK(glb.document["nodes"][joints[j].get<std::size_t>()]["name"] == skeleton()[j].name);
    }
}

TEST_CASE("bounds of the positions are those stored") {
    const Glb glb(bodyGlb(BodyKind::Broad, BodyLevel::Near));
    const std::size_t accessor = glb.document["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
    const auto numbers = glb.numbers(accessor);
    for (std::size_t c = 0; c < 3; ++c) {
        double low = 9.0, high = -9.0;
        for (std::size_t i = c; i < numbers.size(); i += 3)
            low = std::min(low, numbers[i]), high = std::max(high, numbers[i]);
        CHECK(glb.document["accessors"][accessor]["min"][c].get<double>() == low);
        CHECK(glb.document["accessors"][accessor]["max"][c].get<double>() == high);
    }
}

TEST_CASE("a file's skin, bent by its own nodes and matrices, lies where ours does") {
    for (const Sample& sample : samples()) {
        CAPTURE(sample.name);
        const Glb glb(bodyGlb(sample.kind, sample.level));
        const json& attributes = glb.document["meshes"][0]["primitives"][0]["attributes"];
        const auto positions = glb.numbers(attributes["POSITION"]),
                   weights = glb.numbers(attributes["WEIGHTS_0"]);
        const auto roles = glb.numbers(attributes["JOINTS_0"]);
        const json& skin = glb.document["skins"][0];
        const auto inverse = glb.numbers(skin["inverseBindMatrices"]);
        for (const BodyPose& pose : hardPoses()) {
            const auto global = nodeMatrices(glb.document["nodes"], pose);
            JointTransforms joints;
            jointTransforms(pose, {}, joints);
            for (std::size_t v = 0; v < sample.mesh.vertices.size(); ++v) {
                std::array<double, 3> sum{};
                for (std::size_t k = 0; k < 4; ++k) {
                    const auto j = static_cast<std::size_t>(roles[4 * v + k]);
                    Matrix bind;
                    std::copy_n(inverse.begin() + static_cast<std::ptrdiff_t>(16 * j), 16, bind.begin());
                    const Matrix m = product(global[skin["joints"][j].get<std::size_t>()], bind);
                    for (std::size_t r = 0; r < 3; ++r)
                        sum[r] += weights[4 * v + k] *
                                  (m[r] * positions[3 * v] + m[4 + r] * positions[3 * v + 1] +
                                   m[8 + r] * positions[3 * v + 2] + m[12 + r]);
                }
                // The file's x, y, z are our y, z, x.
                const Vec3 ours = skinned(sample.mesh.vertices[v], joints);
                REQUIRE(std::fabs(sum[0] - ours.y) + std::fabs(sum[1] - ours.z) + std::fabs(sum[2] - ours.x) <
                        1e-5);
            }
        }
    }
}

TEST_CASE("bodies with many vertices get wide indices") {
    bodies::GlbFile file;
    const std::array<std::uint32_t, 3> corners{0, 1, 70000};
    file.addIndices(corners, 70001);
    const Glb glb(file.bytes({{"asset", {{"version", "2.0"}}}}));
    CHECK(glb.document["accessors"][0]["componentType"] == 5125);
    CHECK(wordAt(glb.buffer, 8) == 70000);
}
