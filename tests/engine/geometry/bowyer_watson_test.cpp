#include "engine/geometry/bowyer_watson.h"

#include <doctest.h>

#include <map>
#include <utility>

#include "base/random.h"
#include "engine/geometry/polygon.h"

using namespace muster;

namespace {

using Face = BowyerWatson::Face;

/// Live faces without ghosts.
std::vector<Face> trianglesOf(const BowyerWatson& mesh) {
    std::vector<Face> triangles;
    for (const Face& face : mesh.faces())
        if (face.alive && !BowyerWatson::isGhost(face)) triangles.push_back(face);
    return triangles;
}

/// Each neighbour shares the edge and names the face back.
void checkNeighbours(const BowyerWatson& mesh) {
    const auto& faces = mesh.faces();
    for (std::int32_t f = 0; f < std::ssize(faces); ++f) {
        if (!faces[f].alive) continue;
        for (int i = 0; i < 3; ++i) {
            const std::int32_t from = faces[f].vertex[(i + 1) % 3], to = faces[f].vertex[(i + 2) % 3];
            const std::int32_t g = faces[f].neighbour[i];
            REQUIRE(g >= 0);
            REQUIRE(faces[g].alive);
            int back = 0;
            for (int k = 0; k < 3; ++k) {
                if (faces[g].neighbour[k] != f) continue;
                if (faces[g].vertex[(k + 1) % 3] == to && faces[g].vertex[(k + 2) % 3] == from) ++back;
            }
            CHECK(back == 1);
        }
    }
}

/// No point of `points` lies inside the circumcircle of a triangle; each triangle turns left.
void checkDelaunay(const std::vector<Face>& triangles, const std::vector<Vec2>& points, std::int32_t count) {
    for (const Face& t : triangles) {
        const Vec2 a = points[t.vertex[0]], b = points[t.vertex[1]], c = points[t.vertex[2]];
        REQUIRE(orientation(a, b, c) == 1);
        for (std::int32_t k = 0; k < count; ++k) REQUIRE(inCircle(a, b, c, points[k]) <= 0);
    }
}

double areaOf(const std::vector<Face>& triangles, const std::vector<Vec2>& points) {
    double area = 0.0;
    for (const Face& t : triangles)
        area += 0.5 *
                cross(points[t.vertex[1]] - points[t.vertex[0]], points[t.vertex[2]] - points[t.vertex[0]]);
    return area;
}

double hullArea(const std::vector<Vec2>& points) {
    const Polygon hull = convexHull(points);
    double area = 0.0;
    for (std::size_t i = 0; i < hull.size(); ++i) area += 0.5 * cross(hull[i], hull[(i + 1) % hull.size()]);
    return area;
}

}  // namespace

TEST_CASE("after every insertion circumcircles are empty, the hull is filled and neighbours agree") {
    Random random(81);
    for (int round = 0; round < 12; ++round) {
        std::vector<Vec2> points(30);
        const bool lattice = round % 2 == 0;  // Many points on one circle or line.
        for (Vec2& p : points)
            p = lattice ? Vec2{1.0 * random.below(6), 1.0 * random.below(6)}
                        : Vec2{random.uniform(-4, 4), random.uniform(-4, 4)};
        points[0] = {0, 0};
        points[1] = {3, 1};
        points[2] = {1, 3};
        BowyerWatson mesh(points, {0, 1, 2});
        for (std::int32_t k = 3; k < std::ssize(points); ++k) {
            const bool repeated = std::find(points.begin(), points.begin() + k, points[k]) !=
                                  points.begin() + k;
            CHECK(mesh.insert(k) == !repeated);
            const std::vector<Vec2> inserted(points.begin(), points.begin() + k + 1);
            const auto triangles = trianglesOf(mesh);
            checkDelaunay(triangles, points, k + 1);
            CHECK(areaOf(triangles, points) == doctest::Approx(hullArea(inserted)));
        }
        checkNeighbours(mesh);
    }
}

TEST_CASE("the numbers of triangles, edges and hull edges obey Euler's formula") {
    Random random(82);
    std::vector<Vec2> points(200);
    for (Vec2& p : points) p = {random.uniform(0, 9), random.uniform(0, 9)};
    BowyerWatson mesh(points, {0, 1, 2});
    for (std::int32_t k = 3; k < 200; ++k) REQUIRE(mesh.insert(k));
    std::map<std::pair<std::int32_t, std::int32_t>, int> edges;
    const auto triangles = trianglesOf(mesh);
    for (const Face& t : triangles) {
        for (int i = 0; i < 3; ++i) {
            const std::int32_t a = t.vertex[i], b = t.vertex[(i + 1) % 3];
            ++edges[{std::min(a, b), std::max(a, b)}];
        }
    }
    std::ptrdiff_t hull = 0, ghosts = 0;
    for (const auto& [edge, count] : edges) hull += count == 1 ? 1 : 0;
    for (const Face& face : mesh.faces()) ghosts += face.alive && BowyerWatson::isGhost(face) ? 1 : 0;
    CHECK(ghosts == hull);
    CHECK(std::ssize(triangles) == 2 * 200 - 2 - hull);
    CHECK(std::ssize(edges) == 3 * 200 - 3 - hull);
    CHECK(hull == std::ssize(convexHull(points)));
    for (std::int32_t a = 0; a < 200; ++a) {
        for (std::int32_t b = a + 1; b < 200; ++b) {
            const bool joined = edges.count({a, b}) != 0;
            REQUIRE(mesh.hasEdge(a, b) == joined);
            REQUIRE(mesh.hasEdge(b, a) == joined);
        }
    }
}

TEST_CASE("a point added later is inserted like the others, and the first three may turn either way") {
    for (const std::array<std::int32_t, 3> first : {std::array{0, 1, 2}, std::array{0, 2, 1}}) {
        BowyerWatson mesh({{0, 0}, {4, 0}, {0, 4}}, first);
        CHECK(trianglesOf(mesh).size() == 1);
        const std::int32_t inside = mesh.addPoint({1, 1});
        CHECK(inside == 3);
        CHECK(trianglesOf(mesh).size() == 1);
        CHECK(mesh.insert(inside));
        CHECK(trianglesOf(mesh).size() == 3);
        CHECK(!mesh.insert(mesh.addPoint({1, 1})));
        CHECK(mesh.insert(mesh.addPoint({4, 4})));
        CHECK(areaOf(trianglesOf(mesh), mesh.points()) == doctest::Approx(16.0));
        CHECK(mesh.hasEdge(3, 5));  // (1, 1) lies inside the circle through the other three.
        checkNeighbours(mesh);
    }
}
