#include "muster/world.h"

#include <algorithm>
#include <string>

#include "engine/state/group_edits.h"
#include "engine/state/validation.h"
#include "engine/state/world_archive.h"
#include "engine/systems/commands/thing_commands.h"
#include "engine/world/world_engine.h"
#include "muster/ground.h"

namespace muster {
namespace {

Status checkRunner(const TaskRunner& runner) {
    if (runner.run == nullptr)
        return invalidArgument("runner: found no function, expected one that runs tasks");
    if (runner.threads < 1 || runner.threads > 256)
        return invalidArgument("runner: found " + std::to_string(runner.threads) +
                               " threads, expected 1 to 256");
    return {};
}

Status addGround(Environment& environment, const WorldDef& def) {
    for (std::size_t i = 0; i < def.obstacles.size(); ++i) {
        const auto added = environment.addObstacle(def.obstacles[i]);
        if (!added.ok()) return added.status().within("obstacles[" + std::to_string(i) + "]");
    }
    for (std::size_t i = 0; i < def.patches.size(); ++i) {
        const auto added = environment.addPatch(def.patches[i]);
        if (!added.ok()) return added.status().within("patches[" + std::to_string(i) + "]");
    }
    if (!def.map) return {};
    for (const ObstacleDef& obstacle : mapObstacles(def.map->grid, def.map->def)) {
        const auto added = environment.addObstacle(obstacle);
        if (!added.ok()) return added.status().within("map");
    }
    for (const PatchDef& patch : mapPatches(def.map->grid, def.map->def, 1)) {
        const auto added = environment.addPatch(patch);
        if (!added.ok()) return added.status().within("map");
    }
    return {};
}

/// Reads a whole state from a snapshot and checks it.
Status readSnapshot(std::span<const std::uint8_t> snapshot, WorldState& state, ThreadPool& pool) {
    const auto bytes = openSnapshot(snapshot);
    if (!bytes.ok()) return bytes.status();
    Reader reader(*bytes);
    loadState(reader, state, pool);
    if (!reader.ok() || reader.remaining() != 0)
        return {StatusCode::ParseError, "snapshot: found state that does not fit together, expected a world"};
    if (const Status fits = checkState(state); !fits.ok())
        return {StatusCode::ParseError, "snapshot: " + fits.message() + ", expected a world as it was saved"};
    return {};
}

}  // namespace

World::World(std::unique_ptr<WorldEngine> engine) : engine_(std::move(engine)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Result<World> World::create(const WorldDef& def, std::int32_t threads) {
    return createOn(std::make_unique<ThreadPool>(threads), def);
}

Result<World> World::create(const WorldDef& def, const TaskRunner& runner) {
    if (const Status usable = checkRunner(runner); !usable.ok()) return usable;
    return createOn(std::make_unique<ThreadPool>(runner), def);
}

Result<World> World::createOn(std::unique_ptr<ThreadPool> pool, const WorldDef& def) {
    if (const Status valid = validate(def); !valid.ok()) return valid;
    EnvironmentDef ground;
    ground.box = def.box;
    ground.cell = def.cell;
    ground.defaultRange = def.parameters.field.range;
    ground.defaultStrength = def.parameters.field.strength;
    ground.clips = def.clips;
    ground.ring = def.ring;
    Result<Environment> environment = Environment::create(ground);
    if (!environment.ok()) return environment.status();

    auto engine = std::make_unique<WorldEngine>();
    engine->pool = std::move(pool);
    WorldState& state = engine->state;
    state.parameters = def.parameters;
    state.environment = *std::move(environment);
    state.seed = def.seed;
    state.random = Random(def.seed);
    if (const Status added = addGround(state.environment, def); !added.ok()) return added;
    state.environment.setTime(0.0);
    state.checkpoints = def.checkpoints;
    for (std::size_t i = 0; i < def.checkpoints.size(); ++i)
        state.checkpointIds.push_back(CheckpointId{state.nextCheckpoint++});
    // Groups are numbered from 1 in this order.
    for (const FormationCheckpointDef& checkpoint : def.checkpoints)
        state.checkpointGroups.push_back(GroupId{static_cast<std::uint32_t>(checkpoint.group + 1)});
    state.items = def.items;
    state.collected.assign(def.items.size(), 0);
    for (std::size_t i = 0; i < def.items.size(); ++i) state.itemIds.push_back(ItemId{state.nextItem++});
    for (const AreaDef& area : def.areas) {
        const auto group = static_cast<std::uint32_t>(area.kind == AreaKind::Source ? area.group + 1 : 0);
        addArea(state, area, GroupId{group});
    }
    state.groups.reserve(def.groups.size());
    for (std::size_t i = 0; i < def.groups.size(); ++i) {
        const Status added = addGroup(state, def.groups[i]);
        if (!added.ok()) return added.within("groups[" + std::to_string(i) + "]");
    }
    engine->orders.reset(state);
    engine->cost.reset(state);
    engine->ways.reset(state);
    engine->plans.reserve(state, engine->cost);
    return World(std::move(engine));
}

Status World::submit(const Command& command) {
    const Status valid = validateCommand(command);
    if (!valid.ok()) return valid;
    if (command.step < engine_->state.stepCount)
        return invalidArgument(std::string(commandName(command)) + ": found step " +
                               std::to_string(command.step) + ", expected " +
                               std::to_string(engine_->state.stepCount) + " or later");
    std::vector<Command>& queue = engine_->state.queue;
    queue.insert(std::upper_bound(queue.begin(), queue.end(), command, comesBefore), command);
    return {};
}

void World::step() {
    engine_->step();
}

std::uint64_t World::hash() const {
    Hasher hasher;
    engine_->finishBackgroundWork();
    hashState(hasher, engine_->state);
    return hasher.value();
}

std::vector<std::uint8_t> World::snapshot() const {
    Writer writer;
    for (std::size_t k = 0; k < kSnapshotHeadBytes; ++k) {
        std::uint8_t none = 0;
        writer(none);
    }
    engine_->finishBackgroundWork();
    saveState(writer, engine_->state);
    std::vector<std::uint8_t> bytes = writer.take();
    sealSnapshot(bytes);
    return bytes;
}

Result<World> World::restore(std::span<const std::uint8_t> snapshot, std::int32_t threads) {
    return restoreOn(std::make_unique<ThreadPool>(threads), snapshot);
}

Result<World> World::restore(std::span<const std::uint8_t> snapshot, const TaskRunner& runner) {
    if (const Status usable = checkRunner(runner); !usable.ok()) return usable;
    return restoreOn(std::make_unique<ThreadPool>(runner), snapshot);
}

Result<World> World::restoreOn(std::unique_ptr<ThreadPool> pool, std::span<const std::uint8_t> snapshot) {
    auto engine = std::make_unique<WorldEngine>();
    engine->pool = std::move(pool);
    if (Status read = readSnapshot(snapshot, engine->state, *engine->pool); !read.ok()) return read;
    engine->goOnFromState();
    return World(std::move(engine));
}

Status World::rewind(std::span<const std::uint8_t> snapshot) {
    engine_->finishBackgroundWork();
    WorldState earlier;
    if (Status read = readSnapshot(snapshot, earlier, *engine_->pool); !read.ok()) return read;
    keepCaches(earlier, engine_->state);
    engine_->state = std::move(earlier);
    engine_->goOnFromState();
    return {};
}

}  // namespace muster
