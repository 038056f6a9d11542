// Commands as clients send them, one after the other in the bytes of takes; and kinds of commands.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <variant>
#include <vector>

#include "muster/command.h"
#include "muster/session.h"

namespace muster {

/// From a time of the page's clock to one of the world [s].
using StampTime = std::function<double(double)>;

/// Reads orders, changes of units, controls, counts and parameters, and checks them. Fingers and edits of the
/// place come in messages of their own. Fails with one sentence that says which command is wrong.
Result<std::vector<CommandBody>> readDirections(std::span<const std::uint8_t> bytes,
                                                const SessionLimits& limits, const StampTime& stamp);
/// The same for edits of the place: what stands and lies in it, and its groups.
Result<std::vector<CommandBody>> readEdits(std::span<const std::uint8_t> bytes, const SessionLimits& limits);

/// True where the command is of one of these kinds.
template <class... Kinds>
bool isOneOf(const CommandBody& body) {
    return (std::holds_alternative<Kinds>(body) || ...);
}

}  // namespace muster
