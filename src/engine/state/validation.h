// Checks of definitions that take more than the definition, shared by scenarios and commands; they need no
// world.
#pragma once

#include "engine/state/generated/definition_checks.h"
#include "muster/generated/world_definitions.h"

namespace muster {

inline constexpr std::int32_t kMaxCharacters = 200000;  ///< Of a world.
/// Of a world with exact plans: they keep a cost for every pair.
inline constexpr std::int32_t kMaxExact = 5000;
inline constexpr std::size_t kMaxGroups = 20000;   ///< Of a world; their indices travel in 16 bits.
inline constexpr std::size_t kMaxOrders = 1000;    ///< In the queue of one group.
inline constexpr std::size_t kMaxCorners = 10000;  ///< Of one polygon, and waypoints of one path.
inline constexpr std::size_t
    kMaxObstacles = 20000;                      ///< Of a scenario; also the limit for patches and for items.
inline constexpr std::size_t kMaxText = 4096;   ///< Bytes of a name or description.
inline constexpr std::size_t kMaxAreas = 1000;  ///< Exits, sources and waiting areas.
inline constexpr std::size_t kMaxSorts = 100;   ///< Of persons in one group.
inline constexpr double kMaxCoordinate = 1e6;   ///< Of any position [m].

/// InvalidArgument where a patch is bad. `motions` is the number of known clips.
Status validatePatch(const PatchDef& patch, std::int32_t motions);
/// InvalidArgument where a parameter is out of its range or contradicts others, in a world of this box.
Status validateParameters(const Parameters& parameters, const Box& box);
/// InvalidArgument where a checkpoint for one of so many groups is bad.
Status validateCheckpoint(const FormationCheckpointDef& checkpoint, std::size_t groups);
/// LimitExceeded where a world with these parameters would hold more characters than it can.
Status validateTotal(std::int64_t characters, const Parameters& parameters);
/// InvalidArgument where a body is bad, or there is neither one for each of `count` nor one for all (nor,
/// where `optional`, none).
Status validateBodies(const std::vector<Body>& bodies, std::size_t count, bool optional);
/// InvalidArgument where a role is bad.
Status validateRoles(const std::vector<RoleDef>& roles);
/// InvalidArgument where a colour is above 0xFFFFFF.
Status validateColour(const std::optional<std::uint32_t>& colour);
/// InvalidArgument where a demand is out of its range.
Status validateDemands(const std::vector<double>& demands);
/// InvalidArgument where a sort of persons is bad.
Status validatePeople(const std::vector<PeopleDef>& people);

}  // namespace muster
