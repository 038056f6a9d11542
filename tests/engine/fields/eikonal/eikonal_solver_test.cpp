// The eikonal solver: analytic cases, a second algorithm, invariants, bad input.
#include "engine/fields/eikonal/eikonal_solver.h"

#include <doctest.h>

#include <cmath>
#include <cstdio>

#include "base/random.h"
#include "engine/fields/cost/cost_scene.h"
#include "engine/fields/eikonal/cost_field.h"

using namespace muster;
using namespace muster::test;

namespace {

const Box kBox{{-16, -16}, {16, 16}};

// Worst difference to `exact` over the cells at least `from` metres off.
template <class Exact>
double worst(const CostField& field, const Grid& grid, double from, Exact exact) {
    double most = 0.0;
    for (std::int32_t k = 0; k < grid.count(); ++k) {
        const Vec2 p = grid.centre(grid.at(k));
        if (distance(p, field.source()) < from) continue;
        most = std::max(most, std::fabs(field.value(grid.at(k)) - exact(p)));
    }
    return most;
}

UnitCost randomCost(Random& random, double cell, bool anisotropic) {
    const double phase = random.uniform(0, 6);
    return makeCost({{-4, -4}, {4, 4}}, cell, [&](Vec2 p) {
        if (random.below(6) == 0) return isotropic(kInfinity);
        const double base = 2.0 + std::sin(1.3 * p.x + phase) + 0.5 * std::cos(2.1 * p.y);
        CellCost c = isotropic(base);
        if (anisotropic)
            c = {static_cast<float>(base * random.uniform(0.7, 3)),
                 static_cast<float>(base * random.uniform(0.7, 3)),
                 static_cast<float>(base * random.uniform(0.7, 3)),
                 static_cast<float>(base * random.uniform(0.7, 3))};
        return c;
    });
}

// First-order upwind solution at a cell through two neighbours (Treuille, Cooper and Popovic 2006,
// section 4.2).
double update(double a, double ca, double b, double cb) {
    const double one = std::isfinite(a) ? a + ca : static_cast<double>(kInfinity);
    const double other = std::isfinite(b) ? b + cb : static_cast<double>(kInfinity);
    if (!std::isfinite(one) || !std::isfinite(other) || a >= other || b >= one) return std::min(one, other);
    const double wa = 1 / (ca * ca);
    const double wb = 1 / (cb * cb);
    const double root = std::sqrt(wa + wb - wa * wb * (a - b) * (a - b));
    return (wa * a + wb * b + root) / (wa + wb);
}

// The smallest of the four quadrants.
double update(const UnitCost& cost, const std::vector<double>& phi, Cell c) {
    const Grid& grid = cost.grid;
    const CellCost& k = cost.cells[grid.index(c)];
    const auto at = [&](std::int32_t x, std::int32_t y) {
        return grid.contains({x, y}) ? phi[grid.index({x, y})] : static_cast<double>(kInfinity);
    };
    double best = kInfinity;
    for (const bool east : {true, false}) {
        for (const bool north : {true, false}) {
            const double a = at(c.x + (east ? 1 : -1), c.y);
            const double b = at(c.x, c.y + (north ? 1 : -1));
            best = std::min(best, update(a, (east ? k.east : k.west) * grid.cell, b,
                                         (north ? k.north : k.south) * grid.cell));
        }
    }
    return best;
}

}  // namespace

TEST_CASE("on open ground the field is the straight distance") {
    std::printf("measured: open ground, worst error of all cells [m]:");
    for (const double h : {1.0, 0.5, 0.25, 0.125}) {
        const UnitCost cost = makeCost(kBox, h, [](Vec2) { return isotropic(1.0); });
        EikonalSolver solver;
        CostField field;
        const Vec2 source{1.3, 2.1};
        solver.solve(cost, source, {}, field);
        const double error = worst(field, cost.grid, 0.0, [&](Vec2 p) { return distance(p, source); });
        std::printf(" h %.3f: %.1e", h, error);
        CHECK(error < 0.01 * h);
        CHECK(field.acceptedCount() == cost.grid.count());
        CHECK(field.cost(source) == 0.0);
        CHECK(field.cost(source + Vec2{0.01, -0.02}) == doctest::Approx(std::sqrt(0.0005)));
    }
    std::printf("\n");
}

TEST_CASE("differences are of second order: speed rising linearly, against the closed solution") {
    // Speed 1 + y / 40: cost = 40 arcosh(1 + d^2 / (3200 s0 s1)) (a cycloid's circle arcs).
    const Vec2 source{-3.3, -6.1};
    const auto speed = [](Vec2 p) { return 1.0 + p.y / 40.0; };
    const auto exact = [&](Vec2 p) {
        return 40.0 * std::acosh(1.0 + lengthSquared(p - source) / (3200.0 * speed(source) * speed(p)));
    };
    for (const bool second : {false, true}) {
        EikonalDef def{.secondOrder = second};
        double before = 0.0;
        double order = 0.0;
        std::printf("measured: speed rising linearly, %s order:", second ? "second" : "first");
        for (const double h : {1.0, 0.5, 0.25, 0.125}) {
            const UnitCost cost = makeCost(kBox, h, [&](Vec2 p) { return isotropic(1.0 / speed(p)); });
            EikonalSolver solver(def);
            CostField field;
            solver.solve(cost, source, {}, field);
            const double error = worst(field, cost.grid, 2.0, exact);
            order = before > 0.0 ? std::log2(before / error) : 0.0;
            std::printf("  h %.3f: %.5f (order %.2f)", h, error, order);
            before = error;
        }
        std::printf("\n");
        CHECK(order > (second ? 1.6 : 0.7));
        CHECK(before < (second ? 0.012 : 0.2));
    }
}

TEST_CASE("costs that differ by direction: the cost of the direction walked counts") {
    // Walking east costs 3, west 1, north and south 2: from p one walks towards the source.
    const UnitCost cost = makeCost(kBox, 0.25, [](Vec2) { return CellCost{3.0f, 2.0f, 1.0f, 2.0f}; });
    EikonalSolver solver;
    CostField field;
    const Vec2 source{0.4, -0.3};
    solver.solve(cost, source, {}, field);
    const auto exact = [&](Vec2 p) {
        const double x = (source.x - p.x) * (source.x > p.x ? 3.0 : 1.0);
        const double y = (source.y - p.y) * 2.0;
        return std::sqrt(x * x + y * y);
    };
    CHECK(worst(field, cost.grid, 0.0, exact) < 0.2);
    for (const Vec2 p : {Vec2{-9, 4}, Vec2{10, 5}, Vec2{3, -12}, Vec2{-7, -7}})
        CHECK(field.cost(p) == doctest::Approx(exact(p)).epsilon(0.01));
}

TEST_CASE("paths are refracted where the ground gets slower, against Fermat's principle") {
    const UnitCost cost = makeCost(kBox, 0.25, [](Vec2 p) { return isotropic(p.x > 0.0 ? 2.5 : 1.0); });
    EikonalSolver solver;
    CostField field;
    const Vec2 source{-5.1, 0.2};
    solver.solve(cost, source, {}, field);
    for (const Vec2 p : {Vec2{6, 9}, Vec2{3, -12}, Vec2{10, 2}, Vec2{1, 12}}) {
        double best = kInfinity;
        for (int k = -4000; k <= 4000; ++k) {
            const Vec2 crossing{0.0, 0.004 * k};
            best = std::min(best, distance(source, crossing) + 2.5 * distance(crossing, p));
        }
        CHECK(field.cost(p) == doctest::Approx(best).epsilon(0.015));
    }
}

TEST_CASE("first-order fields agree with sweeping to convergence on random ground") {
    Random random(23);
    for (int round = 0; round < 30; ++round) {
        const UnitCost cost = randomCost(random, 0.25, round % 2 == 1);
        const Grid& grid = cost.grid;
        const Vec2 source{random.uniform(-3.5, 3.5), random.uniform(-3.5, 3.5)};
        EikonalDef def{.secondOrder = false};
        EikonalSolver solver(def);
        CostField field;
        solver.solve(cost, source, {}, field);
        // The surroundings of the source are given; all else follows.
        std::vector<double> phi(cost.cells.size(), kInfinity);
        std::vector<bool> given(cost.cells.size(), false);
        for (std::int32_t k = 0; k < grid.count(); ++k) {
            given[k] = distance(grid.centre(grid.at(k)), source) <= 1.0;
            if (given[k]) phi[k] = field.value(grid.at(k));
        }
        for (int sweep = 0; sweep < 200; ++sweep) {
            for (std::int32_t i = 0; i < grid.count(); ++i) {
                const std::int32_t x = i % grid.width;
                const std::int32_t y = i / grid.width;
                const Cell c{(sweep & 1) != 0 ? grid.width - 1 - x : x,
                             (sweep & 2) != 0 ? grid.height - 1 - y : y};
                if (!given[grid.index(c)] && !cost.wall(grid.index(c)))
                    phi[grid.index(c)] = std::min(phi[grid.index(c)], update(cost, phi, c));
            }
        }
        for (std::int32_t k = 0; k < grid.count(); ++k) {
            const float value = field.value(grid.at(k));
            if (std::isinf(phi[k])) {
                CHECK(std::isinf(value));
            } else {
                CHECK(value == doctest::Approx(phi[k]).epsilon(2e-3));
            }
        }
    }
}

TEST_CASE("a front that stops early gives its targets the values of the whole field") {
    Random random(31);
    for (int round = 0; round < 40; ++round) {
        const UnitCost cost = randomCost(random, 0.125, round % 2 == 1);
        const Vec2 source{random.uniform(-4, 4), random.uniform(-4, 4)};
        std::vector<Vec2> targets;
        for (int k = 0; k < 3; ++k)
            targets.push_back(source + Vec2{random.uniform(-1, 1), random.uniform(-1, 1)});
        EikonalSolver solver;
        CostField whole;
        CostField part;
        solver.solve(cost, source, {}, whole);
        solver.solve(cost, source, targets, part);
        CHECK(part.acceptedCount() <= whole.acceptedCount());
        for (const Vec2 target : targets) CHECK(part.cost(target) == whole.cost(target));
    }
}

TEST_CASE("a used solver gives the same bits as a new one") {
    Random random(41);
    EikonalSolver used;
    CostField one;
    for (int round = 0; round < 40; ++round) {
        const UnitCost cost = randomCost(random, round % 3 == 0 ? 0.25 : 0.2, round % 2 == 1);
        const Vec2 source{random.uniform(-5, 5), random.uniform(-5, 5)};
        std::vector<Vec2> targets(random.below(3), source + Vec2{0.5, 0.5});
        used.solve(cost, source, targets, one);
        EikonalSolver fresh;
        CostField other;
        fresh.solve(cost, source, targets, other);
        CHECK(one.acceptedCount() == other.acceptedCount());
        for (std::int32_t k = 0; k < cost.grid.count(); ++k)
            CHECK(one.value(cost.grid.at(k)) == other.value(cost.grid.at(k)));
    }
}

TEST_CASE("sources in walls and outside the world, closed regions, targets that are not finite") {
    const UnitCost cost = makeCost({{-4, -4}, {4, 4}}, 0.25, [](Vec2 p) {
        const bool ring = std::max(std::fabs(p.x), std::fabs(p.y)) < 2.0 &&
                          std::max(std::fabs(p.x), std::fabs(p.y)) > 1.4;
        return ring ? isotropic(kInfinity) : isotropic(1.0);
    });
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EikonalSolver solver;
    CostField field;
    solver.solve(cost, {0, 0}, std::vector<Vec2>{{3, 3}, {nan, 0}, {99, 99}}, field);
    CHECK(std::isinf(field.cost({3, 3})));
    CHECK(field.direction({3, 3}) == Vec2{});
    CHECK(std::isfinite(field.cost({1.3, 1.3})));
    CHECK(std::isinf(field.cost({nan, 0})));
    solver.solve(cost, {1.7, 0.1}, {}, field);
    CHECK(std::isfinite(field.cost({0, 0})));
    solver.solve(cost, {50, -60}, {}, field);
    CHECK(field.source() == Vec2{4, -4});
    CHECK(field.cost({3, 3}) == doctest::Approx(std::sqrt(50.0)).epsilon(0.02));
    solver.solve(cost, {nan, nan}, {}, field);
    CHECK(std::isfinite(field.cost({3, 3})));
    const UnitCost solid = makeCost({{-1, -1}, {1, 1}}, 0.25, [](Vec2) { return isotropic(kInfinity); });
    solver.solve(solid, {0, 0}, {}, field);
    CHECK(field.acceptedCount() == 0);
    CHECK(std::isinf(field.cost({0, 0})));
    std::vector<Vec2> path;
    CHECK_FALSE(tracePath(field, {0, 0}, 0.1, path));
    CHECK(CostField().direction({0, 0}) == Vec2{});
}

TEST_CASE("directions lead to the source") {
    const UnitCost cost = makeCost(kBox, 0.25, [](Vec2) { return isotropic(1.0); });
    EikonalSolver solver;
    CostField field;
    const Vec2 source{-2.2, 3.7};
    solver.solve(cost, source, {}, field);
    Random random(3);
    for (int k = 0; k < 1000; ++k) {
        const Vec2 p{random.uniform(-15, 15), random.uniform(-15, 15)};
        if (distance(p, source) < 0.5) continue;
        CHECK(dot(field.direction(p), normalized(source - p)) > 0.985);
    }
}

TEST_CASE("every cell that can be reached is reached") {
    Random random(57);
    for (int round = 0; round < 30; ++round) {
        const double share = random.uniform(0.05, 0.4);
        const UnitCost cost = makeCost({{-6, -6}, {6, 6}}, 0.25, [&](Vec2) {
            return random.uniform() < share ? isotropic(kInfinity) : isotropic(1.0);
        });
        const Grid& grid = cost.grid;
        const Cell start = grid.nearestCell({random.uniform(-6, 6), random.uniform(-6, 6)});
        if (cost.wall(grid.index(start))) continue;
        std::vector<bool> connected(cost.cells.size(), false);
        std::vector<Cell> open{start};
        connected[grid.index(start)] = true;
        while (!open.empty()) {
            const Cell c = open.back();
            open.pop_back();
            for (const Cell n : {Cell{c.x + 1, c.y}, {c.x - 1, c.y}, {c.x, c.y + 1}, {c.x, c.y - 1}}) {
                if (!grid.contains(n) || cost.wall(grid.index(n)) || connected[grid.index(n)]) continue;
                connected[grid.index(n)] = true;
                open.push_back(n);
            }
        }
        EikonalSolver solver;
        CostField field;
        solver.solve(cost, grid.centre(start), {}, field);
        std::vector<Vec2> path;
        for (std::int32_t k = 0; k < grid.count(); ++k) {
            const Vec2 p = grid.centre(grid.at(k));
            CHECK(std::isfinite(field.value(grid.at(k))) == connected[k]);
            if (!connected[k]) continue;
            CHECK(field.value(grid.at(k)) >= 0.95 * distance(p, field.source()) - 0.05);
        }
    }
}
