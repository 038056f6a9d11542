// A way that a body fits is open, and one that it does not fit is shut, wherever they lie on the cells.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/maths.h"
#include "engine/fields/cost/ground_scene.h"
#include "engine/fields/eikonal/eikonal_solver.h"

using namespace muster;
using namespace muster::test;

namespace {

constexpr double kHalf = 6.0;        // Of the world [m].
constexpr double kMargin = 0.06;     // With so much to spare a body always fits [m],
constexpr double kLittle = 0.005;    // with so much nearly always,
constexpr double kTooLittle = 0.01;  // and with so much too little never.

/// Where a wall lies: its frame has the wall along the y axis and the way along x.
struct Frame {
    Rotation turn;
    Vec2 middle;
    Vec2 at(double x, double y) const { return middle + turn.apply({x, y}); }
};

Frame frame(double angle, double shift) {
    return {{cosine(angle), sine(angle)}, {0.61 * shift, shift}};
}

void addPolygon(Environment& environment, const Frame& where, std::vector<Vec2> corners) {
    ObstacleDef def;
    for (const Vec2 p : corners) def.polygon.push_back(where.at(p.x, p.y));
    REQUIRE(environment.addObstacle(def).ok());
}

/// Adds both sides of a way of this width: `thick` long, or between two tips or two discs.
enum class Kind { Door, Lane, Tips, Discs };

void addWay(Environment& environment, const Frame& where, Kind kind, double width) {
    const double half = 0.5 * width, far = 20.0;
    if (kind == Kind::Tips) {
        addPolygon(environment, where, {{0, half}, {3, 3}, {3, far}, {-3, far}, {-3, 3}});
        addPolygon(environment, where, {{-3, -3}, {-3, -far}, {3, -far}, {3, -3}, {0, -half}});
        return;
    }
    const double thick = kind == Kind::Lane ? 0.8 : 0.1;
    const double from = kind == Kind::Discs ? half + 0.8 : half;
    for (const double side : {1.0, -1.0}) {
        const double low = std::min(side * from, side * far), high = std::max(side * from, side * far);
        addPolygon(environment, where, {{-thick, low}, {thick, low}, {thick, high}, {-thick, high}});
        if (kind != Kind::Discs) continue;
        REQUIRE(environment.addObstacle({.centre = where.at(0.0, side * (half + 0.4)), .radius = 0.4}).ok());
        addPolygon(environment, where,
                   {{-0.05, std::min(side * (half + 0.4), side * from)},
                    {0.05, std::min(side * (half + 0.4), side * from)},
                    {0.05, std::max(side * (half + 0.4), side * from)},
                    {-0.05, std::max(side * (half + 0.4), side * from)}});
    }
}

/// Cost of the way between two points for bodies of this radius; infinite where the field does not lead.
double costOf(const Environment& environment, double radius, Vec2 from, Vec2 to) {
    StaticGround ground;
    ground.update(environment, 1.0, radius);
    EikonalSolver solver;
    CostField field;
    solver.solve(ground.fineLevel().unitCost(), to, {}, field);
    return field.cost(from);
}

bool leads(Kind kind, double radius, double width, double angle, double shift) {
    Environment environment = squareWorld(kHalf);
    const Frame where = frame(angle, shift);
    addWay(environment, where, kind, width);
    environment.setTime(0.0);
    return costOf(environment, radius, where.at(-3.5, 0.0), where.at(3.5, 0.0)) < kUnreachableCost;
}

}  // namespace

TEST_CASE("a body is led through all that it fits, and through nothing else, wherever that lies") {
    int ways = 0, shut = 0;
    for (const Kind kind : {Kind::Door, Kind::Lane, Kind::Tips, Kind::Discs})
        for (const double radius : {0.19, 0.22, 0.25, 0.35, 0.6})
            for (const double angle : {0.0, 0.1, 0.2, 0.47, 0.7, 0.78539816339744831, 1.3})
                for (int k = 0; k < 10; ++k) {
                    const double shift = 0.025 * k;
                    CAPTURE(static_cast<int>(kind));
                    CAPTURE(radius);
                    CAPTURE(angle);
                    CAPTURE(shift);
                    CHECK_FALSE(leads(kind, radius, 2.0 * radius - kTooLittle, angle, shift));
                    for (const double more : {kMargin, 0.11, 0.17, 0.23, 0.3}) {
                        CAPTURE(more);
                        CHECK(leads(kind, radius, 2.0 * radius + more, angle, shift));
                    }
                    ++ways;
                    if (!leads(kind, radius, 2.0 * radius + kLittle, angle, shift)) ++shut;
                }
    MESSAGE("of " << ways << " ways with 5 mm to spare " << shut << " are shut");
    CHECK(shut < ways / 200);
}

TEST_CASE("no field leads through a thin wall, or between obstacles that touch") {
    for (const double radius : {0.19, 0.22, 0.35})
        for (const double angle : {0.0, 0.2, 0.47, 0.78539816339744831, 1.3})
            for (int k = 0; k < 10; ++k)
                for (const double thick : {0.01, 0.06}) {
                    CAPTURE(radius);
                    CAPTURE(angle);
                    CAPTURE(k);
                    CAPTURE(thick);
                    const Frame where = frame(angle, 0.025 * k);
                    const Vec2 from = where.at(-1.5, 0.3), to = where.at(1.5, -0.2);
                    Environment whole = squareWorld(kHalf);
                    addPolygon(whole, where, {{0, -20}, {thick, -20}, {thick, 20}, {0, 20}});
                    whole.setTime(0.0);
                    CHECK_FALSE(costOf(whole, radius, from, to) < kUnreachableCost);
                    // Two walls of which one ends at the side of the other, and two that meet in a corner.
                    for (const double beside : {0.0, thick}) {
                        Environment parts = squareWorld(kHalf);
                        addPolygon(parts, where, {{0, -20}, {thick, -20}, {thick, 0}, {0, 0}});
                        addPolygon(parts, where,
                                   {{beside, 0}, {beside + thick, 0}, {beside + thick, 20}, {beside, 20}});
                        parts.setTime(0.0);
                        CHECK_FALSE(costOf(parts, radius, from, to) < kUnreachableCost);
                    }
                }
}

TEST_CASE("lanes beside each other stay apart, however thin the wall between them") {
    for (const double radius : {0.22, 0.35})
        for (const double angle : {0.0, 0.2, 0.47, 0.78539816339744831})
            for (int k = 0; k < 10; ++k)
                for (const double thick : {0.01, 0.05}) {
                    CAPTURE(radius);
                    CAPTURE(angle);
                    CAPTURE(k);
                    const Frame where = frame(angle, 0.025 * k);
                    const double width = 2.0 * radius + 0.03, length = 2.0;
                    Environment environment = squareWorld(kHalf);
                    // Three walls along x; the lane below is shut at its far end.
                    for (const double y : {-width - thick, 0.0, width + thick})
                        addPolygon(environment, where,
                                   {{-length, y}, {length, y}, {length, y + thick}, {-length, y + thick}});
                    addPolygon(environment, where,
                               {{length, -width - thick},
                                {length + thick, -width - thick},
                                {length + thick, thick},
                                {length, thick}});
                    environment.setTime(0.0);
                    const double low = -0.5 * width, high = thick + 0.5 * width;
                    const Vec2 from = where.at(1.5, low), to = where.at(0.5, high);
                    const double cost = costOf(environment, radius, from, to);
                    const double round = 2.0 + 2.0 * length;
                    CHECK(cost > round);
                    CHECK(cost < round + 1.5 + 4.0 * radius);
                }
}
