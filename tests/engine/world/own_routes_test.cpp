// Who camps follows a route of its own until it has arrived.
#include <doctest.h>

#include "engine/world/world_engine.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

std::vector<OwnRoute>& routesOf(const World& world) {
    return WorldAccess::of(world).state.ownRoutes;
}

// Up to the first step in which somebody has a route of its own, since the next door is held.
World untilSomebodyCamps() {
    World world = World::create(twoDoors(Stance::Hold)).value();
    Order order = Order::move({9, 0});
    order.manner = Manner::Free;
    tell(world, order);
    while (routesOf(world).empty() && world.time() < 30.0) world.step();
    return world;
}

}  // namespace

TEST_CASE("routes lead to the places of those who camp, along the exact ground") {
    World world = untilSomebodyCamps();
    REQUIRE(!routesOf(world).empty());
    WorldState& state = WorldAccess::of(world).state;
    for (int s = 0; s < 600; ++s) {
        world.step();
        for (const OwnRoute& route : state.ownRoutes) {
            const auto at = std::find(state.characters.id.begin(), state.characters.id.end(),
                                      route.character);
            REQUIRE(at != state.characters.id.end());
            const std::size_t i = at - state.characters.id.begin();
            if (route.place != state.characters.place[i] || route.path.empty()) continue;
            CHECK(distance(route.goal, state.groups[0].places.positions()[route.place]) < 1.0);
            for (std::size_t k = 1; k < route.path.size(); ++k)
                CHECK(state.environment.clearLine(route.path[k - 1], route.path[k],
                                                  state.routesOf(state.groups[0]).ground().radius() - 1e-6));
            CHECK(route.cost <=
                  doctest::Approx(pathLength(route.path) +
                                  distance(state.characters.position[i], route.path.front()) + 2.0 / 30));
        }
    }
}

TEST_CASE("routes lead round slow ground where that is quicker") {
    WorldDef def = twoDoors(Stance::Hold);
    def.patches = {{.polygon = {{-5, -7}, {-0.5, -7}, {-0.5, -2}, {-5, -2}}, .speed = 0.2}};
    World world = World::create(def).value();
    Order order = Order::move({9, 0});
    order.manner = Manner::Free;
    tell(world, order);
    int routes = 0;
    while (world.time() < 40.0) {
        world.step();
        routes += routesOf(world).empty() ? 0 : 1;
        for (const Vec2 p : world.characters().position)
            CHECK(!(p.x > -4.8 && p.x < -0.5 && p.y > -6.8 && p.y < -2.2));
    }
    CHECK(routes > 0);
    for (std::size_t i = 0; i + 1 < world.characters().size(); ++i)
        CHECK(world.characters().position[i].x > 2.0);
}

TEST_CASE("a route ends once its character stays at its place") {
    World world = untilSomebodyCamps();
    REQUIRE(!routesOf(world).empty());
    for (int s = 0; s < 60 * 90 && !routesOf(world).empty(); ++s) world.step();
    CHECK(routesOf(world).empty());
}

TEST_CASE("a world in which somebody follows a route is restored bit for bit") {
    World world = untilSomebodyCamps();
    REQUIRE(!routesOf(world).empty());
    checkGoesOn(world, 120);
}

TEST_CASE("a snapshot with routes out of order is refused") {
    World world = untilSomebodyCamps();
    REQUIRE(!routesOf(world).empty());
    routesOf(world).push_back(routesOf(world).front());
    CHECK(!World::restore(world.snapshot()).ok());
}
