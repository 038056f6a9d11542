// Groups that go to areas among random commands: snapshots at random steps go on alike, and nothing
// contradicts itself.
#include <doctest.h>

#include <algorithm>

#include "engine/world/world_scenes.h"
#include "muster/parameter_table.h"

using namespace muster;
using namespace muster::testing;

namespace {

AreaDef boxArea(AreaKind kind, Vec2 low, Vec2 size) {
    return {.kind = kind, .polygon = {low, low + Vec2{size.x, 0}, low + size, low + Vec2{0, size.y}}};
}

/// Two rooms with exits, sources and a waiting area, chosen by a seed.
WorldDef rooms(std::uint64_t seed) {
    Random random(seed);
    WorldDef def;
    if (random.below(2) == 0) def.parameters = *parameterPreset("people");
    if (seed % 4 == 0) def.parameters.plan.solver = PlanSolver::Exact;
    if (seed % 5 == 0) def.parameters.plan.mode = PlanMode::Fixed;
    def.seed = seed;
    def.box = {{0, 0}, {30, 16}};
    def.obstacles = {block(14, 0, 14.5, 6), block(14, 8, 14.5, 16), tree({6, 8}, 0.5)};
    // In half of the worlds there is a second door.
    if (seed % 2 == 1) def.obstacles[1] = block(14, 8, 14.5, 12);
    if (seed % 2 == 1) def.obstacles.push_back(block(14, 13, 14.5, 16));
    for (int g = 0; g < 3; ++g) {
        GroupDef group{.count = g == 2 ? 0 : 12 + static_cast<std::int32_t>(random.below(12)),
                       .position = {5.0 + 15.0 * g, 8.0}};
        if (g == 2) group.position = {8, 12};
        group.orders = {g == 1 ? Order::wait(AreaId{4}, 3.0) : Order::leave()};
        if (g == 1) group.orders.push_back(Order::leave({AreaId{1}, AreaId{2}}));
        if (g == 0) group.orders[0].herding = 2.0;
        if (g == 0) group.orders[0].misjudgement = 1.0;
        def.groups.push_back(group);
    }
    def.areas = {boxArea(AreaKind::Exit, {29, 6}, {1, 4}), boxArea(AreaKind::Exit, {0, 6}, {1, 3}),
                 boxArea(AreaKind::Source, {4, 11}, {5, 4}), boxArea(AreaKind::Waiting, {20, 4}, {5, 8}),
                 boxArea(AreaKind::Exit, {18, 15}, {3, 1})};
    def.areas[1].rate = 0.7;
    def.areas[2].group = 2;
    def.areas[2].rate = 1.0;
    def.areas[2].most = 25;
    def.areas[4].queue = {{19, 14}, {19, 9}};
    return def;
}

/// One random command now and then.
class AreaDirector {
public:
    explicit AreaDirector(std::uint64_t seed) : random_(seed) {}

    void act(World& world) {
        if (random_.below(12) != 0 || world.groupCount() == 0) return;
        const GroupView group = world.group(random_.below(static_cast<std::uint32_t>(world.groupCount())));
        (void)give(world, command(world, group));
    }

private:
    CommandBody command(const World& world, const GroupView& group) {
        const Vec2 p{random_.uniform(1, 29), random_.uniform(1, 15)};
        std::vector<std::uint32_t> ids;
        for (const std::int32_t i : group.members)
            if (random_.below(4) == 0) ids.push_back(world.characters().id[i]);
        if (ids.empty()) ids.push_back(1);
        const GroupId other = world.group(random_.below(static_cast<std::uint32_t>(world.groupCount()))).id;
        AreaDef area = world.area(random_.below(static_cast<std::uint32_t>(world.areaCount()))).def;
        switch (random_.below(22)) {
            case 0:
                return GiveOrder{group.id, QueueMode::Replace, 0, Order::leave()};
            case 1:
                return GiveOrder{group.id, QueueMode::Append, 0, Order::leave({AreaId{2}})};
            case 2:
                return GiveOrder{group.id, QueueMode::Replace, 0, Order::wait(AreaId{4}, 1.0)};
            case 3:
                return GiveOrder{group.id, QueueMode::Replace, 0, Order::walk(random_.uniform(-3, 3))};
            case 4:
                return GiveOrder{group.id, QueueMode::Replace, 0, Order::go(p)};
            case 5:
                return GiveOrder{group.id, QueueMode::Insert, 0, Order::move(p)};
            case 6:
                return EditQueue{group.id, QueueEdit::Cancel, 0};
            case 7:
                return EditQueue{group.id, QueueEdit::Hold, 0};
            case 8:
                return EditQueue{group.id, QueueEdit::Resume, 0};
            case 9:
                return EditQueue{group.id, QueueEdit::Stop, 0};
            case 10:
                return TransferCharacters{ids, {}};
            case 11:
                return TransferCharacters{ids, other};
            case 12:
                return AddCharacters{group.id, {p, p + Vec2{1, 0}}, {}};
            case 13: {
                return SplitGroup{.group = group.id, .by = SplitBy::Shares, .shares = {1.0, 1.0}};
            }
            case 14:
                return MergeGroups{{group.id, other}};
            case 15:
                return ChangeGroup{.group = group.id,
                                   .count = 1 + static_cast<std::int32_t>(random_.below(30))};
            case 16:
                return SetPose{group.id, p, 1.0};
            case 17: {
                FormationDef formation{.kind = FormationKind::Ring};
                return ChangeGroup{.group = group.id, .formation = formation};
            }
            case 18:
                area.open = random_.below(2) == 0;
                return putThing(area, AreaId{1 + random_.below(3)}, group.id);
            case 19:
                return SetPose{group.id, p, 0.5, true};
            case 20:
                return putThing(tree(p, 0.4));
            default: {
                Order order = Order::go(p);
                order.manner = Manner::Continuum;
                return GiveOrder{group.id, QueueMode::Replace, 0, order};
            }
        }
    }

    Random random_;
};

void checkTogether(const World& world) {
    std::size_t members = 0;
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupView group = world.group(g);
        members += group.members.size();
        REQUIRE(std::cmp_equal(group.count, group.members.size()));
        REQUIRE((group.placePositions.empty() || group.placePositions.size() == group.members.size()));
        REQUIRE(group.placePositions.size() == group.meshPlaces.size());
        for (const std::int32_t i : group.members) {
            REQUIRE(world.characters().group[i] == g);
            REQUIRE(world.characters().place[i] < static_cast<std::int32_t>(group.placePositions.size()));
        }
    }
    REQUIRE(members == world.characters().size());
    for (const Vec2 p : world.characters().position) {
        REQUIRE(std::isfinite(p.x));
        REQUIRE(std::isfinite(p.y));
    }
}

}  // namespace

TEST_CASE("groups that go to areas survive random commands, snapshots and rewinds") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        World world = World::create(rooms(seed), 2).value();
        AreaDirector director(seed);
        Random random(seed + 1000);
        for (int s = 0; s < 900; ++s) {
            if (random.below(60) == 0)
                checkGoesOn(world, 12, [director](World& each) mutable { director.act(each); });
            director.act(world);
            world.step();
            checkTogether(world);
        }
    }
}
