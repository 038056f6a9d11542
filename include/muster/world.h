// A world: environment, groups, characters, and the simulation step.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "muster/command.h"
#include "muster/event.h"
#include "muster/generated/characters.h"
#include "muster/generated/world_definitions.h"
#include "muster/order.h"
#include "muster/task_runner.h"
#include "muster/views.h"

namespace muster {

class ThreadPool;
struct WorldEngine;

/// Deterministic simulation at a fixed time step. Not thread-safe; threads inside never change results.
class World {
public:
    /// Builds a world that uses this number of threads (0 for all cores). Fails with InvalidArgument, naming
    /// the faulty value.
    static Result<World> create(const WorldDef& def, std::int32_t threads = 1);
    /// Builds a world that runs on the caller's task runner, which must outlive the world. Results are the
    /// same.
    static Result<World> create(const WorldDef& def, const TaskRunner& runner);
    /// Restores a world from snapshot(); it continues bit for bit. Fails with ParseError on other
    /// bytes, and with Unsupported on a snapshot of another version.
    static Result<World> restore(std::span<const std::uint8_t> snapshot, std::int32_t threads = 1);
    /// Restores a world that runs on the caller's task runner.
    static Result<World> restore(std::span<const std::uint8_t> snapshot, const TaskRunner& runner);
    /// Goes back to a snapshot of this world, or on to it: like restore(), but the ground and all that was
    /// computed and is still true are kept, so that a second run of the same steps costs little more than the
    /// first. Fails as restore(), changing nothing. Spans and views of before become invalid.
    Status rewind(std::span<const std::uint8_t> snapshot);
    World(World&&) noexcept;  ///< Moves.
    World& operator=(World&&) noexcept;
    ~World();

    /// Queues a command. Fails where it is malformed or its step has passed; whether it can
    /// be applied is only known in its step: see rejections().
    Status submit(const Command& command);
    /// Advances by one time step.
    void step();

    std::uint32_t stepCount() const;       ///< Number of steps done.
    double time() const;                   ///< stepCount() * stepTime [s].
    const Parameters& parameters() const;  ///< Current values.

    CharactersView characters() const;  ///< Characters of all groups.
    /// The way of a character, an index into characters(), to its place: corners round what stands still,
    /// both ends included [m]. Empty for the unmatched and where there is none.
    std::vector<Vec2> wayAhead(std::size_t character) const;
    /// Of each character whether it stands in its place, and if not, what keeps it from there.
    std::vector<Standing> standings() const;
    std::size_t groupCount() const;              ///< Current number of groups.
    GroupView group(std::size_t index) const;    ///< Groups are in ascending order of ids.
    GroupDef groupDef(std::size_t index) const;  ///< Current name, count and formation.
    /// What would come of an order that a group were given now, and nothing else changed: would it arrive, by
    /// which way, when? For Follow and Guard where what they are about is now. Nothing changes.
    OrderForecast forecast(GroupId group, const Order& order) const;

    std::span<const ObstacleId> obstacleIds() const;              ///< Ids in ascending order.
    ObstacleView obstacle(ObstacleId id) const;                   ///< The obstacle of that id.
    std::span<const PatchId> patchIds() const;                    ///< Ids in ascending order.
    PatchView patch(PatchId id) const;                            ///< The patch of that id.
    std::span<const ItemDef> items() const;                       ///< All items.
    std::span<const ItemId> itemIds() const;                      ///< Of each item, ascending.
    std::span<const std::uint8_t> collected() const;              ///< Per item: 1 once collected, else 0.
    std::span<const FormationCheckpointDef> checkpoints() const;  ///< All formation checkpoints.
    std::span<const CheckpointId> checkpointIds() const;          ///< Of each checkpoint, ascending.
    std::size_t areaCount() const;           ///< Number of exits, sources and waiting areas.
    AreaView area(std::size_t index) const;  ///< Areas are in ascending order of ids.
    bool ring() const;                       ///< True where the left and the right side are joined.
    std::span<const GroupId> checkpointGroups() const;  ///< Whom each concerns; none for any group.

    std::span<const Event> events() const;          ///< Events of the last step.
    std::span<const Rejection> rejections() const;  ///< Commands that failed in the last step.
    StageTimes stageTimes() const;                  ///< Wall times of the last step.
    ContactReport contacts() const;                 ///< Overlaps after the last step.
    /// Step of the last applied command; 0 for none.
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
