// What is wrong is refused with a code and a sentence, and never read.
#include <doctest.h>

#include <cmath>
#include <thread>

#include "bindings/c/both_worlds.h"
#include "muster/parameter_table.h"

using namespace muster;

namespace {

std::string lastError() {
    return muster_last_error();
}

}  // namespace

TEST_SUITE("misuse of the C API") {
    TEST_CASE("a handle that is none, was destroyed or was made up is refused by every function") {
        MusterWorldId dead{};
        const MusterWorldDef def = muster_default_world_def();
        REQUIRE(muster_world_create(&def, 1, &dead) == MUSTER_OK);
        REQUIRE(muster_world_destroy(dead) == MUSTER_OK);
        MusterWorldId again{};
        REQUIRE(muster_world_create(&def, 1, &again) == MUSTER_OK);
        CHECK(again.index1 == dead.index1);
        for (const MusterWorldId id :
             {MusterWorldId{0, 0}, dead, MusterWorldId{77, 1}, MusterWorldId{1, 0}}) {
            CAPTURE(id.index1);
            CHECK(!muster_world_is_valid(id));
            CHECK(muster_world_step(id) == MUSTER_NOT_FOUND);
            CHECK(lastError().starts_with("world: found "));
            CHECK(muster_world_destroy(id) == MUSTER_NOT_FOUND);
            std::uint64_t hash = 5;
            CHECK(muster_world_hash(id, &hash) == MUSTER_NOT_FOUND);
            CHECK(hash == 5);
            MusterCharacters characters = muster_default_characters();
            CHECK(muster_world_characters(id, &characters) == MUSTER_NOT_FOUND);
            const MusterCommand command = muster_default_command(MUSTER_COMMAND_TOUCH);
            CHECK(muster_world_submit(id, &command) == MUSTER_NOT_FOUND);
        }
        CHECK(muster_world_destroy(again) == MUSTER_OK);
        CHECK(muster_command_list_destroy({1, 99}) == MUSTER_NOT_FOUND);
        CHECK(muster_map_destroy({3, 3}) == MUSTER_NOT_FOUND);
    }

    TEST_CASE("null pointers are named") {
        BothWorlds both(makeDef());
        CHECK(muster_world_create(nullptr, 1, nullptr) == MUSTER_INVALID_ARGUMENT);
        CHECK(lastError() == "outWorld: found null, expected a pointer");
        MusterWorldId world{7, 7};
        CHECK(muster_world_create(nullptr, 1, &world) == MUSTER_INVALID_ARGUMENT);
        CHECK(lastError() == "def: found null, expected a pointer");
        CHECK(world.index1 == 0);
        CHECK(muster_world_submit(both.id(), nullptr) == MUSTER_INVALID_ARGUMENT);
        CHECK(muster_world_hash(both.id(), nullptr) == MUSTER_INVALID_ARGUMENT);
        CHECK(muster_world_characters(both.id(), nullptr) == MUSTER_INVALID_ARGUMENT);
        CHECK(muster_world_group(both.id(), 0, nullptr) == MUSTER_INVALID_ARGUMENT);
        CHECK(muster_world_rewind(both.id(), nullptr, 12) == MUSTER_INVALID_ARGUMENT);
        CHECK(muster_world_parameter(both.id(), nullptr, nullptr) == MUSTER_INVALID_ARGUMENT);
        const MusterEvent* events = nullptr;
        CHECK(muster_world_events(both.id(), &events, nullptr) == MUSTER_INVALID_ARGUMENT);
        CHECK(lastError() == "outCount: found null, expected a pointer");
        CHECK(muster_world_checkpoints(both.id(), nullptr, nullptr, nullptr, nullptr) ==
              MUSTER_INVALID_ARGUMENT);
        CHECK(muster_formation_kind(nullptr, nullptr) == MUSTER_INVALID_ARGUMENT);
        CHECK(muster_map_parse(nullptr, 4, nullptr) == MUSTER_INVALID_ARGUMENT);
        CHECK(muster_parameter_info(-1, nullptr) == MUSTER_INVALID_ARGUMENT);
        muster_free_buffer(nullptr);
    }

    TEST_CASE("structs that no default function made are refused, wherever they stand") {
        MusterWorldId world{};
        MusterWorldDef zeroed{};
        CHECK(muster_world_create(&zeroed, 1, &world) == MUSTER_INVALID_ARGUMENT);
        CHECK(lastError() == "def: found structVersion 0, expected " +
                                 std::to_string(muster_default_world_def().structVersion) +
                                 " as muster_default_world_def() sets it");
        MusterWorldDef def = muster_default_world_def();
        MusterGroupDef groups[2] = {muster_default_group_def(), muster_default_group_def()};
        groups[1].formation.structVersion += 1;
        def.groups = groups;
        def.groupCount = 2;
        CHECK(muster_world_create(&def, 1, &world) == MUSTER_INVALID_ARGUMENT);
        CHECK(lastError().starts_with("def: groups[1]: formation: found structVersion "));
        MusterCommand command = muster_default_command(MUSTER_COMMAND_GIVE_ORDER);
        command.body.giveOrder.order.structVersion = muster_default_group_def().structVersion;
        CHECK(muster_command_validate(&command) == MUSTER_INVALID_ARGUMENT);
        CHECK(lastError().starts_with("command: GiveOrder: order: found structVersion "));
        MusterTaskRunner runner{};
        def.groupCount = 0;
        CHECK(muster_world_create_on(&def, &runner, &world) == MUSTER_INVALID_ARGUMENT);
        runner = muster_default_task_runner();
        CHECK(muster_world_create_on(&def, &runner, &world) == MUSTER_INVALID_ARGUMENT);
        CHECK(lastError() == World::create(WorldDef{}, TaskRunner{}).status().message());
        BothWorlds both(makeDef());
        MusterCharacters characters{};
        CHECK(muster_world_characters(both.id(), &characters) == MUSTER_INVALID_ARGUMENT);
    }

    TEST_CASE("wrong counts, kinds and indices are named") {
        MusterWorldId world{};
        MusterWorldDef def = muster_default_world_def();
        def.groupCount = -2;
        CHECK(muster_world_create(&def, 1, &world) == MUSTER_INVALID_ARGUMENT);
        CHECK(lastError() == "def: groups: found a count of -2, expected 0 or more");
        def.groupCount = 3;
        def.groups = nullptr;
        CHECK(muster_world_create(&def, 1, &world) == MUSTER_INVALID_ARGUMENT);
        CHECK(lastError() == "def: groups: found null for 3 entries, expected a pointer");
        MusterCommand command = muster_default_command(MUSTER_COMMAND_CHANGE_GROUP);
        MusterFormationDef formation = muster_default_formation_def();
        formation.kind = 200;
        command.body.changeGroup.formation = &formation;
        CHECK(muster_command_validate(&command) == MUSTER_INVALID_ARGUMENT);
        CHECK(lastError() == "command: ChangeGroup: formation: kind: found 200, expected 0 to 9");
        command.kind = MUSTER_COMMAND_COUNT;
        CHECK(muster_command_validate(&command) == MUSTER_INVALID_ARGUMENT);
        const int kinds = MUSTER_COMMAND_COUNT;
        CHECK(lastError() == "command: kind: found " + std::to_string(kinds) + ", expected 0 to " +
                                 std::to_string(kinds - 1));
        CHECK(muster_world_create(&def, -1, &world) == MUSTER_INVALID_ARGUMENT);
        CHECK(lastError() == "threads: found -1, expected 0 to 256");
        BothWorlds both(makeDef());
        MusterGroup group = muster_default_group();
        CHECK(muster_world_group(both.id(), 2, &group) == MUSTER_INVALID_ARGUMENT);
        CHECK(muster_world_group(both.id(), -1, &group) == MUSTER_INVALID_ARGUMENT);
        CHECK(lastError() == "group: found index -1, expected one below 2");
        const MusterVec2* points = nullptr;
        std::int32_t count = 0;
        CHECK(muster_world_way_ahead(both.id(), 36, &points, &count) == MUSTER_INVALID_ARGUMENT);
        MusterObstacle obstacle = muster_default_obstacle();
        CHECK(muster_world_obstacle(both.id(), 99, &obstacle) == MUSTER_NOT_FOUND);
        MusterForecast forecast = muster_default_forecast();
        MusterOrder order = muster_default_order();
        CHECK(muster_world_forecast(both.id(), 99, &order, &forecast) == MUSTER_NOT_FOUND);
        order.share = 2.0;
        CHECK(muster_world_forecast(both.id(), 1, &order, &forecast) == MUSTER_INVALID_ARGUMENT);
    }

    TEST_CASE("what the engine refuses comes with the engine's code and sentence") {
        BothWorlds both(makeDef());
        both.step();
        const double nan = std::nan("");
        CHECK(both.submit({1, 1, 0, Touch{TouchPhase::Down, 1, {nan, 0}, 0.0, {}}}) ==
              MUSTER_INVALID_ARGUMENT);
        CHECK(both.submit({0, 1, 1, Touch{TouchPhase::Up, 1, {}, 0.0, {}}}) == MUSTER_INVALID_ARGUMENT);
        CHECK(both.submit({1, 1, 2, SetParameter{"no.such", 1.0}}) != MUSTER_OK);
        CHECK(both.submit({1, 1, 3, ChangeGroup{.group = {1}, .count = 0}}) == MUSTER_INVALID_ARGUMENT);
        WorldDef bad = makeDef();
        bad.groups[1].formation.spacing = -1.0;
        c_api::Arena arena;
        const MusterWorldDef same = asC<MusterWorldDef>(bad, arena);
        MusterWorldId world{};
        CHECK(muster_world_create(&same, 1, &world) == MUSTER_INVALID_ARGUMENT);
        CHECK(lastError() == World::create(bad).status().message());
        const std::uint8_t bytes[] = {1, 2, 3};
        CHECK(muster_world_restore(bytes, 3, 1, &world) == MUSTER_PARSE_ERROR);
        CHECK(lastError() == World::restore(bytes).status().message());
        MusterWorldDef named = muster_default_world_def();
        const MusterParameterValue value{"plan.exponent", 99.0};
        named.parameters = &value;
        named.parameterCount = 1;
        Parameters none;
        CHECK(muster_world_create(&named, 1, &world) == MUSTER_INVALID_ARGUMENT);
        CHECK(lastError() == "def: parameters[0]: " + setParameter(none, "plan.exponent", 99.0).message());
        named.parameterCount = 0;
        named.preset = "nothing";
        CHECK(muster_world_create(&named, 1, &world) == MUSTER_NOT_FOUND);
        CHECK(lastError() == "def: " + parameterPreset("nothing").status().message());
    }

    TEST_CASE("each thread has its own last sentence, and the log gets all of them") {
        std::vector<std::string> messages;
        muster_set_log(
            [](void* context, MusterLogLevel level, const char* message) {
                CHECK(level == MUSTER_LOG_FAILURE);
                static_cast<std::vector<std::string>*>(context)->emplace_back(message);
            },
            &messages);
        CHECK(muster_world_step({0, 0}) == MUSTER_NOT_FOUND);
        const std::string mine = lastError();
        std::string other = "unset", first = "unset";
        std::thread([&] {
            first = muster_last_error();
            (void)muster_formation_kind("no shape", nullptr);
            other = muster_last_error();
        }).join();
        muster_set_log(nullptr, nullptr);
        CHECK(first.empty());
        CHECK(other == "outKind: found null, expected a pointer");
        CHECK(lastError() == mine);
        CHECK(messages == std::vector<std::string>{mine, other});
    }
}
