// Binary glTF, read back with an independent reader.
#include <doctest.h>

#include <set>

#include "engine/geometry/polygon.h"
#include "files/export/formats.h"
#include "files/export/gltf_reader.h"
#include "files/export/pretend_take.h"
#include "people/bodies/body_mesh.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

using namespace muster;
using namespace muster::testing;

namespace {

constexpr std::size_t kFrames = 150;  // More than one block of every buffer, and no multiple of a block.

const GltfReader& pretended() {
    static const GltfReader reader = [] {
        const std::string path = (exportFolder() / "pretended.glb").string();
        const Status status = exportPretendTake(*makeGltfExporter(path), kFrames);
        REQUIRE_MESSAGE(status.ok(), status.message());
        return GltfReader(path);
    }();
    return reader;
}

/// Converts the file's axes to Muster's.
Vec3 ours(Vec3 p) {
    return {p.z, p.x, p.y};
}

std::string nameOf(std::uint32_t id) {
    char name[32];
    std::snprintf(name, sizeof(name), "character-%04u", id);
    return name;
}

/// The positions of all joints of a character in the world, in Muster's axes.
std::vector<Vec3> jointsIn(const GltfReader& file, std::uint32_t id, std::size_t frame) {
    const std::size_t root = file.node(nameOf(id));
    const GltfReader::Placed base = file.local(root, frame);
    std::vector<Transform> joints;
    std::vector<Vec3> places;
    for (std::size_t j = 0; j < kJointCount; ++j) {
        const GltfReader::Placed placed = file.local(root + 1 + j, frame);
        const std::int32_t parent = skeleton()[j].parent;
        joints.push_back(parent < 0 ? placed.transform : joints[parent] * placed.transform);
        places.push_back(ours(base.transform.apply(joints[j].translation * static_cast<float>(base.scale))));
    }
    return places;
}

}  // namespace

TEST_CASE("joints in the GLB have Muster's positions, for every joint and in every block of frames") {
    const GltfReader& file = pretended();
    float worst = 0.0f;
    for (const std::size_t frame : {0, 1, 21, 49, 63, 64, 65, 100, 127, 128, 149}) {
        const PretendFrame people = pretendPeople(1, peopleIn(frame),
                                                  1.0 + static_cast<double>(frame) / 30.0);
        for (const ExportCharacter& c : people.characters) {
            const JointTransforms wanted = jointsOf(c);
            const std::vector<Vec3> found = jointsIn(file, c.id, frame);
            for (std::size_t j = 0; j < kJointCount; ++j)
                worst = std::max(worst, distance(found[j], wanted[j].translation));
        }
    }
    MESSAGE("measured: joints in the GLB differ by at most " << 1000.0f * worst << " mm");
    CHECK(worst < 0.001f);
}

TEST_CASE("consecutive rotations have the same sign, so that interpolation takes the short arc") {
    const GltfReader& file = pretended();
    for (const auto& channel : file.json["animations"][0]["channels"]) {
        if (channel["target"]["path"] != "rotation") continue;
        const auto& sampler = file.json["animations"][0]["samplers"][channel["sampler"].get<std::size_t>()];
        for (std::size_t k = 1; k < kFrames; k += 7) {
            const auto a = file.value(sampler["output"], k - 1), b = file.value(sampler["output"], k);
            REQUIRE(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] > 0.9);
        }
    }
}

TEST_CASE("a character that appears late and leaves early has no size while absent") {
    const GltfReader& file = pretended();
    const std::size_t late = file.node(nameOf(4));
    const double size = static_cast<double>(characterSize(4));
    for (const std::size_t away : {0, 19, 50, 149}) CHECK(file.local(late, away).scale == 0.0);
    for (const std::size_t there : {20, 35, 49})
        CHECK(file.local(late, there).scale == doctest::Approx(size).epsilon(1e-6));
    for (const std::size_t frame : {0, 149})
        CHECK(file.local(file.node(nameOf(1)), frame).scale ==
              doctest::Approx(static_cast<double>(characterSize(1))).epsilon(1e-6));
}

TEST_CASE("a car has the position and rotation of its path") {
    const GltfReader& file = pretended();
    const WorldDef def = furnishedWorld();
    const ObstacleDef& car = def.obstacles[2];
    for (const std::size_t frame : {0, 40, 90, 149}) {
        const Waypoint at = car.path.at(1.0 + static_cast<double>(frame) / 30.0);
        const Transform placed = file.local(file.node("Car"), frame).transform;
        const Vec2 wanted = centroid(car.polygon) + at.position;
        const Vec3 found = ours(placed.translation);
        CHECK(static_cast<double>(found.x) == doctest::Approx(wanted.x).epsilon(1e-5));
        CHECK(static_cast<double>(found.y) == doctest::Approx(wanted.y).epsilon(1e-5));
        const Vec3 front = ours(rotate(placed.rotation, Vec3{0.0f, 0.0f, 1.0f}));
        CHECK(static_cast<double>(front.x) == doctest::Approx(cosine(at.angle)).epsilon(1e-5));
        CHECK(static_cast<double>(front.y) == doctest::Approx(sine(at.angle)).epsilon(1e-5));
    }
}

TEST_CASE("inverse bind matrices take every joint of the rest pose to the origin") {
    const GltfReader& file = pretended();
    JointTransforms rest;
    jointTransforms(restPose(), {}, rest);
    const std::size_t accessor = file.json["skins"][0]["inverseBindMatrices"];
    for (std::size_t j = 0; j < kJointCount; ++j) {
        const auto m = file.value(accessor, j);
        const Vec3 moved = ours(
            {static_cast<float>(m[12]), static_cast<float>(m[13]), static_cast<float>(m[14])});
        CHECK(length(moved + rest[j].translation) < 1e-6f);
        CHECK((m[0] == 1.0 && m[5] == 1.0 && m[10] == 1.0 && m[15] == 1.0));
    }
}

TEST_CASE("meshes equal the bodies, and each is written once") {
    const GltfReader& file = pretended();
    std::set<std::size_t> positions;
    for (const auto& mesh : file.json["meshes"]) {
        const std::string name = mesh["name"];
        if (name.rfind("body ", 0) != 0) continue;
        const BodyMesh body = makeBody(name == "body 1" ? BodyKind::Broad : BodyKind::Narrow,
                                       BodyLevel::Near);
        std::size_t corners = 0;
        for (const auto& primitive : mesh["primitives"])
            corners += file.json["accessors"][primitive["indices"].get<std::size_t>()]["count"]
                           .get<std::size_t>();
        CHECK(corners == body.indices.size());
        const std::size_t accessor = mesh["primitives"][0]["attributes"]["POSITION"];
        positions.insert(accessor);
        for (const std::size_t v : {std::size_t{0}, body.vertices.size() / 2, body.vertices.size() - 1})
            CHECK(ours(GltfReader::point(file.value(accessor, v))) == body.vertices[v].position);
    }
    CHECK(positions.size() <= kBodyKindCount);
    CHECK(!positions.empty());
}

TEST_CASE("an abandoned GLB leaves no file, a completed one leaves no temporary file") {
    const std::size_t before = thingsInFolder();
    {
        const auto exporter = makeGltfExporter((exportFolder() / "given-up.glb").string());
        const auto world = World::create(furnishedWorld());
        REQUIRE(exporter->begin({"Given up", 30.0, 0.0, 10, &*world}).ok());
        const PretendFrame frame = pretendPeople(1, 3, 0.0);
        REQUIRE(exporter->frame({0, 0.0, frame.characters, &*world}).ok());
        CHECK(thingsInFolder() == before + 2);
    }
    CHECK(thingsInFolder() == before);
    REQUIRE(exportPretendTake(*makeGltfExporter((exportFolder() / "done.glb").string()), 5).ok());
    CHECK(thingsInFolder() == before + 1);
}

TEST_CASE("more than 4 GiB is refused before anything is written") {
    WorldDef def = furnishedWorld();
    def.box = {{-100, -100}, {100, 100}};
    def.obstacles.clear();
    def.patches.clear();
    def.groups[0].count = 1000;
    const auto world = World::create(def);
    REQUIRE(world.ok());
    const std::size_t before = thingsInFolder();
    const auto exporter = makeGltfExporter((exportFolder() / "large.glb").string());
    const Status status = exporter->begin({"Large", 240.0, 0.0, 240 * 600, &*world});
    CHECK(status.code() == StatusCode::LimitExceeded);
    CHECK(status.message().find("1000 characters") != std::string::npos);
    CHECK(thingsInFolder() == before);
}

#if defined(__GLIBC__)
TEST_CASE("memory of a hundred characters does not grow with the length of the take") {
    const auto world = World::create(furnishedWorld());
    const auto exporter = makeGltfExporter((exportFolder() / "long.glb").string());
    constexpr std::size_t kLong = 3000;
    REQUIRE(exporter->begin({"Long", 30.0, 0.0, kLong, &*world}).ok());
    const auto used = [] {
        const auto info = mallinfo2();
        return static_cast<std::int64_t>(info.uordblks + info.hblkhd);
    };
    const std::int64_t before = used();
    std::int64_t early = 0, most = 0;
    for (std::size_t k = 0; k < kLong; ++k) {
        const PretendFrame frame = pretendPeople(1, 101, static_cast<double>(k) / 30.0);
        const std::int64_t outside = used();
        REQUIRE(exporter->frame({k, static_cast<double>(k) / 30.0, frame.characters, &*world}).ok());
        (k < 200 ? early : most) = std::max(k < 200 ? early : most, used() - before);
        CHECK_MESSAGE(used() - outside < (k < 64 ? 8 << 20 : 1 << 16), "frame " << k);
    }
    MESSAGE("measured: " << (most >> 10) << " KiB for 100 characters, in takes of any length");
    CHECK(most <= early + (64 << 10));
    CHECK(most < (8 << 20));
    REQUIRE(exporter->finish().ok());
    // One track per character: 21 joints of 8 bytes, 2 positions of 12, 1 rotation of 16.
    const GltfReader file((exportFolder() / "long.glb").string());
    CHECK(file.json["buffers"][0]["byteLength"].get<std::size_t>() > 100 * kLong * 208);
    CHECK(distance(jointsIn(file, 100, kLong - 1)[8],
                   jointsOf(pretendPeople(100, 101, (kLong - 1) / 30.0).characters[0])[8].translation) <
          0.001f);
}
#endif
