#include "engine/formation/shapes/make_formation.h"

#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "base/random.h"

using namespace muster;

namespace {

std::vector<Vec2> placesOf(const Formation& formation) {
    std::vector<Vec2> places;
    for (const MeshPoint& p : formation.places)
        places.push_back(p.position(formation.mesh.triangles, formation.mesh.vertices));
    return places;
}

// Distance of each place to its nearest neighbour, by looking at all pairs near in x.
std::vector<double> nearestDistances(const std::vector<Vec2>& places) {
    std::vector<std::size_t> order(places.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return places[a].x < places[b].x; });
    std::vector<double> nearest(places.size(), 1e300);
    for (std::size_t a = 0; a < order.size(); ++a) {
        for (std::size_t b = a + 1; b < order.size(); ++b) {
            if (places[order[b]].x - places[order[a]].x > nearest[order[a]] &&
                places[order[b]].x - places[order[a]].x > 8.0)
                break;
            const double d = distance(places[order[a]], places[order[b]]);
            nearest[order[a]] = std::min(nearest[order[a]], d);
            nearest[order[b]] = std::min(nearest[order[b]], d);
        }
    }
    return nearest;
}

// Number of pieces that the mesh falls into when triangles are joined by edges.
std::size_t pieces(const TriangleMesh& mesh) {
    std::vector<std::size_t> label(mesh.triangles.size());
    for (std::size_t k = 0; k < label.size(); ++k) label[k] = k;
    for (bool changed = true; changed;) {
        changed = false;
        std::vector<std::pair<std::pair<int, int>, std::size_t>> edges;
        for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
            for (std::size_t i = 0; i < 3; ++i)
                edges.push_back({std::minmax(mesh.triangles[k][i], mesh.triangles[k][(i + 1) % 3]), k});
        std::sort(edges.begin(), edges.end());
        for (std::size_t e = 1; e < edges.size(); ++e) {
            if (edges[e].first != edges[e - 1].first) continue;
            std::size_t& a = label[edges[e].second];
            std::size_t& b = label[edges[e - 1].second];
            if (a != b) a = b = std::min(a, b), changed = true;
        }
    }
    std::sort(label.begin(), label.end());
    return std::unique(label.begin(), label.end()) - label.begin();
}

void checkFormation(const FormationDef& def, std::int32_t count) {
    CAPTURE(std::string(formationName(def.kind)));
    CAPTURE(count);
    CAPTURE(def.spacing);
    CAPTURE(def.opening);
    const Result<Formation> made = makeFormation(def, count);
    REQUIRE_MESSAGE(made.ok(), made.status().message());
    const Formation& formation = *made;
    REQUIRE(formation.places.size() == static_cast<std::size_t>(count));
    CHECK(formation.mesh.vertices.size() <= 420);
    const std::vector<Vec2> places = placesOf(formation);
    for (const MeshPoint& p : formation.places) {
        REQUIRE(*std::min_element(p.weight.begin(), p.weight.end()) >= -1e-9);
        REQUIRE(p.weight[0] + p.weight[1] + p.weight[2] == doctest::Approx(1.0));
    }
    Vec2 mean;
    for (const Vec2 p : places) mean += p / count;
    CHECK(length(mean) < 1e-9 * def.spacing * count);
    if (count > 1) {
        const std::vector<double> nearest = nearestDistances(places);
        const auto [least, most] = std::minmax_element(nearest.begin(), nearest.end());
        CHECK(*least >= 0.8 * def.spacing);
        CHECK(*most <= 1.3 * def.spacing);
    }
    for (std::size_t k = 1; k < places.size(); ++k) {
        const double back = places[k - 1].x - places[k].x;
        REQUIRE(back >= -1e-5 * def.spacing);
        if (std::fabs(back) < 1e-8 * def.spacing) REQUIRE(places[k - 1].y < places[k].y);
    }
    CHECK(pieces(formation.mesh) == 1);
}

PolygonWithHoles letterE() {
    return {{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 3}, {1, 3}, {1, 4}, {4, 4}, {4, 5}, {0, 5}},
            {}};
}

PolygonWithHoles frame() {
    return {{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{{2, 2}, {2, 4}, {4, 4}, {4, 2}}}};
}

}  // namespace

TEST_CASE("named shapes hold any count evenly") {
    for (int kind = 0; kind < 8; ++kind) {
        FormationDef def{.kind = static_cast<FormationKind>(kind)};
        for (const std::int32_t count : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 20, 36, 37, 100, 1000})
            checkFormation(def, count);
    }
}

TEST_CASE("random counts, spacings and openings") {
    Random random(7);
    for (int k = 0; k < 300; ++k) {
        FormationDef def{.kind = static_cast<FormationKind>(random.below(8)),
                         .spacing = random.uniform(0.3, 4.0),
                         .opening = random.uniform(0.05, 5.9)};
        checkFormation(def, 1 + static_cast<std::int32_t>(random.below(400)));
    }
}

TEST_CASE("ten thousand places") {
    for (int kind = 0; kind < 8; ++kind) {
        FormationDef def{.kind = static_cast<FormationKind>(kind)};
        checkFormation(def, 10000);
    }
}

TEST_CASE("outlines of letters and frames hold the count") {
    for (const PolygonWithHoles& outline : {letterE(), frame()}) {
        for (const std::int32_t count : {1, 2, 3, 7, 36, 37, 100, 1000, 10000}) {
            FormationDef def{.kind = FormationKind::Outline, .spacing = 1.2, .outline = outline};
            checkFormation(def, count);
        }
    }
}

TEST_CASE("the square of a square number is an exact lattice") {
    const Result<Formation> made = makeFormation({}, 36);
    REQUIRE(made.ok());
    const std::vector<Vec2> places = placesOf(*made);
    for (std::size_t k = 0; k < 36; ++k) {
        CHECK(places[k].x == doctest::Approx(2.5 - static_cast<double>(k / 6)).epsilon(1e-12));
        CHECK(places[k].y == doctest::Approx(-2.5 + static_cast<double>(k % 6)).epsilon(1e-12));
    }
    const Box box = boundsOf(made->mesh.vertices);
    CHECK(box.width() == doctest::Approx(6.0));
    CHECK(box.height() == doctest::Approx(6.0));
}

TEST_CASE("shapes have the geometry that their names say") {
    const auto box = [](FormationKind kind, std::int32_t count) {
        FormationDef def{.kind = kind};
        return boundsOf(placesOf(*makeFormation(def, count)));
    };
    CHECK(box(FormationKind::Line, 40).height() == doctest::Approx(19.0));
    CHECK(box(FormationKind::Line, 40).width() == doctest::Approx(1.0));
    CHECK(box(FormationKind::Column, 40).width() == doctest::Approx(19.0));
    FormationDef def{.kind = FormationKind::Wedge};
    const std::vector<Vec2> wedge = placesOf(*makeFormation(def, 55));
    CHECK(wedge[0].y == doctest::Approx(0.0));
    CHECK(wedge[0].x > wedge[1].x + 0.5);
    def.kind = FormationKind::Ring;
    for (const Vec2 p : placesOf(*makeFormation(def, 60))) CHECK(length(p) > 2.5);
    def.kind = FormationKind::Pacman;
    const Formation pacman = *makeFormation(def, 200);
    Vec2 leftmost;
    for (const Vec2 p : placesOf(pacman)) leftmost.x = std::min(leftmost.x, p.x);
    // The mouth is open at the front: nobody stands on the axis there, and the mesh leaves it free.
    double front = -1e9;
    for (const Vec2 p : placesOf(pacman))
        if (std::fabs(p.y) < 0.4) front = std::max(front, p.x);
    CHECK(front < 2.0);
    const Vec2 mouth{-leftmost.x - 1.0, 0.0};
    const MeshPoint near = locate(pacman.mesh.triangles, pacman.mesh.vertices, mouth);
    CHECK(distance(near.position(pacman.mesh.triangles, pacman.mesh.vertices), mouth) > 0.5);
}

TEST_CASE("explicit points keep their exact positions and order") {
    Random random(3);
    FormationDef def{.kind = FormationKind::Points};
    for (const std::size_t count : {1u, 2u, 3u, 50u}) {
        def.points.clear();
        for (std::size_t k = 0; k < count; ++k)
            def.points.push_back({random.uniform(5, 25), random.uniform(-10, 10)});
        const Result<Formation> made = makeFormation(def, static_cast<std::int32_t>(count));
        REQUIRE(made.ok());
        const std::vector<Vec2> places = placesOf(*made);
        for (std::size_t k = 0; k < count; ++k) CHECK(distance(places[k], def.points[k]) < 1e-12 * 30);
    }
    def.points = {{0, 0}, {1, 0}, {2, 0}};
    CHECK(makeFormation(def, 3).ok());
    CHECK(makeFormation(def, 2)->places.size() == 2);
    CHECK(makeFormation(def, 4).status().code() == StatusCode::InvalidArgument);
}

TEST_CASE("bad definitions name the culprit") {
    FormationDef def;
    CHECK(makeFormation(def, 0).status().message().find("count 0") != std::string::npos);
    def.spacing = -1;
    CHECK(makeFormation(def, 4).status().message().find("spacing") != std::string::npos);
    def.spacing = std::nan("");
    CHECK_FALSE(makeFormation(def, 4).ok());
    def = {};
    def.kind = FormationKind::Pacman;
    def.opening = 6.5;
    CHECK(makeFormation(def, 4).status().message().find("opening") != std::string::npos);
    def = {};
    def.kind = FormationKind::Outline;
    CHECK(makeFormation(def, 4).status().message().find("outline") != std::string::npos);
    def.outline.outline = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    CHECK_FALSE(makeFormation(def, 4).ok());
    def.outline = frame();
    for (Vec2& p : def.outline.holes[0]) p.x += 10;
    CHECK_FALSE(makeFormation(def, 4).ok());
    def = {};
    def.kind = FormationKind::Points;
    def.points = {{0, 0}, {std::nan(""), 0}};
    CHECK(makeFormation(def, 2).status().message().find("point 1") != std::string::npos);
}

TEST_CASE("names and kinds") {
    for (int kind = 0; kind < 10; ++kind) {
        const auto k = static_cast<FormationKind>(kind);
        CHECK(*formationKind(formationName(k)) == k);
    }
    CHECK(formationKind("blob").status().code() == StatusCode::NotFound);
    CHECK(formationKind("blob").status().message().find("pacman") != std::string::npos);
}
