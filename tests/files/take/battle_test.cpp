// A whole battle from files: scenarios/battle.json with its gestures.
#include <doctest.h>

#include <map>
#include <set>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "muster/scenario.h"
#include "muster/world.h"
#include "test_folders.h"

using namespace muster;

namespace {

const std::string kPath = sourceFolder() + "/scenarios/battle.json";

/// The battle of a minute, played once for all tests.
struct Battle {
    std::map<EventKind, int> counts;
    std::map<std::uint32_t, Vec2> bodies;  // Where everybody stands at the end, by id.
    std::vector<std::string> refused;
    std::int32_t overlaps = 0;
    double leastRoom = 1e9;  // Least distance of a body's rim to an obstacle [m].
    double fastest = 0.0;    // Largest displacement of a step over that at own top speed.
    std::size_t groups = 0;
    std::uint64_t hash = 0;

    Battle() {
        const WorldDef def = loadScenario(kPath).value();
        World world = World::create(def).value();
        const auto commands = loadScenarioGestures(kPath, def);
        for (const Command& command : *commands) REQUIRE(world.submit(command).ok());
        while (world.time() < 60.0) {
            const std::map<std::uint32_t, Vec2> before = bodies;
            world.step();
            read(world, before);
        }
        groups = world.groupCount();
        hash = world.hash();
    }

private:
    void read(const World& world, const std::map<std::uint32_t, Vec2>& before) {
        for (const Event& event : world.events()) ++counts[event.kind];
        for (const Rejection& rejection : world.rejections())
            refused.push_back(std::string(commandName(rejection.command)) + ": " +
                              rejection.status.message());
        overlaps = std::max(overlaps, world.contacts().overlapPairs);
        const CharactersView c = world.characters();
        const Parameters& usual = world.parameters();
        bodies.clear();
        for (std::size_t i = 0; i < c.size(); ++i) {
            bodies[c.id[i]] = c.position[i];
            const double radius = c.body[i].radius > 0.0 ? c.body[i].radius : usual.character.radius;
            const double top = c.body[i].maxSpeed > 0.0 ? c.body[i].maxSpeed : usual.character.maxSpeed;
            const double room = inspect::environment(world).distanceToObstacle(c.position[i]) - radius;
            leastRoom = std::min(leastRoom, room);
            const auto old = before.find(c.id[i]);
            if (old == before.end()) continue;
            fastest = std::max(fastest, distance(old->second, c.position[i]) / (top * usual.stepTime));
        }
    }
};

const Battle& battle() {
    static const Battle once;
    return once;
}

}  // namespace

TEST_CASE("the battle is of the size that was asked for") {
    const WorldDef def = loadScenario(kPath).value();
    CHECK(def.groups.size() == 6);
    CHECK(def.obstacles.size() == 30);
    for (const GroupDef& group : def.groups) {
        CHECK(group.count == 60);
        CHECK(group.bodies.size() == 60);
    }
    std::set<std::size_t> kinds;
    std::set<OrderKind> orders;
    const auto commands = loadScenarioGestures(kPath, def);
    for (const Command& command : *commands) {
        kinds.insert(command.body.index());
        if (const auto* give = std::get_if<GiveOrder>(&command.body)) orders.insert(give->order.kind);
    }
    CHECK(orders.size() == 4);
    CHECK(kinds.size() == 8);
}

TEST_CASE("a battle is fought to its end: every command is obeyed, and nobody is lost") {
    for (const std::string& refused : battle().refused) FAIL_CHECK(refused);
    auto counts = battle().counts;
    CHECK(counts[EventKind::Left] == 10);
    CHECK(counts[EventKind::Joined] == 8);
    CHECK(counts[EventKind::Transferred] >= 6);
    CHECK(counts[EventKind::GroupAdded] == 2);
    CHECK(counts[EventKind::GroupRemoved] == 2);
    CHECK(counts[EventKind::OrderDone] >= 8);
    CHECK(counts[EventKind::OrderSkipped] == 0);
    CHECK(battle().groups == 6);
    std::set<std::uint32_t> expected;  // 360 and the 8 that joined, without the ten that fell.
    for (std::uint32_t id = 1; id <= 368; ++id) expected.insert(id);
    for (const std::uint32_t id : {3, 9, 14, 22, 28, 33, 39, 45, 51, 57}) expected.erase(id);
    std::set<std::uint32_t> found;
    for (const auto& [id, position] : battle().bodies) found.insert(id);
    CHECK(found == expected);
}

TEST_CASE("in a battle nobody stands in another, in a wall, or is faster than they can be") {
    CHECK(battle().overlaps == 0);
    CHECK(battle().leastRoom > -1e-3);
    CHECK(battle().fastest < 1.05);
}
