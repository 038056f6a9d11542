// Applies the commands that edit the place.
#pragma once

#include "engine/state/world_state.h"
#include "muster/command_kinds.h"

namespace muster {

// Each fails, changing nothing, with NotFound where the world lacks what is named.
Status addItem(WorldState& state, const AddItem& add);  ///< Fails where there are 20,000 items.
Status changeItem(WorldState& state, const ChangeItem& change);
Status removeItem(WorldState& state, const RemoveItem& remove);
Status addCheckpoint(WorldState& state,
                     const AddCheckpoint& add);  ///< Fails where there are 20,000 checkpoints.
Status changeCheckpoint(WorldState& state, const ChangeCheckpoint& change);
Status removeCheckpoint(WorldState& state, const RemoveCheckpoint& remove);
Status placeGroup(WorldState& state, const PlaceGroup& place);
Status nameGroup(WorldState& state, const NameGroup& name);
Status colourGroup(WorldState& state, const ColourGroup& colour);
Status setAppearance(WorldState& state, const SetAppearance& appearance);
Status setPeople(WorldState& state, const SetPeople& set);

}  // namespace muster
