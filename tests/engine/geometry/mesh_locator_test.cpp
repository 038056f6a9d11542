// A locator gives what locate() gives, to the bit.
#include "engine/geometry/mesh_locator.h"

#include <doctest.h>

#include "base/random.h"
#include "engine/geometry/triangulation.h"

using namespace muster;

namespace {

bool sameBits(const MeshPoint& a, const MeshPoint& b) {
    return a.triangle == b.triangle && a.weight == b.weight;
}

TriangleMesh meshAt(Vec2 corner, double spacing) {
    const Vec2 a = corner;
    const auto mesh = triangulate({{a, a + Vec2{9, 0}, a + Vec2{12, 5}, a + Vec2{6, 9}, a + Vec2{0, 6}}, {}},
                                  spacing);
    REQUIRE(mesh.ok());
    return *mesh;
}

}  // namespace

TEST_CASE("a mesh locator gives the bits of locate(), inside, on edges, on vertices and outside") {
    Random random(5);
    for (const Vec2 corner : {Vec2{0, 0}, Vec2{-3.3, 0.7}, Vec2{1e4, -7e3}}) {
        const TriangleMesh mesh = meshAt(corner, 0.9);
        const MeshLocator locator(mesh.triangles, mesh.vertices);
        int wrong = 0;
        const auto compare = [&](Vec2 p) {
            if (!sameBits(locator.locate(p), locate(mesh.triangles, mesh.vertices, p))) ++wrong;
        };
        for (int k = 0; k < 2000; ++k)
            compare(corner + Vec2{random.uniform(-2.0, 14.0), random.uniform(-2.0, 11.0)});
        for (const Vec2 v : mesh.vertices) compare(v);
        for (const Triangle& t : mesh.triangles)
            for (const double share : {0.5, 1.0 / 3.0, 0.1, 1e-12})
                compare(lerp(mesh.vertices[t[0]], mesh.vertices[t[1]], share));
        CHECK(wrong == 0);
    }
}

TEST_CASE("a triangle holds its inside and its boundary, and nothing beside it") {
    const std::array<Vec2, 3> corner{Vec2{0, 0}, Vec2{4, 0}, Vec2{0, 2}};
    std::array<double, 3> weight{};
    CHECK(holds(corner, {1, 0.5}, weight));
    CHECK(weight[1] == doctest::Approx(0.25));
    CHECK(holds(corner, {2, 1}, weight));
    CHECK_FALSE(holds(corner, {2, 1.0001}, weight));
    CHECK_FALSE(holds(corner, {-5, 0}, weight));
    CHECK(squaredDistance(corner, {-3, -4}, weight) == doctest::Approx(25.0));
    CHECK(weight[0] == 1.0);
}
