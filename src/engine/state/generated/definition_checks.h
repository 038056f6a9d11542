// Made by schema/generate.mjs from schema/definitions.txt: change these, not this file.
// Checks of definitions: InvalidArgument or LimitExceeded, naming the first field that is bad.
#pragma once

#include "muster/generated/world_definitions.h"

namespace muster {

Status validate(const Waypoint& d);
Status validate(const ObstacleDef& d);
Status validate(const ClipFacts& d);
Status validate(const PatchDef& d);
Status validate(const MapDef& d);
Status validate(const Arrivals& d);
Status validate(const AreaDef& d);
Status validate(const ItemDef& d);
Status validate(const Body& d);
Status validate(const RoleDef& d);
Status validate(const Distribution& d);
Status validate(const PeopleDef& d);
Status validate(const FormationDef& d);
Status validate(const Order& d);
Status validate(const Conduct& d);
Status validate(const GroupDef& d);
Status validate(const GroupColour& d);
Status validate(const GroupLook& d);
Status validate(const FormationCheckpointDef& d);
Status validate(const WorldDef& d);

// What the fields of a definition have to be together is written by hand.
Status relations(const ObstacleDef& d);
Status relations(const AreaDef& d);
Status relations(const Distribution& d);
Status relations(const FormationDef& d);
Status relations(const Order& d);
Status relations(const GroupDef& d);
Status relations(const WorldDef& d);

}  // namespace muster
