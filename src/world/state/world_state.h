// The state of a world, and the memory that its step reuses.
#pragma once

#include <memory>
#include <span>
#include <tuple>
#include <vector>

#include "base/archive.h"
#include "base/parallel.h"
#include "base/random.h"
#include "cost/density.h"
#include "cost/dynamic_cost.h"
#include "cost/static_ground.h"
#include "cost/unit_cost.h"
#include "cost/unit_cost_builder.h"
#include "crowd/characters.h"
#include "crowd/contacts.h"
#include "crowd/motion_state.h"
#include "crowd/steering.h"
#include "environment/environment.h"
#include "formation/mesh/formation_mesh.h"
#include "formation/places/place_tracker.h"
#include "muster/world.h"
#include "planning/plan.h"

namespace muster {

/// A group as the world keeps it.
struct Group {
    GroupId id;
    GroupDef def;
    FormationMesh mesh;
    ControlSet controls;
    PlaceTracker places;
    std::unique_ptr<Plan> plan;
    double objective = 0.0;
    double gapBound = 0.0;
    WalkTotals walk;
    double meanLag = 0.0;
    std::uint32_t formationVersion = 1;
    bool planNow = true;                ///< The next plan is made whole in one step, without incumbents.
    bool assigned = false;              ///< A first assignment stands (for plans made once).
    bool reassigns = true;              ///< The pending plan may change places.
    std::vector<std::int32_t> kept;     ///< Place of each member by the last plan that could change them.
    std::int32_t slice = 0;             ///< Shares of the pending plan done.
    std::int32_t slices = 1;            ///< Shares it was cut into.
    std::int32_t region = -1;           // Cache of this step: region in which most of its characters stand.
    bool apart = false;                 // Cache of this step: they stand in several regions.
    std::vector<std::int32_t> members;  // Cache: indices of its characters, ascending.

    /// Lets an archive read or write everything but the plan and the caches.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, def, mesh, controls, places, objective, gapBound, walk, meanLag, formationVersion,
                planNow, assigned, reassigns, kept, slice, slices);
    }
};

/// Memory that a step reuses; nothing in it outlives the step.
struct StepMemory {
    std::vector<Vec2> targets;
    std::vector<Vec2> groupPositions;
    std::vector<std::int32_t> groupPlaces;
    std::vector<std::uint8_t> groupPresent;
    std::vector<Vec2> groupDirections;
    std::vector<double> groupCosts;
    std::vector<Vec2> placePosition;
    std::vector<Vec2> placeVelocity;
    std::vector<Vec2> facing;
    std::vector<Vec2> nextVelocity;
    std::vector<Vec2> nextHeading;
    std::vector<Vec2> nextPosition;
    std::vector<MotionEvent> motionEvents;
    std::vector<std::int32_t> regionCounts;  ///< Characters by region.
    PlanResult planResult;
};

/// The order in which commands are applied.
inline bool comesBefore(const Command& a, const Command& b) {
    return std::tie(a.step, a.client, a.sequence) < std::tie(b.step, b.client, b.sequence);
}

/// Everything a world is.
struct World::Impl {
    // State.
    Parameters parameters;
    Environment environment;
    Characters characters;
    std::vector<Group> groups;
    std::vector<Command> queue;  ///< Ordered by (step, client, sequence).
    std::vector<FormationCheckpointDef> checkpoints;
    std::vector<GroupId> checkpointGroups;      ///< Whom each concerns; 0 for any.
    std::vector<std::uint8_t> checkpointState;  ///< groups x checkpoints: bit 0 inside now, bit 1 used.
    std::vector<ItemDef> items;
    std::vector<std::uint8_t> collected;
    Random random;
    std::uint32_t stepCount = 0;
    std::uint32_t lastCommandStep = 0;
    std::uint32_t nextCharacter = 1;
    std::uint32_t nextGroup = 1;

    // Reports of the last step, and caches.
    std::vector<Event> events;
    std::vector<Rejection> rejections;
    ContactReport contacts;
    StageTimes times;
    DensityField density;
    UnitCostBuilder costBuilder;
    bool costBuilt = false;  ///< For the density as it is.
    StaticGround ground;
    DynamicCost excess;
    Steering steering;
    Contacts contactSolver;
    /// Plans whose work was launched in the last step. It ends before anything they read changes.
    std::vector<Plan*> aside;
    /// After all that launched work reads: it goes first, and waits for the work.
    std::unique_ptr<ThreadPool> pool;
    StepMemory memory;

    double time() const { return stepCount * parameters.stepTime; }

    // Making and changing groups (world_groups.cpp).
    Status addGroup(const GroupDef& def);
    void removeGroup(std::size_t index);
    std::unique_ptr<Plan> makePlan() const;
    void exchangePlans();
    Status changeFormation(Group& group, const FormationDef& def, std::int32_t count);
    void setCount(Group& group, std::int32_t count);
    void addCharacter(const Group& group, std::uint32_t groupIndex, Vec2 position);
    void removeCharacter(std::size_t index);
    void refreshMembers();
    Group* findGroup(GroupId id);
    std::int32_t regionOf(const Group& group);

    // The stages of a step, in order (world_step.cpp).
    void applyCommands();
    void moveControls();
    void deformMeshes();
    void meetEnvironment();
    void movePlaces();
    void buildDensityAndCost();
    void plan();
    void steer();
    void resolveContacts();
    void updatePatches();
    void raiseEvents();

    // One command each (world_commands.cpp).
    Status apply(const Command& command);

    // Parts of stages.
    bool plansThisStep(const Group& group, std::size_t index) const;
    bool plansReadGround() const;
    void prepareGround();
    void makeRoom();
    void updateGround();
    void planInSlices(Group& group);
    void planAside(Group& group);
    void launchPlans();
    void settlePlans() const { pool->wait(); }
    void startPlan(Group& group);
    void finishPlan(Group& group);
    void steerGroup(Group& group);
    std::span<const Vec2> gather(const Group& group);
    void directTheUnmatched(const Group& group, std::span<const Vec2> positions);
    void findPresent(const Group& group, std::span<const Vec2> positions);
    const UnitCost* unitCostNow();
    void collectItems();
    void meetCheckpoints();
    void measureLag();

    // Whether what was read from a snapshot can go on; brings the lists of members up to date
    // (world_restore.cpp).
    Status checkState();
    Status checkQueueAndMarks() const;

    /// All state, for saving, loading and hashing alike.
    template <class Archive>
    void visit(Archive& archive);
};

/// Lets Muster's own code into a world.
struct WorldAccess {
    static World::Impl& of(const World& world) { return *world.impl_; }  ///< All of it.
};

}  // namespace muster
