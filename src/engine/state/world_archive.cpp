#include "engine/state/world_archive.h"

#include <utility>

#include "engine/state/command_archive.h"
#include "engine/state/group_edits.h"
#include "muster/parameter_table.h"

namespace muster {

namespace {

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
        Writer writer(true);
        encodeForHash(writer, command);
        auto bytes = writer.take();
        hasher(bytes);
    }
}

// Worlds in which everybody has a place have the hashes of before.
void archive(Hasher& hasher, Continuum& continuum) {
    if (!continuum.gatherings.empty()) hasher(continuum);
}
void archive(auto& ar, Continuum& continuum) {
    ar(continuum);
}

/// True where items or checkpoints have come or gone since the world was made.
bool isRenumbered(const WorldState& state) {
    return state.nextItem != state.items.size() + 1 || state.nextCheckpoint != state.checkpoints.size() + 1;
}

// Worlds that have the items and checkpoints of their definition have the hashes of before.
void archiveIds(Hasher& hasher, WorldState& state) {
    if (isRenumbered(state)) hasher(state.itemIds, state.checkpointIds, state.nextItem, state.nextCheckpoint);
}
void archiveIds(auto& ar, WorldState& state) {
    ar(state.itemIds, state.checkpointIds, state.nextItem, state.nextCheckpoint);
}

void archivePlan(Writer& writer, Group& group, const WorldState&, ThreadPool*) {
    group.plan->save(writer);
}
void archivePlan(Hasher& hasher, Group& group, const WorldState&, ThreadPool*) {
    group.plan->hash(hasher);
}
void archivePlan(Reader& reader, Group& group, const WorldState& state, ThreadPool* pool) {
    group.plan = makePlan(state.parameters);
    if (reader.ok() && !group.plan->load(reader, *pool)) reader.fail();
}

void archiveGroups(auto& ar, WorldState& state, ThreadPool* pool) {
    std::vector<Group>& groups = state.groups;
    auto count = static_cast<std::uint32_t>(groups.size());
    ar(count);
    if constexpr (std::decay_t<decltype(ar)>::kReading) {
        groups.clear();
        for (std::uint32_t i = 0; i < count && ar.ok(); ++i) {
            ar(groups.emplace_back());
            archivePlan(ar, groups.back(), state, pool);
        }
    } else {
        for (Group& group : groups) {
            ar(group);
            archivePlan(ar, group, state, pool);
        }
    }
}

/// All state in the order of the format.
void archiveState(auto& ar, WorldState& state, ThreadPool* pool) {
    archive(ar, state.parameters);
    archive(ar, state.environment);
    ar(state.characters, state.ownRoutes);
    archive(ar, state.continuum);
    archive(ar, state.queue);
    ar(state.checkpoints, state.checkpointGroups, state.checkpointState, state.items, state.collected,
       state.areas, state.nextArea, state.seed, state.random, state.stepCount, state.passages, state.survey,
       state.waysLookedAt, state.waysChosenAt, state.lastCommandStep, state.groundEdits, state.nextCharacter,
       state.nextGroup, state.nextOrder);
    archiveIds(ar, state);
    if constexpr (std::decay_t<decltype(ar)>::kReading)
        if (!ar.ok()) return;
    archiveGroups(ar, state, pool);
}

}  // namespace

void saveState(Writer& writer, WorldState& state) {
    archiveState(writer, state, nullptr);
}

void loadState(Reader& reader, WorldState& state, ThreadPool& pool) {
    archiveState(reader, state, &pool);
}

void hashState(Hasher& hasher, WorldState& state) {
    archiveState(hasher, state, nullptr);
}

void keepCaches(WorldState& earlier, WorldState& later) {
    earlier.environment.keepCachesOf(later.environment);
    // Where the environment has become another the next update makes routes from scratch.
    earlier.routes = std::move(later.routes);
    earlier.classRoutes = std::move(later.classRoutes);
    for (Group& group : earlier.groups) {
        Group* const before = later.findGroup(group.id);
        if (before == nullptr) continue;
        group.mesh.keepCachesOf(before->mesh);
        group.flow.plans.keep(before->flow.plans);
        // Fields of another class of ground are of other walls.
        if (group.groundClass == before->groundClass) group.plan->keepFieldsOf(*before->plan);
    }
}

}  // namespace muster
