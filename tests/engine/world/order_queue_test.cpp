// Queues of orders: what comes after what, what is skipped, and that nothing is lost.
#include <doctest.h>

#include "base/random.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

WorldDef yard() {
    return {.box = {{-30, -30}, {30, 30}}, .groups = {{.count = 16}}};
}

struct Log {
    std::vector<std::pair<EventKind, std::uint32_t>> entries;

    void read(const World& world) {
        for (const Event& e : world.events())
            if (e.kind >= EventKind::OrderGiven && e.kind <= EventKind::OrderSkipped)
                entries.emplace_back(e.kind, e.value);
    }
    int count(EventKind kind) const {
        return static_cast<int>(
            std::count_if(entries.begin(), entries.end(), [&](const auto& e) { return e.first == kind; }));
    }
    bool has(EventKind kind, std::uint32_t id) const {
        return std::find(entries.begin(), entries.end(), std::pair{kind, id}) != entries.end();
    }
};

void run(World& world, double seconds, Log& log) {
    const auto steps = static_cast<int>(seconds / world.parameters().stepTime);
    for (int s = 0; s < steps; ++s) {
        world.step();
        log.read(world);
        REQUIRE(world.rejections().empty());
    }
}

}  // namespace

TEST_CASE("queued orders are carried out one after the other") {
    World world = World::create(yard()).value();
    const GroupId id = world.group(0).id;
    Log log;
    tell(world, Order::move({10, 0}), id);
    REQUIRE(give(world, GiveOrder{id, QueueMode::Append, 0, Order::go({10, 10})}).ok());
    REQUIRE(give(world, GiveOrder{id, QueueMode::Insert, 1, Order::face(1.5)}).ok());
    world.step();
    log.read(world);
    REQUIRE(world.group(0).orders.size() == 3);
    CHECK(world.group(0).orders[1].order.kind == OrderKind::Face);
    REQUIRE_FALSE(world.group(0).way.empty());
    CHECK(distance(world.group(0).way.back(), {10, 0}) < 1e-9);
    run(world, 60, log);
    CHECK(log.count(EventKind::OrderDone) == 3);
    const std::vector<std::uint32_t> order{1, 3, 2};
    std::vector<std::uint32_t> done;
    for (const auto& [kind, value] : log.entries)
        if (kind == EventKind::OrderDone) done.push_back(value);
    CHECK(done == order);
    CHECK(world.group(0).orders.empty());
    CHECK(distance(middleOf(world), {10, 10}) < 0.5);
}

TEST_CASE(
    "a gate that opens before an order has ended lets it go on, and one that opens later moves nobody") {
    for (const Manner manner : {Manner::March, Manner::Free})
        for (const double opens : {4.0, 30.0}) {
            CAPTURE(static_cast<int>(manner));
            CAPTURE(opens);
            WorldDef def = yard();
            for (const ObstacleDef& wall :
                 {block(-0.3, -30, 0.3, -2), block(-0.3, 2, 0.3, 30), block(-0.3, -2, 0.3, 2)})
                def.obstacles.push_back(wall);
            def.groups[0].position = {-15, 0};
            Order order = Order::move({12, 0});
            order.manner = manner;
            def.groups[0].orders = {order};
            World world = World::create(def).value();
            Log log;
            run(world, opens, log);
            REQUIRE(give(world, removeThing(world.obstacleIds().back())).ok());
            run(world, 40, log);
            const bool goesOn = opens < 10.0;
            CHECK(log.count(EventKind::OrderDone) == (goesOn ? 1 : 0));
            CHECK(log.count(EventKind::OrderSkipped) == (goesOn ? 0 : 1));
            CHECK((middleOf(world).x > 10.0) == goesOn);
        }
}

TEST_CASE("a queued target that cannot be reached is skipped; the last one is approached") {
    WorldDef def = yard();
    // A closed room.
    for (const ObstacleDef& wall :
         {block(10, 10, 20, 11), block(10, 19, 20, 20), block(10, 11, 11, 19), block(19, 11, 20, 19)})
        def.obstacles.push_back(wall);
    def.groups[0].orders = {Order::move({15, 15}), Order::move({-10, 5}), Order::move({15, 15})};
    World world = World::create(def).value();
    Log log;
    run(world, 80, log);
    CHECK(log.has(EventKind::OrderSkipped, 1));
    CHECK(log.has(EventKind::OrderDone, 2));
    CHECK(log.has(EventKind::OrderBegun, 3));
    CHECK(log.has(EventKind::OrderSkipped, 3));
    CHECK(distance(middleOf(world), {15, 15}) < 10.0);
    CHECK(distance(middleOf(world), {15, 15}) > 5.0);
    const OrderForecast inside = world.forecast(world.group(0).id, Order::move({15, 15}));
    CHECK_FALSE(inside.arrives);
    CHECK(std::isinf(inside.seconds));
}

TEST_CASE("a forecast tells way and time, and changes nothing") {
    WorldDef def = yard();
    def.obstacles.push_back(block(-2, -5, 2, 12));
    def.groups[0].position = {-15, 0};
    World world = World::create(def).value();
    world.step();
    const std::uint64_t hash = world.hash();
    const Order order = Order::move({15, 0}, 0.0);
    const OrderForecast forecast = world.forecast(world.group(0).id, order);
    CHECK(world.hash() == hash);
    REQUIRE(forecast.arrives);
    CHECK(forecast.end == Vec2{15, 0});
    REQUIRE(forecast.way.size() >= 3);
    double way = 0.0;
    for (std::size_t k = 1; k < forecast.way.size(); ++k)
        way += distance(forecast.way[k - 1], forecast.way[k]);
    CHECK(way > 30.0);
    CHECK(way < 45.0);
    Log log;
    tell(world, order);
    double took = 0.0;
    for (; log.count(EventKind::OrderDone) == 0 && took < 90.0; took += world.parameters().stepTime) {
        world.step();
        log.read(world);
    }
    CHECK(took > 0.7 * forecast.seconds);
    CHECK(took < 1.4 * forecast.seconds);
}

TEST_CASE("a forecast counts slow ground") {
    // A bog of 10 m right across, at 0.4 of the speed.
    WorldDef def = yard();
    PatchDef bog{.polygon = {{-5, -30}, {5, -30}, {5, 30}, {-5, 30}}, .speed = 0.4};
    def.patches.push_back(bog);
    def.groups[0].position = {-18, 0};
    World world = World::create(def).value();
    world.step();
    for (const Manner manner : {Manner::March, Manner::Free}) {
        Order order = Order::move({18, 0}, 0.0);
        order.manner = manner;
        World copy = World::restore(world.snapshot()).value();
        const double forecast = copy.forecast(copy.group(0).id, order).seconds;
        Log log;
        tell(copy, order);
        while (log.count(EventKind::OrderDone) == 0 && copy.time() < 90.0) {
            copy.step();
            log.read(copy);
        }
        CAPTURE(static_cast<int>(manner));
        CAPTURE(forecast);
        CAPTURE(copy.time());
        CHECK(forecast >
              24.0);  // Dry: 36 m at 1.94 m/s; 10 m of bog at two fifths of that take 7.7 s longer.
        CHECK(copy.time() > 0.75 * forecast);
        CHECK(copy.time() < 1.3 * forecast);
    }
}

TEST_CASE("a patrol goes round; hold, resume, cancel and stop") {
    WorldDef def = yard();
    def.groups[0].orders = {Order::move({6, 0}), Order::move({-6, 0})};
    def.groups[0].patrols = true;
    World world = World::create(def).value();
    Log log;
    run(world, 60, log);
    CHECK(log.count(EventKind::OrderDone) >= 4);
    CHECK(world.group(0).orders.size() == 2);
    const GroupId id = world.group(0).id;
    REQUIRE(give(world, EditQueue{id, QueueEdit::Hold}).ok());
    run(world, 2, log);
    const Vec2 held = middleOf(world);
    run(world, 3, log);
    CHECK(distance(middleOf(world), held) < 0.2);
    CHECK(world.group(0).held);
    REQUIRE(give(world, EditQueue{id, QueueEdit::Resume}).ok());
    run(world, 3, log);
    CHECK(distance(middleOf(world), held) > 0.5);
    tell(world, Order::go({25, 25}), id);
    run(world, 3, log);
    REQUIRE(give(world, EditQueue{id, QueueEdit::Stop}).ok());
    const Vec2 stopped = middleOf(world);
    run(world, 4, log);
    CHECK(distance(middleOf(world), stopped) < 1.0);
    CHECK(world.group(0).orders.empty());
    REQUIRE(give(world, EditQueue{id, QueueEdit::Cancel, 77}).ok());
    world.step();
    CHECK(world.rejections().size() == 1);
}

TEST_CASE("who goes each for itself stops to hold and where its order is cancelled, and goes on to its end") {
    for (const QueueEdit edit : {QueueEdit::Hold, QueueEdit::Cancel}) {
        CAPTURE(static_cast<int>(edit));
        World world = World::create(yard()).value();
        Log log;
        const GroupId id = world.group(0).id;
        tell(world, Order::go({25, 25}), id);
        run(world, 3, log);
        REQUIRE(give(world, EditQueue{id, edit}).ok());
        run(world, 2, log);
        const Vec2 held = middleOf(world);
        CHECK(distance(held, {25, 25}) > 5.0);
        run(world, 4, log);
        CHECK(distance(middleOf(world), held) < 0.1);
        if (edit == QueueEdit::Cancel) continue;
        REQUIRE(give(world, EditQueue{id, QueueEdit::Resume}).ok());
        run(world, 30, log);
        CHECK(distance(middleOf(world), {25, 25}) < 1.0);
        CHECK(log.count(EventKind::OrderDone) == 1);
    }
}

TEST_CASE("who is told to stop stands where it is, however far from its place") {
    WorldDef def = yard();
    Random random(5);
    def.groups[0].starts.clear();
    for (std::int32_t i = 0; i < def.groups[0].count; ++i) {
        const std::int32_t row = i / 6;
        def.groups[0].starts.push_back({-26.0 + 2.0 * (i % 6), 2.0 * row + random.uniform(-0.5, 0.5)});
    }
    World world = World::create(def).value();
    Log log;
    const GroupId id = world.group(0).id;
    tell(world, Order::move({20, 20}), id);
    run(world, 3, log);
    REQUIRE(give(world, EditQueue{id, QueueEdit::Stop}).ok());
    const CharactersView c = world.characters();
    const std::vector<Vec2> before(c.position.begin(), c.position.end());
    run(world, 3, log);
    for (std::size_t i = 0; i < before.size(); ++i) {
        CHECK(distance(world.characters().position[i], before[i]) < 1.0);
        CHECK(length(world.characters().velocity[i]) < 0.05);
        CHECK(inspect::distanceLeft(world, i) < 0.5);
    }
    // It goes on as a formation.
    tell(world, Order::move({20, 20}), id);
    run(world, 40, log);
    CHECK(log.count(EventKind::OrderDone) == 1);
}

TEST_CASE("two groups that are told to stop while they pass through each other stay there") {
    WorldDef def = yard();
    def.groups[0].position = {-9, 0};
    def.groups.push_back(def.groups[0]);
    def.groups[1].position = {9, 0};
    World world = World::create(def).value();
    Log log;
    for (std::size_t g = 0; g < 2; ++g) tell(world, Order::move({g == 0 ? 20.0 : -20.0, 0}), g);
    run(world, 5, log);
    REQUIRE(distance(middleOf(world), {0, 0}) < 4.0);
    for (std::size_t g = 0; g < 2; ++g)
        REQUIRE(give(world, EditQueue{world.group(g).id, QueueEdit::Stop}).ok());
    const CharactersView c = world.characters();
    const std::vector<Vec2> before(c.position.begin(), c.position.end());
    run(world, 5, log);
    for (std::size_t i = 0; i < before.size(); ++i) {
        CHECK(distance(world.characters().position[i], before[i]) < 1.5);
        CHECK(length(world.characters().velocity[i]) < 0.05);
    }
}

TEST_CASE("fingers take over, and the order goes on from where they leave the mesh") {
    World world = World::create(yard()).value();
    const GroupId id = world.group(0).id;
    Log log;
    tell(world, Order::move({20, 0}), id);
    run(world, 2, log);
    const Vec2 at = world.group(0).finalMesh[0];
    REQUIRE(give(world, Touch{TouchPhase::Down, 1, at, world.time(), id}).ok());
    for (int s = 0; s < 120; ++s) {
        REQUIRE(give(world, Touch{TouchPhase::Move, 1, at + Vec2{0, 0.04 * s}, world.time(), {}}).ok());
        world.step();
    }
    CHECK(world.group(0).pose.position.y > 1.5);
    CHECK(world.group(0).orders.size() == 1);
    REQUIRE(give(world, Touch{TouchPhase::Up, 1, {}, world.time(), {}}).ok());
    run(world, 30, log);
    CHECK(log.count(EventKind::OrderDone) == 1);
    CHECK(distance(middleOf(world), {20, 0}) < 0.5);
    tell(world, Order::move({-20, 0}), id);
    REQUIRE(give(world, SetPose{id, {20, 5}, 0.0}).ok());
    run(world, 10, log);
    CHECK(world.group(0).orders.empty());
    CHECK(distance(middleOf(world), {20, 5}) < 0.5);
}

TEST_CASE("one group follows another, and stops where that is gone") {
    WorldDef def = yard();
    def.groups.push_back({.count = 9, .position = {-12, 0}});
    World world = World::create(def).value();
    Log log;
    tell(world, Order::move({20, 15}));
    tell(world, Order::follow(world.group(0).id, {-6, 0}), 1);
    run(world, 40, log);
    const Pose lead = world.group(0).pose;
    CHECK(distance(middleOf(world, 1), lead.apply({-6, 0})) < 0.7);
    REQUIRE(give(world, RemoveGroup{world.group(0).id}).ok());
    run(world, 1, log);
    CHECK(log.has(EventKind::OrderDone, 2));
    REQUIRE(world.groupCount() == 1);
    const GroupId self = world.group(0).id;
    tell(world, Order::follow(self, {1, 0}), self);
    world.step();
    CHECK(world.rejections().size() == 1);
}

TEST_CASE("guards stand round a rectangle that moves") {
    World world = World::create(yard()).value();
    Order order = Order::guard({5, 0}, {4, 3}, 0.0);
    order.path.waypoints = {{0, {0, 0}, 0}, {8, {0, 0}, 0}, {20, {6, 6}, 0}};
    Log log;
    tell(world, order);
    const auto onRim = [&](Vec2 middle) {
        int count = 0;
        for (const Vec2 p : world.characters().position) {
            const Vec2 q = p - middle;
            const double out = std::max(std::fabs(q.x) - 4.0, std::fabs(q.y) - 3.0);
            if (std::fabs(out) < 0.5) ++count;
        }
        return count;
    };
    run(world, 12, log);
    run(world, 20, log);
    CHECK(onRim({11, 6}) == 16);
    tell(world, Order::move({0, 0}));
    run(world, 30, log);
    CHECK(world.groupDef(0).formation.kind == FormationKind::Square);
}

TEST_CASE("a reversed queue is carried out from its last order to its first") {
    WorldDef def = yard();
    def.groups[0].orders = {Order::move({6, 0}), Order::move({6, 8}), Order::move({-6, 8})};
    World world = World::create(def).value();
    Log log;
    run(world, 1, log);
    std::vector<std::uint32_t> ids;
    for (const QueuedOrder& queued : world.group(0).orders) ids.push_back(queued.id);
    REQUIRE(give(world, ReverseQueue{world.group(0).id}).ok());
    world.step();
    REQUIRE(world.group(0).orders.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) CHECK(world.group(0).orders[k].id == ids[2 - k]);
    run(world, 60, log);
    CHECK(distance(middleOf(world), {6, 0}) < 0.5);
    CHECK(world.group(0).orders.empty());
    REQUIRE(give(world, ReverseQueue{GroupId{77}}).ok());
    world.step();
    CHECK(world.rejections().size() == 1);
}
