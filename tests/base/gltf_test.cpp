#include "base/gltf.h"

#include <doctest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "base/random.h"

using namespace muster;
using Json = nlohmann::json;

namespace {

std::uint32_t word(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (int k = 3; k >= 0; --k) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
    return value;
}

/// A chunk of a GLB file, as section 4.4 of the glTF 2.0 specification lays it out.
struct Chunk {
    std::string type;
    std::string data;
};

/// Splits a GLB file by the rules of the specification: header, then chunks of whole words up to the end.
std::vector<Chunk> chunksOf(const std::string& file) {
    REQUIRE(file.size() >= 12);
    CHECK(file.substr(0, 4) == "glTF");
    CHECK(word(file, 4) == 2);
    CHECK(word(file, 8) == file.size());
    std::vector<Chunk> chunks;
    std::size_t at = 12;
    while (at < file.size()) {
        REQUIRE(at + 8 <= file.size());
        const std::size_t length = word(file, at);
        CHECK(length % 4 == 0);
        CHECK(at % 4 == 0);
        REQUIRE(at + 8 + length <= file.size());
        chunks.push_back({file.substr(at + 4, 4), file.substr(at + 8, length)});
        at += 8 + length;
    }
    return chunks;
}

double distanceOf(Vec3 a, Vec3 b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

Vec3 randomVector(Random& random) {
    const auto one = [&] { return static_cast<float>(random.uniform(-3, 3)); };
    const float x = one(), y = one();
    return {x, y, one()};
}

}  // namespace

TEST_CASE("a GLB file of any length of JSON and buffer splits into the two chunks of the specification") {
    for (std::size_t jsonBytes = 2; jsonBytes < 40; ++jsonBytes) {
        for (std::size_t bufferBytes = 0; bufferBytes <= 24; bufferBytes += 4) {
            const std::string json = "{" + std::string(jsonBytes - 2, ' ') + "}";
            std::string buffer;
            for (std::size_t i = 0; i < bufferBytes; ++i) buffer += static_cast<char>(37 * i + 200);
            const std::string file = glbStart(json, bufferBytes) + buffer;
            CHECK(file.size() == glbSize(json.size(), bufferBytes));
            const auto chunks = chunksOf(file);
            REQUIRE(chunks.size() == 2);
            CHECK(chunks[0].type == "JSON");
            CHECK(chunks[1].type == std::string("BIN\0", 4));
            CHECK(chunks[1].data == buffer);
            // The JSON chunk is padded with spaces by less than a word.
            CHECK(chunks[0].data.substr(0, json.size()) == json);
            CHECK(chunks[0].data.size() - json.size() < 4);
            CHECK(chunks[0].data.find_first_not_of(' ', json.size()) == std::string::npos);
            CHECK(Json::parse(chunks[0].data).is_object());
        }
    }
}

TEST_CASE("padded sizes are the next multiples of four") {
    for (std::uint64_t n = 0; n < 100; ++n) {
        std::uint64_t expected = n;
        while (expected % 4 != 0) ++expected;
        CHECK(gltfPadded(n) == expected);
    }
    CHECK(gltfPadded(0xFFFFFFFDull) == 0x100000000ull);  // Beyond 32 bits it does not wrap.
}

TEST_CASE("views and accessors hold the fields of the specification and no others") {
    const Json view = Json::parse(gltfView(128, 36, GltfTarget::Indices));
    CHECK(view == Json{{"buffer", 0}, {"byteOffset", 128}, {"byteLength", 36}, {"target", 34963}});
    CHECK(Json::parse(gltfView(0, 8, GltfTarget::Vertices))["target"] == 34962);
    CHECK(!Json::parse(gltfView(0, 8, GltfTarget::None)).contains("target"));
    CHECK(Json::parse(gltfView(5'000'000'000ull, 8, GltfTarget::None))["byteOffset"] == 5'000'000'000ull);

    GltfValues positions{GltfNumber::Float, "VEC3", 7, false, "[-1,-2,-3]", "[1,2,3]"};
    const Json bounded = Json::parse(gltfAccessor(4, 12, positions));
    CHECK(bounded == Json{{"bufferView", 4},
                          {"byteOffset", 12},
                          {"componentType", 5126},
                          {"count", 7},
                          {"type", "VEC3"},
                          {"min", {-1, -2, -3}},
                          {"max", {1, 2, 3}}});
    GltfValues rotations{GltfNumber::Short, "VEC4", 3, true};
    const Json plain = Json::parse(gltfAccessor(0, 0, rotations));
    CHECK(plain == Json{{"bufferView", 0},
                        {"componentType", 5122},
                        {"normalized", true},
                        {"count", 3},
                        {"type", "VEC4"}});
}

TEST_CASE("the numbers of component types are those of the specification") {
    const std::array<std::pair<GltfNumber, int>, 5> table{{{GltfNumber::UnsignedByte, 5121},
                                                           {GltfNumber::Short, 5122},
                                                           {GltfNumber::UnsignedShort, 5123},
                                                           {GltfNumber::UnsignedInt, 5125},
                                                           {GltfNumber::Float, 5126}}};
    for (const auto& [number, value] : table) {
        const Json accessor = Json::parse(gltfAccessor(0, 0, {number, "SCALAR", 1}));
        CHECK(accessor["componentType"] == value);
    }
}

TEST_CASE("bytes of numbers are those of memory, lowest byte first") {
    const std::vector<std::uint16_t> shorts{0x0102, 0xFFFE};
    CHECK(bytesOf(shorts) == std::string_view("\x02\x01\xFE\xFF", 4));
    const std::array<float, 2> reals{1.0f, -2.0f};  // 0x3F800000 and 0xC0000000.
    CHECK(bytesOf(reals) == std::string_view("\0\0\x80\x3F\0\0\0\xC0", 8));
    CHECK(bytesOf(std::vector<float>()).empty());
}

TEST_CASE("axes: forward is +z, up is +y, left is +x, and nothing is mirrored") {
    CHECK(gltfAxes(Vec3{1, 0, 0}) == Vec3{0, 0, 1});
    CHECK(gltfAxes(Vec3{0, 1, 0}) == Vec3{1, 0, 0});
    CHECK(gltfAxes(Vec3{0, 0, 1}) == Vec3{0, 1, 0});
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const Vec3 a = randomVector(random), b = randomVector(random);
        CHECK(distanceOf(cross(gltfAxes(a), gltfAxes(b)), gltfAxes(cross(a, b))) < 1e-5);
        CHECK(dot(gltfAxes(a), gltfAxes(b)) == doctest::Approx(dot(a, b)).epsilon(1e-5));
        // A rotation carried over turns carried-over vectors alike.
        const Quat q = axisAngle(normalized(a, {0, 0, 1}),
                                 random.uniform(-std::numbers::pi, std::numbers::pi));
        CHECK(distanceOf(rotate(gltfAxes(q), gltfAxes(b)), gltfAxes(rotate(q, b))) < 1e-5);
    }
}
