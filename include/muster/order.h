// Orders and formations: what groups are to do, one after the other, how they behave meanwhile, and in which
// shape (SPEC M1, M3, M7, B3, B11, B12, B14, B15).
#pragma once

#include <string_view>
#include <vector>

#include "muster/generated/orders_definitions.h"
#include "muster/status.h"
#include "muster/vec2.h"

namespace muster {

/// What would come of an order.
struct OrderForecast {
    bool arrives = false;   ///< True where the target can be reached.
    std::vector<Vec2> way;  ///< The way of the formation's centre, both ends included [m].
    Vec2 end;               ///< Where the formation would stand: the target, or the nearest ground to it [m].
    double seconds = 0.0;   ///< Time until it would arrive [s]; infinite where it never does.
};

/// The name of a kind as files and messages spell it: "square", "line"...
std::string_view formationName(FormationKind kind);
/// The kind with that name. Fails with NotFound, listing the names.
Result<FormationKind> formationKind(std::string_view name);

}  // namespace muster
