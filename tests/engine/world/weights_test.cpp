// Supplies and demands with the default plan (SPEC A1).
#include <doctest.h>

#include <map>
#include <numeric>

#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

// Supplies and demands of a quarter to three units; some places demand nothing.
WorldDef weightedGroup(std::int32_t count, std::uint64_t seed, bool roles = false) {
    WorldDef def{.box = {{-25, -15}, {45, 15}}, .seed = seed, .obstacles = {block(4, -5, 8, 4)}};
    Random random(seed);
    GroupDef& group = def.groups.emplace_back();
    group.count = count;
    group.position = {-12, 0};
    group.bodies.resize(static_cast<std::size_t>(count));
    for (Body& body : group.bodies) {
        body.supply = 0.25 * (1 + random.below(12));
        if (roles) body.unitClass = static_cast<std::uint8_t>(1 + random.below(2));
    }
    for (std::int32_t k = 0; k < count; ++k) group.demands.push_back(0.25 * random.below(13));
    if (roles) group.roles = {{RoleArea::Front, 1}, {RoleArea::Rear, 2}};
    return def;
}

// How often each kind of event comes within some seconds.
std::map<EventKind, int> play(World& world, double seconds) {
    std::map<EventKind, int> counts;
    for (int s = 0; s < seconds * 60; ++s) {
        world.step();
        for (const Event& event : world.events()) ++counts[event.kind];
    }
    return counts;
}

// Characters of each place of the first group.
std::vector<int> occupancy(const World& world) {
    std::vector<int> counts(world.group(0).placePositions.size(), 0);
    for (const std::int32_t i : world.group(0).members)
        if (const std::int32_t place = world.characters().place[i]; place >= 0) ++counts[place];
    return counts;
}

// Deaths, joins, splits, merges and other weights at random: one call per step.
struct WeightDirector {
    Random random;

    void act(World& world) {
        const std::uint32_t dice = random.below(50);
        const std::size_t g = random.below(static_cast<std::uint32_t>(world.groupCount()));
        const GroupView group = world.group(g);
        const auto anybody = [&] {
            const auto members = world.group(g).members;
            return members.empty()
                       ? 1u
                       : world.characters()
                             .id[members[random.below(static_cast<std::uint32_t>(members.size()))]];
        };
        if (dice == 0) (void)give(world, TransferCharacters{{anybody()}, {}});
        if (dice == 1) {
            AddCharacters join{group.id, {{random.uniform(-20, 30), random.uniform(-10, 10)}}, {}};
            join.bodies.resize(1);
            join.bodies[0].supply = random.uniform(0.1, 4.0);
            (void)give(world, join);
        }
        if (dice == 2) {
            SplitGroup split{group.id, SplitBy::Shares};
            split.shares = {1.0, 2.0};
            (void)give(world, split);
        }
        if (dice == 3 && world.groupCount() > 1)
            (void)give(world, MergeGroups{{world.group(0).id, world.group(1).id}});
        if (dice == 4) {
            std::vector<double> demands(group.placePositions.size());
            for (double& demand : demands) demand = 0.5 * random.below(5);
            (void)give(world, ChangeGroup{.group = group.id, .demands = demands});
        }
        if (dice == 5) {
            Body body{.supply = random.uniform(0.01, 3.0)};
            (void)give(world, ChangeCharacters{{anybody()}, std::vector<Body>{body}, {}});
        }
        if (dice == 6)
            (void)give(world, GiveOrder{group.id, QueueMode::Replace, 0,
                                        Order::move({random.uniform(-15, 35), random.uniform(-8, 8)}, 0.0)});
        if (dice == 7) {
            FormationDef formation{.kind = static_cast<FormationKind>(random.below(7))};
            (void)give(world, ChangeGroup{.group = group.id, .formation = formation});
        }
        if (dice == 8)
            (void)give(world,
                       ChangeGroup{.group = group.id,
                                   .roles = std::vector<RoleDef>{{RoleArea::Front, 1}, {RoleArea::Rim, 2}}});
    }
};

}  // namespace

TEST_CASE("a group with weights goes round a block, arrives, and stays near the optimum") {
    for (const std::uint64_t seed : {1, 2, 3}) {
        World world = World::create(weightedGroup(49, seed, seed == 3)).value();
        for (int s = 0; s < 60; ++s) world.step();
        tell(world, Order::move({25, 2}, 0.0));
        std::map<EventKind, int> events;
        double worst = 0.0;
        for (int s = 0; s < 40; ++s) {
            for (const auto& [kind, count] : play(world, 1.0)) events[kind] += count;
            const GroupView group = world.group(0);
            worst = std::max(worst, group.gapBound / std::max(group.objective, 0.0625 * 49));
        }
        INFO("seed " << seed << ", worst gap " << worst << ", swaps " << events[EventKind::Swap]);
        CHECK(events[EventKind::Arrived] == 1);
        CHECK(events[EventKind::OrderDone] == 1);
        CHECK(events[EventKind::Stuck] == 0);
        CHECK(events[EventKind::Swap] < 2 * 49);
        CHECK(worst < 0.02);
        CHECK(worstToPlace(world) < 1.6);
        // Once there, nobody changes places any more.
        CHECK(play(world, 10.0)[EventKind::Swap] == 0);
    }
}

TEST_CASE("places that demand six take six, who stand around them as good as there") {
    WorldDef def = weightedGroup(36, 1);
    def.groups[0].bodies.clear();
    def.groups[0].formation.spacing = 2.0;
    for (int k = 0; k < 36; ++k) def.groups[0].demands[k] = k % 6 == 2 ? 6.0 : 0.0;
    World world = World::create(def).value();
    for (int s = 0; s < 60; ++s) world.step();
    tell(world, Order::move({25, 2}, 0.0));
    auto events = play(world, 60.0);
    CHECK(events[EventKind::Arrived] == 1);
    CHECK(events[EventKind::OrderDone] == 1);
    CHECK(events[EventKind::Stuck] == 0);
    const std::vector<int> counts = occupancy(world);
    for (int k = 0; k < 36; ++k) CHECK(counts[k] == (k % 6 == 2 ? 6 : 0));
    CHECK(play(world, 10.0)[EventKind::Swap] == 0);
    CHECK(worstToPlace(world) < 1.2);
    for (const Vec2 velocity : world.characters().velocity) CHECK(length(velocity) < 0.05);
}

TEST_CASE("one who supplies three places stands at one of them, and stays") {
    WorldDef def = weightedGroup(9, 1);
    def.obstacles.clear();
    for (int k = 0; k < 9; ++k) {
        def.groups[0].demands[k] = 1.0;
        def.groups[0].bodies[k].supply = k % 3 == 0 ? 3.0 : 1e-3;
    }
    World world = World::create(def).value();
    (void)play(world, 3.0);
    std::vector<std::int32_t> held;
    for (const std::int32_t i : {0, 3, 6}) held.push_back(world.characters().place[i]);
    CHECK(std::all_of(held.begin(), held.end(), [](std::int32_t place) { return place >= 0; }));
    (void)play(world, 3.0);
    for (int k = 0; k < 3; ++k) CHECK(world.characters().place[3 * k] == held[k]);
}

TEST_CASE("demands go on with their places when ranks close and groups split and merge") {
    WorldDef def = weightedGroup(36, 4);
    def.obstacles.clear();
    World world = World::create(def).value();
    (void)play(world, 0.5);
    const std::vector<double> before = world.groupDef(0).demands;
    const std::vector<Vec2> places = copyOf(world.group(0).placePositions);
    REQUIRE(give(world, TransferCharacters{{8}, {}}).ok());
    world.step();
    const auto sameAsBefore = [&](std::size_t g) {
        const std::vector<double> after = world.groupDef(g).demands;
        REQUIRE(after.size() == world.group(g).placePositions.size());
        for (std::size_t k = 0; k < after.size(); ++k) {
            const Vec2 p = world.group(g).placePositions[k];
            const auto nearest = std::min_element(places.begin(), places.end(), [&](Vec2 a, Vec2 b) {
                return distance(a, p) < distance(b, p);
            });
            if (distance(*nearest, p) < 0.05) CHECK(after[k] == before[nearest - places.begin()]);
        }
    };
    sameAsBefore(0);
    CHECK(world.groupDef(0).demands.size() == 35);
    SplitGroup split{world.group(0).id, SplitBy::Shares};
    split.shares = {1.0, 1.0};
    REQUIRE(give(world, split).ok());
    world.step();
    REQUIRE(world.groupCount() == 2);
    sameAsBefore(0);
    sameAsBefore(1);
    REQUIRE(give(world, MergeGroups{{world.group(0).id, world.group(1).id}}).ok());
    world.step();
    REQUIRE(world.groupCount() == 1);
    sameAsBefore(0);
    const std::vector<double>& merged = world.groupDef(0).demands;
    CHECK(std::accumulate(merged.begin(), merged.end(), 0.0) > 0.0);
}

TEST_CASE("with weights, worlds that are restored or rewound go on bit for bit") {
    for (const std::uint64_t seed : {1, 2, 3}) {
        CAPTURE(seed);
        World world = World::create(weightedGroup(40, seed, seed == 2)).value();
        WeightDirector director{Random(seed)};
        for (int s = 0; s < 600; ++s) {
            if (s % 120 == 57)
                checkGoesOn(world, 60, [director](World& each) mutable { director.act(each); });
            director.act(world);
            world.step();
            for (const Vec2 p : world.characters().position) REQUIRE(isFinite(p));
        }
    }
}

TEST_CASE("weights that are not one for each place, or out of range, are refused in one sentence") {
    WorldDef def = weightedGroup(9, 1);
    def.groups[0].name = "a";
    def.groups[0].demands.pop_back();
    const Status few = World::create(def).status();
    CHECK(few.message() == "groups[0]: group 'a': found 8 demands, expected one for each of its 9 places");
    def.groups[0].demands.assign(9, -1.0);
    CHECK(World::create(def).status().message().find("demands[0]") != std::string::npos);
    def.groups[0].demands.clear();
    def.groups[0].bodies[4].supply = 0.0;
    CHECK(World::create(def).status().message().find("supply") != std::string::npos);
    World world = World::create(weightedGroup(9, 1)).value();
    REQUIRE(
        give(world, ChangeGroup{.group = world.group(0).id, .demands = std::vector<double>{1.0, 2.0}}).ok());
    world.step();
    REQUIRE(world.rejections().size() == 1);
    CHECK(world.rejections()[0].status.message().find("found 2 demands") != std::string::npos);
}
