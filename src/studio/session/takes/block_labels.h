// What people call a command of a take.
#pragma once

#include <string>

#include "muster/command.h"
#include "muster/world.h"

namespace muster {

/// "Move to Fountain", "Form a ring", "Split". Things are called as the place of the take calls them.
std::string blockLabel(const CommandBody& body, const WorldDef& place);

}  // namespace muster
