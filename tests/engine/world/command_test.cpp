#include "muster/command.h"

#include <doctest.h>

#include <cmath>
#include <limits>
#include <span>

#include "base/random.h"
#include "engine/state/command_archive.h"
#include "generated/random_commands.h"

using namespace muster;

namespace {

/// Four random commands of every kind, kind by kind.
std::vector<Command> everyCommand() {
    constexpr std::uint32_t kEach = 4;
    CommandDraw draw(1);
    std::vector<Command> commands;
    for (std::uint32_t n = 0; n < kEach * std::variant_size_v<CommandKinds>; ++n)
        commands.push_back({60 + n, 1 + n % 3, n, randomCommand(n / kEach, draw)});
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
    for (std::size_t i = 0; i < commands.size(); ++i) {
        CAPTURE(commandName(commands[i]));
        CHECK(commands[i].body.index() == i / 4);
        const Status valid = validateCommand(commands[i]);
        CHECK_MESSAGE(valid.ok(), valid.message());
        const auto bytes = bytesOf(commands[i]);
        Reader reader(bytes);
        const auto back = decodeCommand(reader);
        REQUIRE(back.ok());
        CHECK(reader.remaining() == 0);
        CHECK(back->step == commands[i].step);
        CHECK(back->client == commands[i].client);
        CHECK(back->sequence == commands[i].sequence);
        CHECK(back->body.index() == i / 4);
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
    const auto bytes = bytesOf({5, 2, 9, Touch{TouchPhase::Down, 7, {1.5, -2.25}, 0.125, GroupId{2}}});
    Reader reader(bytes);
    const auto back = decodeCommand(reader);
    REQUIRE(back.ok());
    const auto& down = std::get<Touch>(back->body);
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
    auto bytes = bytesOf({0, 0, 0, Touch{TouchPhase::Cancel, 1, {}, 0.0, {}}});
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
    CHECK(refused(Touch{TouchPhase::Down, 1, {nan, 0}, 0, {}}));
    CHECK(refused(Touch{TouchPhase::Down, 1, {0, infinity}, 0, {}}));
    CHECK(refused(Touch{TouchPhase::Down, 1, {0, 0}, -1.0, {}}));
    CHECK(refused(Touch{TouchPhase::Move, 1, {2e6, 0}, 0, {}}));
    CHECK(refused(Touch{TouchPhase::Up, 1, {}, nan, {}}));
    CHECK(refused(ChangeGroup{.group = GroupId{1}, .count = 0}));
    CHECK(refused(ChangeGroup{.group = GroupId{1}, .count = 200001}));
    CHECK(refused(SetPose{GroupId{1}, {0, 0}, infinity}));
    CHECK(refused(SetParameter{"plan.exponent", 0.5}));
    CHECK(refused(SetParameter{"no.such", 0.5}));
    CHECK(refused(SetParameter{"time.step", 1.0 / 30.0}));
    CHECK(refused(AddControl{GroupId{1}, ControlKind::Line, {1}, {{0, 0}}, 0}));
    CHECK(refused(AddControl{GroupId{1}, ControlKind::Area, {1, 2, 3}, {{0, 0}, {1, 0}}, 0}));
    CHECK(refused(AddControl{GroupId{1}, ControlKind::Point, {}, {}, 0}));
    ObstacleDef crossed{.polygon = {{0, 0}, {1, 1}, {1, 0}, {0, 1}}};
    CHECK(refused(putThing(crossed)));
    CHECK(refused(putThing(ObstacleDef{})));
    PatchDef patch{.polygon = {{0, 0}, {1, 0}, {1, 1}}, .motion = -1};
    CHECK(refused(putThing(patch)));
    FormationDef formation{.spacing = 0.0};
    CHECK(refused(ChangeGroup{.group = GroupId{1}, .formation = formation}));
    formation = {};
    formation.kind = FormationKind::Points;
    CHECK(refused(ChangeGroup{.group = GroupId{1}, .formation = formation}));
    GroupDef group{.starts = {{0, 0}}};
    CHECK(refused(AddGroup{group}));
}
