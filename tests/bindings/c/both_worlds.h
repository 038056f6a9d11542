// The same world by the C API and by the C++ API.
#pragma once

#include <doctest.h>

#include <utility>
#include <vector>

#include "bindings/c/c_world/command_fields.h"
#include "muster/muster.h"
#include "muster/world.h"

/// Two groups, a wall, a moving gate, a net, an item and a checkpoint.
inline muster::WorldDef makeDef() {
    using namespace muster;
    WorldDef def{.name = "Both", .parameters = {.character = {.radius = 0.22}}};
    def.parameters.plan.period = 2;
    ObstacleDef wall{.polygon = {{4, -3}, {5, -3}, {5, 3}, {4, 3}}};
    ObstacleDef gate{.name = "Gate",
                     .polygon = {{4, 4}, {5, 4}, {5, 5}, {4, 5}},
                     .path = {.waypoints = {{0.0, {}, 0.0}, {4.0, {0, 3}, 0.0}}, .loop = true}};
    def.obstacles = {wall, gate};
    def.patches = {{.name = "Net", .polygon = {{-3, 6}, {3, 6}, {3, 9}, {-3, 9}}, .motion = 3}};
    GroupDef first{.name = "First",
                   .count = 20,
                   .position = {-8, -4},
                   .bodies = {Body{0.3, 0.0, 0.0, 2.0, 1.0, 1}},
                   .roles = {{RoleArea::Front, 1}}};
    GroupDef second{.name = "Second",
                    .count = 16,
                    .formation = {.kind = FormationKind::Wedge},
                    .position = {-8, 7},
                    .orders = {Order::move({6, 10}, 0.5)}};
    second.orders[0].formation = FormationDef{FormationKind::Line, 1.1, 1.2, {}, {}, 0};
    def.groups = {first, second};
    def.checkpoints = {{.position = {0, -8}, .formation = {.kind = FormationKind::Column}, .share = 0.25}};
    def.items = {{{9, -9}, 0.5}};
    def.groups[0].people = {adults()};
    AreaDef exit{.name = "Door", .polygon = {{13, -2}, {15, -2}, {15, 2}, {13, 2}}};
    AreaDef source{.kind = AreaKind::Source,
                   .polygon = {{-14, 10}, {-11, 10}, {-11, 14}, {-14, 14}},
                   .rate = 0.5,
                   .group = 1,
                   .timetable = {{1.0, 2}}};
    def.areas = {exit, source};
    return def;
}

/// Commands of many kinds, with their steps; the last one is refused in its step.
inline std::vector<std::pair<std::uint32_t, muster::CommandBody>> sampleScript(const muster::World& world) {
    using namespace muster;
    const GroupId first = world.group(0).id, second = world.group(1).id;
    SplitGroup split{.group = first, .by = SplitBy::Shares, .shares = {1.0, 2.0}};
    AreaDef closed = world.area(0).def;
    closed.open = false;
    GiveOrder go{first, QueueMode::Replace, 0, Order::move({10, -6}, 0.0)};
    go.order.route = {{-2, -10}, {6, -9}};
    return {{0, Touch{TouchPhase::Down, 1, world.group(0).finalMesh.front(), 0.0, first}},
            {2, Touch{TouchPhase::Move, 1, world.group(0).finalMesh.front() + Vec2{1, 0}, 0.1, {}}},
            {10, Touch{TouchPhase::Up, 1, {}, 0.2, {}}},
            {20, go},
            {30, SetParameter{"character.maxSpeed", 1.7}},
            {40, ChangeGroup{.group = second, .conduct = Conduct{Stance::Hold, 0.5, 0.3, true}}},
            {60, split},
            {80, AddCharacters{second, {{-9, 9}, {-9, 10}}, {}}},
            {90, TransferCharacters{{2, 3}, {}}},
            {100, ChangeGroup{.group = second,
                              .formation = FormationDef{FormationKind::Circle, 1.0, 1.2, {}, {}, 0}}},
            {120, putThing(ItemDef{{2, 2}, 0.4})},
            {130, ChangeGroup{.group = second, .colour = GroupColour{0x336699u}}},
            {131, ChangeGroup{.group = second, .look = GroupLook{std::nullopt, MotionSet::March}}},
            {140, ChangeGroup{.group = second, .name = "Renamed"}},
            {145, putThing(closed, AreaId{1})},
            {146, GiveOrder{second, QueueMode::Append, 0, Order::leave({{1}})}},
            {150, RemoveGroup{{99}}}};
}

/// Reads definitions of the engine as those of the C API.
template <class A, class B>
A asC(const B& value, muster::c_api::Arena& arena) {
    return muster::c_api::writeC<A>(value, arena);
}

class BothWorlds {
public:
    explicit BothWorlds(const muster::WorldDef& def) : engine_(*muster::World::create(def)) {
        muster::c_api::Arena arena;
        const MusterWorldDef same = asC<MusterWorldDef>(def, arena);
        REQUIRE(muster_world_create(&same, 1, &id_) == MUSTER_OK);
    }
    ~BothWorlds() { CHECK(muster_world_destroy(id_) == MUSTER_OK); }

    muster::World& engine() { return engine_; }
    MusterWorldId id() const { return id_; }

    MusterStatus submit(const muster::Command& command) {
        muster::c_api::Arena arena;
        const MusterCommand same = asC<MusterCommand>(command, arena);
        const muster::Status status = engine_.submit(command);
        const MusterStatus other = muster_world_submit(id_, &same);
        CHECK(static_cast<int>(status.code()) == other);
        if (!status.ok()) CHECK(status.message() == muster_last_error());
        return other;
    }
    void step() {
        engine_.step();
        REQUIRE(muster_world_step(id_) == MUSTER_OK);
    }
    std::uint64_t hash() const {
        std::uint64_t hash = 0;
        CHECK(muster_world_hash(id_, &hash) == MUSTER_OK);
        return hash;
    }
    /// Compares the events of the last step and gives their number.
    std::size_t compareEvents() {
        const MusterEvent* events = nullptr;
        std::int32_t count = 0;
        REQUIRE(muster_world_events(id_, &events, &count) == MUSTER_OK);
        REQUIRE(static_cast<std::size_t>(count) == engine_.events().size());
        for (std::size_t i = 0; i < engine_.events().size(); ++i) {
            const muster::Event& event = engine_.events()[i];
            CHECK(events[i].kind == static_cast<int>(event.kind));
            CHECK(events[i].subject == event.subject);
            CHECK(events[i].value == event.value);
            CHECK(events[i].position.x == event.position.x);
        }
        return engine_.events().size();
    }
    /// Compares the rejections of the last step and gives their number.
    std::size_t compareRejections() {
        const MusterRejection* rejections = nullptr;
        std::int32_t count = 0;
        REQUIRE(muster_world_rejections(id_, &rejections, &count) == MUSTER_OK);
        REQUIRE(static_cast<std::size_t>(count) == engine_.rejections().size());
        for (std::size_t i = 0; i < engine_.rejections().size(); ++i) {
            const muster::Rejection& rejection = engine_.rejections()[i];
            CHECK(rejections[i].status == static_cast<int>(rejection.status.code()));
            CHECK(rejection.status.message() == rejections[i].message);
            CHECK(rejections[i].command.kind == static_cast<int>(rejection.command.body.index()));
        }
        return engine_.rejections().size();
    }

private:
    muster::World engine_;
    MusterWorldId id_{};
};
