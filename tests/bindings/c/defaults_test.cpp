// Defaults, names, parameters, maps, host memory.
#include <doctest.h>

#include <cstdlib>
#include <map>

#include "bindings/c/both_worlds.h"
#include "muster/ground.h"
#include "muster/parameter_table.h"

using namespace muster;

namespace {

/// A host's memory that knows what is out.
struct CountedMemory {
    std::map<void*, std::size_t> blocks;
    std::size_t taken = 0;
    bool empty = false;

    MusterAllocator allocator() {
        return {this,
                [](void* context, std::size_t size, std::size_t) -> void* {
                    auto& self = *static_cast<CountedMemory*>(context);
                    if (self.empty) return nullptr;
                    void* const block = std::malloc(size);
                    self.blocks[block] = size;
                    self.taken += size;
                    return block;
                },
                [](void* context, void* block) {
                    CHECK(static_cast<CountedMemory*>(context)->blocks.erase(block) == 1);
                    std::free(block);
                }};
    }
};

}  // namespace

TEST_SUITE("defaults of the C API") {
    TEST_CASE("a world of defaults is that of the engine's defaults") {
        MusterWorldDef def = muster_default_world_def();
        const MusterGroupDef group = muster_default_group_def();
        def.groups = &group;
        def.groupCount = 1;
        MusterWorldId world{};
        REQUIRE(muster_world_create(&def, 1, &world) == MUSTER_OK);
        WorldDef same;
        same.groups.emplace_back();
        World engine = *World::create(same);
        for (int step = 0; step < 10; ++step) {
            CHECK(muster_world_step(world) == MUSTER_OK);
            engine.step();
        }
        std::uint64_t hash = 0;
        CHECK(muster_world_hash(world, &hash) == MUSTER_OK);
        CHECK(hash == engine.hash());
        CHECK(muster_world_destroy(world) == MUSTER_OK);
    }

    TEST_CASE("a definition comes through C unchanged") {
        const WorldDef def = makeDef();
        c_api::Arena arena;
        const MusterWorldDef same = asC<MusterWorldDef>(def, arena);
        WorldDef back;
        REQUIRE(c_api::readC(&same, back, "def").ok());
        CHECK(World::create(back)->hash() == World::create(def)->hash());
        CHECK(back.name == def.name);
        CHECK(back.obstacles == def.obstacles);
        CHECK(back.patches == def.patches);
        CHECK(back.areas == def.areas);
        CHECK(back.groups[0].people == def.groups[0].people);
        CHECK(back.clips == def.clips);
        CHECK(back.parameters.plan.period == 2);
        CHECK(back.parameters.character.radius == 0.22);
        CHECK(same.parameterCount == 2);
    }

    TEST_CASE("parameters by name are those of the table, of worlds and of presets") {
        REQUIRE(muster_parameter_count() == static_cast<int>(parameterTable().size()));
        const Parameters paper = *parameterPreset("paper");
        for (int i = 0; i < muster_parameter_count(); ++i) {
            MusterParameterInfo info{};
            REQUIRE(muster_parameter_info(i, &info) == MUSTER_OK);
            const ParameterInfo& row = parameterTable()[static_cast<std::size_t>(i)];
            CHECK(row.name == info.name);
            CHECK(row.unit == info.unit);
            CHECK(row.description == info.description);
            CHECK(info.whole == row.whole());
            CHECK(info.standard == row.get(Parameters{}));
            double value = -1.0;
            REQUIRE(muster_preset_value("paper", info.name, &value) == MUSTER_OK);
            CHECK(value == row.get(paper));
        }
        double value = 0.0;
        CHECK(muster_preset_value("muster", "no.such", &value) == MUSTER_NOT_FOUND);
        CHECK(muster_preset_value("none", "plan.exponent", &value) == MUSTER_NOT_FOUND);
        BothWorlds both(makeDef());
        CHECK(muster_world_parameter(both.id(), "plan.period", &value) == MUSTER_OK);
        CHECK(value == 2.0);
        CHECK(muster_world_parameter(both.id(), "no.such", &value) == MUSTER_NOT_FOUND);
    }

    TEST_CASE("distributions, adults and speeds by age are those of the engine") {
        double value = 0.0;
        const MusterPeopleDef grown = muster_adults();
        CHECK(muster_distribution_quantile(&grown.speed, 0.25, &value) == MUSTER_OK);
        CHECK(value == adults().speed.quantile(0.25));
        CHECK(std::string(grown.name) == "Adults");
        CHECK(muster_walking_speed_at_age(45.0) == walkingSpeedAtAge(45.0));
        MusterDistribution drawn = muster_default_distribution();
        CHECK(drawn.most == Distribution{}.most);
        CHECK(muster_distribution_quantile(&drawn, 1.0, &value) == MUSTER_INVALID_ARGUMENT);
        drawn.spread = 6;
        CHECK(muster_distribution_quantile(&drawn, 0.5, &value) == MUSTER_INVALID_ARGUMENT);
        CHECK(std::string(muster_last_error()) == "distribution: spread: found 6, expected 0 to 5");
    }

    TEST_CASE("formations have the engine's names") {
        for (int kind = 0; kind <= MUSTER_FORMATION_POINTS; ++kind) {
            const char* const name = muster_formation_name(static_cast<MusterFormationKind>(kind));
            MusterFormationKind back = 255;
            CHECK(muster_formation_kind(name, &back) == MUSTER_OK);
            CHECK(back == kind);
        }
        MusterFormationKind kind = 0;
        CHECK(muster_formation_kind("heap", &kind) == MUSTER_NOT_FOUND);
        CHECK(std::string(muster_last_error()) == formationKind("heap").status().message());
        CHECK(muster_formation_name(10) == nullptr);
        CHECK(std::string(muster_event_name(MUSTER_EVENT_ARRIVED)) == "arrived");
        CHECK(muster_event_name(MUSTER_EVENT_COUNT) == nullptr);
        CHECK(std::string(muster_status_name(MUSTER_CORRUPT)) == "corrupt");
        CHECK(std::string(muster_status_name(-1)) == "unknown");
        CHECK(muster_has_component("core"));
        CHECK(!muster_has_component("engine"));
    }

    TEST_CASE("a timed path half way is half way") {
        const MusterWaypoint waypoints[] = {{0.0, {0, 0}, 0.0}, {4.0, {8, 2}, 1.0}};
        const MusterTimedPath path{waypoints, 2, false};
        MusterPathState state{};
        REQUIRE(muster_timed_path_at(&path, 2.0, &state) == MUSTER_OK);
        CHECK(state.at.position.x == doctest::Approx(4.0));
        CHECK(state.velocity.x == doctest::Approx(2.0));
        CHECK(state.angularVelocity == doctest::Approx(0.25));
        const MusterWaypoint falling[] = {{4.0, {0, 0}, 0.0}, {0.0, {8, 2}, 1.0}};
        const MusterTimedPath bad{falling, 2, false};
        CHECK(muster_timed_path_at(&bad, 2.0, &state) == MUSTER_INVALID_ARGUMENT);
    }

    TEST_CASE("a map gives the ground that the engine makes of it") {
        const std::string text = "type octile\nheight 3\nwidth 4\nmap\n.@@.\n.@S.\n....\n";
        MusterMapId map{};
        REQUIRE(muster_map_parse(text.data(), text.size(), &map) == MUSTER_OK);
        MusterMapDef def = muster_default_map_def();
        REQUIRE(muster_map_def(map, &def) == MUSTER_OK);
        CHECK(def.width == 4);
        CHECK(std::string(def.cells, 12) == parseMap(text)->cells);
        def.metresPerCell = 2.0;
        def.origin = {1, 1};
        const MusterObstacleDef* obstacles = nullptr;
        const MusterPatchDef* patches = nullptr;
        std::int32_t count = 0;
        REQUIRE(muster_map_obstacles(map, &def, &obstacles, &count) == MUSTER_OK);
        const auto expected = mapObstacles(*parseMap(text), {2.0, {1, 1}, 0.4});
        REQUIRE(count == static_cast<int>(expected.size()));
        CHECK(obstacles[0].polygon.points[0].x == expected[0].polygon[0].x);
        REQUIRE(muster_map_patches(map, &def, 1, &patches, &count) == MUSTER_OK);
        REQUIRE(count == 1);
        CHECK(patches[0].speed == 0.4);
        CHECK(muster_map_destroy(map) == MUSTER_OK);
        CHECK(muster_map_parse("nonsense", 8, &map) == MUSTER_PARSE_ERROR);
        CHECK(std::string(muster_last_error()) == parseMap("nonsense").status().message());
    }

    TEST_CASE("memory comes from the host's functions and goes back to them") {
        CountedMemory memory;
        const MusterAllocator allocator = memory.allocator();
        REQUIRE(muster_set_allocator(&allocator) == MUSTER_OK);
        {
            BothWorlds both(makeDef());
            MusterBuffer bytes{};
            CHECK(muster_world_snapshot(both.id(), &bytes) == MUSTER_OK);
            CHECK(memory.taken >= bytes.size);
            // What was taken before goes back to where it came from.
            CHECK(muster_set_allocator(nullptr) == MUSTER_OK);
            muster_free_buffer(&bytes);
            CHECK(muster_set_allocator(&allocator) == MUSTER_OK);
            memory.empty = true;
            CHECK(muster_world_snapshot(both.id(), &bytes) == MUSTER_OUT_OF_MEMORY);
            CHECK(bytes.data == nullptr);
            memory.empty = false;
        }
        CHECK(muster_set_allocator(nullptr) == MUSTER_OK);
        CHECK(memory.blocks.empty());
        const MusterAllocator none{};
        CHECK(muster_set_allocator(&none) == MUSTER_INVALID_ARGUMENT);
    }
}
