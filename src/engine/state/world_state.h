// The state of a world: all that can influence its later steps.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "base/as_mutable.h"
#include "base/random.h"
#include "engine/ground/environment/environment.h"
#include "engine/ground/routes/route_graph.h"
#include "engine/passages/survey_state.h"
#include "engine/state/area.h"
#include "engine/state/command_order.h"
#include "engine/state/continuum.h"
#include "engine/state/group.h"
#include "engine/state/own_route.h"
#include "engine/steering/character_arrays.h"
#include "muster/command.h"
#include "muster/generated/parameters.h"
#include "muster/generated/world_definitions.h"

namespace muster {

/// All state. Snapshots and hashes hold it whole (world_archive.h); everything else is a cache or a report.
struct WorldState {
    Parameters parameters;
    Environment environment;                          ///< Obstacles, patches and the ground.
    Characters characters;                            ///< In ascending order of ids.
    std::vector<Group> groups;                        ///< In ascending order of ids.
    std::vector<OwnRoute> ownRoutes;                  ///< In ascending order of characters.
    Continuum continuum;                              ///< Groups without places.
    std::vector<Command> queue;                       ///< In the order of comesBefore().
    std::vector<FormationCheckpointDef> checkpoints;  ///< As defined.
    std::vector<GroupId> checkpointGroups;            ///< Whom each checkpoint concerns; none for any group.
    std::vector<std::uint8_t> checkpointState;        ///< Groups x checkpoints: bit 0 inside, bit 1 used.
    std::vector<CheckpointId> checkpointIds;          ///< Of each checkpoint, ascending.
    std::vector<ItemDef> items;                       ///< As defined.
    std::vector<ItemId> itemIds;                      ///< Of each item, ascending.
    std::vector<std::uint8_t> collected;              ///< Per item, 1 once collected.
    std::vector<Area> areas;                          ///< In ascending order of ids.
    std::uint64_t seed = 0;                           ///< As defined.
    Random random;                                    ///< For start positions.
    std::uint32_t stepCount = 0;                      ///< Steps done.
    std::vector<Passage> passages;                    ///< Gaps before which somebody may have to wait.
    SurveyState survey;                               ///< Looks for further ones.
    std::uint32_t waysLookedAt = 0;                   ///< Step in which groups were last looked at for that.
    std::uint32_t waysChosenAt = 0;                   ///< Step in which ways were last chosen.
    std::uint32_t lastCommandStep = 0;                ///< Step of the last applied command; 0 for none.
    std::uint32_t groundEdits = 0;                    ///< Commands that changed obstacles or patches.
    std::uint32_t nextCharacter = 1;                  ///< Id of the next character.
    std::uint32_t nextGroup = 1;                      ///< Id of the next group.
    std::uint32_t nextOrder = 1;                      ///< Id of the next order.
    std::uint32_t nextItem = 1;                       ///< Id of the next item.
    std::uint32_t nextCheckpoint = 1;                 ///< Id of the next checkpoint.
    std::uint32_t nextArea = 1;                       ///< Id of the next area.

    // Of the commands of this step.
    std::uint32_t editsBefore = 0;      ///< groundEdits before them.
    bool editedPatches = false;         ///< They changed patches.
    std::vector<CellRect> editedAreas;  ///< Cells whose clearance or travel speed they may have changed.

    // Caches.
    RouteGraph routes;  ///< Where usual characters can walk; as it was after the last refreshRoutes().
    std::map<std::int32_t, RouteGraph> classRoutes;  ///< The same for other classes of ground.

    /// Simulated time [s].
    double time() const { return stepCount * parameters.stepTime; }
    /// The group with that id; null where there is none.
    Group* findGroup(GroupId id);
    /// The area with that id; null where there is none.
    Area* findArea(AreaId id);
    const Area* findArea(AreaId id) const { return asMutable(*this).findArea(id); }
    /// Brings Group::members up to date after characters have joined or left.
    void refreshMembers();
    /// Brings the routes up to date after the ground or the radius of characters has changed.
    RouteGraph& refreshRoutes() {
        routes.update(environment, parameters.character.radius);
        return routes;
    }
    /// The same for a class of ground.
    RouteGraph& refreshRoutes(std::int32_t groundClass);
    /// The routes of a group, as they were after the last refresh of those of its class.
    const RouteGraph& routesOf(const Group& group) const;
    RouteGraph& routesOf(const Group& group) { return asMutable(std::as_const(*this).routesOf(group)); }
};

/// The region in which most of a group's characters stand who fit on its ground, the lower label among
/// equals; -1 for none. `counts` becomes the number of its characters by region.
std::int32_t mainRegion(const WorldState& state, const Group& group, std::vector<std::int32_t>& counts);

}  // namespace muster
