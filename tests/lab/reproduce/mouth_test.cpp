#include "lab/reproduce/experiments/mouth.h"

#include <doctest.h>
#include <cmath>
#include <vector>

#include "base/maths.h"
#include "engine/formation/shapes/make_formation.h"

using namespace muster;

TEST_CASE("the mouth of a mesh at rest is where the formation puts it") {
    for (const double opening : {0.8, 1.2, 2.0}) {
        FormationDef def{.kind = FormationKind::Pacman, .spacing = 0.8, .opening = opening};
        const Formation pacman = makeFormation(def, 60).value();
        const Mouth mouth(pacman.mesh);
        // The mesh's lips run parallel to the opening's sides, so the angle at the hinge is the opening.
        CHECK(mouth.angle(pacman.mesh.vertices) == doctest::Approx(opening).epsilon(0.03));
    }
}

TEST_CASE("the angle is that of lips turned about the hinge, wherever the mesh stands") {
    TriangleMesh rest{.vertices = {{-1, 0}, {0, 0}, {1, 1}, {1, -1}}, .triangles = {{0, 1, 2}, {0, 3, 1}}};
    const Mouth mouth(rest);
    for (const double half : {0.1, 0.7, 1.5, 1.9}) {
        std::vector<Vec2> turned = rest.vertices;
        const double base = 2.5;
        for (Vec2& p : turned) p = {7, 3};
        turned[0] = Vec2{7, 3} - Vec2{std::cos(base), std::sin(base)};
        turned[2] = Vec2{7, 3} + Vec2{std::cos(base + half), std::sin(base + half)} * 3.0;
        turned[3] = Vec2{7, 3} + Vec2{std::cos(base - half), std::sin(base - half)};
        CHECK(mouth.angle(turned) == doctest::Approx(2.0 * half));
    }
}

TEST_CASE("only an opening after a closing counts") {
    OpeningCounter counter(1.0, 2.0);
    for (const double angle : {1.5, 2.5, 1.5, 2.5}) counter.observe(angle);
    CHECK(counter.openings() == 0);  // Never shut.
    for (const double angle : {0.9, 1.5, 2.1, 1.9, 2.1, 1.1, 2.5}) counter.observe(angle);
    CHECK(counter.openings() == 1);  // Trembles about the threshold, and half shut.
    for (int k = 0; k < 40; ++k) counter.observe(1.5 - 0.8 * std::cos(2.0 * kPi * k / 10.0));
    CHECK(counter.openings() == 5);
}
