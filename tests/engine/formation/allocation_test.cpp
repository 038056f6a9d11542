// After warm-up a step of the formation layer allocates nothing.
#include <cmath>

#include "counting_new.h"
#include "engine/formation/mesh_fixture.h"
#include "engine/formation/places/place_tracker.h"

using namespace muster;
using namespace muster::test;

TEST_CASE("a warm step of controls, mesh and places allocates nothing") {
    EnvironmentDef world;
    Environment environment = *Environment::create(world);
    ObstacleDef disc{.radius = 0.8};
    disc.centre = {-6.5, 0.2};  // Its field reaches the mesh, but no place needs a path round it.
    REQUIRE(environment.addObstacle(disc).ok());
    environment.setTime(0.0);
    RouteGraph routes;
    routes.update(environment, 0.25);
    Stage s(square(100));
    for (std::uint32_t t = 0; t < 3; ++t) REQUIRE(s.down(t, s.vertex(static_cast<std::int32_t>(t * 40))));
    for (std::uint32_t t = 0; t < 3; ++t)
        s.move(t, s.vertex(static_cast<std::int32_t>(t * 40)) + Vec2{4.0, 1.0 * t});
    PlaceTracker places;
    std::vector<Vec2> targets;
    long byPlaces = 0;
    const auto step = [&] {
        s.time += kStep;
        s.controls.advance(s.parameters.input, s.parameters.control, kStep, s.time, 1.0);
        const bool ok = s.mesh.deform(s.parameters.mesh, s.parameters.control, s.controls, kStep).ok();
        s.mesh.applyEnvironment(s.parameters.field, environment, kStep);
        s.mesh.placePositions(targets);
        const long beforePlaces = allocations;
        places.advance({}, targets, routes, -1, kStep);
        byPlaces += allocations - beforePlaces;
        return ok;
    };
    for (int k = 0; k < 60; ++k) REQUIRE(step());
    const long before = allocations;
    byPlaces = 0;
    bool ok = true;
    for (int k = 0; k < 60; ++k) ok = step() && ok;
    const long after = allocations;
    CHECK(ok);
    CHECK(after - before - byPlaces == 0);
    CHECK(byPlaces == 0);
    CHECK(before > 0);
}

TEST_CASE("places that search paths round a block and through a patch again and again allocate nothing") {
    Environment environment = *Environment::create({});
    ObstacleDef block{.polygon = {{-1, -5}, {1, -5}, {1, 5}, {-1, 5}}};
    REQUIRE(environment.addObstacle(block).ok());
    REQUIRE(environment.addPatch({.polygon = {{-6, -3}, {-3, -3}, {-3, 3}, {-6, 3}}, .speed = 0.5}).ok());
    environment.setTime(0.0);
    RouteGraph routes;
    routes.update(environment, 0.25);
    PlaceTracker places;
    std::vector<Vec2> targets(49);
    const auto aim = [&](double x) {
        for (int k = 0; k < 49; ++k) targets[k] = {x + 0.8 * (k % 7 - 3), 0.8 * (k / 7 - 3)};
    };
    aim(-8.0);
    places.reset({}, targets, routes, -1);
    long counted = 0;
    std::size_t detours = 0;
    for (int pass = 0; pass < 8; ++pass) {
        // All targets jump to the other side, so that many places need a path at once.
        aim(pass % 2 == 0 ? 8.0 : -8.0);
        const long before = allocations;
        for (int k = 0; k < 1500; ++k) {
            places.advance({}, targets, routes, -1, kStep);
            for (const Vec2 p : places.positions()) detours += std::fabs(p.y) > 5.0 ? 1 : 0;
        }
        if (pass >= 4) counted += allocations - before;
        double worst = 0.0;
        for (std::size_t k = 0; k < targets.size(); ++k)
            worst = std::max(worst, distance(places.positions()[k], targets[k]));
        CHECK(worst < 0.1);
    }
    CHECK(detours > 0);  // Some went round the block.
    CHECK(counted == 0);
}
