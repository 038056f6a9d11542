// How a group is divided or joined again when that is taken back.
#pragma once

#include <span>

#include "muster/event.h"
#include "session/deed.h"

namespace muster {

/// The deed of a command that is about to divide or join groups.
DivisionDeed divisionOf(const CommandBody& asked, const World& world);
/// Adds the commands that divide or join. Adds none where too few of the groups are left.
void divisionCommands(DivisionDeed& deed, const World& world, DeedCommands& commands);
/// The groups that came when the step divided one for this deed. Takes their events out.
std::vector<GroupId> takeNewParts(const DivisionDeed& deed, std::vector<Event>& added);
/// Adds what makes new groups what they were before they were joined.
void partsComeBack(const DivisionDeed& deed, const World& world, DeedCommands& commands);

}  // namespace muster
