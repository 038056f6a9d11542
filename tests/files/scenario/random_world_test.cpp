// Random definitions of every kind in one world, there and back through a scenario file.
#include <doctest.h>

#include <cstdint>
#include <vector>

#include "base/archive.h"
#include "generated/random_definitions.h"
#include "muster/scenario.h"

namespace muster {
namespace {

WorldDef randomWorld(DefinitionDraw& draw) {
    WorldDef def;
    def.name = draw.text();
    draw.list(def.obstacles, [&] { return randomObstacleDef(draw); });
    draw.list(def.patches, [&] { return randomPatchDef(draw); });
    draw.list(def.groups, [&] { return randomGroupDef(draw); });
    draw.list(def.checkpoints, [&] { return randomCheckpointDef(draw); });
    draw.list(def.items, [&] { return randomItemDef(draw); });
    draw.list(def.areas, [&] { return randomAreaDef(draw); });
    def.parameters.plan.solver = PlanSolver::Fast;
    return def;
}

std::vector<std::uint8_t> bytesOfDefinitions(WorldDef& def) {
    Writer writer;
    writer(def.obstacles, def.patches, def.groups, def.checkpoints, def.items, def.areas);
    return writer.take();
}

}  // namespace

TEST_CASE("random definitions are the same after a file, bit by bit") {
    DefinitionDraw draw(5);
    for (int k = 0; k < 40; ++k) {
        WorldDef def = randomWorld(draw);
        auto read = parseScenario(writeScenario(def), "random", "");
        REQUIRE_MESSAGE(read.ok(), read.status().message());
        CHECK(bytesOfDefinitions(*read) == bytesOfDefinitions(def));
    }
}

TEST_CASE("random definitions are the same after their bytes") {
    DefinitionDraw draw(6);
    for (int k = 0; k < 40; ++k) {
        WorldDef def = randomWorld(draw), read;
        const std::vector<std::uint8_t> bytes = bytesOfDefinitions(def);
        Reader reader(bytes);
        reader(read.obstacles, read.patches, read.groups, read.checkpoints, read.items, read.areas);
        CHECK(reader.ok());
        CHECK(reader.remaining() == 0);
        CHECK(bytesOfDefinitions(read) == bytes);
    }
}

}  // namespace muster
