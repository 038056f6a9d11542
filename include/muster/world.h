// A world: environment, groups, characters, and the step that joins all layers.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "cost/density.h"
#include "cost/unit_cost.h"
#include "crowd/characters.h"
#include "crowd/contacts.h"
#include "formation/mesh/formation_mesh.h"
#include "formation/places/place_tracker.h"
#include "muster/command.h"
#include "muster/event.h"
#include "muster/world_def.h"
#include "planning/plan.h"

namespace muster {

/// The stages of a step, in order.
enum class Stage : std::uint8_t {
    Commands,
    Controls,
    UserMesh,
    FinalMesh,
    Places,
    DensityAndCost,
    Plan,
    Steering,
    Contacts,
    Patches,
    Events,
    Count
};
/// "commands", "controls", "user mesh"...
const char* stageName(Stage stage);

/// Milliseconds of the last step by stage: for reports only.
struct StageTimes {
    std::array<double, static_cast<std::size_t>(Stage::Count)> milliseconds{};  ///< By Stage.
    double total = 0.0;                                                         ///< Whole step [ms].
};

/// A command that could not be applied, and why.
struct Rejection {
    Command command;
    Status status;
};

/// Costs of the ways from characters to their places, over those that have one.
struct WalkTotals {
    double sum = 0.0;      ///< [m] where the ground is plain.
    double squares = 0.0;  ///< [m^2].
    double longest = 0.0;  ///< [m].

    /// Adds one way; infinite ones do not count.
    void add(double walk);
    /// Adds the ways of others.
    void add(const WalkTotals& others);

    /// Lets an archive read or write the totals.
    template <class Archive>
    void visit(Archive& archive) {
        archive(sum, squares, longest);
    }
};

/// What can be read of a group.
struct GroupView {
    GroupId id;
    const GroupDef* def = nullptr;        ///< Name, count and formation as they are now.
    const FormationMesh* mesh = nullptr;  ///< Rest shape, Vu, Vf.
    const ControlSet* controls = nullptr;
    const PlaceTracker* places = nullptr;
    const Plan* plan = nullptr;
    double objective = 0.0;  ///< Of the last plan [cost^p].
    double gapBound = 0.0;   ///< Of the last plan [cost^p].
    WalkTotals walk;         ///< Of the last plan: what every objective would judge.
    /// Mean distance of characters to where their places are bound [m] (SPEC U6).
    double meanLag = 0.0;
    std::uint32_t formationVersion = 0;  ///< Grows when the mesh is exchanged.
};

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

    std::uint32_t stepCount() const;           ///< Steps done.
    double time() const;                       ///< [s] = stepCount * stepTime.
    const Parameters& parameters() const;      ///< As they are now.
    const Environment& environment() const;    ///< Obstacles, patches, ground.
    const Characters& characters() const;      ///< Of all groups.
    std::size_t groupCount() const;            ///< Groups now.
    GroupView group(std::size_t index) const;  ///< In ascending order of ids.
    const DensityField& density() const;       ///< Of the last step.
    /// Unit cost of the last step; null before the first.
    const UnitCost* unitCost() const;
    std::span<const Event> events() const;          ///< Of the last step.
    std::span<const Rejection> rejections() const;  ///< Of the last step.
    std::span<const ItemDef> items() const;
    std::span<const std::uint8_t> collected() const;  ///< Per item, 1 once collected.
    std::span<const FormationCheckpointDef> checkpoints() const;
    const StageTimes& stageTimes() const;   ///< Of the last step.
    const ContactReport& contacts() const;  ///< After the last step.
    /// Step of the last applied command (0 for none): the clock of "arrived" starts there.
    std::uint32_t lastCommandStep() const;

    /// Hash of all state.
    std::uint64_t hash() const;
    /// All state as bytes.
    std::vector<std::uint8_t> snapshot() const;

    struct Impl;  ///< Private.

private:
    static Result<World> createOn(std::unique_ptr<ThreadPool> pool, const WorldDef& def);
    static Result<World> restoreOn(std::unique_ptr<ThreadPool> pool, std::span<const std::uint8_t> snapshot);
    explicit World(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
