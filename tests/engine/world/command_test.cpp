#include "muster/command.h"

#include <doctest.h>

#include <cmath>
#include <limits>
#include <span>

#include "base/random.h"
#include "engine/state/command_archive.h"

using namespace muster;

namespace {

/// One good command of every kind.
std::vector<Command> everyCommand() {
    AreaDef source;
    source.name = "Gate";
    source.kind = AreaKind::Source;
    source.polygon = {{0, 0}, {2, 0}, {2, 2}};
    source.rate = 0.5;
    source.timetable = {{1.0, 3}, {2.0, 4}};
    FormationDef outline;
    outline.kind = FormationKind::Outline;
    outline.outline.outline = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    outline.outline.holes = {{{1, 1}, {1, 2}, {2, 2}}};
    ObstacleDef box;
    box.name = "Box";
    box.polygon = {{0, 0}, {1, 0}, {1, 1}};
    box.path.waypoints = {{0.0, {0, 0}, 0.0}, {2.5, {3, 1}, 0.5}};
    box.path.loop = true;
    ObstacleDef disc;
    disc.centre = {1, 2};
    disc.radius = 0.5;
    PatchDef patch;
    patch.polygon = box.polygon;
    patch.motion = 3;
    GroupDef group;
    group.count = 2;
    group.starts = {{0, 0}, {1, 1}};
    Order order = Order::move({3, 4}, 0.5);
    order.route = {{1, 1}, {2, 3}};
    order.formation = outline;
    order.path = box.path;
    const Body heavy{0.4, 1.5, 6.0, 2.0, 3.0, 4};
    group.bodies = {heavy, {}};
    group.roles = {{RoleArea::Rim, 4}};
    group.demands = {1.0, 2.0};
    group.conduct = {Stance::Hold, 0.5, 0.25, true};
    group.orders = {order, Order::face(1.0)};
    group.patrols = true;
    FormationCheckpointDef checkpoint;
    checkpoint.position = {3, 4};
    checkpoint.formation = outline;
    checkpoint.once = false;
    checkpoint.trigger = CheckpointTrigger::Mesh;
    const std::vector<CommandBody> bodies = {
        TouchDown{7, {1.5, -2.25}, 0.125, GroupId{2}},
        TouchMove{7, {1, 2}, 0.25},
        TouchUp{7, 0.5},
        TouchCancel{7},
        AddControl{GroupId{1}, ControlKind::Line, {1, 2}, {{0, 0}, {1, 0}}, 0.75},
        PinControl{GroupId{1}, ControlId{3}, false},
        RemoveControl{GroupId{1}, ControlId{3}},
        ReleaseClient{},
        SetFormation{GroupId{1}, outline},
        SetCount{GroupId{1}, 50},
        SetPose{GroupId{1}, {1, 2}, 0.3},
        AddGroup{group},
        RemoveGroup{GroupId{1}},
        AddObstacle{box},
        ChangeObstacle{ObstacleId{4}, disc},
        RemoveObstacle{ObstacleId{4}},
        AddPatch{patch},
        ChangePatch{PatchId{1}, patch},
        RemovePatch{PatchId{1}},
        SetParameter{"plan.exponent", 1.5},
        GiveOrder{GroupId{1}, QueueMode::Insert, 2, order},
        EditQueue{GroupId{1}, QueueEdit::Cancel, 7},
        SetConduct{GroupId{1}, group.conduct},
        AddCharacters{GroupId{1}, {{0, 0}, {1, 2}}, {heavy}},
        RemoveCharacters{{4, 2}},
        TransferCharacters{{4, 2}, GroupId{2}},
        SplitGroup{GroupId{1}, SplitBy::Shares, {}, {}, {1.0, 2.5}, true, PartShape::Smaller},
        MergeGroups{{GroupId{2}, GroupId{1}}, PartShape::AsHeld},
        SetBodies{{4, 2}, {heavy, {}}},
        SetRoles{GroupId{1}, group.roles},
        SetDemands{GroupId{1}, {0.5, 2.0}},
        SetDriver{{4, 2}, Driver::Outside},
        WriteMotion{{4, 2}, {{0, 0}, {1, 2}}, {{1, 0}, {0, 1}}},
        AddItem{{{1, 2}, 0.75}},
        ChangeItem{ItemId{3}, {{1, 2}, 0.75}},
        RemoveItem{ItemId{3}},
        AddCheckpoint{checkpoint, GroupId{2}},
        ChangeCheckpoint{CheckpointId{5}, checkpoint, GroupId{}},
        RemoveCheckpoint{CheckpointId{5}},
        PlaceGroup{GroupId{1}, {1, 2}, 0.3},
        NameGroup{GroupId{1}, "Guests"},
        ColourGroup{GroupId{1}, 0x1D5FD1},
        SetAppearance{GroupId{1}, BodyBuild::Narrow, MotionSet::March},
        PutArea{AreaId{2}, source, GroupId{1}},
        RemoveArea{AreaId{2}},
        SetPeople{GroupId{1}, {adults()}}};
    std::vector<Command> commands;
    for (const CommandBody& body : bodies) {
        const auto n = static_cast<std::uint32_t>(commands.size());
        commands.push_back({60 + n, 1 + n % 3, n, body});
    }
    return commands;
}

std::vector<std::uint8_t> bytesOf(const Command& command) {
    Writer writer;
    encodeCommand(writer, command);
    return writer.take();
}

}  // namespace

TEST_CASE("what a group may have and has not is not hashed") {
    Command command{5, 1, 0, AddGroup{}};
    Writer hashed(true);
    encodeCommand(hashed, command);
    CHECK(bytesOf(command).size() == hashed.bytes().size() + 3);
    GroupDef& group = std::get<AddGroup>(command.body).group;
    group.colour = 0;
    group.build = BodyBuild::Broad;
    group.motions = MotionSet::March;
    Writer coloured(true);
    encodeCommand(coloured, command);
    CHECK(coloured.bytes() == bytesOf(command));
}

TEST_CASE("every kind of command is valid and survives its bytes") {
    const auto commands = everyCommand();
    REQUIRE(commands.size() == std::variant_size_v<CommandKinds>);
    for (std::size_t i = 0; i < commands.size(); ++i) {
        CAPTURE(commandName(commands[i]));
        CHECK(commands[i].body.index() == i);
        CHECK(validateCommand(commands[i]).ok());
        const auto bytes = bytesOf(commands[i]);
        Reader reader(bytes);
        const auto back = decodeCommand(reader);
        REQUIRE(back.ok());
        CHECK(reader.remaining() == 0);
        CHECK(back->step == commands[i].step);
        CHECK(back->client == commands[i].client);
        CHECK(back->sequence == commands[i].sequence);
        CHECK(back->body.index() == i);
        CHECK(bytesOf(*back) == bytes);
    }
}

TEST_CASE("a command as bytes: the same as in archives, and nothing behind it") {
    for (const Command& command : everyCommand()) {
        CAPTURE(commandName(command));
        std::vector<std::uint8_t> bytes = encodeCommand(command);
        CHECK(bytes == bytesOf(command));
        REQUIRE(decodeCommand(bytes).ok());
        CHECK(encodeCommand(*decodeCommand(bytes)) == bytes);
        bytes.push_back(0);
        CHECK(decodeCommand(bytes).status().code() == StatusCode::ParseError);
    }
}

TEST_CASE("decoded values are those encoded") {
    const auto bytes = bytesOf({5, 2, 9, TouchDown{7, {1.5, -2.25}, 0.125, GroupId{2}}});
    Reader reader(bytes);
    const auto back = decodeCommand(reader);
    REQUIRE(back.ok());
    const auto& down = std::get<TouchDown>(back->body);
    CHECK(down.touch == 7);
    CHECK(down.position == Vec2{1.5, -2.25});
    CHECK(down.time == 0.125);
    CHECK(down.group == GroupId{2});
}

TEST_CASE("cut bytes and unknown kinds are refused") {
    for (const Command& command : everyCommand()) {
        const auto bytes = bytesOf(command);
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            Reader reader(std::span<const std::uint8_t>(bytes).first(size));
            CHECK(decodeCommand(reader).status().code() == StatusCode::ParseError);
        }
    }
    auto bytes = bytesOf({0, 0, 0, TouchCancel{1}});
    bytes[12] = 200;
    Reader reader(bytes);
    CHECK(decodeCommand(reader).status().message().find("200") != std::string::npos);
}

TEST_CASE("flipped bytes never crash, and what is accepted is valid") {
    Random random(3);
    int accepted = 0;
    for (int round = 0; round < 200; ++round) {
        for (const Command& command : everyCommand()) {
            auto bytes = bytesOf(command);
            bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] ^= static_cast<std::uint8_t>(
                1 + random.below(255));
            Reader reader(bytes);
            const auto back = decodeCommand(reader);
            if (!back.ok()) continue;
            ++accepted;
            CHECK(validateCommand(*back).ok());
        }
    }
    CHECK(accepted > 100);
}

TEST_CASE("values out of range are refused") {
    const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
    const auto refused = [](CommandBody body) {
        const Status status = validateCommand({0, 1, 0, std::move(body)});
        return status.code() == StatusCode::InvalidArgument || status.code() == StatusCode::NotFound ||
               status.code() == StatusCode::LimitExceeded;
    };
    CHECK(refused(TouchDown{1, {nan, 0}, 0, {}}));
    CHECK(refused(TouchDown{1, {0, infinity}, 0, {}}));
    CHECK(refused(TouchDown{1, {0, 0}, -1.0, {}}));
    CHECK(refused(TouchMove{1, {2e6, 0}, 0}));
    CHECK(refused(TouchUp{1, nan}));
    CHECK(refused(SetCount{GroupId{1}, 0}));
    CHECK(refused(SetCount{GroupId{1}, 200001}));
    CHECK(refused(SetPose{GroupId{1}, {0, 0}, infinity}));
    CHECK(refused(SetParameter{"plan.exponent", 0.5}));
    CHECK(refused(SetParameter{"no.such", 0.5}));
    CHECK(refused(SetParameter{"time.step", 1.0 / 30.0}));
    CHECK(refused(AddControl{GroupId{1}, ControlKind::Line, {1}, {{0, 0}}, 0}));
    CHECK(refused(AddControl{GroupId{1}, ControlKind::Area, {1, 2, 3}, {{0, 0}, {1, 0}}, 0}));
    CHECK(refused(AddControl{GroupId{1}, ControlKind::Point, {}, {}, 0}));
    ObstacleDef crossed;
    crossed.polygon = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    CHECK(refused(AddObstacle{crossed}));
    CHECK(refused(AddObstacle{ObstacleDef{}}));
    PatchDef patch;
    patch.polygon = {{0, 0}, {1, 0}, {1, 1}};
    patch.motion = -1;
    CHECK(refused(AddPatch{patch}));
    FormationDef formation;
    formation.spacing = 0.0;
    CHECK(refused(SetFormation{GroupId{1}, formation}));
    formation = {};
    formation.kind = FormationKind::Points;
    CHECK(refused(SetFormation{GroupId{1}, formation}));
    GroupDef group;
    group.starts = {{0, 0}};
    CHECK(refused(AddGroup{group}));
}
