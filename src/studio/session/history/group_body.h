// The body of a whole group, as the page changes it while a place is made.
#pragma once

#include <vector>

#include "muster/command.h"
#include "muster/world.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// Each edit becomes a ChangeCharacters for all who are in the group now: the numbers that it names are
/// theirs from then on, and all others stay. Fails with one sentence that names the edit.
Result<std::vector<CommandBody>> bodiesOf(const std::vector<protocol::GroupBodyEdit>& edits,
                                          const World& world);

/// What all in a group have in common. Parameters stand in where a body has none of its own. Of an empty
/// group: the parameters.
protocol::GroupBody groupBody(const World& world, std::size_t group);

}  // namespace muster
