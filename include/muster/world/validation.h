// Range checks of definitions, shared by scenarios and commands; they need no world.
#pragma once

#include "muster/world/world_def.h"

namespace muster {

inline constexpr std::int32_t kMaxCharacters = 100000;  ///< Of one group.
inline constexpr std::size_t kMaxCorners = 20000;       ///< Of one polygon, and points of one formation or path.
inline constexpr std::size_t kMaxObstacles = 20000;     ///< Of a scenario; patches, items likewise.
inline constexpr std::size_t kMaxText = 4096;           ///< Bytes of a name or description.
inline constexpr double kMaxCoordinate = 1e6;           ///< Of any position [m].

/// InvalidArgument where the spacing, the opening or the shape is bad.
Status validateFormation(const FormationDef& formation);
/// InvalidArgument where the shape, path or field is bad.
Status validateObstacle(const ObstacleDef& obstacle);
/// InvalidArgument where the shape, path, motion or speed is bad. `motions` is the number of known clips.
Status validatePatch(const PatchDef& patch, std::int32_t motions);
/// InvalidArgument where the count, pose, starts or formation is bad.
Status validateGroup(const GroupDef& group);
/// InvalidArgument naming the first bad thing of a whole definition ("groups[1]: ...").
Status validateWorld(const WorldDef& def);

}  // namespace muster
