// Formations of groups whose characters or shapes have changed: places go on from where they are.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/formation/shapes/make_formation.h"
#include "engine/state/world_state.h"
#include "muster/status.h"
#include "muster/vec2.h"

namespace muster {

/// For each of `to` one of `from`, -1 for none: each takes the nearest that is still free within `reach`, all
/// in [m]. Lower indices choose first.
std::vector<std::int32_t> matchNear(std::span<const Vec2> to, std::span<const Vec2> from, double reach);

/// For each of `to` one of `from`, -1 for none, so that as many as possible are matched at a low sum of
/// squared distances: near the least up to 128 of `from`, roughly where there are more; plans improve that.
std::vector<std::int32_t> matchAll(std::span<const Vec2> to, std::span<const Vec2> from);

/// Places as groups hold them, which new formations begin from. One entry per place in each array.
struct HeldPlaces {
    std::vector<Vec2> rest;                     ///< As controls have bent the mesh, in its axes [m].
    std::vector<std::uint32_t> occupants;       ///< Id of the character of each place; 0 for none.
    std::vector<PlaceTracker::Origin> origins;  ///< Where each is now.

    /// Adds the places of a group, in the axes of the mesh of `frame`.
    void add(const WorldState& state, const Group& group, const Group& frame);
    /// Keeps the places of these characters only; `ids` ascend.
    void keep(std::span<const std::uint32_t> ids);
};

/// A new formation of a group, place by place.
struct Reform {
    FormationDef def;                           ///< Of which it is made.
    Formation formation;                        ///< In the axes of the mesh; no places where nobody is left.
    std::vector<std::uint32_t> occupants;       ///< Id of the character of each place; 0 for none yet.
    std::vector<PlaceTracker::Origin> origins;  ///< Where each place begins.
    std::vector<Vec2> unmoved;  ///< Vertices of the mesh before it was moved to fit; empty where it was not.
};

/// The definition of a group's formation for other characters, whose ids ascend. A square keeps its files, or
/// has them in proportion to its size where `scaled`. Points are those held, of which the hindmost are
/// dropped, or to which ranks are added behind.
FormationDef resized(const Group& group, const HeldPlaces& held, std::span<const std::uint32_t> characters,
                     bool scaled);

/// A formation by `def` for characters, whose ids ascend, from the places that are held. Unless it is one of
/// points, it is moved in the axes of the mesh to where it fits these best; who has a place keeps it, ranks
/// close up, and newcomers take what is left. Fails as makeFormation().
Result<Reform> refit(const WorldState& state, const Group& frame, const HeldPlaces& held,
                     const FormationDef& def, std::span<const std::uint32_t> characters);
/// Each of the characters, whose ids ascend, keeps the place that it holds, or where it stands.
Result<Reform> asHeld(const WorldState& state, const Group& frame, const HeldPlaces& held,
                      std::span<const std::uint32_t> characters);

/// Gives a group a new formation at the pose of `mesh`, mostly its own. Its members must be those of the
/// reform. They are planned again. No background work may be running.
void applyReform(WorldState& state, Group& group, Reform reform, const FormationMesh& mesh);

/// Closes the ranks: where a place has no character, those behind it in its file move up, one after the
/// other. `rest` are the places [m], front towards +x. Places that stay empty are the hindmost of their
/// files.
void closeRanks(std::span<const Vec2> rest, double spacing, std::span<std::uint32_t> occupants);

/// Makes the middle of a formation that was fitted the origin of its mesh; nothing moves.
void recentreFormation(Group& group);

}  // namespace muster
