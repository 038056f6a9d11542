// Costs between any two points, against exact geodesics and cost fields of the fine ground.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/fields/cost/ground_scene.h"
#include "engine/fields/cost/unit_cost_builder.h"
#include "engine/fields/eikonal/eikonal_solver.h"
#include "engine/fields/eikonal/geodesic_oracle.h"
#include "engine/fields/geodesics/geodesics.h"

using namespace muster;
using namespace muster::test;

namespace {

// A ground with places; warm() queries until all requested fields are solved.
struct Scene {
    Environment environment;
    StaticGround ground;
    DynamicCost dynamicCost;
    DensityField density;
    std::vector<Vec2> places;
    Geodesics geodesics;
    ThreadPool pool{2};
    UnitCost fineCost;

    explicit Scene(Environment made) : environment(std::move(made)) {
        environment.setTime(0.0);
        ground.update(environment, 1.0, 0.25);
        fineCost = ground.fineLevel().unitCost();
        density = DensityField(environment.def().box, {});
        dynamicCost.update({}, environment, density, 0.25);
    }
    void step() { geodesics.update(ground, dynamicCost, places, pool); }
    void warm(const std::vector<std::vector<Vec2>>& from) {
        for (int round = 0; round < 1500; ++round) {
            step();
            for (std::size_t j = 0; j < places.size(); ++j)
                for (const Vec2 p : from[j]) (void)geodesics.cost(p, static_cast<std::int32_t>(j));
        }
        step();
    }
};

struct Errors {
    std::vector<double> all;
    double mean = 0.0;
    double at(double share) {
        std::sort(all.begin(), all.end());
        return all[share * static_cast<double>(all.size() - 1)];
    }
};

// Relative errors of points within `reach` of each place and not in line of sight of it.
Errors errorsOf(Scene& scene, std::size_t count, double half, double reach, std::uint64_t seed) {
    Random random(seed);
    for (std::size_t j = 0; j < count; ++j) scene.places.push_back(freeSpot(scene.environment, random, half));
    std::vector<std::vector<Vec2>> from(count);
    for (std::size_t j = 0; j < count; ++j)
        while (from[j].size() < 12) {
            const Vec2 p = scene.places[j] +
                           Vec2{random.uniform(-reach, reach), random.uniform(-reach, reach)};
            if (scene.environment.def().box.grown(-0.3).contains(p) &&
                scene.environment.distanceToObstacle(p) >= 0.27)
                from[j].push_back(p);
        }
    scene.warm(from);
    Errors errors;
    EikonalSolver solver;
    CostField field;
    for (std::size_t j = 0; j < count; ++j) {
        solver.solve(scene.fineCost, scene.places[j], {}, field);
        for (const Vec2 p : from[j]) {
            const auto place = static_cast<std::int32_t>(j);
            const double truth = field.cost(p);
            const double known = scene.geodesics.cost(p, place);
            if (scene.geodesics.lineOfSight(p, place)) {
                // The reference field is a discretisation too.
                REQUIRE(known == doctest::Approx(truth).epsilon(0.02).scale(1.0));
                continue;
            }
            errors.all.push_back(std::fabs(known - truth) / std::max(truth, 0.5));
            errors.mean += (known - truth) / std::max(truth, 0.5);
        }
    }
    REQUIRE(errors.all.size() > 20);
    errors.mean /= static_cast<double>(errors.all.size());
    return errors;
}

}  // namespace

TEST_CASE("in the open costs are straight lines") {
    Scene scene(squareWorld(40.0));
    scene.places = {{0, 0}, {30, -30}};
    scene.step();
    CHECK(scene.geodesics.cost({3, 4}, 0) == doctest::Approx(5.0));
    CHECK(scene.geodesics.cost({-30, 30}, 1) == doctest::Approx(std::hypot(60.0, 60.0)));
    SteeringTarget target;
    const Guidance guidance = scene.geodesics.guidance({3, 4}, 0, target);
    CHECK(distance(guidance.direction, {-0.6, -0.8}) < 1e-9);
    CHECK(scene.geodesics.cost({0, 0}, 0) == 0.0f);
}

TEST_CASE("near costs around a block are those of the fine cost field") {
    Environment environment = squareWorld(20.0);
    REQUIRE(environment.addObstacle(rectangle(-4, -5, 4, 5)).ok());
    Scene scene(std::move(environment));
    Errors errors = errorsOf(scene, 250, 9.0, 4.5, 1);
    MESSAGE("block: " << errors.all.size() << " hidden, median " << errors.at(0.5) << ", p95 "
                      << errors.at(0.95));
    CHECK(errors.at(0.5) < 0.01);
    CHECK(errors.at(0.95) < 0.06);
}

TEST_CASE("near costs among trees are those of the fine cost field") {
    Environment environment = squareWorld(16.0);
    Random random(9);
    for (int k = 0; k < 60; ++k) {
        ObstacleDef tree{.centre = {random.uniform(-14, 14), random.uniform(-14, 14)},
                         .radius = random.uniform(0.3, 0.5)};
        REQUIRE(environment.addObstacle(tree).ok());
    }
    Scene scene(std::move(environment));
    Errors errors = errorsOf(scene, 200, 12.0, 3.5, 2);
    MESSAGE("trees: " << errors.all.size() << " hidden, median " << errors.at(0.5) << ", p95 "
                      << errors.at(0.95));
    CHECK(errors.at(0.5) < 0.01);
    CHECK(errors.at(0.95) < 0.05);
}

TEST_CASE("far costs around a block and through a corridor are near the exact ones") {
    Environment environment = squareWorld(48.0);
    REQUIRE(environment.addObstacle(rectangle(-6, -48, 6, -3)).ok());
    REQUIRE(environment.addObstacle(rectangle(-6, 3, 6, 48)).ok());
    Scene scene(std::move(environment));
    Random random(3);
    std::vector<Vec2> from;
    for (int k = 0; k < 30; ++k) {
        scene.places.push_back({random.uniform(15, 40), random.uniform(-25, 25)});
        from.push_back({random.uniform(-40, -15), random.uniform(-25, 25)});
    }
    scene.step();
    std::int64_t cells = 1000000000;
    scene.geodesics.prefetch(from, true, cells, scene.pool);
    const std::vector<Shape> walls = {{{{-6, -48}, {6, -48}, {6, -3}, {-6, -3}}},
                                      {{{-6, 3}, {6, 3}, {6, 48}, {-6, 48}}}};
    double worst = 0.0;
    for (std::size_t j = 0; j < scene.places.size(); ++j) {
        const GeodesicOracle oracle(walls, 0.25, scene.places[j]);
        for (const Vec2 p : from) {
            const double truth = oracle.cost(p);
            worst = std::max(
                worst, std::fabs(scene.geodesics.cost(p, static_cast<std::int32_t>(j)) - truth) / truth);
        }
    }
    MESSAGE("far: worst relative error " << worst);
    CHECK(worst < 0.06);
}

TEST_CASE("costs to slow ground between walls are near those of the fine cost field at all distances") {
    Environment environment = squareWorld(32.0);
    REQUIRE(environment.addObstacle(rectangle(-8, 2.6, 8, 3.4)).ok());
    REQUIRE(environment.addObstacle(rectangle(-8, 8.6, 8, 32)).ok());
    REQUIRE(environment.addObstacle(rectangle(-8, -3.4, 8, -2.6)).ok());
    REQUIRE(environment.addObstacle(rectangle(-8, -32, 8, -8.6)).ok());
    REQUIRE(environment.addPatch(slowBox(-4.5, 3.4, 4.5, 8.6, 0.4)).ok());
    REQUIRE(environment.addPatch(slowBox(-4.5, -8.6, 4.5, -3.4, 0.2)).ok());
    Scene scene(std::move(environment));
    Errors errors = errorsOf(scene, 220, 12.0, 16.0, 4);
    MESSAGE("slow ground: " << errors.all.size() << " hidden, median " << errors.at(0.5) << ", p99 "
                            << errors.at(0.99) << ", worst " << errors.at(1.0));
    CHECK(errors.at(0.5) < 0.04);
    CHECK(errors.at(0.99) < 0.12);
}

TEST_CASE("a path around slow ground is found, inside and outside local fields") {
    Environment environment = squareWorld(32.0);
    REQUIRE(environment.addPatch(slowBox(-3, -2.5, 3, 2.5, 0.1)).ok());
    Scene scene(std::move(environment));
    scene.places = {{3.7, 0.4}, {2.2, -0.3}};
    // The second place lies on the slow ground, near its far side.
    const std::vector<Vec2> from = {{-3.6, 0.2}, {-3.9, -1.0}, {-4.1, 1.2}, {-3.4, -1.9}, {3.9, 1.0}};
    scene.warm({from, from});
    EikonalSolver solver;
    CostField field;
    for (std::int32_t j = 0; j < 2; ++j) {
        solver.solve(scene.fineCost, scene.places[j], {}, field);
        for (const Vec2 p : from) {
            CAPTURE(p);
            CHECK(scene.geodesics.cost(p, j) == doctest::Approx(field.cost(p)).epsilon(0.15));
        }
    }
}

TEST_CASE("no cost is below its lower bound, which includes the slow ground at both ends") {
    Environment environment = squareWorld(24.0);
    REQUIRE(environment.addPatch(slowBox(-9, -8, -1, 8, 0.3)).ok());
    REQUIRE(environment.addPatch(slowBox(2, -8, 8, 8, 0.5)).ok());
    REQUIRE(environment.addObstacle(rectangle(-1, 8, 2, 24)).ok());
    Scene scene(std::move(environment));
    Random random(17);
    for (int j = 0; j < 40; ++j) scene.places.push_back(freeSpot(scene.environment, random, 12.0));
    scene.step();
    EikonalSolver solver;
    CostField field;
    int closer = 0;
    for (std::int32_t j = 0; j < 40; ++j) {
        solver.solve(scene.fineCost, scene.places[j], {}, field);
        for (int k = 0; k < 40; ++k) {
            const Vec2 p = freeSpot(scene.environment, random, 12.0);
            const double line = scene.geodesics.leastUnitCost() * distance(p, scene.places[j]);
            const double bound = scene.geodesics.lowerBound(p, j);
            CAPTURE(p);
            CHECK(bound >= line - 1e-9);
            CHECK(bound <= 1.03 * field.cost(p) + 0.2);
            closer += bound > 1.2 * line ? 1 : 0;
        }
    }
    CHECK(closer > 400);  // Of 1,600, of which more than half have an end on slow ground.
}

TEST_CASE("a far path that begins beside a cart includes the cost of leaving it") {
    Environment environment = squareWorld(16.0);
    REQUIRE(environment.addObstacle(rectangle(-1, -9, 1, 9)).ok());
    ObstacleDef cart{
        .centre = {-4, -3}, .radius = 0.8, .path = {.waypoints = {{0.0, {0, 0}, 0.0}, {10.0, {0, 15}, 0.0}}}};
    REQUIRE(environment.addObstacle(cart).ok());
    Scene scene(std::move(environment));
    scene.environment.setTime(1.0);
    scene.dynamicCost.update({}, scene.environment, scene.density, 0.25);
    scene.places = {{3, 0}, {3, 2}, {5, -2}};
    // In front of the cart, and away from its path.
    const Vec2 inFront{-4.2, 0.2};
    const Vec2 away{-9, 0.2};
    scene.warm({{inFront, away}, {inFront, away}, {inFront, away}});
    UnitCostBuilder builder;
    UnitCost cost;
    builder.build({}, scene.environment, scene.density, 0.25, cost);
    EikonalSolver solver;
    CostField field;
    CHECK(scene.geodesics.hasMovingCost(inFront));
    CHECK_FALSE(scene.geodesics.hasMovingCost(away));
    for (std::int32_t j = 0; j < 3; ++j) {
        solver.solve(cost, scene.places[j], {}, field);
        const double exact = field.cost(inFront);
        CHECK(scene.geodesics.cost(away, j) == doctest::Approx(field.cost(away)).epsilon(0.04));
        CHECK(scene.geodesics.cost(inFront, j) == doctest::Approx(exact).epsilon(0.12));
        solver.solve(scene.fineCost, scene.places[j], {}, field);
        CHECK(exact > 1.15 * field.cost(inFront));
    }
}

TEST_CASE("following the guidance leads to the place by nearly the shortest path") {
    Environment environment = squareWorld(32.0);
    REQUIRE(environment.addObstacle(rectangle(-3, -12, 3, 10)).ok());
    const std::vector<Shape> walls = {{{{-3, -12}, {3, -12}, {3, 10}, {-3, 10}}}};
    Scene scene(std::move(environment));
    scene.places = {{20, -4}, {6, 2}, {4.5, -11.5}};
    for (std::int32_t j = 0; j < 3; ++j) {
        Vec2 at{-20, 3};
        SteeringTarget target;
        double walked = 0.0;
        const GeodesicOracle oracle(walls, 0.25, scene.places[j]);
        const double truth = oracle.cost(at);
        for (int k = 0; k < 4000 && distance(at, scene.places[j]) > 0.1; ++k) {
            scene.step();
            const Guidance guidance = scene.geodesics.guidance(at, j, target);
            const Vec2 next = scene.environment.projectToFreeSpace(at + guidance.direction * 0.05, 0.25);
            walked += distance(at, next);
            at = next;
        }
        CHECK(distance(at, scene.places[j]) <= 0.1);
        CHECK(walked < 1.05 * truth);
    }
}

TEST_CASE("a saved oracle continues bit for bit") {
    Environment environment = squareWorld(20.0);
    REQUIRE(environment.addObstacle(rectangle(-4, -5, 4, 5)).ok());
    Scene scene(std::move(environment));
    Random random(7);
    std::vector<Vec2> from;
    for (int k = 0; k < 40; ++k) {
        scene.places.push_back(freeSpot(scene.environment, random, 9.0));
        from.push_back(freeSpot(scene.environment, random, 15.0));
    }
    const auto query = [&](const Geodesics& geodesics) {
        std::vector<float> costs;
        for (std::size_t j = 0; j < scene.places.size(); ++j)
            for (const Vec2 p : from) costs.push_back(geodesics.cost(p, static_cast<std::int32_t>(j)));
        return costs;
    };
    for (int k = 0; k < 25; ++k) {
        scene.step();
        (void)query(scene.geodesics);
    }
    Writer writer;
    scene.geodesics.save(writer);
    Geodesics copy;
    Reader reader(writer.bytes());
    REQUIRE(copy.load(reader));
    for (int k = 0; k < 30; ++k) {
        for (Vec2& place : scene.places) place += Vec2{0.01, 0.005};
        scene.step();
        copy.update(scene.ground, scene.dynamicCost, scene.places, scene.pool);
        REQUIRE(query(copy) == query(scene.geodesics));
    }
    Reader cut(std::span(writer.bytes()).first(writer.bytes().size() / 2));
    CHECK_FALSE(Geodesics().load(cut));
}
