#include "engine/formation/mesh/formation_mesh.h"

#include "engine/formation/mesh_fixture.h"

using namespace muster;
using namespace muster::test;

namespace {

// Deviation from a rigid placement after the four corners were dragged as in the paper's figure 2:
// both right corners forward and inwards, in groups that make points, lines or one area.
double dragCorners(int fingersPerControl) {
    Stage s(square(100));
    s.parameters.input.window = 0.05;
    const Vec2 corners[4] = {{5, 5}, {5, -5}, {-5, 5}, {-5, -5}};
    const Vec2 moves[4] = {{1, 3}, {2, 3}, {0, -1}, {-1, 0}};
    for (std::uint32_t t = 0; t < 4; ++t) {
        if (t % static_cast<std::uint32_t>(fingersPerControl) == 0) s.time += 1.0;
        REQUIRE(s.down(t, corners[t]));
    }
    for (std::uint32_t t = 0; t < 4; ++t) REQUIRE(s.move(t, corners[t] + moves[t]));
    s.run(6.0);
    const std::size_t expected = 4 / fingersPerControl;
    CHECK(s.controls.controls().size() == expected);
    // Rigidity as a number: how evenly the section follows its corners, that is how far edges of the mesh
    // leave the affine map that the corners' drag asks for.
    const TriangleMesh& rest = s.mesh.formation().mesh;
    double sum = 0.0;
    for (std::size_t v = 0; v < rest.vertices.size(); ++v) {
        const double x = (rest.vertices[v].x + 5.0) / 10.0;
        const double y = (rest.vertices[v].y + 5.0) / 10.0;
        const Vec2 bilinear = rest.vertices[v] + moves[0] * (x * y) + moves[1] * (x * (1 - y)) +
                              moves[2] * ((1 - x) * y) + moves[3] * ((1 - x) * (1 - y));
        sum += lengthSquared(s.mesh.userMesh()[v] - bilinear);
    }
    return std::sqrt(sum / static_cast<double>(rest.vertices.size()));
}

// The worst difference of an edge's length from the rest shape among edges for which `wanted`.
template <class Wanted>
double stretch(const Stage& s, Wanted wanted) {
    const TriangleMesh& rest = s.mesh.formation().mesh;
    double worst = 0.0;
    for (const Triangle& t : rest.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t a = t[k];
            const std::int32_t b = t[(k + 1) % 3];
            if (!wanted(rest.vertices[a]) || !wanted(rest.vertices[b])) continue;
            const double before = distance(rest.vertices[a], rest.vertices[b]);
            worst = std::max(worst,
                             std::fabs(distance(s.mesh.userMesh()[a], s.mesh.userMesh()[b]) / before - 1.0));
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("figure 2: the same drag binds the mesh more as points, lines and area") {
    const double point = dragCorners(1), line = dragCorners(2), area = dragCorners(4);
    MESSAGE("rms distance from the shape that follows its corners evenly: point "
            << point << " m, line " << line << " m, area " << area << " m");
    CHECK(point > 1.1 * line);
    CHECK(line > 1.1 * area);
}

TEST_CASE("figure 3: a line bends the left half, an area keeps the right half") {
    Stage s(square(100));
    REQUIRE(s.down(1, {-5, 5}));
    REQUIRE(s.down(2, {-5, -5}));
    s.run(0.3);
    const Vec2 area[4] = {{1, 5}, {5, 5}, {5, -5}, {1, -5}};
    for (std::uint32_t t = 0; t < 4; ++t) REQUIRE(s.down(3 + t, area[t]));
    REQUIRE(s.controls.controls().size() == 2);
    REQUIRE(s.move(1, {-3, 8}));
    REQUIRE(s.move(2, {-7, -1}));
    s.run(6.0);
    const double left = stretch(s, [](Vec2 p) { return p.x <= 1.01; });
    const double right = stretch(s, [](Vec2 p) { return p.x >= 0.99; });
    MESSAGE("worst stretch of an edge: left half " << left << ", right half " << right);
    CHECK(left > 0.4);
    CHECK(right < left / 3.0);
}

TEST_CASE("one control translates the mesh without lag and keeps its orientation exactly") {
    Stage s(square(), poseOf(0.6, {4, 5}));
    const std::vector<Vec2> before = s.mesh.userMesh();
    REQUIRE(s.down(1, before[0]));
    s.step();
    Vec2 finger = before[0];
    for (int k = 0; k < 200; ++k) {
        finger += Vec2{0.01, -0.015};
        REQUIRE(s.move(1, finger));
        s.step();
        for (std::size_t v = 0; v < before.size(); ++v)
            REQUIRE(distance(s.mesh.userMesh()[v] - before[v], finger - before[0]) < 1e-9);
    }
}

TEST_CASE("after release the mesh recovers its rest shape where it stands") {
    Stage s;
    REQUIRE(s.down(1, {3, 3}));
    REQUIRE(s.down(2, {-3, -3}));
    s.move(1, {6, 1});
    s.move(2, {-2, -5});
    s.run(4.0);
    const double bent = s.deviation();
    CHECK(bent > 0.3);
    const Pose fit = bestRigidFit(s.mesh.formation().mesh.vertices, s.mesh.userMesh());
    s.up(1);
    s.up(2);
    s.run(1.0);
    CHECK(s.deviation() < 0.05 * bent);
    s.run(3.0);
    double worst = 0.0;
    for (std::size_t v = 0; v < s.mesh.userMesh().size(); ++v)
        worst = std::max(worst,
                         distance(s.mesh.userMesh()[v], fit.apply(s.mesh.formation().mesh.vertices[v])));
    CHECK(worst < 1e-9);
}

TEST_CASE("vertices never jump when controls begin, end and change kind") {
    Random random(17);
    Stage s(square(64));
    double fastest = 0.0;
    std::uint32_t touch = 0;
    std::vector<std::uint32_t> down;
    for (int k = 0; k < 150; ++k) {
        // Drag the controls, and wait until they have arrived.
        for (const std::uint32_t t : down)
            for (const Control& control :
                 std::vector<Control>(s.controls.controls().begin(), s.controls.controls().end()))
                for (const ControlPoint& p : control.points)
                    if (p.touch == t && p.down)
                        s.move(t, p.position - p.offset +
                                      Vec2{random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4)});
        s.run(0.4 + (random.below(3) == 0 ? 1.0 : 0.1));
        // Then only the set of controls changes, so vertices move by the bounded decay of residuals only.
        for (std::uint32_t n = random.below(3); n > 0; --n) {
            const Vec2 p = s.vertex(static_cast<std::int32_t>(
                random.below(static_cast<std::uint32_t>(s.mesh.userMesh().size()))));
            if (down.size() < 5 && s.down(++touch, p)) down.push_back(touch);
            if (random.below(3) == 0) fastest = std::max(fastest, s.step());
        }
        while (!down.empty() && random.below(2) == 0) {
            s.up(down.back());
            down.pop_back();
        }
        fastest = std::max(fastest, s.run(0.2));
    }
    MESSAGE("fastest vertex at changes " << fastest << " m/s");
    CHECK(fastest > 0.1);
    CHECK(fastest <= s.parameters.mesh.morphSpeed + 1e-6);
}

TEST_CASE("held vertices stay on their targets when others are released") {
    Stage s;
    s.parameters.input.window = 0.0;
    REQUIRE(s.down(1, {3, 3}));
    s.time += 1;
    REQUIRE(s.down(2, {-3, -3}));
    s.move(1, {5, 4});
    s.run(3.0);
    s.up(2);
    for (int k = 0; k < 60; ++k) {
        s.step();
        CHECK(distance(s.vertex(s.controls.controls()[0].points[0].vertex), {5, 4}) < 1e-9);
    }
}

TEST_CASE("repeated deformations do not change the rest shape") {
    Stage s;
    for (int k = 0; k < 40; ++k) {
        REQUIRE(s.down(1, s.vertex(0)));
        REQUIRE(s.down(2, s.vertex(20)));
        s.move(1, s.vertex(0) + Vec2{0.5, 0.7});
        s.run(0.4);
        s.up(1);
        s.up(2);
        s.run(1.5);
    }
    s.run(3.0);
    CHECK(s.deviation() < 1e-9);
}

TEST_CASE("a change of formation keeps position and orientation") {
    Stage s(square(), poseOf(1.0, {7, -2}));
    FormationDef def{.kind = FormationKind::Wedge};
    REQUIRE(s.mesh.change(*makeFormation(def, 36)).ok());
    std::vector<Vec2> places;
    s.mesh.placePositions(places);
    CHECK(places.size() == 36);
    Vec2 mean;
    for (const Vec2 p : places) mean += p / 36.0;
    CHECK(distance(mean, {7, -2}) < 1e-9);
    CHECK(s.mesh.pose().rotation.s == doctest::Approx(sine(1.0)));
    Formation bad = square();
    bad.places[3].triangle = 999;
    CHECK(s.mesh.change(bad).message().find("place 3") != std::string::npos);
    CHECK(s.mesh.formation().places.size() == 36);
    CHECK(s.mesh.formation().mesh.vertices.size() == s.mesh.userMesh().size());
    CHECK_FALSE(s.mesh.reset(square(), {{std::nan(""), 0}, {}}).ok());
    s.mesh.setPose(poseOf(0.2, {1, 1}));
    s.mesh.placePositions(places);
    mean = {};
    for (const Vec2 p : places) mean += p / 36.0;
    CHECK(distance(mean, {1, 1}) < 1e-9);
}

TEST_CASE("vertices leave obstacles; displacements are bounded, decay and end") {
    EnvironmentDef world;
    Environment environment = *Environment::create(world);
    ObstacleDef disc{.centre = {0.3, 0.2}, .radius = 1.3};
    const ObstacleId id = *environment.addObstacle(disc);
    environment.setTime(0.0);
    Stage s(square(49));
    std::vector<Vec2> last = s.mesh.finalMesh();
    for (int k = 0; k < 120; ++k) {
        s.step();
        s.mesh.applyEnvironment(s.parameters.field, environment, kStep);
        for (std::size_t v = 0; v < last.size(); ++v) {
            REQUIRE(environment.distanceToObstacle(s.mesh.finalMesh()[v]) > -1e-9);
            // Outside the obstacle from the first step on, the bound holds.
            if (k > 0 && distance(last[v], disc.centre) > 1.4)
                CHECK(distance(last[v], s.mesh.finalMesh()[v]) <= s.parameters.field.speed * kStep + 1e-9);
        }
        last = s.mesh.finalMesh();
    }
    REQUIRE(environment.removeObstacle(id).ok());
    for (int k = 0; k < 240; ++k) s.mesh.applyEnvironment(s.parameters.field, environment, kStep);
    CHECK(s.mesh.finalMesh() == s.mesh.userMesh());
    Parameters::Field off = s.parameters.field;
    off.enabled = false;
    s.mesh.applyEnvironment(off, environment, kStep);
    CHECK(s.mesh.finalMesh() == s.mesh.userMesh());
}

TEST_CASE("a mesh that is saved in the middle of a deformation and restored continues with the same bits") {
    Stage s;
    s.down(1, {3, 3});
    s.down(2, {-3, 3});
    s.move(1, {6, 6});
    s.run(0.4);
    Writer writer;
    writer(s.mesh);
    FormationMesh copy;
    Reader reader(writer.bytes());
    reader(copy);
    REQUIRE(reader.ok());
    for (int k = 0; k < 120; ++k) {
        if (k == 40) s.up(1);
        if (k == 60) s.up(2);
        s.step();
        REQUIRE(copy.deform(s.parameters.mesh, s.parameters.control, s.controls, kStep).ok());
    }
    CHECK(hashOf(copy) == hashOf(s.mesh));
    std::vector<std::uint8_t> broken = writer.bytes();
    broken[4] = 7;  // A coordinate or a length: either it reads as another mesh or it is refused.
    Reader again(broken);
    FormationMesh other;
    again(other);
    broken.resize(broken.size() - 9);
    Reader cut(broken);
    cut(other);
    CHECK_FALSE(cut.ok());
}
