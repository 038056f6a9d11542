#include "engine/formation/control/control_set.h"

#include "engine/formation/mesh_fixture.h"

using namespace muster;
using namespace muster::test;

namespace {
const Vec2 kCorners[4] = {{3, 3}, {-3, 3}, {-3, -3}, {3, -3}};
const double kNaN = std::nan("");
}  // namespace

TEST_CASE("touches within the window become point, line and area") {
    Stage s;
    REQUIRE(s.down(1, {3, 3}));
    CHECK(s.controls.controls()[0].kind == ControlKind::Point);
    s.step();
    REQUIRE(s.down(2, {-3, 3}));
    CHECK(s.controls.controls().size() == 1);
    CHECK(s.controls.controls()[0].kind == ControlKind::Line);
    CHECK(s.controls.controls()[0].supplementary.size() == 5);
    s.step();
    REQUIRE(s.down(3, {-3, -3}));
    CHECK(s.controls.controls()[0].kind == ControlKind::Area);
    REQUIRE(s.down(4, {3, -3}));
    const Control& area = s.controls.controls()[0];
    CHECK(area.kind == ControlKind::Area);
    CHECK(area.points.size() == 4);
    CHECK(area.supplementary.size() >= 20 + 25);
    CHECK(area.weights.size() == 4 * area.supplementary.size());
}

TEST_CASE("later touches, other clients and lifted fingers make controls of their own") {
    Stage s;
    s.parameters.input.window = 0.1;
    REQUIRE(s.down(1, {3, 3}));
    REQUIRE(s.down(1, {-3, 3}, 2));  // The same number of another client.
    CHECK(s.controls.controls().size() == 2);
    s.run(0.2);
    REQUIRE(s.down(2, {-3, -3}));
    CHECK(s.controls.controls().size() == 3);
    CHECK(s.up(2));
    REQUIRE(s.down(3, {3, -3}));
    CHECK(s.controls.controls().size() == 4);
    for (const Control& control : s.controls.controls()) CHECK(control.kind == ControlKind::Point);
}

TEST_CASE("invalid touches are refused") {
    Stage s;
    REQUIRE(s.down(1, {3, 3}));
    CHECK_FALSE(s.down(1, {-3, 3}));
    CHECK_FALSE(s.down(2, {3.1, 3.1}));  // The same vertex.
    CHECK_FALSE(s.down(3, {kNaN, 0}));
    CHECK_FALSE(s.move(1, {INFINITY, 0}));
    CHECK_FALSE(s.move(9, {0, 0}));
    CHECK_FALSE(s.up(9));
    CHECK_FALSE(s.controls.touchDown({}, 1, 5, {0, 0}, kNaN, s.mesh.formation().mesh, s.mesh.userMesh()));
    CHECK_FALSE(s.controls.touchDown({}, 1, 5, {0, 0}, 0.0, {}, {}));
    CHECK_FALSE(s.controls.setPinned(ControlId{77}, true));
    CHECK_FALSE(s.controls.remove(ControlId{77}));
    const std::uint32_t touches[2] = {7, 8};
    const Vec2 positions[2] = {{-3, 3}, {-3, -3}};
    CHECK_FALSE(s.controls.addControl(1, ControlKind::Area, touches, positions, 0.0, s.mesh.formation().mesh,
                                      s.mesh.userMesh()));
    CHECK(s.controls.addControl(1, ControlKind::Line, touches, positions, 0.0, s.mesh.formation().mesh,
                                s.mesh.userMesh()));
    CHECK_FALSE(s.controls.addControl(1, ControlKind::Line, touches, positions, 0.0, s.mesh.formation().mesh,
                                      s.mesh.userMesh()));
}

TEST_CASE("fingers and controls are limited") {
    Stage s(square(400));
    s.parameters.input.window = 0.0;
    std::int32_t taken = 0;
    for (std::uint32_t k = 0; k < 40; ++k) {
        s.time += 1.0;
        taken += s.down(k, s.vertex(static_cast<std::int32_t>(k))) ? 1 : 0;
    }
    CHECK(taken == 32);
    for (std::uint32_t k = 0; k < 60; ++k) {
        s.time += 1.0;
        taken += s.down(k, s.vertex(static_cast<std::int32_t>(40 + k)), 2 + k) ? 1 : 0;
    }
    CHECK(taken == 64);
}

TEST_CASE("a small drag is followed at once, without a jump at touch down") {
    Stage s;
    const Vec2 before = s.vertex(s.nearest({3, 3}));
    REQUIRE(s.down(1, {3.2, 2.9}));
    s.step();
    CHECK(distance(s.vertex(s.nearest({3, 3})), before) < 1e-12);
    REQUIRE(s.move(1, {3.21, 2.9}));
    s.step();
    CHECK(distance(s.vertex(s.nearest({3, 3})), before + Vec2{0.01, 0}) < 1e-12);
}

TEST_CASE("trajectories are cut into checkpoints of fixed spacing with interpolated times") {
    Stage s;
    REQUIRE(s.down(1, {3, 3}));
    s.time = 4.0;
    REQUIRE(s.move(1, {5.2, 3}));
    const std::vector<Checkpoint>& path = s.controls.controls()[0].points[0].trajectory;
    REQUIRE(path.size() == 5);
    for (std::size_t k = 0; k < 4; ++k)
        CHECK(path[k].position.x == doctest::Approx(3.5 + 0.5 * static_cast<double>(k)));
    CHECK(path[4].position.x == doctest::Approx(5.2));
    s.time = 8.0;
    REQUIRE(s.move(1, {7.2, 3}));
    // From 5.2 m at 4 s to 7.2 m at 8 s: 6.0 m is passed at 5.6 s.
    CHECK(path[5].position.x == doctest::Approx(6.0));
    CHECK(path[5].time == doctest::Approx(5.6));
    for (std::size_t k = 1; k < path.size(); ++k) CHECK(path[k].time >= path[k - 1].time);
}

TEST_CASE("control points keep the speed bound, wait at pace 0, and follow the trajectory after lifting") {
    Stage s;
    REQUIRE(s.down(1, {3, 3}));
    s.step();
    REQUIRE(s.move(1, {3, 9}));
    const std::int32_t v = s.nearest({3, 3});
    const Vec2 stopped = s.vertex(v);
    s.run(0.5, 0.0);
    CHECK(distance(s.vertex(v), stopped) < 1e-12);
    REQUIRE(s.up(1));
    double fastest = 0.0;
    Vec2 last = s.vertex(v);
    int steps = 0;
    while (!s.controls.controls().empty() && steps < 1000) {
        s.step(0.5);
        fastest = std::max(fastest, distance(s.vertex(v), last) / kStep);
        last = s.vertex(v);
        ++steps;
    }
    CHECK(distance(last, {3, 9}) < 1e-9);
    CHECK(fastest <= 0.5 * s.parameters.control.speed + 1e-9);
    CHECK(steps * kStep == doctest::Approx(6.0 / 0.8).epsilon(0.02));
}

TEST_CASE("a slow drawing is followed at the speed it was drawn") {
    Stage s;
    REQUIRE(s.down(1, {3, 3}));
    for (int k = 1; k <= 120; ++k) {
        REQUIRE(s.move(1, {3 + k * 0.005, 3}));
        s.step();
        CHECK(s.controls.controls()[0].points[0].position.x == doctest::Approx(3 + k * 0.005));
    }
}

TEST_CASE("both ends of a line move on one clock") {
    Stage s;
    REQUIRE(s.down(1, {3, 3}));
    REQUIRE(s.down(2, {3, -3}));
    // One end draws three times the way of the other in the same time; all at once, ahead of the crowd.
    for (int k = 1; k <= 30; ++k) {
        s.time += kStep;
        REQUIRE(s.move(1, {3 + k * 0.3, 3}));
        REQUIRE(s.move(2, {3 + k * 0.1, -3}));
    }
    const Control& line = s.controls.controls()[0];
    for (int k = 0; k < 200; ++k) {
        s.step();
        CHECK(line.points[0].position.x - 3 ==
              doctest::Approx(3 * (line.points[1].position.x - 3)).epsilon(1e-6));
    }
    CHECK(line.points[0].position.x > 8.0);
}

TEST_CASE("pauses drawn while the crowd lags are collapsed by the clock rate") {
    Stage s;
    REQUIRE(s.down(1, {3, 3}));
    REQUIRE(s.move(1, {4, 3}));
    s.time = 20.0;  // The finger rests.
    REQUIRE(s.move(1, {4.0, 3.0}));
    s.time = 20.1;
    REQUIRE(s.move(1, {5, 3}));
    REQUIRE(s.up(1));
    int steps = 0;
    while (!s.controls.controls().empty() && ++steps < 2000) s.step();
    // 2 m at 1.6 m/s, and 20 s of pause at four times the speed.
    CHECK(steps * kStep < 2.0 / 1.6 + 20.0 / 4.0 + 0.2);
}

TEST_CASE("pinned controls stay, cancelled and removed ones end") {
    Stage s;
    REQUIRE(s.down(1, {3, 3}));
    const ControlId id = s.controls.controls()[0].id;
    REQUIRE(s.controls.setPinned(id, true));
    s.up(1);
    s.run(1.0);
    REQUIRE(s.controls.controls().size() == 1);
    CHECK_FALSE(s.down(2, {3, 3}));
    s.controls.setPinned(id, false);
    s.step();
    CHECK(s.controls.controls().empty());
    REQUIRE(s.down(3, {3, 3}));
    CHECK(s.controls.touchCancel(1, 3));
    CHECK_FALSE(s.controls.touchCancel(1, 3));
    REQUIRE(s.down(4, {3, 3}));
    CHECK(s.controls.controls()[0].id.value > id.value);
    CHECK(s.controls.remove(s.controls.controls()[0].id));
    REQUIRE(s.down(5, {3, 3}));
    s.controls.releaseClient(1);
    s.step();
    CHECK(s.controls.controls().empty());
}

TEST_CASE("a lifted control that still follows its trajectory yields its vertex to a new finger") {
    Stage s;
    REQUIRE(s.down(1, {3, 3}));
    s.move(1, {9, 3});
    s.up(1);
    s.run(0.5);
    REQUIRE(s.controls.controls().size() == 1);
    CHECK(s.down(1, s.controls.controls()[0].points[0].position));
    CHECK(s.controls.controls().size() == 1);
    CHECK(s.controls.controls()[0].points[0].trajectory.empty());
}

TEST_CASE("supplementary points reproduce linear maps of the rest shape") {
    Random random(21);
    const Formation formation = square(100);
    for (int k = 0; k < 60; ++k) {
        Stage s(formation);
        const std::uint32_t n = 2 + random.below(5);
        for (std::uint32_t t = 0; t < n; ++t) s.down(t, {random.uniform(-5, 5), random.uniform(-5, 5)});
        const double a = random.uniform(-2, 2), b = random.uniform(-2, 2), c = random.uniform(-2, 2),
                     d = random.uniform(-2, 2);
        const auto map = [&](Vec2 p) { return Vec2{a * p.x + b * p.y + 3, c * p.x + d * p.y - 1}; };
        for (const Control& control : s.controls.controls()) {
            const std::size_t columns = control.points.size();
            for (std::size_t i = 0; i < control.supplementary.size(); ++i) {
                Vec2 target;
                for (std::size_t j = 0; j < columns; ++j)
                    target += map(formation.mesh.vertices[control.points[j].vertex]) *
                              control.weights[i * columns + j];
                const Vec2 rest = control.supplementary[i].position(formation.mesh.triangles,
                                                                    formation.mesh.vertices);
                REQUIRE(distance(target, map(rest)) < 1e-9);
            }
        }
    }
}

TEST_CASE("three fingers on one line make a chain of lines") {
    Stage s;
    REQUIRE(s.down(1, {3, 3}));
    REQUIRE(s.down(2, {3, -3}));
    REQUIRE(s.down(3, {3, 0}));
    CHECK(s.controls.controls()[0].kind == ControlKind::Area);
    CHECK(s.controls.controls()[0].supplementary.size() == 4);
    for (const double w : s.controls.controls()[0].weights) CHECK(std::isfinite(w));
    s.move(1, {5, 5});
    s.run(1.0);
}

TEST_CASE("a line across a ring is sampled only where the mesh covers it") {
    FormationDef def{.kind = FormationKind::Ring};
    Stage s(*makeFormation(def, 60));
    REQUIRE(s.down(1, {7, 0}));
    REQUIRE(s.down(2, {-7, 0}));
    const TriangleMesh& rest = s.mesh.formation().mesh;
    REQUIRE_FALSE(s.controls.controls()[0].supplementary.empty());
    for (const MeshPoint& p : s.controls.controls()[0].supplementary)
        CHECK(length(p.position(rest.triangles, rest.vertices)) > 2.0);
}

TEST_CASE("binding to another mesh keeps positions and merges points on one vertex") {
    Stage s(square(100));
    for (std::uint32_t t = 0; t < 4; ++t) REQUIRE(s.down(t, kCorners[t]));
    s.run(0.5);
    const Vec2 held = s.controls.controls()[0].points[0].position;
    REQUIRE(s.mesh.change(square(9)).ok());
    s.controls.rebind(s.mesh.formation().mesh, s.mesh.userMesh());
    REQUIRE(s.controls.controls().size() == 1);
    CHECK(s.controls.controls()[0].points[0].position == held);
    s.run(0.5);
    REQUIRE(s.mesh.change(square(1)).ok());
    s.controls.rebind(s.mesh.formation().mesh, s.mesh.userMesh());
    std::vector<std::int32_t> seen;
    for (const ControlPoint& p : s.controls.controls()[0].points) seen.push_back(p.vertex);
    std::sort(seen.begin(), seen.end());
    CHECK(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
    s.run(0.5);
}

TEST_CASE("long trajectories stay within the limit and keep their end") {
    Stage s;
    REQUIRE(s.down(1, {3, 3}));
    Vec2 finger{3, 3};
    for (int k = 0; k < 12000; ++k) {
        s.time += 0.01;
        finger += Vec2{0.6 * cosine(k * 0.01), 0.6 * sine(k * 0.01)};
        REQUIRE(s.move(1, finger));
    }
    const auto& trajectory = s.controls.controls()[0].points[0].trajectory;
    CHECK(trajectory.size() <= 4096);
    CHECK(distance(trajectory.back().position, finger) < 1e-9);
    for (std::size_t k = 1; k < trajectory.size(); ++k) CHECK(trajectory[k].time >= trajectory[k - 1].time);
}

TEST_CASE("saved and restored controls continue alike") {
    Stage s;
    s.down(1, {3, 3});
    s.down(2, {-3, 3});
    s.move(1, {6, 6});
    s.run(0.3);
    Writer writer;
    writer(s.controls);
    ControlSet copy;
    Reader reader(writer.bytes());
    reader(copy);
    REQUIRE(reader.ok());
    CHECK(hashOf(copy) == hashOf(s.controls));
    for (int k = 0; k < 50; ++k) {
        s.time += kStep;
        s.controls.advance(s.parameters.input, s.parameters.control, kStep, s.time, 1.0);
        copy.advance(s.parameters.input, s.parameters.control, kStep, s.time, 1.0);
    }
    CHECK(hashOf(copy) == hashOf(s.controls));
}

TEST_CASE("random touches leave all numbers finite and all limits kept") {
    Random random(99);
    Stage s(square(49));
    for (int k = 0; k < 6000; ++k) {
        const std::uint32_t touch = random.below(8);
        const std::uint32_t client = 1 + random.below(2);
        const Vec2 p{random.uniform(-6, 6), random.uniform(-6, 6)};
        switch (random.below(12)) {
            case 0:
            case 1:
                s.down(touch, p, client);
                break;
            case 2:
                s.up(touch, client);
                break;
            case 3:
                s.controls.touchCancel(client, touch);
                break;
            case 4:
                if (!s.controls.controls().empty() && random.below(8) == 0)
                    s.controls.setPinned(s.controls.controls()[0].id, random.below(3) == 0);
                break;
            case 5:
                if (random.below(60) == 0) {
                    REQUIRE(s.mesh.change(square(1 + static_cast<std::int32_t>(random.below(60)))).ok());
                    s.controls.rebind(s.mesh.formation().mesh, s.mesh.userMesh());
                }
                break;
            default:
                s.move(touch, p, client);
        }
        s.step(random.uniform());
    }
}

TEST_CASE("stamps decide which touches join, however late they arrive") {
    Stage s;
    s.parameters.input.window = 0.15;
    const double startTime = s.time;
    REQUIRE(s.controls.touchDown(s.parameters.input, 1, 1, {3, 3}, startTime, s.mesh.formation().mesh,
                                 s.mesh.userMesh()));
    s.run(0.4);  // The second finger came down 0.14 s after the first, but its message took long.
    REQUIRE(s.controls.touchDown(s.parameters.input, 1, 2, {-3, 3}, startTime + 0.14, s.mesh.formation().mesh,
                                 s.mesh.userMesh()));
    CHECK(s.controls.controls().size() == 1);
    // The third came down later than the window, and arrives in the same step.
    REQUIRE(s.controls.touchDown(s.parameters.input, 1, 3, {-3, -3}, startTime + 0.16,
                                 s.mesh.formation().mesh, s.mesh.userMesh()));
    CHECK(s.controls.controls().size() == 2);
    // Long after, a stamp proves nothing.
    s.run(1.0);
    REQUIRE(s.controls.touchDown(s.parameters.input, 1, 4, {3, -3}, startTime + 0.1, s.mesh.formation().mesh,
                                 s.mesh.userMesh()));
    CHECK(s.controls.controls().size() == 3);
}

TEST_CASE("stamps ahead of a paused world separate touches, and the drawing begins at the world's time") {
    Stage s;
    const double now = s.time;
    REQUIRE(s.controls.touchDown(s.parameters.input, 1, 1, {3, 3}, now, s.mesh.formation().mesh,
                                 s.mesh.userMesh()));
    REQUIRE(s.controls.touchDown(s.parameters.input, 1, 2, {-3, 3}, now + 3.0, s.mesh.formation().mesh,
                                 s.mesh.userMesh()));
    REQUIRE(s.controls.touchDown(s.parameters.input, 1, 3, {-3, -3}, now + 3.1, s.mesh.formation().mesh,
                                 s.mesh.userMesh()));
    REQUIRE(s.controls.controls().size() == 2);
    CHECK(s.controls.controls()[0].kind == ControlKind::Point);
    CHECK(s.controls.controls()[1].kind == ControlKind::Line);
    s.step();
    CHECK(s.controls.controls()[1].clock <= s.time);
}
