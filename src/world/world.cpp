#include "muster/world.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "muster/parameter_table.h"
#include "world/commands/command_archive.h"
#include "world/commands/validation.h"
#include "world/state/world_state.h"

namespace muster {
namespace {

constexpr std::uint32_t kSnapshotMagic = 0x4d535032;  // "MSP2"

void archive(Writer& writer, Environment& environment) {
    environment.save(writer);
}
void archive(Hasher& hasher, Environment& environment) {
    environment.hash(hasher);
}
void archive(Reader& reader, Environment& environment) {
    if (!environment.load(reader)) reader.fail();
}

// All parameters are numbers in archives, in the order of the table.
void archive(auto& ar, Parameters& parameters) {
    for (const ParameterInfo& info : parameterTable()) {
        double value = info.get(parameters);
        ar(value);
        if constexpr (std::decay_t<decltype(ar)>::kReading) {
            if (info.valid(value))
                info.set(parameters, value);
            else
                ar.fail();
        }
    }
}

void archive(Writer& writer, std::vector<Command>& queue) {
    auto count = static_cast<std::uint32_t>(queue.size());
    writer(count);
    for (const Command& command : queue) encodeCommand(writer, command);
}
void archive(Reader& reader, std::vector<Command>& queue) {
    std::uint32_t count = 0;
    reader(count);
    queue.clear();
    for (std::uint32_t i = 0; i < count && reader.ok(); ++i) {
        Result<Command> command = decodeCommand(reader);
        if (!command.ok()) {
            reader.fail();
            return;
        }
        queue.push_back(*std::move(command));
    }
}
void archive(Hasher& hasher, std::vector<Command>& queue) {
    for (const Command& command : queue) {
        Writer writer;
        encodeCommand(writer, command);
        auto bytes = writer.take();
        hasher(bytes);
    }
}

void archivePlan(Writer& writer, World::Impl&, Group& group) {
    group.plan->save(writer);
}
void archivePlan(Hasher& hasher, World::Impl&, Group& group) {
    group.plan->hash(hasher);
}
void archivePlan(Reader& reader, World::Impl& world, Group& group) {
    group.plan = world.makePlan();
    if (reader.ok() && !group.plan->load(reader, *world.pool)) reader.fail();
}

void archiveGroups(auto& ar, World::Impl& world) {
    std::vector<Group>& groups = world.groups;
    auto count = static_cast<std::uint32_t>(groups.size());
    ar(count);
    if constexpr (std::decay_t<decltype(ar)>::kReading) {
        groups.clear();
        for (std::uint32_t i = 0; i < count && ar.ok(); ++i) {
            ar(groups.emplace_back());
            archivePlan(ar, world, groups.back());
        }
    } else {
        for (Group& group : groups) {
            ar(group);
            archivePlan(ar, world, group);
        }
    }
}

Status checkRunner(const TaskRunner& runner) {
    if (runner.run == nullptr)
        return invalidArgument("runner: found no function, expected one that runs tasks");
    if (runner.threads < 1 || runner.threads > 256)
        return invalidArgument("runner: found " + std::to_string(runner.threads) +
                               " threads, expected 1 to 256");
    return {};
}

Status addGround(World::Impl& world, const WorldDef& def) {
    for (std::size_t i = 0; i < def.obstacles.size(); ++i) {
        const auto added = world.environment.addObstacle(def.obstacles[i]);
        if (!added.ok()) return added.status().within("obstacles[" + std::to_string(i) + "]");
    }
    for (std::size_t i = 0; i < def.patches.size(); ++i) {
        const auto added = world.environment.addPatch(def.patches[i]);
        if (!added.ok()) return added.status().within("patches[" + std::to_string(i) + "]");
    }
    if (!def.map) return {};
    for (const ObstacleDef& obstacle : mapObstacles(def.map->grid, def.map->def)) {
        const auto added = world.environment.addObstacle(obstacle);
        if (!added.ok()) return added.status().within("map");
    }
    for (const PatchDef& patch : mapPatches(def.map->grid, def.map->def, 1)) {
        const auto added = world.environment.addPatch(patch);
        if (!added.ok()) return added.status().within("map");
    }
    return {};
}

}  // namespace

template <class Archive>
void World::Impl::visit(Archive& ar) {
    archive(ar, parameters);
    archive(ar, environment);
    ar(characters);
    archive(ar, queue);
    ar(checkpoints, checkpointGroups, checkpointState, items, collected, random, stepCount, lastCommandStep,
       nextCharacter, nextGroup);
    if constexpr (Archive::kReading)
        if (!ar.ok()) return;
    archiveGroups(ar, *this);
}

World::World(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
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
    if (const Status valid = validateWorld(def); !valid.ok()) return valid;
    EnvironmentDef ground;
    ground.box = def.box;
    ground.cell = def.cell;
    ground.defaultRange = def.parameters.field.range;
    ground.defaultStrength = def.parameters.field.strength;
    ground.clips = def.clips;
    Result<Environment> environment = Environment::create(ground);
    if (!environment.ok()) return environment.status();

    auto impl = std::make_unique<Impl>();
    impl->pool = std::move(pool);
    impl->parameters = def.parameters;
    impl->environment = *std::move(environment);
    impl->random = Random(def.seed);
    const Status grounded = addGround(*impl, def);
    if (!grounded.ok()) return grounded;
    impl->environment.setTime(0.0);
    impl->density = DensityField(impl->environment.def().box, impl->parameters.density);
    impl->checkpoints = def.checkpoints;
    // Groups are numbered from 1 in this order.
    for (const FormationCheckpointDef& checkpoint : def.checkpoints)
        impl->checkpointGroups.push_back(GroupId{static_cast<std::uint32_t>(checkpoint.group + 1)});
    impl->items = def.items;
    impl->collected.assign(def.items.size(), 0);
    for (std::size_t i = 0; i < def.groups.size(); ++i) {
        const Status added = impl->addGroup(def.groups[i]);
        if (!added.ok()) return added.within("groups[" + std::to_string(i) + "]");
    }
    impl->prepareGround();
    impl->makeRoom();
    return World(std::move(impl));
}

Status World::submit(const Command& command) {
    const Status valid = validateCommand(command);
    if (!valid.ok()) return valid;
    if (command.step < impl_->stepCount)
        return invalidArgument(std::string(commandName(command)) + ": found step " +
                               std::to_string(command.step) + ", expected " +
                               std::to_string(impl_->stepCount) + " or later");
    const auto at = std::upper_bound(impl_->queue.begin(), impl_->queue.end(), command, comesBefore);
    impl_->queue.insert(at, command);
    return {};
}

std::uint64_t World::hash() const {
    Hasher hasher;
    impl_->settlePlans();
    impl_->visit(hasher);
    return hasher.value();
}

std::vector<std::uint8_t> World::snapshot() const {
    Writer writer;
    std::uint32_t magic = kSnapshotMagic;
    writer(magic);
    impl_->settlePlans();
    impl_->visit(writer);
    return writer.take();
}

Result<World> World::restore(std::span<const std::uint8_t> snapshot, std::int32_t threads) {
    return restoreOn(std::make_unique<ThreadPool>(threads), snapshot);
}

Result<World> World::restore(std::span<const std::uint8_t> snapshot, const TaskRunner& runner) {
    if (const Status usable = checkRunner(runner); !usable.ok()) return usable;
    return restoreOn(std::make_unique<ThreadPool>(runner), snapshot);
}

Result<World> World::restoreOn(std::unique_ptr<ThreadPool> pool, std::span<const std::uint8_t> snapshot) {
    Reader reader(snapshot);
    std::uint32_t magic = 0;
    reader(magic);
    if (magic != kSnapshotMagic)
        return Status(StatusCode::ParseError, "snapshot: found another kind of file, expected a world");
    auto impl = std::make_unique<Impl>();
    impl->pool = std::move(pool);
    impl->visit(reader);
    if (!reader.ok() || reader.remaining() != 0)
        return Status(StatusCode::ParseError, "snapshot: found torn or foreign data, expected a whole world");
    if (const Status fits = impl->checkState(); !fits.ok())
        return Status(StatusCode::ParseError,
                      "snapshot: " + fits.message() + ", expected a world as it was saved");
    impl->density = DensityField(impl->environment.def().box, impl->parameters.density);
    impl->prepareGround();
    return World(std::move(impl));
}

}  // namespace muster
