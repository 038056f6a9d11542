// How a group is divided or joined again when that is taken back.
#pragma once

#include <span>

#include "muster/event.h"
#include "studio/session/history/crowd_change.h"

namespace muster {

/// The change of the crowd of a command that is about to divide or join groups.
DivisionChange divisionOf(const CommandBody& asked, const World& world);
/// Adds the commands that divide or join. Adds none where too few of the groups are left.
void divisionCommands(DivisionChange& crowdChange, const World& world, CrowdCommands& commands);
/// The groups that came when the step divided one for this change of the crowd. Takes their events out.
std::vector<GroupId> takeNewParts(const DivisionChange& crowdChange, std::vector<Event>& added);
/// Adds what makes new groups what they were before they were joined.
void partsComeBack(const DivisionChange& crowdChange, const World& world, CrowdCommands& commands);

}  // namespace muster
