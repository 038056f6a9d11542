// The inside of a world for Muster's own pictures, files, reports and tests. Users read the public views.
//
// All references are valid until the world steps or ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "muster/id.h"
#include "muster/vec2.h"

namespace muster {

class DensityField;
class Environment;
class FormationMesh;
class PlaceTracker;
class Plan;
class World;
struct Characters;
struct FormationDef;
struct GroupDef;
struct StandingReport;
struct UnitCost;

namespace inspect {

/// Obstacles, patches and ground.
const Environment& environment(const World& world);
/// All arrays of the characters.
const Characters& characters(const World& world);
/// Density of the last step.
const DensityField& density(const World& world);
/// Unit cost of the last step, made now where the step needed none; null before the first step.
const UnitCost* unitCost(const World& world);
/// Index of the group with an id; none where there is no such group.
std::optional<std::size_t> indexOfGroup(const World& world, GroupId id);
/// Index of the group that a finger picks where it comes down [m]; none where it picks none.
std::optional<std::size_t> pickedGroup(const World& world, Vec2 p);
/// Name, count and formation of a group.
const GroupDef& groupDef(const World& world, std::size_t group);
/// The formation of a group now, or the one that it takes up again after its present order.
const FormationDef& ownFormation(const World& world, std::size_t group);
/// Rest shape, Vu and Vf of a group.
const FormationMesh& mesh(const World& world, std::size_t group);
/// Travelling places of a group.
const PlaceTracker& places(const World& world, std::size_t group);
/// Distance of a character from where it is to stand in the end [m]: from its place, and under an order from
/// its place at the end of it; infinite without a place, and while its formation is marching. Without places:
/// the distance beyond the crowd round the target.
double distanceLeft(const World& world, std::size_t character);
/// Of each character whether it stands in its place, what keeps it from there, and where that is.
std::vector<StandingReport> standings(const World& world);
/// True for a character that is to leave the world by an exit.
bool leaves(const World& world, std::size_t character);
/// The number of the way through a door for a character that leaves and does not take the shortest route; -1
/// for others.
std::int32_t doorWay(const World& world, std::size_t character);
/// True for an open source that may still send people to a group that is there.
bool maySend(const World& world, std::size_t area);
/// The plan of a group.
const Plan& plan(const World& world, std::size_t group);

}  // namespace inspect
}  // namespace muster
