// Meshes of a world's objects: they are closed, face outwards, and have the right size.
#include <doctest.h>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "files/export/pretend_take.h"
#include "files/export/scene_camera.h"
#include "files/export/scene_mesh.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Volume by the divergence theorem: correct only for closed meshes that face outwards.
double volumeOf(const std::vector<SceneSurface>& surfaces) {
    double sum = 0.0;
    for (const SceneSurface& s : surfaces)
        for (std::size_t i = 0; i + 2 < s.indices.size(); i += 3) {
            const Vec3 a = s.positions[s.indices[i]], b = s.positions[s.indices[i + 1]];
            sum += static_cast<double>(dot(a, cross(b, s.positions[s.indices[i + 2]]))) / 6.0;
        }
    return sum;
}

/// Area of the upward faces at a height, seen from above.
double areaAt(const std::vector<SceneSurface>& surfaces, Finish finish, float z) {
    double sum = 0.0;
    for (const SceneSurface& s : surfaces) {
        if (s.finish != finish) continue;
        for (std::size_t i = 0; i + 2 < s.indices.size(); i += 3) {
            const Vec3 a = s.positions[s.indices[i]], b = s.positions[s.indices[i + 1]];
            const Vec3 c = s.positions[s.indices[i + 2]];
            if (a.z == z && b.z == z && c.z == z) sum += 0.5 * static_cast<double>(cross(b - a, c - a).z);
        }
    }
    return sum;
}

const SceneThing& find(const std::vector<SceneThing>& things, const std::string& name) {
    for (const SceneThing& thing : things)
        if (thing.name == name) return thing;
    FAIL("nothing is called " << name);
    return things.front();
}

}  // namespace

TEST_CASE("normals are perpendicular to their triangles, on the side that they face") {
    const auto world = World::create(furnishedWorld());
    for (const SceneThing& thing : makeScene(*world)) {
        for (const SceneSurface& s : thing.surfaces) {
            REQUIRE(s.positions.size() == s.normals.size());
            REQUIRE(!s.indices.empty());
            for (std::size_t i = 0; i < s.indices.size(); i += 3) {
                const Vec3 a = s.positions[s.indices[i]], b = s.positions[s.indices[i + 1]];
                const Vec3 face = normalized(cross(b - a, s.positions[s.indices[i + 2]] - a));
                for (std::size_t k = 0; k < 3; ++k) {
                    const Vec3 normal = s.normals[s.indices[i + k]];
                    REQUIRE(length(normal) == doctest::Approx(1.0f).epsilon(1e-5));
                    REQUIRE_MESSAGE(dot(normal, face) > 0.7f, thing.name);
                }
            }
        }
    }
}

TEST_CASE("solids have the right volume") {
    const Polygon corner{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
    SceneMeshBuilder prism({2, 1});
    prism.prism(Finish::Wall, Finish::Roof, corner, 0.0, 2.5);
    // The bottom is open, but lies in the plane z = 0, where it adds nothing.
    CHECK(volumeOf(prism.take()) == doctest::Approx(6.0 * 2.5).epsilon(1e-5));
    SceneMeshBuilder cone({});
    cone.frustum(Finish::Stone, {0, 0, 0}, 3.0, 2.0, 1.0, 200);
    CHECK(volumeOf(cone.take()) == doctest::Approx(kPi * 3.0 / 3.0 * (4.0 + 2.0 + 1.0)).epsilon(1e-3));
    SceneMeshBuilder beam({});
    beam.beam(Finish::Net, {1, 2, 3}, {4, 6, 3}, 0.2);
    CHECK(volumeOf(beam.take()) == doctest::Approx(5.0 * 0.04).epsilon(1e-4));
    SceneMeshBuilder ball({});
    ball.blob(Finish::Crown, {0, 0, 4}, 1.0, 1.0, 5, 24, 24);
    const double volume = volumeOf(ball.take());
    CHECK(volume > 0.88 * 0.88 * 0.88 * 4.0);
    CHECK(volume < 1.08 * 1.08 * 1.08 * 4.2);
}

TEST_CASE("the ground has a hole where the pool is, and the pool a bottom") {
    const auto world = World::create(furnishedWorld());
    const auto things = makeScene(*world);
    const Box box = inspect::environment(*world).def().box.grown(40.0);
    const double whole = box.width() * box.height();
    CHECK(areaAt(find(things, "Ground").surfaces, Finish::Ground, 0.0f) ==
          doctest::Approx(whole - 30.0).epsilon(1e-5));
    const SceneThing& pool = find(things, "Pool");
    CHECK(areaAt(pool.surfaces, Finish::Tile, -1.15f) == doctest::Approx(30.0).epsilon(1e-5));
    CHECK(areaAt(pool.surfaces, Finish::Water, -0.1f) == doctest::Approx(30.0).epsilon(1e-5));
}

TEST_CASE("pools that overlap lie on ground without holes") {
    WorldDef def = furnishedWorld();
    def.patches.push_back(def.patches[0]);
    const auto world = World::create(def);
    const auto things = makeScene(*world);
    const Box box = inspect::environment(*world).def().box.grown(40.0);
    CHECK(areaAt(find(things, "Ground").surfaces, Finish::Ground, 0.0f) ==
          doctest::Approx(box.width() * box.height()).epsilon(1e-5));
    for (const char* name : {"Pool", "Pool 2"}) {
        const auto& surfaces = find(things, name).surfaces;
        CHECK(areaAt(surfaces, Finish::Tile, -1.15f) == 0.0);
        CHECK(surfaces.front().finish == Finish::Water);
    }
    CHECK(areaAt(find(things, "Pool").surfaces, Finish::Water, 0.006f) ==
          doctest::Approx(30.0).epsilon(1e-5));
    // One of them lies higher where they overlap.
    CHECK(find(things, "Pool 2").surfaces.front().positions.front().z > 0.0065f);
}

TEST_CASE("every motion has its own floor, and every object its own name") {
    WorldDef def = furnishedWorld();
    def.patches.clear();
    const auto clips = defaultClipFacts();
    for (MotionId m = 0; m < static_cast<MotionId>(clips.size()); ++m) {
        PatchDef patch{.motion = m};
        const double x = -18.0 + 4.0 * m;
        patch.polygon = {{x, -3}, {x + 3, -3}, {x + 3, 3}, {x, 3}};
        def.patches.push_back(patch);
    }
    const auto world = World::create(def);
    REQUIRE(world.ok());
    const auto things = makeScene(*world);
    CHECK(things.size() == 1 + def.obstacles.size() + def.patches.size());
    for (std::size_t i = 0; i < things.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) CHECK(things[i].name != things[k].name);
}

TEST_CASE("exits, sources and waiting areas lie flat above all other floors, by their names") {
    WorldDef def = furnishedWorld();
    AreaDef area{.name = "Yard", .polygon = {{-10, -3}, {-8, -3}, {-8, 0}, {-10, 0}}};
    def.areas = {area, area, area};
    def.areas[1].kind = AreaKind::Source;
    def.areas[2].kind = AreaKind::Waiting;
    def.areas[2].name.clear();
    const auto world = World::create(def);
    REQUIRE(world.ok());
    const auto things = makeScene(*world);
    CHECK(areaAt(find(things, "Yard").surfaces, Finish::Exit, 0.0165f) == doctest::Approx(6.0).epsilon(1e-5));
    CHECK(find(things, "Yard 2").surfaces.front().finish == Finish::Source);
    CHECK(find(things, "Waiting area").surfaces.front().finish == Finish::Waiting);
}

TEST_CASE("a camera sees all points, and is no farther away than necessary") {
    CameraFit fit;
    const std::vector<Vec3> points{{-20, 3, 0}, {15, -8, 1.8f}, {4, 22, 0}, {9, 9, 1.8f}, {30, 1, 0}};
    for (const Vec3 p : points) fit.add(p);
    const SceneCamera c = fit.camera();
    const double slope = std::tan(0.5 * c.fieldOfView);
    double widest = 0.0;
    for (const Vec3 p : points) {
        const Vec3 d = p - c.eye;
        const double deep = static_cast<double>(dot(d, c.forward));
        REQUIRE(deep > 0.1);
        CHECK(deep < c.farthest);
        widest = std::max({widest, std::fabs(static_cast<double>(dot(d, c.up))) / (deep * slope),
                           std::fabs(static_cast<double>(dot(d, c.right))) / (deep * slope * c.aspect)});
    }
    CHECK(widest < 0.93);
    CHECK(widest > 0.91);
    CHECK(static_cast<double>(c.forward.z) == doctest::Approx(-std::sin(46.0 * kPi / 180.0)).epsilon(1e-5));
    CHECK(c.fieldOfView == doctest::Approx(24.0 * kPi / 180.0));
    CHECK(length(cross(c.right, c.up) + c.forward) < 1e-5f);
}

TEST_CASE("colours in linear light") {
    CHECK(linearColour(0xFFFFFF) == Vec3{1.0f, 1.0f, 1.0f});
    CHECK(linearColour(0x000000) == Vec3{});
    const Vec3 grey = linearColour(0x808080);
    CHECK(static_cast<double>(grey.x) == doctest::Approx(0.2159).epsilon(1e-3));
    CHECK(static_cast<double>(linearColour(0x0A0000).x) ==
          doctest::Approx(10.0 / 255.0 / 12.92).epsilon(1e-5));
}
