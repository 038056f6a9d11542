// Directions on ridges, where two paths cost the same.
#include <doctest.h>

#include <cmath>

#include "engine/fields/cost/cost_scene.h"
#include "engine/fields/eikonal/eikonal_solver.h"

using namespace muster;
using namespace muster::test;

namespace {

bool inBlock(Vec2 p) {
    return p.x > 1.0 && p.x < 2.0 && std::fabs(p.y) < 2.0;
}

}  // namespace

TEST_CASE("exactly behind a block the direction follows one of two equal paths") {
    for (const bool mirror : {false, true}) {
        const auto mirrored = [&](Vec2 p) { return mirror ? Vec2{p.y, p.x} : p; };
        const UnitCost cost = makeCost({{-8, -8}, {8, 8}}, 0.25, [&](Vec2 p) {
            return isotropic(inBlock(mirrored(p)) ? kInfinity : 1.0);
        });
        EikonalSolver solver;
        CostField field;
        solver.solve(cost, mirrored({6, 0}), {}, field);
        Vec2 p{-2, 0};
        double walked = 0.0;
        while (distance(p, {6, 0}) > 0.3 && walked < 30.0) {
            const Vec2 step = mirrored(field.direction(mirrored(p))) * 0.03;
            walked += 0.03;
            Vec2 next = p + step;
            if (inBlock(next)) next = inBlock({next.x, p.y}) ? Vec2{p.x, next.y} : Vec2{next.x, p.y};
            p = next;
        }
        // Both paths are about 9.4 m long; the first metres straight to the wall cost a little more.
        CHECK(walked < 12.0);
    }
}

TEST_CASE("exactly before slow ground the direction follows one of two equal paths") {
    for (const double slow : {1.5, 2.5, 6.0}) {
        CAPTURE(slow);
        // Deep and narrow: 4 m through at `slow`, or about a metre more round it.
        const auto onPatch = [](Vec2 p) { return p.x > -4.0 && p.x < 0.0 && std::fabs(p.y) < 1.0; };
        const UnitCost cost = makeCost({{-8, -8}, {8, 8}}, 0.25,
                                       [&](Vec2 p) { return isotropic(onPatch(p) ? slow : 1.0); });
        EikonalSolver solver;
        CostField field;
        solver.solve(cost, {3, 0}, {}, field);
        Vec2 p{-6, 0};
        double paid = 0.0;
        while (distance(p, {3, 0}) > 0.3 && paid < 40.0) {
            p += field.direction(p) * 0.03;
            paid += 0.03 * (onPatch(p) ? slow : 1.0);
        }
        CHECK(paid < 11.0);
    }
}
