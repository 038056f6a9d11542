// Every kind of command: from the engine's bytes to C and back, bit for bit.
#include <doctest.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "bindings/c/both_worlds.h"
#include "generated/random_commands.h"

using namespace muster;

namespace {

Order richOrder() {
    Order order = Order::guard({1, 2}, {3, 4}, 0.5);
    order.kind = OrderKind::Guard;
    order.manner = Manner::Free;
    order.turn = Turn::Reverse;
    order.width = 7.5;
    order.route = {{1, 1}, {2, 2}, {3, 1}};
    order.formation = FormationDef{FormationKind::Outline,
                                   1.5,
                                   2.0,
                                   {{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{2, 2}, {2, 3}, {3, 3}}}},
                                   {},
                                   0};
    order.pace = 1.25;
    order.share = 0.8;
    order.group = {4};
    order.character = 0;
    order.offset = {-1, -2};
    order.path.waypoints = {{1.0, {1, 0}, 0.25}, {2.0, {2, 0}, 0.5}};
    order.path.loop = true;
    order.exits = {{3}, {1}};
    order.choice = ExitChoice::Nearest;
    order.attractions = {0.5, -0.25};
    order.herding = 4.0;
    order.misjudgement = 2.0;
    order.area = {7};
    order.seconds = 60.0;
    return order;
}

PeopleDef richSort() {
    PeopleDef sort;
    sort.name = "Guests";
    sort.share = 0.25;
    sort.unitClass = 3;
    sort.speed = Distribution::normal(1.25, 0.25, 0.5, 2.0);
    sort.radius = Distribution::uniform(0.2, 0.25);
    sort.headway = Distribution::constant(0.5);
    sort.premovement = {Spread::LogNormal, 3.0, 0.5, 0.0, 500.0};
    sort.age = {Spread::Weibull, 40.0, 7.0, 20.0, 70.0};
    sort.upstairs = 0.5;
    sort.downstairs = 0.75;
    return sort;
}

AreaDef richArea() {
    AreaDef area;
    area.name = "Stop";
    area.kind = AreaKind::Source;
    area.polygon = {{0, 0}, {4, 0}, {4, 4}};
    area.open = false;
    area.rate = 1.5;
    area.group = 2;
    area.from = 3.0;
    area.until = 90.0;
    area.most = 30;
    area.timetable = {{10.0, 4}, {20.0, 5}};
    return area;
}

AreaDef richExit() {
    AreaDef area;
    area.polygon = {{0, 0}, {1, 0}, {1, 1}};
    area.queue = {{1, 2}, {1, 6}};
    return area;
}

GroupDef richGroup() {
    GroupDef group;
    group.name = "Rich";
    group.count = 2;
    group.formation = {FormationKind::Points, 1.25, 1.0, {}, {{0, 0}, {1, 0}}, 0};
    group.position = {5, 6};
    group.angle = 0.75;
    group.starts = {{4, 4}, {5, 5}};
    group.jitter = 0.125;
    group.bodies = {Body{0.3, 1.5, 4.0, 2.0, 3.0, 7, 0.5, 30.0, 0.75, 0.5}, Body{}};
    group.roles = {{RoleArea::Rim, 7}, {RoleArea::Flanks, 2}};
    group.demands = {1.0, 3.0};
    group.conduct = {Stance::Yield, 0.25, 0.5, true};
    group.orders = {richOrder(), Order::face(1.0)};
    group.patrols = true;
    group.colour = 0x123456;
    group.build = BodyBuild::Narrow;
    group.motions = MotionSet::March;
    group.people = {richSort(), adults()};
    return group;
}

ObstacleDef richObstacle() {
    ObstacleDef def;
    def.name = "Block";
    def.polygon = {{0, 0}, {1, 0}, {1, 1}};
    def.path.waypoints = {{0.0, {}, 0.0}, {1.0, {1, 1}, 1.0}};
    def.range = 2.0;
    def.strength = 0.5;
    def.height = 4.0;
    return def;
}

PatchDef richPatch() {
    PatchDef def;
    def.name = "Pool";
    def.polygon = {{0, 0}, {1, 0}, {1, 1}};
    def.path.loop = true;
    def.motion = 4;
    def.speed = 0.5;
    def.ascent = -0.5;
    def.speedDown = 0.25;
    return def;
}

FormationCheckpointDef richCheckpoint() {
    return {{1, 2}, 3.0, {FormationKind::Pacman, 1.0, 0.5, {}, {}, 0}, 2, false, CheckpointTrigger::Mesh,
            0.75};
}

/// Commands of which no field is at its default where it has a choice.
std::vector<CommandBody> everyBody() {
    const Body body{0.3, 1.5, 4.0, 2.0, 3.0, 7};
    return {TouchDown{3, {1, 2}, 0.5, {7}},
            TouchMove{3, {2, 2}, 0.6},
            TouchUp{3, 0.7},
            TouchCancel{4},
            AddControl{{2}, ControlKind::Line, {5, 6}, {{1, 1}, {2, 2}}, 1.5},
            PinControl{{2}, {3}, false},
            RemoveControl{{2}, {3}},
            ReleaseClient{},
            SetFormation{{1}, richGroup().formation},
            SetCount{{1}, 55},
            SetPose{{1}, {3, 4}, 0.5},
            AddGroup{richGroup()},
            RemoveGroup{{9}},
            putThing(richObstacle()),
            putThing(richObstacle(), ObstacleId{3}),
            removeThing(ObstacleId{4}),
            putThing(richPatch()),
            putThing(richPatch(), PatchId{5}),
            removeThing(PatchId{6}),
            SetParameter{"plan.exponent", 1.5},
            GiveOrder{{1}, QueueMode::Insert, 2, richOrder()},
            EditQueue{{1}, QueueEdit::EndPatrol, 6},
            SetConduct{{1}, {Stance::Hold, 0.25, 0.5, true}},
            AddCharacters{{1}, {{1, 1}, {2, 2}}, {body}},
            RemoveCharacters{{1, 2, 3}},
            TransferCharacters{{4, 5}, {6}},
            SplitGroup{{1}, SplitBy::Lasso, {7}, {{0, 0}, {1, 0}, {1, 1}}, {0.5}, true, PartShape::Smaller},
            MergeGroups{{{1}, {2}, {3}}, PartShape::AsHeld},
            SetBodies{{1, 2}, {body, Body{}}},
            SetRoles{{1}, {{RoleArea::Centre, 3}}},
            SetDemands{{1}, {0.5, 2.0}},
            SetDriver{{8, 9}, Driver::Outside},
            WriteMotion{{8}, {{1, 2}}, {{0.5, 0.25}}},
            putThing(ItemDef{{1, 2}, 0.75}),
            putThing(ItemDef{{3, 4}, 0.25}, ItemId{2}),
            removeThing(ItemId{3}),
            putThing(richCheckpoint(), {}, GroupId{2}),
            putThing(richCheckpoint(), CheckpointId{1}, GroupId{2}),
            removeThing(CheckpointId{1}),
            PlaceGroup{{1}, {2, 3}, 0.5},
            NameGroup{{1}, "Name"},
            ColourGroup{{1}, 0x00FF7Fu},
            SetAppearance{{1}, BodyBuild::Narrow, MotionSet::Weary},
            putThing(richArea(), AreaId{2}, GroupId{3}),
            removeThing(AreaId{2}),
            SetPeople{{2}, {adults(), PeopleDef{}}},
            putThing(richExit())};
}

/// The engine's default of the same kind.
Command defaultOfKind(const CommandBody& body) {
    return std::visit([](const auto& one) { return Command{0, 0, 0, std::decay_t<decltype(one)>{}}; }, body);
}

}  // namespace

TEST_SUITE("commands in C") {
    TEST_CASE("every kind of command comes through C with the same bytes") {
        std::vector<CommandBody> bodies = everyBody();
        CommandDraw draw(3);
        for (std::size_t kind = 0; kind < MUSTER_COMMAND_COUNT; ++kind)
            for (int k = 0; k < 4; ++k) bodies.push_back(randomCommand(kind, draw));
        std::set<int> kinds;
        for (const CommandBody& body : bodies) {
            const Command command{12, 3, 45, body};
            CAPTURE(commandName(command));
            const std::vector<std::uint8_t> bytes = encodeCommand(command);
            MusterCommandListId list{};
            REQUIRE(muster_command_decode(bytes.data(), bytes.size(), &list) == MUSTER_OK);
            const MusterCommand* commands = nullptr;
            std::int32_t count = 0;
            REQUIRE(muster_command_list_get(list, &commands, &count) == MUSTER_OK);
            REQUIRE(count == 1);
            CHECK(commands->kind == static_cast<int>(body.index()));
            CHECK(commands->step == 12);
            kinds.insert(commands->kind);
            MusterBuffer again{};
            REQUIRE(muster_command_encode(commands, &again) == MUSTER_OK);
            CHECK(std::vector<std::uint8_t>(again.data, again.data + again.size) == bytes);
            muster_free_buffer(&again);
            CHECK(muster_command_list_destroy(list) == MUSTER_OK);
        }
        CHECK(kinds.size() == MUSTER_COMMAND_COUNT);
    }

    TEST_CASE("the default of every kind is that of the engine") {
        for (int kind = 0; kind < MUSTER_COMMAND_COUNT; ++kind) {
            const MusterCommand command = muster_default_command(kind);
            CHECK(command.kind == kind);
            MusterBuffer bytes{};
            REQUIRE(muster_command_encode(&command, &bytes) == MUSTER_OK);
            CommandDraw draw(4);
            const Command expected = defaultOfKind(randomCommand(static_cast<std::size_t>(kind), draw));
            CHECK(std::vector<std::uint8_t>(bytes.data, bytes.data + bytes.size) == encodeCommand(expected));
            CHECK(std::string(commandName(expected)) == muster_command_name(kind));
            muster_free_buffer(&bytes);
        }
        CHECK(muster_default_command(-1).kind == 0);
        CHECK(muster_default_command(1000).kind == 0);
        CHECK(muster_command_name(MUSTER_COMMAND_COUNT) == nullptr);
        const MusterCommand order = muster_default_command(MUSTER_COMMAND_GIVE_ORDER);
        CHECK(order.body.giveOrder.order.share == Order{}.share);
        CHECK(order.body.giveOrder.order.structVersion == muster_default_order().structVersion);
    }

    TEST_CASE("the members of the union by their names have the numbers of their kinds") {
        MusterCommand command = muster_default_command(MUSTER_COMMAND_PLACE_GROUP);
        command.body.placeGroup.group = 3;
        command.body.placeGroup.position = {1.5, 2.5};
        command.body.placeGroup.angle = 0.25;
        const Command expected{0, 0, 0, PlaceGroup{{3}, {1.5, 2.5}, 0.25}};
        MusterBuffer bytes{};
        REQUIRE(muster_command_encode(&command, &bytes) == MUSTER_OK);
        CHECK(std::vector<std::uint8_t>(bytes.data, bytes.data + bytes.size) == encodeCommand(expected));
        muster_free_buffer(&bytes);
        CHECK(std::string(muster_command_name(MUSTER_COMMAND_COLOUR_GROUP)) == "ColourGroup");
    }
}
