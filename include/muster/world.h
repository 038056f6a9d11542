// A world: environment, groups, characters, and the step that joins all layers.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "muster/characters.h"
#include "muster/command.h"
#include "muster/event.h"
#include "muster/task_runner.h"
#include "muster/views.h"
#include "muster/world_def.h"

namespace muster {

class ThreadPool;
struct WorldEngine;

/// Deterministic simulation at a fixed time step. Not thread-safe; threads inside never change results.
class World {
public:
    /// Builds a world. `threads` as for ThreadPool. Fails with InvalidArgument naming the culprit.
    static Result<World> create(const WorldDef& def, std::int32_t threads = 1);
    /// The same, with its work handed to the caller's own task runner, which outlives the world. Results are
    /// the same.
    static Result<World> create(const WorldDef& def, const TaskRunner& runner);
    /// A world from snapshot(): goes on bit for bit. Fails with ParseError on anything else.
    static Result<World> restore(std::span<const std::uint8_t> snapshot, std::int32_t threads = 1);
    /// The same on the caller's own task runner.
    static Result<World> restore(std::span<const std::uint8_t> snapshot, const TaskRunner& runner);
    World(World&&) noexcept;  ///< Moves.
    World& operator=(World&&) noexcept;
    ~World();

    /// Queues a command. Fails where it is malformed or its step has passed; whether it applies (does the
    /// group exist?) shows when its step comes: see rejections().
    Status submit(const Command& command);
    /// Advances by one time step.
    void step();

    std::uint32_t stepCount() const;       ///< Steps done.
    double time() const;                   ///< [s] = stepCount * stepTime.
    const Parameters& parameters() const;  ///< As they are now.

    CharactersView characters() const;           ///< Of all groups.
    std::size_t groupCount() const;              ///< Groups now.
    GroupView group(std::size_t index) const;    ///< In ascending order of ids.
    GroupDef groupDef(std::size_t index) const;  ///< Name, count and formation as they are now.

    std::span<const ObstacleId> obstacleIds() const;  ///< In ascending order.
    ObstacleView obstacle(ObstacleId id) const;
    std::span<const PatchId> patchIds() const;  ///< In ascending order.
    PatchView patch(PatchId id) const;
    std::span<const ItemDef> items() const;
    std::span<const std::uint8_t> collected() const;  ///< Per item, 1 once collected.
    std::span<const FormationCheckpointDef> checkpoints() const;

    std::span<const Event> events() const;          ///< Of the last step.
    std::span<const Rejection> rejections() const;  ///< Of the last step.
    StageTimes stageTimes() const;                  ///< Of the last step.
    ContactReport contacts() const;                 ///< After the last step.
    /// Step of the last applied command (0 for none): the clock of "arrived" starts there.
    std::uint32_t lastCommandStep() const;

    /// Hash of all state.
    std::uint64_t hash() const;
    /// All state as bytes.
    std::vector<std::uint8_t> snapshot() const;

private:
    friend struct WorldAccess;
    static Result<World> createOn(std::unique_ptr<ThreadPool> pool, const WorldDef& def);
    static Result<World> restoreOn(std::unique_ptr<ThreadPool> pool, std::span<const std::uint8_t> snapshot);
    explicit World(std::unique_ptr<WorldEngine> engine);
    std::unique_ptr<WorldEngine> engine_;
};

}  // namespace muster
