// Which formations a group can take (SPEC M1, M3, M7).
#pragma once

#include <string_view>

#include "muster/generated/orders_definitions.h"
#include "muster/status.h"

namespace muster {

/// The name of a kind as files and messages spell it: "square", "line"...
std::string_view formationName(FormationKind kind);
/// The kind with that name. Fails with NotFound, listing the names.
Result<FormationKind> formationKind(std::string_view name);

}  // namespace muster
