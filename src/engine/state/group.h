// A group of characters, as a world's state holds it.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/assignment/planning/plan.h"
#include "engine/formation/control/control_set.h"
#include "engine/formation/mesh/formation_mesh.h"
#include "engine/formation/places/place_tracker.h"
#include "engine/orders/avoidance.h"
#include "engine/state/march_flow.h"
#include "engine/state/order_progress.h"
#include "engine/state/order_queue.h"
#include "engine/state/place_classes.h"
#include "muster/generated/walk_totals.h"
#include "muster/generated/world_definitions.h"
#include "muster/vec2.h"

namespace muster {

/// How far the places of a group stand off their formation, because some who hold them are large. Empty where
/// all are alike.
struct PlaceRoom {
    std::uint64_t key = 0;     ///< Hash of what `wanted` was found for.
    std::vector<Vec2> wanted;  ///< Of each place, in the axes of the rest shape [m].
    std::vector<Vec2> given;   ///< The same now; it goes towards `wanted` [m].

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(key, wanted, given);
    }
};

/// Whether the mesh of a group rests.
struct Settling {
    Vec2 centre;                  ///< Mean of its targets in the last step [m].
    std::uint32_t restSteps = 0;  ///< Steps for which that has not moved.

    static constexpr std::uint32_t kRestSteps = 20;  ///< A mesh that has not moved for so many steps rests.
    /// True where the mesh rests.
    bool rests() const { return restSteps >= kRestSteps; }

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(centre, restSteps);
    }
};

/// A group: its mesh, the controls on it, its places and its plan.
struct Group {
    GroupId id;                                ///< Never used again.
    GroupDef def;                              ///< Name, count and formation as they are now.
    FormationMesh mesh;                        ///< Rest shape, Vu and Vf.
    ControlSet controls;                       ///< What fingers hold of the mesh.
    PlaceTracker places;                       ///< One per character.
    std::unique_ptr<Plan> plan;                ///< Who goes to which place; never null.
    double objective = 0.0;                    ///< Of the last finished plan [cost^p].
    double gapBound = 0.0;                     ///< Bound on its duality gap [cost^p].
    WalkTotals walk;                           ///< Path costs by the last finished plan.
    double meanLag = 0.0;                      ///< Mean distance to the goals of places [m] (SPEC U6).
    std::uint32_t formationVersion = 1;        ///< Grows when the mesh is exchanged.
    bool planNow = true;                       ///< The next plan is made whole in one step, at once.
    bool provisional = false;                  ///< The last plan was made by rough costs.
    bool refitted = false;                     ///< The middle of its formation may lie off its mesh's origin.
    bool assigned = false;                     ///< True once a plan was finished for this formation.
    bool reassigns = true;                     ///< The pending plan may change places.
    std::vector<std::int32_t> lastAssignment;  ///< Place of each member by the last plan that reassigned.
    std::vector<std::uint8_t> placeClass;      ///< Of each place by the roles; empty without roles.
    std::int32_t slice = 0;                    ///< Shares of the pending plan that are done.
    std::int32_t slices = 1;                   ///< Shares into which it was cut.
    OrderProgress order;                       ///< How far it has come with its order.
    OrderQueue orders;                         ///< What it is to do.
    MarchFlow flow;                            ///< How its places flow along its way.
    Avoidance avoidance;                       ///< How its mesh keeps clear of others, if it does.
    /// By checkpoint, the ids of those who have been in it since it was last left, ascending.
    std::vector<std::vector<std::uint32_t>> visitors;
    Settling settling;             ///< Where it settles.
    PlaceRoom room;                ///< What its places make for large bodies.
    Vec2 surveyFrom;               ///< Where passages were last looked for from [m]...
    Vec2 surveyTo;                 ///< ... and where to [m].
    Vec2 waysFor;                  ///< Mean goal for which ways were last chosen [m].
    Vec2 goalDrift;                ///< Velocity of the mean goal before that [m/s].
    Vec2 foreseen;                 ///< How far goals will have moved soon [m].
    std::int32_t groundClass = 0;  ///< Of the ground that it plans on (ground_class.h).

    PlaceClasses placeClasses;  ///< Finds placeClass; a cache.
    // Caches of a step.
    std::int32_t region = -1;           ///< Region in which most of its characters stand; -1 for none.
    bool split = false;                 ///< True where they stand in several regions.
    std::vector<std::int32_t> members;  ///< Indices of its characters, ascending.
    bool renumbered = false;            ///< Its places have other numbers than its plan knows.

    /// Lets an archive read or write everything but the plan and the caches.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, def, mesh, controls, places, objective, gapBound, walk, meanLag, formationVersion,
                planNow, provisional, assigned, reassigns, lastAssignment, placeClass, slice, slices, order,
                orders, flow, avoidance, visitors, settling, surveyFrom, surveyTo, waysFor, goalDrift,
                foreseen, refitted, groundClass, room);
    }
};

}  // namespace muster
