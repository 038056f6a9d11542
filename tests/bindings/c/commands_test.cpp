// Every kind of command: from the engine's bytes to C and back, bit for bit.
#include <doctest.h>

#include <set>

#include "bindings/c/both_worlds.h"
#include "generated/random_commands.h"

using namespace muster;

namespace {

/// The engine's default of the same kind.
Command defaultOfKind(const CommandBody& body) {
    return std::visit([](const auto& one) { return Command{0, 0, 0, std::decay_t<decltype(one)>{}}; }, body);
}

}  // namespace

TEST_SUITE("commands in C") {
    TEST_CASE("every kind of command comes through C with the same bytes") {
        std::vector<CommandBody> bodies;
        CommandDraw draw(3);
        for (std::size_t kind = 0; kind < MUSTER_COMMAND_COUNT; ++kind)
            for (int k = 0; k < 16; ++k) bodies.push_back(randomCommand(kind, draw));
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
        MusterCommand command = muster_default_command(MUSTER_COMMAND_SET_POSE);
        command.body.setPose.group = 3;
        command.body.setPose.position = {1.5, 2.5};
        command.body.setPose.angle = 0.25;
        command.body.setPose.characters = true;
        const Command expected{0, 0, 0, SetPose{{3}, {1.5, 2.5}, 0.25, true}};
        MusterBuffer bytes{};
        REQUIRE(muster_command_encode(&command, &bytes) == MUSTER_OK);
        CHECK(std::vector<std::uint8_t>(bytes.data, bytes.data + bytes.size) == encodeCommand(expected));
        muster_free_buffer(&bytes);
        CHECK(std::string(muster_command_name(MUSTER_COMMAND_CHANGE_GROUP)) == "ChangeGroup");
    }

    TEST_CASE("what a change of a group does not give is none, and an empty list is one") {
        MusterCommand command = muster_default_command(MUSTER_COMMAND_CHANGE_GROUP);
        CHECK(muster_command_validate(&command) == MUSTER_INVALID_ARGUMENT);
        const double demands[] = {1.0, 0.5};
        command.body.changeGroup.group = 3;
        command.body.changeGroup.hasDemands = true;
        command.body.changeGroup.demands = demands;
        command.body.changeGroup.demandCount = 2;
        command.body.changeGroup.hasRoles = true;
        command.body.changeGroup.hasName = true;
        command.body.changeGroup.name = "Van";
        const ChangeGroup change{.group = {3},
                                 .roles = std::vector<RoleDef>(),
                                 .demands = std::vector<double>{1.0, 0.5},
                                 .name = "Van"};
        MusterBuffer bytes{};
        REQUIRE(muster_command_encode(&command, &bytes) == MUSTER_OK);
        CHECK(std::vector<std::uint8_t>(bytes.data, bytes.data + bytes.size) ==
              encodeCommand({0, 0, 0, change}));
        muster_free_buffer(&bytes);
    }
}
