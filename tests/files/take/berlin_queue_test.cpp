// A queue of five orders through a city, from files, as docs/orders-and-units.md tells to play it.
#include <doctest.h>

#include <fstream>
#include <sstream>

#include "muster/ground.h"
#include "muster/scenario.h"
#include "muster/world.h"
#include "test_folders.h"

using namespace muster;

namespace {

/// The world that `muster import --cell 1 --count 60` makes; no groups where the map is not here.
WorldDef berlin() {
    std::ifstream file(sourceFolder() + "/../shared/maps/Berlin_0_256.map", std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    WorldDef def;
    if (text.str().empty()) return def;
    def.map = MapGround{parseMap(text.str()).value(), {}};
    def.box = {{0, 0}, {256, 256}};
    def.cell = 0.5;
    def.groups = {{.count = 60, .position = {51.25, 200.75}}};
    return def;
}

struct Walk {
    std::vector<std::uint32_t> done, skipped;  // Ids of orders.
    std::vector<Vec2> where;                   // The middle of the crowd as each was done.
    std::int32_t overlaps = 0;
};

Vec2 middleOf(const World& world) {
    Vec2 sum;
    for (const Vec2 p : world.characters().position) sum += p;
    return sum / static_cast<double>(world.characters().size());
}

Walk walk(World& world, double seconds) {
    Walk walk;
    while (world.time() < seconds) {
        world.step();
        CHECK(world.rejections().empty());
        walk.overlaps = std::max(walk.overlaps, world.contacts().overlapPairs);
        for (const Event& event : world.events()) {
            if (event.kind == EventKind::OrderSkipped) walk.skipped.push_back(event.value);
            if (event.kind != EventKind::OrderDone) continue;
            walk.done.push_back(event.value);
            walk.where.push_back(middleOf(world));
        }
    }
    return walk;
}

}  // namespace

TEST_CASE("a queue of five orders leads through Berlin; one into a closed courtyard is skipped") {
    const WorldDef def = berlin();
    if (def.groups.empty()) {
        MESSAGE("skipped: Berlin_0_256.map is not here");
        return;
    }
    auto commands = loadGestures(sourceFolder() + "/samples/berlin_queue.json", def.parameters.stepTime);
    REQUIRE_MESSAGE(commands.ok(), commands.status().message());
    REQUIRE(commands->size() == 5);
    World world = World::create(def).value();
    for (const Command& command : *commands) REQUIRE(world.submit(command).ok());
    // The courtyard comes third: nobody can get there, and the queue goes on.
    const Order courtyard = Order::move({97.3, 155.0});
    REQUIRE(world.submit({40, 2, 0, GiveOrder{GroupId{1}, QueueMode::Insert, 2, courtyard}}).ok());
    const Walk found = walk(world, 420.0);
    CHECK(found.skipped.size() == 1);
    REQUIRE(found.done.size() == 5);
    for (std::size_t k = 0; k < 5; ++k) {
        const Vec2 target = std::get<GiveOrder>((*commands)[k].body).order.target;
        CHECK(distance(found.where[k], target) < 3.0);
    }
    CHECK(found.overlaps == 0);
}
