// The body of a whole group, as the page changes it while a place is made.
#pragma once

#include <string_view>
#include <vector>

#include "muster/command.h"
#include "muster/session.h"
#include "muster/world.h"

namespace muster {

/// True where the text of an edit holds events `groupBody` (docs/protocol.md), and maybe others.
bool changesGroupBody(std::string_view text);
/// Reads events `groupBody`. Each becomes a SetBodies for all who are in the group now: the numbers that it
/// names are theirs from then on, and all others stay. Fails with one sentence that names the event.
Result<std::vector<CommandBody>> parseGroupBodies(std::string_view text, const SessionLimits& limits,
                                                  const World& world);

/// What all in a group have in common. What they differ in is negative.
struct GroupBody {
    double radius = -1.0;    ///< [m]
    double maxSpeed = -1.0;  ///< Top speed in the open [m/s].
    std::int32_t unitClass = -1;
};

/// Parameters stand in where a body has none of its own. Of an empty group: the parameters.
GroupBody groupBody(const World& world, std::size_t group);

}  // namespace muster
